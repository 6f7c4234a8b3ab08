//! Bodies of different materials, for which pressure and traction are coupled.
//!
//! If Dundurs' constant $`\beta`$ is not zero, pressure moves the surfaces tangentially and shear moves them normally
//! (K and the signs as in [`influence`](crate::influence)):
//!
//! ```math
//! u_z = C_{zz}\,p + B\,q, \qquad u_t = B^{T} p + C_{tt}\,q, \qquad B = (C_{zx}, C_{zy}) .
//! ```
//!
//! A [`CoupledProblem`] describes bodies that are pressed and sheared from rest in one step. In a
//! [`History`](crate::History) this happens in many steps. Both solve for p and q that satisfy
//!
//! ```math
//! g = h + u_z - \delta \ge 0,\; p \ge 0,\; p\,g = 0, \qquad
//! |q| \le m = \min(\mu p, \tau_{max}),\; s = u_t - \delta_t,\;
//! s = 0 \text{ where } |q| < m,\; s = -|s|\,q/m \text{ where } |q| = m .
//! ```
//!
//! # Influence of the coupling
//!
//! Between aluminium and steel ($`\beta = 0.12`$), neglecting the coupling changes the peak pressure of a sphere by 1.2
//! %. The change is 8 % at $`\beta = 0.29`$ and 20 to 30 % at $`\beta = 0.5`$. The approach changes by at most 3.4 %.
//! Steel on rubber is nearly uncoupled ($`\beta = 0.02`$), but a hard body on a compressible body is not.
//!
//! # Load steps
//!
//! Friction makes pressing depend on the load history: cells at the rim of a growing contact slip while cells inside
//! stick. One step from rest underestimates the stick radius of a pressed sphere by more than a factor of two. At
//! $`\beta = 0.5`$ and $`\mu = 0.3`$ it gives 0.23 instead of 0.50 of the contact radius. Its approach is accurate to
//! 4e-4 and its peak pressure to 9e-3. For a flat punch, whose contact does not grow, one step is exact.
//! [`History::press`](crate::History::press) takes as many steps as a tolerance requires.
//!
//! # Sliding forces
//!
//! For a uniform coefficient of friction and a prescribed normal force W, friction carries less than $`\mu W`$ for any
//! distribution of the pressure. A greater force is rejected immediately, and a force of $`(1 - 10^{-8}) \mu W`$ is
//! solved.
//!
//! Under a prescribed approach, or with a coefficient per cell or a shear cap, the sum of the limits depends on the
//! unknown pressure. If a solve stalls, the prescribed force is compared with the force at which the bodies slide
//! steadily in the same direction. [`Error::BeyondFrictionCapacity`](crate::Error::BeyondFrictionCapacity) states this
//! sliding force. Equilibria under slightly larger forces are returned if the solver finds them.
//!
//! # Certificates
//!
//! A friction limit that depends on the unknown pressure is not the optimality condition of any energy, and the
//! solution is known to be unique for weak friction only. A. Klarbring, Ingenieur-Archiv 60 (1990) 529, gives examples without
//! a solution and with several. G. De Saxcé and Z.-Q. Feng, Math. Comput. Modelling 28 (1998) 225,
//! <https://doi.org/10.1016/S0895-7177(98)00119-8>, state both laws as one with a bipotential.
//!
//! The report contains the residual of both laws. It also contains a rigorous bound for each half (the normal or the
//! tangential problem), given the present solution of the other half. See [`CoupledReport`].
//!
//! If friction is weak enough for the grid and no tangential force is prescribed, these bounds also bound the whole
//! error ([`CoupledReport::error_bounds`]). On 64 x 64 cells this holds up to $`\mu = 0.29`$ for aluminium on steel, up
//! to 0.09 for a body of $`\nu = 0.3`$ on a rigid body, and up to 0.026 at $`\beta = 0.5`$. These limits decrease with
//! the square root of the number of cells per side. In all other cases the report has an [`ErrorEstimate`], which is
//! not a bound.
//!
//! The example `dissimilar` plots:
#![cfg_attr(doc, doc = include_str!("../pictures/dissimilar.html"))]

mod coarse_start;
mod error_bound;
mod growth;
mod increment;
mod offset;
mod problem;
mod report;
mod sliding;
mod solution;
mod solver;
mod window_solver;

pub(crate) use growth::SensitivityInput;
pub(crate) use increment::{CoupledIncrement, CoupledTarget, check_joint};
pub use problem::{CoupledProblem, CoupledProblemBuilder};
pub use report::{CoupledReport, ErrorEstimate};
pub use solution::CoupledSolution;
pub use solver::CoupledSolver;

/// Number of components of a vector, along z, x and y.
const N: usize = 3;
