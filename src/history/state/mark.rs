//! Numbers that identify a state among the states of several histories.

use crate::history::LoopPoint;
use crate::history::state::State;

/// Forces and motion of a state, and a digest of the input of its history. Two states of different contacts differ in one of
/// these numbers. Equality ignores the digest, because saved marks do not contain it.
#[derive(Debug, Clone, Copy)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub(in crate::history) struct StateMark {
    steps: u64,
    normal_force: f64,
    approach: f64,
    point: LoopPoint,
    /// Digest of the input of the history, or `None` if the state was read from bytes.
    #[cfg_attr(feature = "serde", serde(skip))]
    origin: Option<u64>,
}

impl PartialEq for StateMark {
    fn eq(&self, other: &Self) -> bool {
        self.steps == other.steps
            && self.normal_force == other.normal_force
            && self.approach == other.approach
            && self.point == other.point
    }
}

impl StateMark {
    pub(in crate::history) fn of(state: &State) -> Self {
        Self {
            steps: state.steps,
            normal_force: state.normal.force(),
            approach: state.approach(),
            point: LoopPoint::of(state),
            origin: state.origin,
        }
    }

    /// Returns the number of steps that led to the state.
    pub(in crate::history) fn steps(&self) -> u64 {
        self.steps
    }

    /// Returns whether both marks belong to the same state of one history.
    pub(in crate::history) fn is_same(&self, other: &Self) -> bool {
        let origins = self.origin.zip(other.origin);
        self == other && origins.is_none_or(|(own, other)| own == other)
    }
}
