//! Normal contact: pressure and contact area under a force or an approach.
//!
//! ```math
//! g = h + C_{zz}\,p - \delta \ge 0, \qquad p \ge 0, \qquad p\,g = 0,
//! \qquad W = \Delta \textstyle\sum p
//! ```
//!
//! (eqs 10-12 of Wang et al. 2021). Here `h` is the initial gap, `p` the pressure and `delta` the approach of the
//! bodies. `g` is the gap under load, and `Delta` is the area of a cell. Under a force, the pressure minimises
//! `1/2 p'Cp + h'p` over `p >= 0` with `Delta sum p = W`. Under an approach, it minimises `1/2 p'Cp + (h - delta)'p`
//! over `p >= 0`. The active-set method of [`crate::cgm`] computes the pressure. With a [`Hardness`] H the pressure is
//! at most H, and cells at the limit overlap.
//!
//! This is the minimum principle of Kalker and van Randen, J. Eng. Math. 6 (1972) 193. Stanley and Kato, J. Tribology
//! 119 (1997) 481, <https://doi.org/10.1115/1.2833523>, solved it on periodic grids with Fourier transforms. Müser et
//! al., Tribol. Lett. 65 (2017) 118, <https://doi.org/10.1007/s11249-017-0900-2>, compare methods for rough contacts with
//! adhesion, which this crate does not model (Contact-Mechanics Challenge).
//!
//! # Assumptions
//!
//! - Bodies are linear elastic half-spaces, with small strains and small slopes. A solution has a
//!   [warning](NormalSolution::warnings) if the contact radius exceeds 0.3 of the radius of curvature, or if the rms slope within
//!   the contact exceeds 0.5. Both limits are conventional and do not bound an error.
//! - Loads are quasi-static: the contact has no inertia and no viscosity, and its state does not depend on the rate.
//! - Surfaces do not adhere, and do not overlap except at their hardness.
//! - On a periodic grid under a prescribed approach, the [certified bound](crate::Report::duality_gap) is relative to the
//!   contact under the computed force.
//!
//! [`NormalProblem`] validates and stores the input. [`NormalSolver`] owns the buffers and starts each solve from its
//! last solution. [`NormalSolution`] is the result.
//!
//! The example `hardness` plots:
#![cfg_attr(doc, doc = include_str!("../pictures/hardness.html"))]

mod area;
mod closed_gap;
mod gap_change;
mod hardness;
mod load;
mod over_ranks;
mod pressure_problem;
mod pressure_solver;
mod problem;
mod scale;
mod seam;
mod solution;
mod solver;
mod window_solver;

#[cfg(feature = "history")]
pub(crate) use gap_change::LoadedCell;
pub(crate) use gap_change::{GapChange, LastGap, PressedGap};
pub use hardness::Hardness;
pub use load::{NormalControl, NormalLoad};
pub(crate) use pressure_solver::{NormalInput, PressureSolver};
pub use problem::{NormalProblem, NormalProblemBuilder};
pub(crate) use scale::Scale;
pub use solution::NormalSolution;
pub use solver::NormalSolver;
