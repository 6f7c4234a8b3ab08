//! Depth of a point, and its distances from the cells along an axis of the surface.

use crate::grid::Grid;

/// Depth, in longer sides of a cell, below which a point counts as on the surface. Squares of smaller depths can
/// underflow.
const SURFACE: f64 = 1e-150;
/// Largest distance of a point from the middle of the grid, in shorter sides of a cell. Its fifth power does not
/// overflow.
const REACH: f64 = 1e60;
/// Error text for points farther away than [`REACH`].
pub(super) const TOO_FAR: &str = "must lie within 1e60 cells of the grid";

/// Returns the depth at which the integrals are evaluated.
pub(super) fn depth_in(grid: Grid, depth: f64) -> f64 {
    if depth < SURFACE * grid.dx().max(grid.dy()) {
        0.0
    } else {
        depth
    }
}

/// Returns whether the integrals are finite at this coordinate of a point.
pub(super) fn reach(grid: Grid, coordinate: f64) -> bool {
    coordinate.abs() <= REACH * grid.dx().min(grid.dy())
}

/// Distances of a point from the cells along one axis, or from their nearest images if the axis is periodic.
///
/// A point on an edge must be on the edge of the cells on both sides. If round-off moved the point to one side, the
/// logarithms of the two cells would not cancel.
pub(super) struct Distances {
    at: f64,
    cells: usize,
    side: f64,
    repeats: bool,
    /// Distance from the middle of the grid in half sides, if it is an integer.
    steps: Option<f64>,
}

impl Distances {
    pub(super) fn new(at: f64, cells: usize, side: f64, repeats: bool) -> Self {
        let steps = 2.0 * (at / side);
        let error = 8.0 * f64::EPSILON * (1.0 + steps.abs());
        let steps = Some(steps.round()).filter(|whole| (steps - whole).abs() <= error);
        Self {
            at,
            cells,
            side,
            repeats,
            steps,
        }
    }

    pub(super) fn to(&self, cell: usize) -> f64 {
        // Position of the centre in half sides.
        let centre = 2.0 * cell as f64 - (self.cells - 1) as f64;
        let half = 0.5 * self.side;
        let (distance, period, unit) = match self.steps {
            Some(steps) => (steps - centre, 2.0 * self.cells as f64, half),
            None => (self.at - centre * half, self.side * self.cells as f64, 1.0),
        };
        let periods = if self.repeats {
            (distance / period).round()
        } else {
            0.0
        };
        (distance - period * periods) * unit
    }
}
