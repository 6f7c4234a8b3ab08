//! Partial slip: shear traction, stick and slip under a tangential load within Coulomb friction.
//!
//! ```math
//! s = C\,q - \delta, \qquad |q| \le m, \qquad
//! s = 0 \text{ where } |q| < m, \qquad q\,s \le 0 \text{ where } |q| = m,
//! \qquad F = \Delta \textstyle\sum q
//! ```
//!
//! (eqs 13-16 of Wang et al. 2021): `q` is the traction on body 1 along one axis, `C` is `C_xx` or
//! `C_yy`, `delta` the shift of the bodies, `s` the slip, `m = min(mu p, tau_max)` the friction
//! limit of each cell, `Delta` the area of a cell. For one monotonic load step with a pressure that
//! shear does not change it is the minimum of `1/2 q'Cq` over `|q| <= m`.
//!
//! The traction across the load is neglected, as in the paper: for the sphere of Poisson's ratio
//! 0.29 it reaches 2 to 4 % of the largest friction limit and changes the force by less than 0.1 %.
//!
//! [`TangentialProblem`] checks and holds a scene; [`TangentialSolver`] owns the buffers and starts
//! from its last answer; [`TangentialSolution`] is the answer, with one [`Zone`] per cell.
//! [`JaegerSuperposition`] is the exact answer where the two compliances are proportional.

mod friction;
mod nested;
mod problem;
mod solution;
mod solver;
mod superposition;
mod zone;

pub(crate) use friction::Coefficient;
pub use friction::Friction;
pub(crate) use problem::{Limits, check_coupling};
pub use problem::{TangentialLoad, TangentialProblem, TangentialProblemBuilder};
pub use solution::TangentialSolution;
pub use solver::TangentialSolver;
pub(crate) use solver::component;
pub use superposition::JaegerSuperposition;
pub use zone::{Axis, Zone};
