//! Selection of the middle of a larger field.

use std::f64::consts::PI;

use crate::error::Result;
use crate::grid::Grid;
use crate::grid::field::Field;

/// Middle part of a periodic field, or the whole field.
#[derive(Debug, Clone, Copy)]
pub(super) struct CropWindow {
    /// Grid of the periodic field.
    pub(super) whole: Grid,
    /// Grid of the selected part.
    pub(super) part: Grid,
    /// First cell of the selected part in the whole field.
    pub(super) first: [usize; 2],
}

impl CropWindow {
    /// Selects the whole periodic field.
    pub(super) fn all(grid: Grid) -> Self {
        Self {
            whole: grid,
            part: grid,
            first: [0, 0],
        }
    }

    /// Selects the middle of a periodic field with twice the side lengths and the same cell size.
    pub(super) fn middle(grid: Grid) -> Result<Self> {
        let [nx, ny] = [grid.nx(), grid.ny()];
        let twice = |n: usize| n.saturating_mul(2);
        Ok(Self {
            whole: Grid::new(twice(nx), twice(ny), grid.dx(), grid.dy())?,
            part: grid,
            first: [nx / 2, ny / 2],
        })
    }

    /// Returns the selected part of a field.
    pub(super) fn of(&self, whole: &Field) -> Field {
        let mut part = Field::zeros(self.part);
        let nx = self.part.nx();
        let rows = whole.rows().skip(self.first[1]);
        for (row, out) in rows.zip(part.as_mut_slice().chunks_exact_mut(nx)) {
            out.copy_from_slice(&row[self.first[0]..][..nx]);
        }
        part
    }

    /// Embeds the selected part in the whole field. The other cells are zero.
    pub(super) fn padded(&self, part: &Field) -> Field {
        let mut whole = Field::zeros(self.whole);
        let rows = whole.as_mut_slice().chunks_exact_mut(self.whole.nx());
        for (row, out) in part.rows().zip(rows.skip(self.first[1])) {
            out[self.first[0]..][..row.len()].copy_from_slice(row);
        }
        whole
    }

    /// Returns the phase of a wave in the first cell of the whole field. The wave has the given numbers of periods, and
    /// its phase in the middle of the selected part is zero.
    pub(super) fn phase_of_first_cell(&self, numbers: [i64; 2]) -> f64 {
        let along = |number: i64, whole: usize, part: usize, first: usize| {
            let count = |n: usize| i128::try_from(n).unwrap_or(i128::MAX);
            // In units of half cells the position is an integer. Reducing this integer by whole periods causes no
            // round-off.
            let half_cells = count(part) - 1 + 2 * count(first);
            let turned = (-i128::from(number) * half_cells).rem_euclid(2 * count(whole));
            PI * turned as f64 / whole as f64
        };
        let [i, j] = numbers;
        let (whole, part) = (self.whole, self.part);
        along(i, whole.nx(), part.nx(), self.first[0])
            + along(j, whole.ny(), part.ny(), self.first[1])
    }
}
