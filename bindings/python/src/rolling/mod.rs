//! Steady rolling.

mod control;
mod coupled;
mod creep;
mod problem;
mod solution;
mod solver;

pub(crate) use coupled::{
    CoupledRollingProblem, CoupledRollingReport, CoupledRollingSolution, CoupledRollingSolver,
};
pub(crate) use creep::{CreepForce, CreepForces};
pub(crate) use problem::RollingProblem;
pub(crate) use solution::RollingSolution;
pub(crate) use solver::RollingSolver;
