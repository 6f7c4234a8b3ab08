//! Tangential contact under a given pressure.

pub(crate) mod pressure;
mod problem;
mod relative;
mod solution;
mod solver;
mod superposition;

pub(crate) use problem::TangentialProblem;
pub(crate) use relative::RelativeDisplacement;
pub(crate) use solution::TangentialSolution;
pub(crate) use solver::TangentialSolver;
pub(crate) use superposition::JaegerSuperposition;
