//! What normal, tangential and coupled contacts have in common: the half-space posed to the engine, the loop over windows,
//! starts from coarser cells and from earlier answers, and what the passes of a solve may take together.

pub(crate) mod map;
pub(crate) mod survey;

mod by_size;
mod elastic_solver;
mod extrapolation;
mod limits;
mod nested_start;
mod solver;
mod windows;

pub(crate) use by_size::{BySize, OfSize};
pub(crate) use elastic_solver::{ElasticProblem, ElasticSolver, multipliers};
pub(crate) use extrapolation::{Ahead, Reached, Trend};
pub(crate) use limits::{
    Cancellation, Conditions, ended_from_outside, has_iterate, with_counts_of,
};
pub(crate) use nested_start::{Levels, Scene, is_worth_coarsening, known_of_start, nested_start};
pub(crate) use solver::solver_methods;
pub(crate) use windows::{OnWindow, Seen, Windows, missed};
