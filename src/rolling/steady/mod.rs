//! Steady rolling: the problem, the solver and the solution.

pub(super) mod capacity;
pub(super) mod control;
pub(super) mod creep;
pub(super) mod inverse;
mod neglected_lift;
pub(super) mod options;
pub(super) mod problem;
mod reload;
mod resting_cell;
mod sliding_start;
mod slip_direction;
pub(super) mod slip_operator;
pub(super) mod solution;
pub(super) mod solver;
pub(super) mod spin_search;
pub(super) mod stiffness;
mod trend;
