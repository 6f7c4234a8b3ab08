//! Range of the motion over several steps.

use crate::grid::Grid;
use crate::tangential::RigidMotion;
use crate::warning::Warning;

/// Range of shift and twist over consecutive steps in contact that do not roll.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub(in crate::history) struct MotionRange {
    /// Least and largest shift along x and y and twist, or `None` without such a step.
    ends: Option<[[f64; 3]; 2]>,
}

impl MotionRange {
    /// Adds a step between two motions.
    pub(in crate::history) fn extend(&mut self, from: RigidMotion, to: RigidMotion) {
        for RigidMotion {
            shift: [x, y],
            twist,
        } in [from, to]
        {
            let motion = [x, y, twist];
            let [least, largest] = self.ends.unwrap_or([motion; 2]);
            self.ends = Some([
                std::array::from_fn(|i| motion[i].min(least[i])),
                std::array::from_fn(|i| motion[i].max(largest[i])),
            ]);
        }
    }

    /// Removes all steps.
    pub(in crate::history) fn restart(&mut self) {
        self.ends = None;
    }

    /// Returns the larger range of the shift along x and y over the side of the grid, and the range of the twist, in tenths. Small ranges are `None`.
    pub(in crate::history) fn tenths(&self, grid: Grid) -> [Option<usize>; 2] {
        let Some([least, largest]) = self.ends else {
            return [None; 2];
        };
        let [x, y, twist] = std::array::from_fn(|i| largest[i] - least[i]);
        [
            Warning::shift_beyond(grid, [x.max(y), 0.0]),
            Warning::twist_beyond(twist),
        ]
    }
}
