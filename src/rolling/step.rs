//! Differences over a step, and sums of them, on the way of particles through a window.

use crate::history::Passage;

impl Passage {
    /// `(1 - T) f` in place; zero in cells whose particles come from beyond the window.
    pub(super) fn difference(&self, field: &mut [f64]) {
        self.sweep(self.edge.is_positive(), |cell, before| {
            field[cell] = before.map_or(0.0, |before| field[cell] - field[before]);
        });
    }

    /// The sum from the leading edge on, the inverse of `1 - T` for fields that vanish there, in place.
    pub(super) fn sum(&self, field: &mut [f64]) {
        self.sweep(!self.edge.is_positive(), |cell, before| {
            field[cell] += before.map_or(0.0, |before| field[before]);
        });
    }

    /// A cell that is the last on its particles' way.
    pub(super) fn trailing_cell(&self) -> usize {
        if self.edge.is_positive() {
            0
        } else {
            self.size[0] * self.size[1] - 1
        }
    }

    /// Visits the cells in the order of their places along the axis, each with that of its particle before.
    fn sweep(&self, is_ascending: bool, mut visit: impl FnMut(usize, Option<usize>)) {
        let cells = 0..self.size[0] * self.size[1];
        let visit = |cell: usize| visit(cell, self.before(cell));
        if is_ascending {
            cells.for_each(visit);
        } else {
            cells.rev().for_each(visit);
        }
    }

    /// The most cells, a step apart, that lie one behind the other where `length` cells do along the axis.
    pub(super) fn chain(&self, length: usize) -> usize {
        length.div_ceil(self.cells)
    }
}
