//! Partial slip: shear traction, stick and slip under a tangential load with Coulomb friction.
//!
//! ```math
//! s = C\,q - \delta, \qquad |q| \le m, \qquad
//! s = 0 \text{ where } |q| < m, \qquad q\,s \le 0 \text{ where } |q| = m,
//! \qquad F = \Delta \textstyle\sum q
//! ```
//!
//! (eqs 13-16 of Wang et al. 2021). Here `q` is the traction on body 1 along one axis, and `C` is `C_xx` or `C_yy`. `delta` is
//! the shift of the bodies, which the literature calls the relative rigid tangential displacement. `s` is the slip, also called
//! relative slip or microslip. `m = min(mu p, tau_max)` is the friction limit of each cell, and `Delta` is the area of a cell.
//! Consider one monotonic load step with a pressure that shear does not change. If the force is prescribed, the traction
//! minimises `1/2 q'Cq` over `|q| <= m` with `Delta sum q = F`. If the shift is prescribed, the traction minimises
//! `1/2 q'Cq - delta sum q` over `|q| <= m`.
//!
//! The traction across the load is neglected, as in Wang et al. (2021), except in [`TangentialModel::Vector`]. This
//! model solves for both components:
//!
//! ```math
//! s = \begin{pmatrix} C_{xx} & C_{xy} \\ C_{xy} & C_{yy} \end{pmatrix} q - \delta, \qquad |q| \le m, \qquad
//! s = 0 \text{ where } |q| < m, \qquad s = -|s|\,q/m \text{ where } |q| = m .
//! ```
//!
//! The next table lists the effect of neglecting the traction across the load. The contact is a sphere under the same
//! shift in both models, at 0.1, 0.4 and 0.9 of the sliding force:
//!
//! | Poisson's ratio | traction across / largest limit | its largest angle | relative change of the force | changed zones |
//! |---|---|---|---|---|
//! | 0 | 0 | 0 | 0 | 0 |
//! | 0.29 | 1.3, 2.7, 3.7 % | 7.2 degrees | 6e-5, 2.4e-4, 4.7e-4 | 8 of 3200 cells at 0.9 |
//! | 0.5 | 2.5, 5.4, 7.4 % | 14.6 degrees | 2.4e-4, 9e-4, 1.8e-3 | 20 of 3200 cells at 0.9 |
//!
//! # Assumptions
//!
//! - Friction is quasi-static and independent of the rate. A cell has one [coefficient](Friction), for sticking and for
//!   sliding (static equals kinetic).
//! - Tractions do not enlarge the contact: there is no junction growth and no adhesion.
//! - The shift does not move the gap. It must be small compared with the contact, and on rough surfaces compared with
//!   the shortest wave. For larger shifts, a [`History`](crate::History) takes a [new gap](crate::History::set_gap) in
//!   each step.
//! - The assumptions of the [normal contact](crate::normal#assumptions) apply.
//!
//! Under a force oblique to the surface, normal and tangential force grow together. For elastic bodies of the same material such
//! a contact does not slip if $`F/W < \mu`$ (Mindlin and Deresiewicz, J. Appl. Mech. 20 (1953) 327,
//! <https://doi.org/10.1115/1.4010702>, for spheres; Deresiewicz, J. Appl. Mech. 24 (1957) 623, for nonspherical bodies). A
//! problem of this module applies the tangential load after the normal load. A [`History`](crate::History) applies both together.
//!
//! [`TangentialProblem`] validates and stores the input. [`TangentialSolver`] owns the buffers and starts each solve
//! from its last solution. [`TangentialSolution`] is the result, with one [`Zone`] per cell. [`JaegerSuperposition`] is
//! the exact solution if the tangential compliance is proportional to the normal compliance.
//!
//! The example `sphere` plots:
#![cfg_attr(doc, doc = include_str!("../pictures/sphere.html"))]

#[cfg(any(feature = "spots", feature = "stiffness", feature = "subsurface"))]
mod consistency;
pub(crate) mod entry_rule;
mod friction;
mod friction_limits;
mod friction_problem;
mod friction_scale;
mod increment;
#[cfg(feature = "analytical")]
mod jaeger;
mod lifting;
mod load;
mod offset;
mod one_way;
mod over_ranks;
mod pressure_source;
mod problem;
mod relative_displacement;
mod rigid_motion;
mod solution;
mod solver;
mod step_solution;
mod traction_solver;
mod zone;

pub(crate) use entry_rule::EntryRule;
pub(crate) use entry_rule::{
    EntryCompliance, EntryCompliances, entry_compliance, ratios_of_compliances,
};
pub use friction::Friction;
pub(crate) use friction::FrictionWithin;
pub(crate) use friction_limits::{PressureOnWindow, SLIDING, is_at_limit};
pub(crate) use friction_problem::{prolongated_traction, reserve};
pub(crate) use friction_scale::FrictionScale;
pub(crate) use increment::{Start, TangentialIncrement};
#[cfg(feature = "analytical")]
#[cfg_attr(docsrs, doc(cfg(feature = "analytical")))]
pub use jaeger::JaegerSuperposition;
pub(crate) use lifting::{Lifting, lift_residual};
pub(crate) use load::TangentialTarget;
pub use load::{TangentialControl, TangentialLoad};
pub(crate) use offset::{Offsets, carry_offsets};
pub(crate) use one_way::CouplingDisplacement;
pub use pressure_source::PressureSource;
pub(crate) use pressure_source::{check_bodies, contact_window};
pub use problem::{TangentialProblem, TangentialProblemBuilder};
pub use relative_displacement::RelativeDisplacement;
pub(crate) use rigid_motion::{RigidMotion, centre};
pub use solution::TangentialSolution;
pub use solver::TangentialSolver;
pub(crate) use step_solution::StepSolution;
pub(crate) use traction_solver::{TangentialVector, at, check_axes, displacement, zeros};
pub use zone::{Axis, TangentialModel, Zone};
