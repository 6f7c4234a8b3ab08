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
//! [`NormalProblem`] validates and stores the input. [`NormalSolver`] owns the buffers and starts each solve from its
//! last solution. [`NormalSolution`] is the result.
//!
//! The example `hardness` plots:
#![cfg_attr(doc, doc = include_str!("../pictures/hardness.html"))]

mod area;
mod hardness;
mod over_ranks;
mod pressure_problem;
mod pressure_solver;
mod problem;
mod scale;
mod solution;
mod solver;
mod window_solver;

pub use hardness::Hardness;
pub(crate) use pressure_solver::{NormalInput, PressureSolver};
pub use problem::{NormalControl, NormalProblem, NormalProblemBuilder};
pub(crate) use scale::Scale;
pub use solution::NormalSolution;
pub use solver::NormalSolver;
