//! What normal, tangential and coupled contacts have in common: the loop over windows, starts from coarser cells, and what
//! the passes of a solve may take together.

mod budget;
mod nested_start;
mod solver;
mod windows;

pub(crate) use budget::{Conditions, ended_from_outside, with_counts_of, with_memory};
pub(crate) use nested_start::{Levels, Scene, is_worth_coarsening, nested_start};
pub(crate) use solver::solver_methods;
pub(crate) use windows::{OnWindow, Seen, Windows, missed};
