//! Coupled contacts, which determine pressure and tractions of bodies of different materials simultaneously.

mod problem;
mod report;
mod solution;
mod solver;

pub(crate) use problem::CoupledProblem;
pub(crate) use report::{CoupledReport, ErrorEstimate};
pub(crate) use solution::CoupledSolution;
pub(crate) use solver::CoupledSolver;
use solver::Loads;
