//! Numbers that identify a state among the states of several histories.

use crate::history::LoopPoint;
use crate::history::state::State;

/// Forces and motion of a state. Two states of different contacts differ in one of these numbers, unless the contacts
/// are equal or not yet loaded.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub(in crate::history) struct StateMark {
    steps: u64,
    normal_force: f64,
    approach: f64,
    point: LoopPoint,
}

impl StateMark {
    pub(in crate::history) fn of(state: &State) -> Self {
        Self {
            steps: state.steps,
            normal_force: state.normal.force(),
            approach: state.approach(),
            point: LoopPoint::of(state),
        }
    }

    /// Returns the number of steps that led to the state.
    pub(in crate::history) fn steps(&self) -> u64 {
        self.steps
    }
}
