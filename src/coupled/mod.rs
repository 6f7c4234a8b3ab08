//! Bodies of different materials, for which pressure and traction are coupled.
//!
//! If Dundurs' constant $`\beta`$ is not zero, pressure moves the surfaces tangentially and shear moves them normally.
//! With K and the signs of [`influence`](crate::influence), the displacements are
//!
//! ```math
//! u_z = C_{zz}\,p + B\,q, \qquad u_t = B^{T} p + C_{tt}\,q, \qquad B = (C_{zx}, C_{zy}) .
//! ```
//!
//! A [`CoupledProblem`] describes bodies that are pressed and sheared from rest in one step. A
//! [`History`](crate::History) presses and shears bodies in many steps. Both solve for p and q that satisfy
//!
//! ```math
//! g = h + u_z - \delta \ge 0,\; p \ge 0,\; p\,g = 0, \qquad
//! |q| \le m = \min(\mu p, \tau_{max}),\; s = u_t - \delta_t,\;
//! s = 0 \text{ where } |q| < m,\; s = -|s|\,q/m \text{ where } |q| = m .
//! ```
//!
//! # Influence of the coupling
//!
//! Between aluminium and steel ($`\beta = 0.12`$), the coupling changes the peak pressure of a sphere by 1.2 %. The
//! change is 8 % at $`\beta = 0.29`$ and 20 to 31 % at $`\beta = 0.5`$. The approach changes by at most 3.4 %.
//! Steel on rubber is nearly uncoupled ($`\beta = 0.02`$), but a hard body on a compressible body is not.
//!
//! # Load steps
//!
//! Friction makes pressing depend on the load history. Cells at the edge of a growing contact slip while cells inside
//! the contact stick. One step from rest gives a stick radius that is too small or too large. At $`\beta = 0.5`$ and
//! $`\mu = 0.3`$ a `CoupledProblem` gives 0.23 instead of 0.50 of the contact radius. Its approach is accurate to 4e-4,
//! and its peak pressure to 4e-3. In one step of a history with the entry rule, aluminium on steel at $`\mu = 0.1`$
//! sticks everywhere ([table](crate::guide::load_steps#load-steps-of-dissimilar-bodies)). For a flat punch, whose
//! contact does not grow, one step is exact. [`History::press`](crate::History::press) takes as many steps as a
//! tolerance requires.
//!
//! # Sliding forces
//!
//! The following holds for a uniform coefficient of friction and a prescribed normal force W. Friction carries less
//! than $`\mu W`$ for any distribution of the pressure. The solver rejects a greater force immediately, and it solves
//! for a force of $`(1 - 10^{-8}) \mu W`$.
//!
//! Under a prescribed approach, with a coefficient per cell or with a shear cap, the sum of the limits depends on the
//! unknown pressure. If a solve stalls, the solver compares the prescribed force with the force at which the bodies
//! slide steadily in the same direction. [`Error::BeyondFrictionCapacity`](crate::Error::BeyondFrictionCapacity) states
//! this sliding force. Equilibria under slightly larger forces are returned if the solver finds them.
//!
//! # Certificates
//!
//! The friction limit depends on the unknown pressure, so the equations are not the optimality conditions of any
//! energy. The solution is known to be unique for weak friction only. A. Klarbring, Ingenieur-Archiv 60 (1990) 529,
//! gives examples without a solution and with several solutions. G. De Saxcé and Z.-Q. Feng, Math. Comput. Modelling 28
//! (1998) 225, <https://doi.org/10.1016/S0895-7177(98)00119-8>, combine both laws in a bipotential.
//!
//! The report contains the residual of both laws. The two halves of the problem are the normal and the tangential
//! problem. The report contains a rigorous bound for each half, given the present solution of the other half. See
//! [`CoupledReport`].
//!
//! If friction is weak enough for the grid and no tangential force is prescribed, these bounds also bound the whole
//! error ([`CoupledReport::error_bounds`]). For a sphere on 64 x 64 cells over 2.5 to 3 contact radii the limit of
//! friction is $`\mu = 0.32`$ for aluminium on steel. It is 0.10 for a body of $`\nu = 0.3`$ on a rigid body, and 0.026
//! at $`\beta = 0.5`$. These limits decrease with the square root of the number of cells per side. In all other cases the
//! report has an [`ErrorEstimate`], which is not a bound.
//!
//! The example `dissimilar` plots:
#![cfg_attr(doc, doc = include_str!("../pictures/dissimilar.html"))]

mod coarse_start;
mod error_bound;
mod growth;
mod increment;
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
