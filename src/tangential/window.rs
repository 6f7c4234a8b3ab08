//! The smallest rectangle of cells around a contact.

use crate::error::{Error, Result};
use crate::grid::Grid;

/// A rectangle of cells of a grid.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Window {
    columns: usize,
    corner: [usize; 2],
    pub(super) size: [usize; 2],
}

impl Window {
    /// Around all cells that carry pressure.
    ///
    /// # Errors
    /// [`Error::EmptyContact`] if none does.
    pub(super) fn around(grid: Grid, pressure: &[f64]) -> Result<Self> {
        let (mut low, mut high) = ([usize::MAX; 2], [0; 2]);
        for (iy, row) in pressure.chunks_exact(grid.nx()).enumerate() {
            let first = row.iter().position(|&p| p > 0.0);
            let last = row.iter().rposition(|&p| p > 0.0);
            if let (Some(first), Some(last)) = (first, last) {
                low = [low[0].min(first), low[1].min(iy)];
                high = [high[0].max(last), iy];
            }
        }
        if low[0] == usize::MAX {
            return Err(Error::EmptyContact);
        }
        Ok(Self {
            columns: grid.nx(),
            corner: low,
            size: [high[0] - low[0] + 1, high[1] - low[1] + 1],
        })
    }

    pub(super) fn cells(&self) -> usize {
        self.size[0] * self.size[1]
    }

    /// Index in the whole grid of the first cell of a row of the window.
    fn row_start(&self, row: usize) -> usize {
        (self.corner[1] + row) * self.columns + self.corner[0]
    }

    /// Indices in the whole grid, in the order of the window.
    pub(super) fn indices(&self) -> impl Iterator<Item = usize> + use<> {
        let window = *self;
        (0..window.size[1]).flat_map(move |row| {
            let start = window.row_start(row);
            start..start + window.size[0]
        })
    }
}
