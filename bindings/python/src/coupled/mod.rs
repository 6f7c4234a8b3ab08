//! Pressure and traction found together, of bodies of different materials.

mod problem;
mod report;
mod solution;
mod solver;

pub(crate) use problem::CoupledProblem;
pub(crate) use report::{CoupledReport, ErrorEstimate};
pub(crate) use solution::CoupledSolution;
pub(crate) use solver::CoupledSolver;
