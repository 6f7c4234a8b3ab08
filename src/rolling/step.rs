//! Differences over a step, and sums of them, on the way of particles through a window.

use crate::history::Passage;

/// Lines that are summed at once.
const LINES: usize = 4;

impl Passage {
    /// `(1 - T) f` in place; zero in cells whose particles come from beyond the window.
    pub(super) fn difference(&self, field: &mut [f64]) {
        let [line, way] = self.line();
        for line in field.chunks_exact_mut(line) {
            let (cells, way) = (line.len(), way.min(line.len()));
            if self.edge.is_positive() {
                for cell in 0..cells - way {
                    line[cell] -= line[cell + way];
                }
                line[cells - way..].fill(0.0);
            } else {
                for cell in (way..cells).rev() {
                    line[cell] -= line[cell - way];
                }
                line[..way].fill(0.0);
            }
        }
    }

    /// The sum from the leading edge on, the inverse of `1 - T` for fields that vanish there, in place.
    pub(super) fn sum(&self, field: &mut [f64]) {
        let [line, way] = self.line();
        // Several lines at once, so that additions overlap.
        for lines in field.chunks_mut(LINES * line) {
            for place in way..line {
                let (at, before) = if self.edge.is_positive() {
                    (line - 1 - place, line - 1 - place + way)
                } else {
                    (place, place - way)
                };
                for line in lines.chunks_exact_mut(line) {
                    line[at] += line[before];
                }
            }
        }
    }

    /// A cell that is the last on its particles' way.
    pub(super) fn trailing_cell(&self) -> usize {
        if self.edge.is_positive() {
            0
        } else {
            self.size[0] * self.size[1] - 1
        }
    }

    /// The most cells, a step apart, that lie one behind the other where `length` cells do along the axis.
    pub(super) fn chain(&self, length: usize) -> usize {
        length.div_ceil(self.cells)
    }
}
