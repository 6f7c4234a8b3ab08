//! Identification of a pressure by a few sums.

use crate::cgm::reduce;
use crate::grid::Grid;
use crate::numerics::agreement::agree_within;
use crate::parallel::layout::Layout;

/// Sums over the pressure of a contact. Results of a shear problem store them to identify the pressure to which they belong.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub(crate) struct PressureFingerprint {
    sum: f64,
    squares: f64,
    /// Sums of x p and y p, with coordinates in units of the sides of the grid.
    moments: [f64; 2],
}

impl PressureFingerprint {
    /// Computes the sums over the cells of a layout, equal on every rank. `cell` returns the local index in the grid and the
    /// pressure of a cell of the layout.
    pub(crate) fn of(
        grid: Grid,
        layout: &Layout,
        cell: impl Fn(usize) -> (usize, f64) + Sync,
    ) -> Self {
        let [columns, rows] = grid.whole().size();
        let (width, depth) = (columns as f64 * grid.dx(), rows as f64 * grid.dy());
        let (sum, squares, moments) = reduce::sum(layout, |k| {
            let (i, pressure) = cell(k);
            if pressure == 0.0 {
                return (0.0, 0.0, [0.0; 2]);
            }
            let (x, y) = (grid.x(i % columns), grid.y(i / columns));
            let moments = [x / width * pressure, y / depth * pressure];
            (pressure, pressure * pressure, moments)
        });
        Self {
            sum,
            squares,
            moments,
        }
    }

    /// Returns whether both belong to the same pressure, up to a relative difference.
    pub(crate) fn agrees_with(&self, other: &Self, tolerance: f64) -> bool {
        // The sum of the squares of very large pressures is infinite.
        let are_equal = |one: f64, other: f64, scale| {
            (one.is_infinite() && other.is_infinite()) || agree_within(tolerance, one, other, scale)
        };
        are_equal(self.sum, other.sum, 0.0)
            && are_equal(self.squares, other.squares, 0.0)
            && (0..2).all(|axis| are_equal(self.moments[axis], other.moments[axis], self.sum))
    }
}
