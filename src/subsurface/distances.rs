//! How far a point is from the cells: along an axis of the surface, and below it.

use crate::grid::Grid;

/// Depth, in longer sides of a cell, below which a point is on the surface: squares of such depths are lost.
const SURFACE: f64 = 1e-150;
/// How far a point may be from the middle of the grid, in shorter sides of a cell: fifth powers of it are numbers.
const REACH: f64 = 1e60;
/// The rule of that.
pub(super) const TOO_FAR: &str = "must lie within 1e60 cells of the grid";

/// The depth at which the integrals are taken.
pub(super) fn depth_in(grid: Grid, depth: f64) -> f64 {
    if depth < SURFACE * grid.dx().max(grid.dy()) {
        0.0
    } else {
        depth
    }
}

/// Whether the integrals are numbers at this coordinate of a point.
pub(super) fn reach(grid: Grid, coordinate: f64) -> bool {
    coordinate.abs() <= REACH * grid.dx().min(grid.dy())
}

/// The distances of a point from the cells along one axis, from their nearest images if they repeat. A point on an
/// edge is there for the cells on both sides: one that were beside it by a rounding would see logarithms that do not
/// cancel.
pub(super) struct Distances {
    at: f64,
    cells: usize,
    side: f64,
    repeats: bool,
    /// Half sides from the middle of the grid, if they are whole.
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
        // The centre in half sides.
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
