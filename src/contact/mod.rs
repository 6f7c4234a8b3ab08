//! Common modules of normal, tangential and coupled contacts. They contain the solver of the half-space, the loop over
//! windows, and starts from coarser grids and from earlier solutions. They also contain the limits shared by the passes of a
//! solve, and the solver of all kinds of contacts.

pub(crate) mod contact_counts;
pub(crate) mod fragments;
pub(crate) mod map;
pub(crate) mod pressure_fingerprint;

mod elastic_solver;
mod extrapolation;
mod limits;
mod nested_start;
mod responses;
mod size_cache;
mod solver;
mod windows;

pub(crate) use elastic_solver::{ElasticProblem, ElasticSolver, multipliers};
pub(crate) use extrapolation::{LoadIncrement, LoadPoint, LoadTrend};
pub(crate) use limits::{
    Cancellation, SolveContext, has_iterate, interrupted_status, with_counts_of, within_time,
};
pub(crate) use nested_start::{
    GridTransfer, MultilevelProblem, is_worth_coarsening, known_of_start, nested_start,
};
pub(crate) use responses::{Elasticity, LinearResponse, ResponseColumn, ResponseContext};
pub(crate) use size_cache::{HasSize, SizeCache};
pub use solver::{Contact, Solver};
pub(crate) use solver::{Model, model_fields};
pub(crate) use windows::{PassOutcome, WindowEngine, Windows, overlap_outside};
