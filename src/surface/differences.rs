//! Slopes and area of a surface from the differences of neighbouring heights.

use super::slab::Slab;
use crate::parallel::reduce;

/// Returns the root mean square of the slopes between neighbours along x and along y. The mean is over the existing
/// pairs, and the result is zero along an axis of one cell. `z` are the heights of the local rows and of the next row.
pub(super) fn rms_slopes(z: &[f64], slab: &Slab) -> [f64; 2] {
    let grid = slab.whole();
    let (nx, ny) = (grid.nx(), grid.ny());
    let squared = |i: usize, j: usize, side: f64| ((z[j] - z[i]) / side).powi(2);
    let [along_x, along_y] = reduce::sum(slab.layout(), |i| {
        let has_right = i % nx + 1 < nx;
        let has_above = i + nx < z.len();
        [
            if has_right {
                squared(i, i + 1, grid.dx())
            } else {
                0.0
            },
            if has_above {
                squared(i, i + nx, grid.dy())
            } else {
                0.0
            },
        ]
    });
    // The sum is zero along an axis of one cell, which has no pairs.
    let mean = |sum: f64, pairs: usize| sum / pairs.max(1) as f64;
    [
        mean(along_x, (nx - 1) * ny).sqrt(),
        mean(along_y, nx * (ny - 1)).sqrt(),
    ]
}

/// Returns the excess of the area of a surface over its projection, relative to the projection. `z` are the heights of
/// the local rows and of the next row.
///
/// Each rectangle of four neighbouring heights is cut into two triangles along either diagonal, and the two results are
/// averaged. The result is the mean of `sqrt(1 + s_x^2 + s_y^2) - 1` over the four corners. The two sides at a corner
/// have the slopes `s_x` and `s_y`. The slope along an axis of one cell is zero.
pub(super) fn developed_area_ratio(z: &[f64], slab: &Slab) -> f64 {
    let grid = slab.whole();
    let (nx, ny) = (grid.nx(), grid.ny());
    let (columns, rows) = ((nx - 1).max(1), (ny - 1).max(1));
    let excess = |sx: f64, sy: f64| {
        let squared = sx * sx + sy * sy;
        squared / (1.0 + (1.0 + squared).sqrt())
    };
    let [sum] = reduce::sum(slab.layout(), |i| {
        let (left, bottom) = (i % nx, i / nx);
        if left >= columns || slab.first_row() + bottom >= rows {
            return [0.0];
        }
        let right = (left + 1).min(nx - 1);
        let top = if ny > 1 { bottom + 1 } else { bottom };
        let height = |ix: usize, iy: usize| z[iy * nx + ix];
        let along_x = |iy| (height(right, iy) - height(left, iy)) / grid.dx();
        let along_y = |ix| (height(ix, top) - height(ix, bottom)) / grid.dy();
        let (below, above) = (along_x(bottom), along_x(top));
        let (west, east) = (along_y(left), along_y(right));
        let corners = [(below, west), (below, east), (above, west), (above, east)];
        [corners.map(|(sx, sy)| excess(sx, sy)).iter().sum()]
    });
    0.25 * sum / (columns * rows) as f64
}
