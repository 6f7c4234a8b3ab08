//! Normal contact.

mod hardness;
mod problem;
mod solution;
mod solver;

pub(crate) use hardness::{AnyHardness, Hardness};
pub(crate) use problem::NormalProblem;
pub(crate) use solution::NormalSolution;
pub(crate) use solver::NormalSolver;
