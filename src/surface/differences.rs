//! Slopes and area of a surface from the differences of neighbouring heights.

use super::slab::Slab;
use crate::parallel::reduce;

/// Returns the root mean square of the slopes between neighbours along x and along y. The mean is over the pairs of
/// measured neighbours, and the result is zero along an axis of one cell. It is NaN along an axis of several cells without
/// such pairs. `z` are the heights of the local rows and of the next row.
pub(super) fn rms_slopes(z: &[f64], slab: &Slab) -> [f64; 2] {
    let grid = slab.whole();
    let (nx, ny) = (grid.nx(), grid.ny());
    // The sum of the squares, and the number of pairs.
    let pair = |exists: bool, i: usize, j: usize, side: f64| {
        let difference = if exists { z[j] - z[i] } else { f64::NAN };
        if difference.is_nan() {
            [0.0, 0.0]
        } else {
            [(difference / side).powi(2), 1.0]
        }
    };
    let sums = reduce::sum(slab.layout(), |i| {
        [
            pair(i % nx + 1 < nx, i, i + 1, grid.dx()),
            pair(i + nx < z.len(), i, i + nx, grid.dy()),
        ]
    });
    // An axis of one cell has no pairs.
    let mean = |cells: usize, [sum, pairs]: [f64; 2]| if cells > 1 { sum / pairs } else { 0.0 };
    [mean(nx, sums[0]).sqrt(), mean(ny, sums[1]).sqrt()]
}

/// Returns the excess of the area of a surface over its projection, relative to the projection. `z` are the heights of
/// the local rows and of the next row.
///
/// Rectangles with a missing height are skipped. Without a complete rectangle, the result is NaN.
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
    let [sum, count] = reduce::sum(slab.layout(), |i| {
        let (left, bottom) = (i % nx, i / nx);
        if left >= columns || slab.first_row() + bottom >= rows {
            return [0.0, 0.0];
        }
        let right = (left + 1).min(nx - 1);
        let top = if ny > 1 { bottom + 1 } else { bottom };
        let height = |ix: usize, iy: usize| z[iy * nx + ix];
        let along_x = |iy| (height(right, iy) - height(left, iy)) / grid.dx();
        let along_y = |ix| (height(ix, top) - height(ix, bottom)) / grid.dy();
        let (below, above) = (along_x(bottom), along_x(top));
        let (west, east) = (along_y(left), along_y(right));
        let corners = [(below, west), (below, east), (above, west), (above, east)];
        if [below, above, west, east].iter().any(|side| side.is_nan()) {
            return [0.0, 0.0];
        }
        [corners.map(|(sx, sy)| excess(sx, sy)).iter().sum(), 1.0]
    });
    0.25 * sum / count
}
