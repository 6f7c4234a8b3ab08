//! Fields on cells of twice the sides, and back.

use std::ops::Range;

use crate::buffer;
use crate::error::Result;
use crate::parallel;

/// Half the cells along each axis, the last one alone where their number is odd.
pub(crate) fn halved(size: [usize; 2]) -> [usize; 2] {
    size.map(|n| n.div_ceil(2))
}

/// The mean of each two by two cells (of those there are, at an odd edge).
pub(crate) fn coarsened([nx, ny]: [usize; 2], fine: &[f64]) -> Result<Vec<f64>> {
    let [width, height] = halved([nx, ny]);
    let mut coarse = buffer::zeros(width * height)?;
    parallel::rows(&mut coarse, width, |j, row| {
        let rows = &fine[2 * j * nx..(2 * j + 2).min(ny) * nx];
        for (i, mean) in row.iter_mut().enumerate() {
            let columns = 2 * i..(2 * i + 2).min(nx);
            let cells = columns.len() * (rows.len() / nx);
            let sums = rows
                .chunks_exact(nx)
                .map(|row| row[columns.clone()].iter().sum::<f64>());
            *mean = sums.sum::<f64>() / cells as f64;
        }
    });
    Ok(coarse)
}

/// Bilinear interpolation of coarse cell centres at the fine ones of some rows, constant beyond the outermost. The coarse
/// field begins with the row `first`.
pub(crate) fn refined(
    [nx, ny]: [usize; 2],
    rows: Range<usize>,
    coarse: &[f64],
    first: usize,
) -> Result<Vec<f64>> {
    let [width, height] = halved([nx, ny]);
    // The nearer coarse cell weighs 3/4 along each axis, the one beyond 1/4.
    let neighbours = |i: usize, cells: usize| {
        let near = i / 2;
        let far = if i % 2 == 0 {
            near.saturating_sub(1)
        } else {
            (near + 1).min(cells - 1)
        };
        [near, far]
    };
    by_rows(nx, rows, |j, row| {
        let [near, beyond] =
            neighbours(j, height).map(|row| &coarse[(row - first) * width..][..width]);
        for (i, value) in row.iter_mut().enumerate() {
            let [x, beyond_x] = neighbours(i, width);
            let corners = [near[x], near[beyond_x] + beyond[x], beyond[beyond_x]];
            *value = (9.0 * corners[0] + 3.0 * corners[1] + corners[2]) / 16.0;
        }
    })
}

/// The value of the coarse cell that each fine one of some rows lies in. The coarse field begins with the row `first`.
pub(crate) fn inherited(
    [nx, ny]: [usize; 2],
    rows: Range<usize>,
    coarse: &[f64],
    first: usize,
) -> Result<Vec<f64>> {
    let [width, _] = halved([nx, ny]);
    by_rows(nx, rows, |j, row| {
        let parents = &coarse[(j / 2 - first) * width..][..width];
        for (i, value) in row.iter_mut().enumerate() {
            *value = parents[i / 2];
        }
    })
}

/// Some rows of a field of so many columns, each written by `write(row, its samples)`.
fn by_rows(
    columns: usize,
    rows: Range<usize>,
    write: impl Fn(usize, &mut [f64]) + Sync,
) -> Result<Vec<f64>> {
    let mut field = buffer::zeros(columns * rows.len())?;
    parallel::rows(&mut field, columns, |j, row| write(rows.start + j, row));
    Ok(field)
}
