//! Steady rolling: traction, slip and creepage of two bodies that roll over each other, in a frame that moves with the
//! contact.
//!
//! The contact is fixed in this frame. The particles of both surfaces enter it at the [leading edge](LeadingEdge) and move
//! through it. The distance $`d`$ per step is a whole number of cells. Let $`T f(x) = f(x + d)`$ be the value at the position of
//! a particle before the step. The slip of a cell over a step is
//!
//! ```math
//! s = (1 - T)\,(C q + u_p) + B q - w, \qquad
//! w = d \begin{pmatrix} \xi - \varphi\,y \\ \eta + \varphi\,x \end{pmatrix},
//! ```
//!
//! with the traction q on body 1, the creepages $`\xi, \eta`$ and the spin $`\varphi`$ about the origin of the grid. The
//! displacement $`u_p`$ due to the pressure is zero between bodies of the same material. Creepages and spin are per length
//! rolled, and x and y are the coordinates of the middle of the path of the particle. Coulomb's law is satisfied in every cell:
//! $`|q| \le \mu p`$, and the cell slips against the traction only if $`|q| = \mu p`$. A positive creepage moves body 2 along the
//! axis over body 1 and causes a positive force, as a positive [shift](crate::TangentialSolution::shift) does. Kalker's creepage
//! is the motion of body 1 over body 2. It has the opposite sign, and causes a force of the opposite sign on body 1.
//!
//! Along each axis either the creepage or the force is prescribed. If the force is prescribed, the same solve determines the
//! creepage as its multiplier. A moment can be prescribed instead of the spin.
//!
//! # Entering cells
//!
//! A particle ahead of the contact moves with the free surface. Its displacement is smaller than the displacement of a
//! sticking particle by B q, with $`B = \kappa\,g/p`$. Here g is the gap at the previous position of the particle. The pressure p
//! acts on the cell that the particle enters. The factor $`\kappa`$ varies from 1 across the edge of the contact to
//! $`1/(1 - \nu)`$ along the edge (for bodies of the same material). This is the entry rule of [growing
//! contacts](crate::guide::load_steps). The error of the force then decreases with the square of the cell size. Without
//! it ([`EntryRule::WholeStep`], as in CONTACT) the error decreases in proportion to the cell size.
//!
//! # Loads
//!
//! - [`RollingSolver::set_normal_load`] and [`RollingSolver::set_pressure`] set new normal contacts, as in the [time loop of a
//!   vehicle](crate::guide::rolling#vehicle-dynamics).
//! - [`RollingSolver::stiffness`] returns the derivatives of forces and moment with respect to creepages and spin.
//! - [`RollingSolver::creep_forces`] returns the points of creep curves and creep surfaces.
//! - [`SpinControl::Moment`] prescribes a moment instead of the spin. Several solves then determine the spin.
//!
//! # Bodies of different materials
//!
//! Tractions lift the surfaces of such bodies, and the pressure changes. A [`RollingProblem`] requires a given pressure, which
//! ignores the lift. Its solution then has the warning [`NeglectedLift`](crate::Warning::NeglectedLift). A
//! [`CoupledRollingProblem`] alternates between two solves: for the pressure over the lifted gap, and for the tractions under
//! this pressure. The passes were a contraction in all measured contacts. The table is for a sphere on a rigid plane ($`\nu`$ of
//! 0.45, 0.25 and 0) with R = 1, G = 1, W = 1 and 24 cells over 2.6 contact radii. The longitudinal creepage is 0.05, the spin is
//! 0.1, and the tolerance is 1e-9:
//!
//! | $`\beta`$ | $`\mu`$ | error of a pass divided by the error of the previous pass | passes | products |
//! |---|---|---|---|---|
//! | 0.09 | 0.1 | 0.01 | 6 | 311 |
//! | 0.33 | 1 | 0.13 | 12 | 412 |
//! | 0.5 | 0.3 | 0.13 | 15 | 745 |
//! | 0.5 | 1 | 0.22 | 21 | 810 |
//!
//! [`CoupledRollingReport`] contains a rigorous bound for each half, the residual of the coupling, and an estimate for the whole
//! coupled contact. [`CoupledRollingSolver::stiffness`] includes the effect of the tractions on the pressure.
//!
//! # Uniqueness and error
//!
//! The operator $`(1 - T) C`$ is not symmetric, but monotone. With the energy norm $`|e|_C^2 = e' C e`$ and fields e that are
//! zero outside the contact,
//!
//! ```math
//! e' (1 - T)\,C e = \tfrac12 |e - T e|_C^2 \ge \lambda \left(1 - \cos\frac{\pi}{m + 1}\right) |e|^2 ,
//! ```
//!
//! where $`\lambda`$ is a lower bound on the eigenvalues of C on a window one step longer than the contact. The number m is the
//! largest number of cells in a chain of cells that are one step apart. Therefore the traction is unique for each creepage, and
//! for each force below $`\mu P`$. The [certificate](crate::cgm#the-certified-error) of the solver bounds
//! $`(q - q^*)' ((1 - T)\,C + B)\,(q - q^*)`$, relative to the same form of q.
//!
//! # Accuracy and cost
//!
//! The table is for a sphere with $`\nu = 0.25`$, friction 0.3, and the longitudinal creepage at which Kalker's linear
//! theory ($`C_{11} = 4.12`$) reaches $`\mu P`$. The solves are cold (they start from zero tractions), with a tolerance of
//! 1e-8. The columns are the numbers of cells across the contact. The grid has four more cells on each side:
//!
//! | cells | 16 | 32 | 64 | 128 |
//! |---|---|---|---|---|
//! | $`F/\mu P`$ with the entry rule | 0.7202 | 0.7204 | 0.7205 | 0.7205 |
//! | $`F/\mu P`$ without the entry rule | 0.7477 | 0.7324 | 0.7262 | 0.7234 |
//! | products, cold | 48 | 66 | 84 | 116 |
//!
//! A product is one application of the compliance of both directions to the tractions of a window around the contact. All
//! products are computed in double precision, including the products that the report counts as [single-precision
//! products](crate::Report::single_precision_products). One application of the preconditioner in single precision follows each
//! product. After an increase of the creepage by one per cent, a solve takes 29, 41, 51 and 65 products.
//!
//! For Carter's cylinder at 0.64 of the sliding force, on 32, 64, 128, 256 and 512 cells, the errors of the force are 9e-5, 4e-5,
//! 8e-6, 3e-6 and 4e-7 of $`\mu P`$. Without the entry rule they are 9e-3, 4e-3, 2e-3, 1e-3 and 6e-4.
//!
//! The grid must extend beyond the leading edge by at least one step. Otherwise the problem is rejected
//! ([`Error::GridTooShort`](crate::Error::GridTooShort)). The entry rule also uses slopes of the gap around the previous
//! positions of entering particles, which need two more cells. If these cells are missing, the slopes are one-sided.
//!
//! ```
//! use stickslip::rolling::RollingProblem;
//! use stickslip::*;
//! let grid = Grid::square(24, 3.0)?;
//! let body = Material::from_shear_modulus(1.0, 0.25)?;
//! let bodies = HalfSpace::new(grid, ElasticPair::new(body, body)?)?;
//! let (ball, load) = (surface::sphere(grid, 1.0)?, NormalLoad::Force(1.0));
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
//! The traction at the end of a step opposes the mean slip of the step. Under spin, or under oblique creepage with
//! $`\nu > 0`$, the slip turns within the contact. The direction of the traction then lags by half a step, and the
//! forces converge with first order. [`slip_corrections`](RollingProblemBuilder::slip_corrections) extrapolates the
//! slip to the end of the step, and the order becomes 1.5 to 2. The table is for a sphere without creepage, with R = 1,
//! G = 1, $`\nu = 0`$, W = 1.2 and friction 0.3. It lists $`F_y/\mu W`$ by the number of cells across the contact:
//!
//! | spin, corrections | 12 | 24 | 48 | 96 | 192 |
//! |---|---|---|---|---|---|
//! | 0.3, none | 0.6012 | 0.5892 | 0.5820 | 0.5781 | 0.5761 |
//! | 0.3, two | 0.5818 | 0.5767 | 0.57478 | 0.57419 | 0.57402 |
//! | 1, none | 0.3486 | 0.3195 | 0.3035 | 0.2953 | 0.2911 |
//! | 1, two | 0.2925 | 0.2892 | 0.28763 | 0.28702 | 0.28687 |
//!
//! No correction is necessary without spin if the creepage is along or across the rolling direction. Rolling steps of a
//! [`History`](crate::History) have no correction.
//!
//! # Sources
//!
//! The formulation follows J. J. Kalker, Three-dimensional elastic bodies in rolling contact (1990),
//! <https://doi.org/10.1007/978-94-015-7889-9>. The entry rule and the bound are derived here.
//!
//! Line contacts were solved by Carter (1926) and by H. Fromm, Z. Angew. Math. Mech. 7 (1927) 27
//! ([`Carter`](crate::analytical::Carter)). D. J. Haines and E. Ollerton, Proc. Inst. Mech. Eng. 177 (1963) 95, divide an
//! ellipse into strips, each of which follows this solution. FASTSIM (J. J. Kalker, Vehicle Syst. Dyn. 11 (1982) 1,
//! <https://doi.org/10.1080/00423118208968684>) replaces the half-space by independent springs. The example `wheel` compares
//! it with this crate.

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
