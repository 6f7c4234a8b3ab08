//! How an answer changed with its load: where the next solve starts.

use crate::grid::field::clone_in_place;
use crate::memory::fallible::try_clone;

/// Beyond so many times the last change nothing is extrapolated.
const FARTHEST: f64 = 3.0;

/// Parts of the last change that are round-off.
const NO_PART: f64 = 1e-9;

/// Sum of a component of the unknowns (or the force it makes), and motion (approach or shift) along it.
pub(crate) type LoadPoint = [f64; 2];

/// The change of the unknowns on a window in the last solve in which the load changed, and what changed it.
#[derive(Debug)]
pub(crate) struct LoadTrend<const N: usize> {
    /// Of every cell; empty before there is one.
    pub(crate) change: [Vec<f64>; N],
    /// Of what was reached along each component; zero if nothing can be told from it.
    pub(crate) by: [LoadPoint; N],
}

clone_in_place!(LoadTrend<const N: usize> { change, by });

try_clone!(LoadTrend<const N: usize> { change } { by });

impl<const N: usize> Default for LoadTrend<N> {
    fn default() -> Self {
        Self {
            change: [const { Vec::new() }; N],
            by: [[0.0; 2]; N],
        }
    }
}

/// How much further a component of the load is to go.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum LoadIncrement {
    /// It is not prescribed.
    Nothing,
    /// In sum (or force).
    Total(f64),
    /// In motion.
    Motion(f64),
    /// In the position of the far end of a spring of this stiffness.
    Spring { far_end: f64, stiffness: f64 },
}

impl LoadIncrement {
    /// The same in units of a change.
    fn parts(self, [by_total, by_motion]: LoadPoint) -> f64 {
        match self {
            Self::Nothing => 0.0,
            Self::Total(total) => total / by_total,
            Self::Motion(motion) => motion / by_motion,
            Self::Spring { far_end, stiffness } => far_end / (by_motion + by_total / stiffness),
        }
    }
}

impl<const N: usize> LoadTrend<N> {
    /// Forgets the change; keeps the memory.
    pub(crate) fn forget(&mut self) {
        for change in &mut self.change {
            change.clear();
        }
        self.by = [[0.0; 2]; N];
    }

    /// Whether something is known of what changed.
    pub(crate) fn is_known(&self) -> bool {
        self.by.as_flattened().iter().any(|by| *by != 0.0)
    }

    /// How many times the last change the load lies ahead, negative if it goes back: the mean of the components, by the
    /// squares of the changes of their sums. `None` where the trend does not lead there, or too far.
    pub(crate) fn parts(&self, ahead: [LoadIncrement; N]) -> Option<f64> {
        let (mut parts, mut squares) = (0.0, 0.0);
        for (ahead, by) in ahead.into_iter().zip(self.by) {
            let square = by[0] * by[0];
            if square > 0.0 {
                parts += square * ahead.parts(by);
                squares += square;
            }
        }
        if squares == 0.0 {
            return None;
        }
        let parts: f64 = parts / squares;
        (NO_PART..=FARTHEST).contains(&parts.abs()).then_some(parts)
    }
}
