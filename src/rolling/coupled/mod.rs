//! Steady rolling of bodies of different materials, with pressure and tractions coupled both ways.

mod problem;
mod report;
mod setters;
mod solution;
mod solver;
mod stiffness;

pub use problem::{CoupledRollingProblem, CoupledRollingProblemBuilder};
pub use report::CoupledRollingReport;
pub use solution::CoupledRollingSolution;
pub use solver::CoupledRollingSolver;
