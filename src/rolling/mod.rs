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
//! [growing contacts](crate::guide::growing_contacts). With it the error of the force falls with the square of the size of
//! the cells, without it ([`TouchRule::WholeStep`](crate::history::TouchRule::WholeStep), as CONTACT) in proportion.
//!
//! # Loads
//!
//! [`RollingSolver::stiffness`] has the derivatives of forces and moment by creepages and spin,
//! [`RollingSolver::creep_forces`] creep curves and surfaces as numbers for a table, [`SpinControl::Moment`] prescribes a
//! moment in place of the spin: the spin is then found by several solves.
//!
//! # Uniqueness and error
//!
//! $`(1 - T) C`$ is not symmetric, but monotone: with the energy norm $`|e|_C^2 = e' C e`$ and fields e that are zero
//! outside the contact,
//!
//! ```math
//! e' (1 - T)\,C e = \tfrac12 |e - T e|_C^2 \ge \lambda \left(1 - \cos\frac{\pi}{m + 1}\right) |e|^2 ,
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
//! | products, cold | 49 | 70 | 93 | 135 |
//!
//! After one per cent more of the creepage a solve takes 28, 39, 51 and 72 products. The products are of double precision,
//! the preconditioner of single precision: together a cold solve takes the time of 71, 130 and 212 products on 32, 64 and
//! 128 cells.
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
//! Sources: J. J. Kalker, Three-dimensional elastic bodies in rolling contact (1990),
//! <https://doi.org/10.1007/978-94-015-7889-9>; the law of entering cells and the bound are derived here.

mod capacity;
mod control;
mod creep;
mod inverse;
mod operator;
mod problem;
mod resting_cell;
mod sliding_start;
mod solution;
mod solver;
mod spin_search;
mod step;
mod stiffness;

pub use crate::history::LeadingEdge;
pub use control::{RollingControl, SpinControl};
pub use creep::CreepForce;
pub use problem::{RollingProblem, RollingProblemBuilder};
pub use solution::RollingSolution;
pub use solver::RollingSolver;
