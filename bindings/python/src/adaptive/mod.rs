//! Contacts that are solved to a required accuracy.

mod gap;
mod problem;
mod region;
mod solution;
mod target;

pub(crate) use problem::AdaptiveProblem;
pub(crate) use region::Region;
pub(crate) use solution::{AdaptiveSolution, GridRecord};
