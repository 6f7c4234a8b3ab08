//! Where the components of a vector lie: one traction along an axis, or both in the plane.

use crate::tangential::Axis;

/// Components of the cells of a window: all of the first axis, then all of the second, if there is one.
#[derive(Debug, Clone, Copy)]
pub(super) struct Layout {
    pub(super) axes: &'static [Axis],
    pub(super) cells: usize,
}

/// The axes along which there are tractions: one, or both in the plane.
pub(super) fn axes_of(axis: Option<Axis>) -> &'static [Axis] {
    match axis {
        Some(Axis::X) => &[Axis::X],
        Some(Axis::Y) => &[Axis::Y],
        None => &[Axis::X, Axis::Y],
    }
}

impl Layout {
    /// Along an axis, or in the plane.
    pub(super) fn new(axis: Option<Axis>, cells: usize) -> Self {
        let axes = axes_of(axis);
        Self { axes, cells }
    }

    /// Numbers in a vector.
    pub(super) fn len(self) -> usize {
        self.axes.len() * self.cells
    }

    /// `[x, y]` of a cell, zero where there is none.
    pub(super) fn at(self, vector: &[f64], cell: usize) -> [f64; 2] {
        let mut value = [0.0; 2];
        for (place, axis) in self.axes.iter().enumerate() {
            value[axis.index()] = vector[place * self.cells + cell];
        }
        value
    }

    /// Puts `[x, y]` into a cell.
    pub(super) fn set(self, vector: &mut [f64], cell: usize, value: [f64; 2]) {
        for (place, axis) in self.axes.iter().enumerate() {
            vector[place * self.cells + cell] = value[axis.index()];
        }
    }

    /// The components one by one, with their axes.
    pub(super) fn parts(self, vector: &[f64]) -> impl Iterator<Item = (&'static Axis, &[f64])> {
        self.axes.iter().zip(vector.chunks_exact(self.cells))
    }

    /// The components one by one, with their axes.
    pub(super) fn parts_mut(
        self,
        vector: &mut [f64],
    ) -> impl Iterator<Item = (&'static Axis, &mut [f64])> {
        self.axes.iter().zip(vector.chunks_exact_mut(self.cells))
    }
}
