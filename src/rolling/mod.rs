//! Steady rolling: traction, slip and creepage of two bodies that roll over each other, as the contact sees them.
//!
//! The contact stands still, and the particles of both surfaces move through it by $`d`$, a number of whole cells, from the
//! [leading edge](LeadingEdge) on. With $`T f(x) = f(x + d)`$, the value where a particle was before that step, the slip
//! of a cell over a step is
//!
//! ```math
//! s = (1 - T)\,(C q + u_p) + B q - w, \qquad
//! w = d \begin{pmatrix} \xi - \varphi\,y \\ \eta + \varphi\,x \end{pmatrix},
//! ```
//!
//! with the traction q on body 1, the displacement $`u_p`$ by the pressure (zero between bodies of the same material), the
//! creepages $`\xi, \eta`$, the spin $`\varphi`$ about the origin of the grid, all per length rolled, and x and y in the
//! middle of the way of the particle. Coulomb's law holds in every cell: $`|q| \le \mu p`$, and slip against the traction
//! only where $`|q| = \mu p`$. A positive creepage moves body 2 along the axis over body 1 and causes a positive force, as a positive
//! [shift](crate::TangentialSolution::shift) does.
//!
//! A creepage is given, or the force along its axis; the creepage then is the multiplier of that force, found in the same
//! solve. In place of the spin a moment can be given.
//!
//! # Cells that enter
//!
//! A particle ahead of the contact moves with the free surface: by B q less than one that sticks, $`B = \kappa\,g/p`$, with
//! the gap g where the particle was, the pressure p of the cell it enters, and $`\kappa`$ from 1 across the edge of the
//! contact to $`1/(1 - \nu)`$ along it (of bodies of one material). It is the law of
//! [growing contacts](crate::guide::load_steps). With it the error of the force falls with the square of the size of
//! the cells, without it ([`EntryRule::WholeStep`], as CONTACT) in proportion.
//!
//! # Loads
//!
//! - [`RollingSolver::set_load`] and [`RollingSolver::set_pressure`] take new normal contacts, as in the [time loop of a
//!   vehicle](crate::guide::rolling#vehicle-dynamics).
//! - [`RollingSolver::stiffness`] returns the derivatives of forces and moment with respect to creepages and spin.
//! - [`RollingSolver::creep_forces`] returns the points of creep curves and surfaces.
//! - [`SpinControl::Moment`] prescribes a moment instead of the spin, which several solves then find.
//!
//! # Bodies of different materials
//!
//! Tractions lift the surfaces of such bodies, and the pressure changes. A [`RollingProblem`] takes a pressure that ignores
//! the lift; its solution then has the warning [`NeglectedLift`](crate::Warning::NeglectedLift). A [`CoupledRollingProblem`]
//! repeats two solves, of the pressure over the lifted gap and of the tractions under this pressure. The passes form a
//! contraction in all measured contacts. A sphere on a rigid plane ($`\nu`$ of 0.45, 0.25 and 0), 24 cells over 2.6
//! contact radii, longitudinal creepage 0.05, spin 0.1, to a tolerance of 1e-9:
//!
//! | $`\beta`$ | $`\mu`$ | error of a pass over that of the last | passes | products |
//! |---|---|---|---|---|
//! | 0.09 | 0.1 | 0.01 | 6 | 311 |
//! | 0.33 | 1 | 0.13 | 12 | 409 |
//! | 0.5 | 0.3 | 0.13 | 15 | 741 |
//! | 0.5 | 1 | 0.22 | 21 | 802 |
//!
//! [`CoupledRollingReport`] has a rigorous bound for each half, the residual of the coupling, and an estimate for the whole.
//! [`CoupledRollingSolver::stiffness`] includes the pressure that follows the tractions.
//!
//! # Uniqueness and error
//!
//! $`(1 - T) C`$ is not symmetric, but monotone: with the energy norm $`|e|_C^2 = e' C e`$ and fields e that are zero
//! outside the contact,
//!
//! ```math
//! e' (1 - T)\,C e = \tfrac12 |e - T e|_C^2 \ge \lambda \with_remaining_limits(1 - \cos\frac{\pi}{m + 1}\right) |e|^2 ,
//! ```
//!
//! where $`\lambda`$ bounds from below the eigenvalues of C on a window one step longer than the contact, and m cells, a
//! step apart, lie one behind the other at most. So there is one traction for each creepage, and for each force below
//! $`\mu P`$, and the [certificate](crate::cgm#the-certified-error) of the engine bounds
//! $`(q - q^*)' ((1 - T)\,C + B)\,(q - q^*)`$, relative to the same of q.
//!
//! # Accuracy and cost
//!
//! Sphere, $`\nu = 0.25`$, friction 0.3, the longitudinal creepage at which Kalker's linear theory reaches $`\mu P`$; cold,
//! to a tolerance of 1e-8, by the cells across the contact:
//!
//! | cells | 16 | 32 | 64 | 128 |
//! |---|---|---|---|---|
//! | $`F/\mu P`$ with the law | 0.7202 | 0.7204 | 0.7205 | 0.7205 |
//! | $`F/\mu P`$ without | 0.7477 | 0.7324 | 0.7262 | 0.7234 |
//! | products, cold | 46 | 62 | 83 | 114 |
//!
//! After one per cent more of the creepage a solve takes 27, 37, 49 and 64 products. The products are of double precision,
//! and each has an application of the preconditioner in single precision. A cold solve therefore takes the time of 1.0, 1.4
//! and 1.6 times as many products on 32, 64 and 128 cells.
//!
//! Of Carter's cylinder at 0.64 of the sliding force the force is wrong by 9e-5, 4e-5, 8e-6, 3e-6 and 4e-7 of
//! $`\mu P`$ on 32, 64, 128, 256 and 512 cells, without the law by 9e-3, 4e-3, 2e-3, 1e-3 and 6e-4. The law needs the
//! slope of the gap two cells ahead of the contact: leave the grid as much room.
//!
//! ```
//! use stickslip::rolling::RollingProblem;
//! use stickslip::*;
//! let grid = Grid::square(24, 3.0)?;
//! let body = Material::from_shear_modulus(1.0, 0.25)?;
//! let bodies = HalfSpace::new(grid, ElasticPair::new(body, body)?)?;
//! let (ball, load) = (surface::sphere(grid, 1.0)?, NormalControl::Force(1.0));
//! let normal = NormalProblem::builder(&bodies, &ball, load).build()?.solve()?;
//! // Small creepages: F = G a b C11 xi, with Kalker's C11 = 4.12.
//! let problem = RollingProblem::builder(&bodies, &normal, Friction::coulomb(0.3)?);
//! let rolling = problem.creepage([1e-5, 0.0]).build()?.solve()?;
//! let a = analytical::HertzSphere::new(bodies.pair(), 1.0, 1.0)?.contact_radius();
//! let coefficient = rolling.force()[0] / (a * a * 1e-5);
//! assert!((coefficient / 4.12 - 1.0).abs() < 0.02);
//! # Ok::<(), Error>(())
//! ```
//!
//! # Slip that turns
//!
//! The traction at the end of a step opposes the mean slip of the step. Under spin, or oblique creepage and $`\nu > 0`$, the
//! slip turns within the contact; the direction of the traction then lags by half a step, and forces converge
//! with first order. [`slip_corrections`](RollingProblemBuilder::slip_corrections) extrapolates the slip to the end of the
//! step, and the order becomes 1.5 to 2. Sphere, R = 1, G = 1, $`\nu = 0`$, W = 1.2, friction 0.3, free of creepage, $`F_y/\mu W`$ by the cells across the
//! contact:
//!
//! | spin, corrections | 12 | 24 | 48 | 96 | 192 |
//! |---|---|---|---|---|---|
//! | 0.3, none | 0.6012 | 0.5892 | 0.5820 | 0.5781 | 0.5761 |
//! | 0.3, two | 0.5818 | 0.5767 | 0.57478 | 0.57419 | 0.57402 |
//! | 1, none | 0.3486 | 0.3195 | 0.3035 | 0.2953 | 0.2911 |
//! | 1, two | 0.2925 | 0.2892 | 0.28763 | 0.28702 | 0.28687 |
//!
//! Without spin and across or along the rolling direction there is nothing to correct. Rolled steps of a
//! [`History`](crate::History) have no correction.
//!
//! Sources: J. J. Kalker, Three-dimensional elastic bodies in rolling contact (1990),
//! <https://doi.org/10.1007/978-94-015-7889-9>; the entry rule and the bound are derived here.

#[cfg(all(feature = "history", feature = "rolling"))]
mod coupled;
pub(crate) mod entry;
pub(crate) mod leading_edge;
mod passage;
#[cfg(feature = "rolling")]
mod steady;

#[doc(no_inline)]
pub use crate::tangential::entry_rule::EntryRule;
#[cfg(all(feature = "history", feature = "rolling"))]
#[cfg_attr(docsrs, doc(cfg(all(feature = "history", feature = "rolling"))))]
pub use coupled::{
    CoupledRollingProblem, CoupledRollingProblemBuilder, CoupledRollingReport,
    CoupledRollingSolution, CoupledRollingSolver,
};
#[doc(no_inline)]
pub use leading_edge::LeadingEdge;
pub(crate) use passage::{RollingShift, WindowShift};
#[cfg(feature = "rolling")]
#[cfg_attr(docsrs, doc(cfg(feature = "rolling")))]
pub use steady::control::{RollingControl, SpinControl};
#[cfg(feature = "rolling")]
#[cfg_attr(docsrs, doc(cfg(feature = "rolling")))]
pub use steady::creep::CreepForce;
#[cfg(feature = "rolling")]
#[cfg_attr(docsrs, doc(cfg(feature = "rolling")))]
pub use steady::problem::{RollingProblem, RollingProblemBuilder};
#[cfg(feature = "rolling")]
#[cfg_attr(docsrs, doc(cfg(feature = "rolling")))]
pub use steady::solution::RollingSolution;
#[cfg(feature = "rolling")]
#[cfg_attr(docsrs, doc(cfg(feature = "rolling")))]
pub use steady::solver::RollingSolver;
