//! Bodies of different materials: pressure and traction found together.
//!
//! Where Dundurs' constant $`\beta`$ is not zero, pressure moves the surfaces tangentially and shear moves them
//! normally (K and the signs as in [`influence`](crate::influence)):
//!
//! ```math
//! u_z = C_{zz}\,p + B\,q, \qquad u_t = B^{T} p + C_{tt}\,q, \qquad B = (C_{zx}, C_{zy}) .
//! ```
//!
//! A [`CoupledProblem`] presses and shears from rest, in one step; a [`History`](crate::History) of such bodies does so step
//! by step. They find p and q under
//!
//! ```math
//! g = h + u_z - \delta \ge 0,\; p \ge 0,\; p\,g = 0, \qquad
//! |q| \le m = \min(\mu p, \tau_{max}),\; s = u_t - \delta_t,\;
//! s = 0 \text{ where } |q| < m,\; s = -|s|\,q/m \text{ where } |q| = m .
//! ```
//!
//! # When it matters
//!
//! Between aluminium and steel ($`\beta = 0.12`$) the neglect of the coupling changes the peak pressure of a sphere by
//! 1.2 %, at $`\beta = 0.29`$ by 8 %, at 0.5 by 20 to 30 %; the approach by at most 3.4 %. Steel on rubber is nearly
//! uncoupled (0.02), hard on compressible is not.
//!
//! # Load steps
//!
//! Friction remembers, in pressing too: cells at the rim of a growing contact slip while those inside stick. One step
//! from rest finds the stick radius of a pressed sphere at less than half of what many steps find (0.23 for 0.50 at
//! $`\beta = 0.5`$, $`\mu = 0.3`$); its approach is right to 4e-4 and its peak pressure to 9e-3. For a flat punch, whose
//! contact does not grow, one step is exact. [`History::press`](crate::History::press) takes as many steps as a tolerance
//! needs.
//!
//! # Forces that slide
//!
//! With one coefficient of friction and a prescribed normal force W, friction holds less than $`\mu W`$ however the
//! pressure is distributed: any greater force is refused at once, one of $`(1 - 10^{-8}) \mu W`$ is answered. Under a
//! prescribed approach, or with a coefficient of each cell or a shear cap, the sum of the limits follows from the pressure
//! that is sought. A solve that stalls is then compared with bodies that slide steadily in the direction of the force:
//! [`Error::BeyondFrictionCapacity`](crate::Error::BeyondFrictionCapacity) names the force that this takes. Equilibria that
//! exist a little beyond it are returned if they are found.
//!
//! # What is certified
//!
//! Friction whose limit follows an unknown pressure is not the condition of a minimum of any energy, and solutions are known
//! to be unique for weak friction alone. The report gives the
//! residual of both laws and a rigorous bound for each half, the other being as it is: see [`CoupledReport`]. Where friction
//! is weak enough for the grid and no tangential force is prescribed, the halves bound the whole
//! ([`CoupledReport::error_bounds`]): between aluminium and steel up to $`\mu = 0.29`$ on 64 x 64 cells, with a body of
//! $`\nu = 0.3`$ on a rigid one up to 0.09, at $`\beta = 0.5`$ up to 0.026; these limits fall with the root of the cells along
//! a side. Elsewhere there is an [`ErrorEstimate`], which is no bound.
//!
//! The example `dissimilar` draws:
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

/// Components of a vector: along z, x and y.
const N: usize = 3;
