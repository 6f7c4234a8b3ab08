//! Extrapolation of the solution in the load, for the start of the next solve.

use crate::grid::field::clone_in_place;
use crate::memory::fallible::try_clone;

/// Maximum ratio of a change to the last change for which the solution is extrapolated.
const FARTHEST: f64 = 3.0;

/// Ratio to the last change below which a change counts as round-off.
const NO_PART: f64 = 1e-9;

/// Sum of a component of the unknowns (or the force that it causes), and motion along this component (approach or shift).
pub(crate) type LoadPoint = [f64; 2];

/// Change of the unknowns on a window in the last solve with a changed load, and the change of the load.
#[derive(Debug)]
pub(crate) struct LoadTrend<const N: usize> {
    /// Change of every cell. The vectors are empty before the first change.
    pub(crate) change: [Vec<f64>; N],
    /// Change of sum and motion along each component. A change that cannot be used is zero.
    pub(crate) by: [LoadPoint; N],
}

clone_in_place!(LoadTrend<const N: usize> { change, by });

try_clone!(LoadTrend<const N: usize> { change } { by });

/// Trends without a change of the load are equal, because no solve uses them.
impl<const N: usize> PartialEq for LoadTrend<N> {
    fn eq(&self, other: &Self) -> bool {
        self.by == other.by && (!self.is_known() || self.change == other.change)
    }
}

impl<const N: usize> Default for LoadTrend<N> {
    fn default() -> Self {
        Self {
            change: [const { Vec::new() }; N],
            by: [[0.0; 2]; N],
        }
    }
}

/// Remaining change of a component of the load.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum LoadIncrement {
    /// The component is not prescribed.
    Nothing,
    /// Change of the sum (or force).
    Total(f64),
    /// Change of the motion.
    Motion(f64),
    /// Change of the position of the far end of a spring of this stiffness.
    Spring { far_end: f64, stiffness: f64 },
}

impl LoadIncrement {
    /// Returns the change as a multiple of the last change.
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
    /// Discards the change but keeps the memory.
    pub(crate) fn forget(&mut self) {
        for change in &mut self.change {
            change.clear();
        }
        self.by = [[0.0; 2]; N];
    }

    /// Returns whether a change of the load is stored.
    pub(crate) fn is_known(&self) -> bool {
        self.by.as_flattened().iter().any(|by| *by != 0.0)
    }

    /// Returns the change of the load as a multiple of the last change, negative if it reverses. The components are averaged with
    /// the squares of the changes of their sums as weights. Returns `None` if the multiple is too small or too large for an
    /// extrapolation.
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
