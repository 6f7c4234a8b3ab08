//! Rigid motion of one body relative to the other.

use crate::grid::Grid;

/// Motion of body 2 relative to body 1 since the start: a shift, and a rotation about the origin of the grid.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub(crate) struct RigidMotion {
    pub(crate) shift: [f64; 2],
    /// Rotation in radians, positive from x to y.
    pub(crate) twist: f64,
}

impl RigidMotion {
    /// Returns the displacement of a point.
    #[inline]
    pub(crate) fn at(self, [x, y]: [f64; 2]) -> [f64; 2] {
        [
            self.shift[0] - self.twist * y,
            self.shift[1] + self.twist * x,
        ]
    }

    /// Returns the motion from `before` to `self`.
    pub(crate) fn since(self, before: Self) -> Self {
        Self {
            shift: [0, 1].map(|axis| self.shift[axis] - before.shift[axis]),
            twist: self.twist - before.twist,
        }
    }
}

/// Returns the centre of a cell.
pub(crate) fn centre(grid: Grid, index: usize) -> [f64; 2] {
    [grid.x(index % grid.nx()), grid.y(index / grid.nx())]
}
