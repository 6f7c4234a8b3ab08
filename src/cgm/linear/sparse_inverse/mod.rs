//! Factorised sparse approximate inverse of the operator on scattered moving cells.
//!
//! The inverse of the matrix of the moving cells is approximated by $`G'WG`$ with a sparse unit lower triangular matrix $`G`$ and
//! a diagonal matrix $`W`$ (Kolotilina & Yeremin, SIAM J. Matrix Anal. Appl. 14 (1993) 45, <https://doi.org/10.1137/0614004>). The
//! row of a cell contains the cell and the moving cells among its [earlier neighbours](EARLIER). It solves the equations of these
//! cells alone:
//!
//! ```math
//! C_P\,y = e_i, \quad g = y / y_i, \quad w = y_i .
//! ```
//!
//! Without a square root, a change of units by powers of two causes no rounding.
//!
//! The coefficients depend only on the distance. Therefore the row depends only on the pattern of moving neighbours, and a table
//! contains the rows of all patterns. In contrast to the circulant inverse, the rows depend on the edges of the contact. A
//! product costs a few operations per moving cell instead of two transforms of the grid. The couplings of the components are
//! omitted.

#[cfg(test)]
mod tests;

use std::sync::{Arc, OnceLock};

use crate::cgm::free_cells::FreeCells;
use crate::error::{Result, positive};
use crate::memory::fallible;

/// Columns and rows from a cell to its earlier neighbours, which precede the cell row by row. The neighbours lie within a radius
/// of the square root of five cells.
const EARLIER: [[i8; 2]; 10] = [
    [-1, -2],
    [0, -2],
    [1, -2],
    [-2, -1],
    [-1, -1],
    [0, -1],
    [1, -1],
    [2, -1],
    [-2, 0],
    [-1, 0],
];
/// Number of rows before or after the row of a cell that contain its neighbours.
const REACH: usize = 2;
/// Number of entries of a row of the factor. The last entry is the weight of the row, because the entry of the cell itself is one.
const ENTRIES: usize = EARLIER.len() + 1;
/// Number of patterns of moving neighbours.
const PATTERNS: usize = 1 << EARLIER.len();
/// Pattern of a cell that does not move.
const NOTHING: u16 = 1 << EARLIER.len();
/// Number of cells below which the transforms take little time, compared with the computation of the factors.
const SMALL: usize = 4096;
/// Fraction of moving cells at which a product costs as much as a product with the circulant inverse.
const DENSE: f64 = 0.3;
/// Mean fraction of moving cells among the earlier neighbours at which a contact becomes compact. In a compact contact, the steps
/// that the circulant inverse saves outweigh the time that the sparse inverse saves.
const COMPACT: f64 = 0.82;

/// Rows of the factor for all patterns of moving neighbours.
type Table = Vec<[f64; ENTRIES]>;

/// Coefficients of the operator at short distances, and the factors that follow from them.
#[derive(Debug)]
pub(crate) struct SparseFactors<const N: usize> {
    /// Diagonal coefficients of each component by the distance in rows and columns.
    coefficients: [[[f64; 5]; 3]; N],
    tables: OnceLock<Result<[Table; N]>>,
}

/// Pattern of the moving neighbours of each moving cell, and [`NOTHING`] for the other cells. It is empty before the first
/// scattered contact.
#[derive(Debug, Clone, Default)]
pub(crate) struct SparseScratch {
    patterns: Vec<u16>,
}

impl<const N: usize> SparseFactors<N> {
    /// Number of columns and rows of distances whose coefficients determine the factors.
    pub(crate) const DISTANCES: [usize; 2] = [5, 3];

    /// Creates the factors from the coefficients of equal components, given by component, column and row.
    pub(crate) fn new(coefficient: impl Fn(usize, usize, usize) -> f64) -> Self {
        let row = |c: usize, row: usize| std::array::from_fn(|column| coefficient(c, column, row));
        Self {
            coefficients: std::array::from_fn(|c| std::array::from_fn(|y| row(c, y))),
            tables: OnceLock::new(),
        }
    }

    /// Returns the tables, which the first call computes.
    ///
    /// # Errors
    /// - [`Error::NotPositive`](crate::Error::NotPositive) if the coefficients are not positive definite.
    /// - [`Error::Memory`](crate::Error::Memory) if memory ran out in the first call.
    fn tables(&self) -> Result<&[Table; N]> {
        let make = || fallible::try_each(|n| table(&self.coefficients[n]));
        self.tables.get_or_init(make).as_ref().map_err(Clone::clone)
    }
}

/// Computes the rows of the factor for all patterns.
fn table(coefficients: &[[f64; 5]; 3]) -> Result<Table> {
    let mut table = fallible::with_room(PATTERNS)?;
    for pattern in 0..PATTERNS {
        table.push(row(coefficients, pattern)?);
    }
    Ok(table)
}

/// Computes the row of the factor for a pattern of moving neighbours, or returns an error if their coefficients are not positive
/// definite.
fn row(coefficients: &[[f64; 5]; 3], pattern: usize) -> Result<[f64; ENTRIES]> {
    let mut listed = [EARLIER.len(); ENTRIES];
    let mut count = 0;
    for neighbour in (0..EARLIER.len()).filter(|neighbour| pattern >> neighbour & 1 == 1) {
        listed[count] = neighbour;
        count += 1;
    }
    // The cell itself is the last of the listed cells.
    let listed = &listed[..=count];
    let place = |entry: usize| EARLIER.get(entry).copied().unwrap_or([0; 2]);
    let (mut factor, mut pivots) = ([[0.0; ENTRIES]; ENTRIES], [0.0; ENTRIES]);
    for (p, &one) in listed.iter().enumerate() {
        for (q, &other) in listed[..=p].iter().enumerate() {
            let ([x, y], [u, v]) = (place(one), place(other));
            let coefficient = coefficients[usize::from(y.abs_diff(v))][usize::from(x.abs_diff(u))];
            let known = (0..q).fold(coefficient, |sum, k| {
                sum - factor[p][k] * factor[q][k] * pivots[k]
            });
            if p > q {
                factor[p][q] = known / pivots[q];
            } else {
                pivots[p] = positive("pivot of the coefficients of near cells", known)?;
            }
        }
    }
    // With `C = L D L'` the row is the last row of the inverse of `L`, and the weight is the inverse of the last entry of `D`.
    let mut row = [0.0; ENTRIES];
    row[EARLIER.len()] = 1.0;
    for p in (0..count).rev() {
        row[listed[p]] = (p + 1..=count).fold(0.0, |sum, k| sum - factor[k][p] * row[listed[k]]);
    }
    row[EARLIER.len()] = 1.0 / pivots[count];
    Ok(row)
}

/// Sparse inverse for a grid with the given number of columns.
#[derive(Debug, Clone)]
pub(crate) struct SparseInverse<const N: usize> {
    pub(crate) factors: Arc<SparseFactors<N>>,
    pub(crate) columns: usize,
}

/// Returns whether the grid is large and few of its cells move. Otherwise the circulant inverse takes less time.
pub(super) fn has_few(moving: &FreeCells) -> bool {
    let (count, cells) = (moving.of_all_ranks(), moving.layout().of_all_ranks());
    let is_dense = count as f64 > DENSE * cells as f64;
    cells >= SMALL && count > 0 && !is_dense
}

impl<const N: usize> SparseInverse<N> {
    /// Returns whether the moving cells, which are [few](has_few), are so scattered that the sparse inverse takes less time
    /// than the circulant inverse. In this case the scratch is prepared for these cells. `moves` is one on the moving cells and
    /// zero on the other cells.
    pub(super) fn prepare(
        &self,
        moving: &FreeCells,
        moves: &[f64],
        scratch: &mut SparseScratch,
    ) -> bool {
        let found = self.find_patterns(moving, moves, scratch);
        let most = COMPACT * (moving.of_all_ranks() * EARLIER.len()) as f64;
        found.is_ok_and(|neighbours| (neighbours as f64) < most)
    }

    /// Determines the pattern of every moving cell. Returns the number of moving neighbours of all cells.
    fn find_patterns(
        &self,
        moving: &FreeCells,
        moves: &[f64],
        scratch: &mut SparseScratch,
    ) -> Result<usize> {
        let (layout, columns) = (moving.layout(), self.columns);
        let halo = layout.with_halo(moves, REACH)?;
        let tables = self.factors.tables();
        let room = |_| fallible::resize_with_zeros(&mut scratch.patterns, halo.values.len());
        layout.collective_result(tables.and_then(room))?;
        scratch.patterns.fill(NOTHING);
        let pattern = |cell: usize| {
            let pattern = earlier(&halo.values, cell, columns, |moves| {
                moves.bits(|moves| moves > 0.0)
            });
            pattern & inside(cell % columns, columns)
        };
        let own = halo.before..halo.before + layout.cells();
        for cell in own.end..halo.values.len() {
            if halo.values[cell] > 0.0 {
                scratch.patterns[cell] = pattern(cell);
            }
        }
        let patterns = layout.blocks(&mut scratch.patterns[own]);
        Ok(moving.sweep(patterns, |entries, patterns| {
            entries.sums(|_, place| {
                let found = pattern(halo.before + entries.chunk.start + place);
                patterns.items[place] = found;
                found.count_ones() as usize
            })
        }))
    }

    /// Computes the product with `direction` on the moving cells for which the scratch is [prepared](Self::prepare). `direction`
    /// must be zero on the other cells. Returns false if the ranks cannot exchange their rows.
    ///
    /// Each moving cell multiplies its row by its value of $`W G r`$, and adds the result to its earlier neighbours. The neighbours
    /// of cells after a chunk may belong to the chunk. Therefore each chunk also visits these cells, but adds to its own cells
    /// only. The order of the additions does not depend on the chunks.
    pub(super) fn apply(
        &self,
        moving: &FreeCells,
        direction: [&[f64]; N],
        image: &mut [Vec<f64>; N],
        scratch: &SparseScratch,
    ) -> bool {
        let (layout, columns) = (moving.layout(), self.columns);
        let Ok(tables) = self.factors.tables() else {
            return false;
        };
        let patterns = &scratch.patterns[..];
        for ((table, direction), image) in tables.iter().zip(direction).zip(image) {
            let Ok(halo) = layout.with_halo(direction, REACH) else {
                return false;
            };
            let residual = &*halo.values;
            moving.sweep(layout.blocks(image), |entries, image| {
                let image = image.items;
                let chunk = halo.before + entries.chunk.start..halo.before + entries.chunk.end;
                let after = chunk.end..patterns.len().min(chunk.end + REACH * (columns + 1));
                let after = after.filter(|cell| patterns[*cell] != NOTHING);
                for place in entries.places().chain(after.map(|cell| cell - chunk.start)) {
                    let cell = chunk.start + place;
                    let row = &table[usize::from(patterns[cell])];
                    let sum = earlier(residual, cell, columns, |neighbours| {
                        neighbours.sum(|entry, residual| row[entry] * residual)
                    });
                    let half = row[EARLIER.len()] * (sum + residual[cell]);
                    if let Some(own) = image.get_mut(place) {
                        *own = half;
                    }
                    add_to_earlier(row, half, place, columns, image);
                }
            });
        }
        true
    }
}

/// Adds the products of a row and of a number to the earlier neighbours of a cell that belong to the image.
#[inline]
fn add_to_earlier(
    row: &[f64; ENTRIES],
    half: f64,
    place: usize,
    columns: usize,
    image: &mut [f64],
) {
    let [f0, f1, f2, n0, n1, n2, n3, n4, o0, o1, _] = row;
    add_to(
        image,
        place.wrapping_sub(2 * columns + 1),
        [f0, f1, f2],
        half,
    );
    add_to(
        image,
        place.wrapping_sub(columns + 2),
        [n0, n1, n2, n3, n4],
        half,
    );
    add_to(image, place.wrapping_sub(2), [o0, o1], half);
}

/// Adds the products of adjacent entries of a row and of a number to the cells from `first`. Skips the cells outside the image.
/// The number of a cell before the image wraps around.
#[inline]
fn add_to<const K: usize>(image: &mut [f64], first: usize, row: [&f64; K], half: f64) {
    let cells = image
        .get_mut(first..)
        .and_then(|cells| cells.first_chunk_mut::<K>());
    if let Some(cells) = cells {
        for (cell, entry) in cells.iter_mut().zip(row) {
            *cell += entry * half;
        }
    } else {
        for (k, entry) in row.into_iter().enumerate() {
            if let Some(cell) = image.get_mut(first.wrapping_add(k)) {
                *cell += entry * half;
            }
        }
    }
}

/// Returns the patterns of the neighbours that lie inside the grid, for a cell in this column.
fn inside(column: usize, columns: usize) -> u16 {
    if column >= REACH && column + REACH < columns {
        return NOTHING - 1;
    }
    let bits = EARLIER.iter().enumerate().map(|(bit, [x, _])| {
        let neighbour = column.checked_add_signed(isize::from(*x));
        u16::from(neighbour.is_some_and(|neighbour| neighbour < columns)) << bit
    });
    bits.fold(0, |pattern, bit| pattern | bit)
}

/// Values at the neighbours of a cell in three rows, from left to right.
#[derive(Clone, Copy)]
struct Neighbours<'a, T> {
    /// Neighbours two rows away.
    far: &'a [T; 3],
    /// Neighbours in the adjacent row.
    near: &'a [T; 5],
    /// Neighbours in the row of the cell.
    own: &'a [T; 2],
}

impl<T: Copy> Neighbours<'_, T> {
    /// Adds one term for each earlier neighbour, row by row, so that the processor overlaps the additions.
    #[inline]
    fn sum(self, term: impl Fn(usize, T) -> f64) -> f64 {
        let far = |n: usize| term(n, self.far[n]);
        let near = |n: usize| term(3 + n, self.near[n]);
        let own = |n: usize| term(8 + n, self.own[n]);
        let next = (near(0) + near(1)) + (near(2) + near(3)) + near(4);
        (far(0) + far(1) + far(2)) + next + (own(0) + own(1))
    }

    /// Returns the pattern of the earlier neighbours that satisfy a condition.
    #[inline]
    fn bits(self, holds: impl Fn(T) -> bool) -> u16 {
        let bit = |value: T, bit: usize| u16::from(holds(value)) << bit;
        let far = (0..3).fold(0, |bits, n| bits | bit(self.far[n], n));
        let near = (0..5).fold(far, |bits, n| bits | bit(self.near[n], 3 + n));
        (0..2).fold(near, |bits, n| bits | bit(self.own[n], 8 + n))
    }
}

/// Calls `f` with the values at the earlier neighbours of a cell. Values before the start of the vector are zero. The value at a
/// neighbour beyond the side of the grid is the value of a different cell.
#[inline]
fn earlier<T: Copy + Default, R>(
    values: &[T],
    cell: usize,
    columns: usize,
    f: impl Fn(Neighbours<'_, T>) -> R,
) -> R {
    let inside = || {
        let values = values.get(cell.checked_sub(2 * columns + 2)?..cell)?;
        Some(Neighbours {
            far: values.get(1..)?.first_chunk()?,
            near: values.get(columns..)?.first_chunk()?,
            own: values.get(2 * columns..)?.first_chunk()?,
        })
    };
    match inside() {
        Some(neighbours) => f(neighbours),
        None => at_start(values, cell, columns, f),
    }
}

/// Calls `f` with the values at the earlier neighbours of a cell near the start of the vector.
#[cold]
fn at_start<T: Copy + Default, R>(
    values: &[T],
    cell: usize,
    columns: usize,
    f: impl Fn(Neighbours<'_, T>) -> R,
) -> R {
    let value = |entry: usize| {
        let [x, y] = EARLIER[entry];
        let above = cell.checked_sub(usize::from(y.unsigned_abs()) * columns);
        let place = above.and_then(|above| above.checked_add_signed(x.into()));
        let value = place.and_then(|place| values.get(place));
        value.copied().unwrap_or_default()
    };
    f(Neighbours {
        far: &std::array::from_fn(&value),
        near: &std::array::from_fn(|n| value(3 + n)),
        own: &std::array::from_fn(|n| value(8 + n)),
    })
}
