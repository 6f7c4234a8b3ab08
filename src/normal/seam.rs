//! Seams of periodic gaps: jumps between opposite edges of the grid.

use crate::grid::Grid;
use crate::half_space::HalfSpace;

/// Least mean jump across the border, over the standard deviation of the jumps along the border. The jumps of a level measured
/// surface vary along the border as much as the heights.
const LEAST_MEAN: f64 = 5.0;

/// Number of cells of the grid per cell of the margin at its border. A gap without contact in the margins is an array of separate
/// contacts.
const CELLS_PER_MARGIN: usize = 16;

/// Returns the mean jump of the gap across the border along x and along y, divided by the largest mean step between neighbouring
/// columns or rows. Returns zero if the grid is not periodic or is distributed, if no contact is near the border, or if the jumps
/// vary as much as their mean.
pub(super) fn mean_jumps(bodies: &HalfSpace, gap: &[f64], pressure: &[f64]) -> [f64; 2] {
    let grid = bodies.grid();
    let repeats = bodies.boundary().repeats();
    let is_whole = grid.cells() == grid.whole().cells();
    [0, 1].map(|axis| {
        if is_whole && repeats[axis] {
            mean_jump(grid, axis, gap, pressure)
        } else {
            0.0
        }
    })
}

fn mean_jump(grid: Grid, axis: usize, gap: &[f64], pressure: &[f64]) -> f64 {
    let (along, across) = (grid.size()[axis], grid.size()[1 - axis]);
    let strides = if axis == 0 {
        [1, grid.nx()]
    } else {
        [grid.nx(), 1]
    };
    let cell = |i: usize, j: usize| i * strides[0] + j * strides[1];
    let margin = along.div_ceil(CELLS_PER_MARGIN);
    let is_loaded = |i: usize| (0..across).any(|j| pressure[cell(i, j)] > 0.0);
    if !(0..margin).chain(along - margin..along).any(is_loaded) {
        return 0.0;
    }
    let jump = |j: usize| gap[cell(0, j)] - gap[cell(along - 1, j)];
    let mean_of = |sum: f64| sum / across as f64;
    let mean = mean_of((0..across).map(jump).sum());
    let variance = mean_of((0..across).map(|j| (jump(j) - mean).powi(2)).sum());
    if mean.abs() <= LEAST_MEAN * variance.sqrt() {
        return 0.0;
    }
    let height = |i: usize| mean_of((0..across).map(|j| gap[cell(i, j)]).sum());
    let mut last = height(0);
    let largest = (1..along).fold(0.0_f64, |largest, i| {
        let step = height(i) - last;
        last += step;
        largest.max(step.abs())
    });
    mean.abs() / largest
}
