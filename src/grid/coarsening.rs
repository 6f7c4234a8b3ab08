//! Transfer of fields to cells of twice the sides (restriction) and back (prolongation).

use std::ops::Range;

use crate::error::Result;
use crate::memory::fallible;
use crate::parallel;

/// Returns half the number of cells along each axis, rounded up. If the number is odd, the last coarse cell contains a single
/// fine cell along this axis.
pub(crate) fn halved(size: [usize; 2]) -> [usize; 2] {
    size.map(|n| n.div_ceil(2))
}

/// Returns the mean of each block of two by two cells, with fewer cells at an odd edge.
pub(crate) fn coarsened([nx, ny]: [usize; 2], fine: &[f64]) -> Result<Vec<f64>> {
    let [width, height] = halved([nx, ny]);
    let mut coarse = fallible::zeros(width * height)?;
    parallel::rows(&mut coarse, width, |j, row| {
        let rows = &fine[2 * j * nx..(2 * j + 2).min(ny) * nx];
        let mean_of = |i: usize| {
            let columns = 2 * i..(2 * i + 2).min(nx);
            let cells = columns.len() * (rows.len() / nx);
            let sums = rows
                .chunks_exact(nx)
                .map(|row| row[columns.clone()].iter().sum::<f64>());
            sums.sum::<f64>() / cells as f64
        };
        // A complete block always has four cells, so these blocks are summed without counting their cells.
        let (upper, lower) = rows.split_at(nx);
        let blocks = upper.chunks_exact(2).zip(lower.chunks_exact(2));
        let whole = blocks.len();
        for (mean, (upper, lower)) in row.iter_mut().zip(blocks) {
            *mean = ((upper[0] + upper[1]) + (lower[0] + lower[1])) / 4.0;
        }
        for (i, mean) in row.iter_mut().enumerate().skip(whole) {
            *mean = mean_of(i);
        }
    });
    Ok(coarse)
}

/// Prolongates a field to the fine cells of some rows, by bilinear interpolation between the centres of the coarse
/// cells. The field is constant beyond the outermost centres. The slice `coarse` begins with the row `first`.
pub(crate) fn refined(
    [nx, ny]: [usize; 2],
    rows: Range<usize>,
    coarse: &[f64],
    first: usize,
) -> Result<Vec<f64>> {
    let [width, height] = halved([nx, ny]);
    // Along each axis the weight of the nearer coarse cell is 3/4 and the weight of the farther cell is 1/4. The farther cell is
    // before or after the nearer one.
    let before = |near: usize| near.saturating_sub(1);
    let after = |near: usize, cells: usize| (near + 1).min(cells - 1);
    by_rows(nx, rows, |j, row| {
        let near = j / 2;
        let far = if j % 2 == 0 {
            before(near)
        } else {
            after(near, height)
        };
        let [near, beyond] = [near, far].map(|row| &coarse[(row - first) * width..][..width]);
        let value = |x: usize, beyond_x: usize| {
            let corners = [near[x], near[beyond_x] + beyond[x], beyond[beyond_x]];
            (9.0 * corners[0] + 3.0 * corners[1] + corners[2]) / 16.0
        };
        for (x, values) in row.chunks_mut(2).enumerate() {
            values[0] = value(x, before(x));
            if let Some(second) = values.get_mut(1) {
                *second = value(x, after(x, width));
            }
        }
    })
}

/// Prolongates a field that is positive in a zone. At the edge of the zone the field falls to zero like the square root
/// of the distance, as a pressure does. The function interpolates the squares of the field, which are linear near the
/// edge. If only some rows are prolongated, the coarse field must contain [`REACH`] rows beyond the nearest rows,
/// within the grid.
pub(crate) fn refined_zone(
    size: [usize; 2],
    rows: Range<usize>,
    coarse: &[f64],
    first: usize,
) -> Result<Vec<f64>> {
    // The unit keeps the squares finite for any unit of pressure. A power of two causes no rounding, so the results of
    // all ranks are bitwise identical.
    let largest = coarse.iter().copied().fold(0.0, f64::max);
    let unit = largest.log2().clamp(-1000.0, 1000.0).floor().exp2();
    let squares = continued_squares(halved(size)[0], coarse, unit)?;
    let mut fine = refined(size, rows, &squares, first)?;
    parallel::update(&mut fine, |_, chunk| {
        for value in chunk {
            *value = unit * value.max(0.0).sqrt();
        }
    });
    Ok(fine)
}

/// Number of rows of coarse cells beyond the nearest row that affect the fine cells.
pub(crate) const REACH: usize = 3;

/// Returns the squares of a field, in the given unit, inside the zone where the field is positive. Cells next to the
/// zone receive a continuation of these squares, and all other cells are zero. The continued value is a mean of terms
/// over the directions whose next cell lies inside the zone. A term is the linear continuation from two cells, but at
/// most zero. If the second cell lies outside the zone, the term is the negated square in the next cell.
fn continued_squares(width: usize, zone: &[f64], unit: f64) -> Result<Vec<f64>> {
    const DIRECTIONS: [[isize; 2]; 8] = [
        [1, 0],
        [-1, 0],
        [0, 1],
        [0, -1],
        [1, 1],
        [-1, 1],
        [1, -1],
        [-1, -1],
    ];
    let height = zone.len() / width;
    let square = |[i, j]: [usize; 2], [x, y]: [isize; 2]| {
        let place = i.checked_add_signed(x).zip(j.checked_add_signed(y));
        let place = place.filter(|&(i, j)| i < width && j < height);
        place.map_or(0.0, |(i, j)| (zone[j * width + i] / unit).powi(2))
    };
    let continued = |cell: [usize; 2]| {
        let (mut sum, mut count) = (0.0, 0.0);
        for [x, y] in DIRECTIONS {
            let [next, second] = [square(cell, [x, y]), square(cell, [2 * x, 2 * y])];
            if next > 0.0 {
                let beyond = if second > 0.0 {
                    2.0 * next - second
                } else {
                    -next
                };
                sum += beyond.min(0.0);
                count += 1.0;
            }
        }
        // The count is zero if the squares of all neighbours underflow.
        if count > 0.0 { sum / count } else { 0.0 }
    };
    let mut squares = fallible::zeros(zone.len())?;
    parallel::rows(&mut squares, width, |j, row| {
        let around = &zone[j.saturating_sub(1) * width..(j + 2).min(height) * width];
        let touches = |i: usize| {
            let columns = i.saturating_sub(1)..(i + 2).min(width);
            let mut rows = around.chunks_exact(width);
            rows.any(|row| row[columns.clone()].iter().any(|&value| value > 0.0))
        };
        for (i, value) in row.iter_mut().enumerate() {
            if zone[j * width + i] > 0.0 {
                *value = square([i, j], [0, 0]);
            } else if touches(i) {
                *value = continued([i, j]);
            }
        }
    });
    Ok(squares)
}

/// Creates rows of a field with the given number of columns. `write(row, samples)` fills each row.
fn by_rows(
    columns: usize,
    rows: Range<usize>,
    write: impl Fn(usize, &mut [f64]) + Sync,
) -> Result<Vec<f64>> {
    let mut field = fallible::zeros(columns * rows.len())?;
    parallel::rows(&mut field, columns, |j, row| write(rows.start + j, row));
    Ok(field)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Returns `sqrt(1 - r^2)`, or zero outside the unit circle, at the centres of `n` x `n` cells that cover the
    /// circle.
    fn root(n: usize) -> Vec<f64> {
        let centre = |i: usize| 2.6 * ((i as f64 + 0.5) / n as f64 - 0.5);
        let value = |cell: usize| {
            let [x, y] = [centre(cell % n), centre(cell / n)];
            (1.0 - x * x - y * y).max(0.0).sqrt()
        };
        (0..n * n).map(value).collect()
    }

    #[test]
    fn a_zone_is_handed_down_to_a_fraction_of_a_cell() {
        for (n, most) in [(24, 40), (48, 8), (96, 8)] {
            let (coarse, exact) = (root(n), root(2 * n));
            let zone = refined_zone([2 * n; 2], 0..2 * n, &coarse, 0).unwrap();
            let differ = |field: &[f64]| {
                let pairs = field.iter().zip(&exact);
                pairs.filter(|(a, b)| (**a > 0.0) != (**b > 0.0)).count()
            };
            let bilinear = refined([2 * n; 2], 0..2 * n, &coarse, 0).unwrap();
            let edge = std::f64::consts::TAU * n as f64 / 1.3;
            // The limits are measured. Bilinear interpolation of the values adds at least a ring of cells.
            assert!(differ(&zone) <= most, "{}", differ(&zone));
            assert!(differ(&bilinear) as f64 > edge);
        }
    }

    #[test]
    fn the_unit_of_a_zone_does_not_matter() {
        let (n, coarse) = (48, root(24));
        let ordinary = refined_zone([n; 2], 0..n, &coarse, 0).unwrap();
        for unit in [1e-290, 1e-160, 1e160, 1e290] {
            let coarse: Vec<_> = coarse.iter().map(|value| unit * value).collect();
            let found = refined_zone([n; 2], 0..n, &coarse, 0).unwrap();
            for (found, ordinary) in found.iter().zip(&ordinary) {
                assert!((found / unit - ordinary).abs() < 1e-14);
            }
        }
    }

    #[test]
    fn rows_of_a_zone_are_those_of_the_whole() {
        let [nx, ny] = [31, 37_usize];
        let [width, height] = halved([nx, ny]);
        let coarse: Vec<f64> = (0..width * height)
            .map(|cell| (7.3 * cell as f64).sin() + (0.41 * cell as f64).cos())
            .collect();
        let whole = refined_zone([nx, ny], 0..ny, &coarse, 0).unwrap();
        for rows in [
            0..8_usize,
            8..20,
            20..37,
            7..8,
            8..9,
            0..1,
            36..37,
            9..21,
            37..37,
        ] {
            let first = (rows.start / 2).saturating_sub(REACH).min(height);
            let end = (rows.end / 2 + REACH).min(height);
            let held = &coarse[first * width..end * width];
            let part = refined_zone([nx, ny], rows.clone(), held, first);
            assert_eq!(part.unwrap(), whole[rows.start * nx..rows.end * nx]);
        }
        assert_eq!(refined_zone([nx, ny], 5..5, &[], 0).unwrap(), []);
    }
}
