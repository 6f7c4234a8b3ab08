//! Factorised sparse approximate inverse of the operator on scattered moving cells.
//!
//! The inverse of the matrix of the moving cells is approximated by $`G'G`$ with a sparse lower triangular matrix $`G`$
//! (Kolotilina & Yeremin, SIAM J. Matrix Anal. Appl. 14 (1993) 45, <https://doi.org/10.1137/0614004>). The row of a cell contains
//! the cell and the moving cells among its [earlier neighbours](EARLIER). It solves the equations of these cells alone:
//!
//! ```math
//! C_P\,y = e_i, \quad g = y / \sqrt{y_i} .
//! ```
//!
//! The coefficients depend only on the distance. Therefore the row depends only on the pattern of moving neighbours, and a table
//! contains the rows of all patterns. In contrast to the circulant inverse, the rows contain the edges of the contact. A product
//! costs a few operations per moving cell instead of two transforms of the grid. The couplings of the components are omitted.

use std::sync::{Arc, OnceLock};

use crate::cgm::free_cells::FreeCells;
use crate::error::Result;
use crate::memory::fallible;

/// Columns and rows from a cell to its neighbours within a radius of the root of five cells that precede the cell row by row.
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
/// Number of rows of cells before or after a cell in which its neighbours lie.
const REACH: usize = 2;
/// Number of entries of a row of the factor. The last entry belongs to the cell itself.
const ENTRIES: usize = EARLIER.len() + 1;
/// Number of patterns of moving neighbours.
const PATTERNS: usize = 1 << EARLIER.len();
/// Pattern of a cell of another rank that does not move, whose row is zero.
const NOTHING: u16 = 1 << EARLIER.len();
/// Number of cells below which the transforms take little time, compared with the computation of the factors.
const SMALL: usize = 4096;
/// Fraction of moving cells from which a product costs as much as a product with the circulant inverse.
const DENSE: f64 = 0.3;
/// Mean fraction of the earlier neighbours that move from which a contact is compact. The circulant inverse then saves more steps
/// than the sparse inverse saves time.
const COMPACT: f64 = 0.82;

/// Rows of the factor for all patterns of moving neighbours.
type Table = Vec<[f64; ENTRIES]>;

/// Coefficients of the operator at short distances, and the factors that follow from them.
#[derive(Debug)]
pub(crate) struct SparseFactors<const N: usize> {
    /// Diagonal coefficients of each component by the distance in rows and columns.
    coefficients: [[[f64; 5]; 3]; N],
    tables: OnceLock<Option<[Table; N]>>,
}

/// Buffers of products with the sparse inverse. They are empty before the first scattered contact.
#[derive(Debug, Clone)]
pub(crate) struct SparseScratch<const N: usize> {
    /// Pattern of the moving neighbours of each moving cell.
    patterns: Vec<u16>,
    /// Product with the first factor.
    half: [Vec<f64>; N],
}

impl<const N: usize> SparseScratch<N> {
    pub(super) fn new() -> Self {
        Self {
            patterns: Vec::new(),
            half: std::array::from_fn(|_| Vec::new()),
        }
    }

    fn resize(&mut self, cells: usize) -> Result<()> {
        fallible::resize_with_zeros(&mut self.patterns, cells)?;
        for part in &mut self.half {
            fallible::resize_with_zeros(part, cells)?;
        }
        Ok(())
    }
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

    /// Returns the tables, or `None` if the coefficients are not positive definite.
    fn tables(&self) -> Option<&[Table; N]> {
        let make = || {
            let mut tables = std::array::from_fn(|_| Vec::new());
            for (table, coefficients) in tables.iter_mut().zip(&self.coefficients) {
                let rows = (0..PATTERNS).map(|pattern| row(coefficients, pattern));
                *table = rows.collect::<Option<Table>>()?;
                table.push([0.0; ENTRIES]);
            }
            Some(tables)
        };
        self.tables.get_or_init(make).as_ref()
    }
}

/// Computes the row of the factor for a pattern of moving neighbours, or `None` if their coefficients are not positive definite.
fn row(coefficients: &[[f64; 5]; 3], pattern: usize) -> Option<[f64; ENTRIES]> {
    let mut listed = [EARLIER.len(); ENTRIES];
    let mut count = 0;
    for neighbour in (0..EARLIER.len()).filter(|neighbour| pattern >> neighbour & 1 == 1) {
        listed[count] = neighbour;
        count += 1;
    }
    // The cell itself is the last of the listed cells.
    let listed = &listed[..=count];
    let place = |entry: usize| EARLIER.get(entry).copied().unwrap_or([0; 2]);
    let mut factor = [[0.0; ENTRIES]; ENTRIES];
    for (p, &one) in listed.iter().enumerate() {
        for (q, &other) in listed[..=p].iter().enumerate() {
            let ([x, y], [u, v]) = (place(one), place(other));
            let coefficient = coefficients[usize::from(y.abs_diff(v))][usize::from(x.abs_diff(u))];
            let known = (0..q).fold(coefficient, |sum, k| sum - factor[p][k] * factor[q][k]);
            if p > q {
                factor[p][q] = known / factor[q][q];
            } else if known > 0.0 && known.is_finite() {
                factor[p][p] = known.sqrt();
            } else {
                return None;
            }
        }
    }
    // With `C = L L'` the row is the last row of the inverse of `L`.
    let mut row = [0.0; ENTRIES];
    for p in (0..=count).rev() {
        let unit = if p == count { 1.0 } else { 0.0 };
        let later = (p + 1..=count).fold(unit, |sum, k| sum - factor[k][p] * row[listed[k]]);
        row[listed[p]] = later / factor[p][p];
    }
    Some(row)
}

/// Sparse inverse for a grid with the given number of columns.
#[derive(Debug, Clone)]
pub(crate) struct SparseInverse<const N: usize> {
    pub(crate) factors: Arc<SparseFactors<N>>,
    pub(crate) columns: usize,
}

impl<const N: usize> SparseInverse<N> {
    /// Returns whether the moving cells are so scattered that the sparse inverse takes less time than the circulant inverse. In
    /// this case the scratch is prepared for these cells. `moves` is one on the moving cells and zero on the other cells.
    pub(super) fn prepare(
        &self,
        moving: &FreeCells,
        moves: &[f64],
        scratch: &mut SparseScratch<N>,
    ) -> bool {
        let (count, cells) = (moving.of_all_ranks(), moving.layout().of_all_ranks());
        let is_dense = count as f64 > DENSE * cells as f64;
        if cells < SMALL || count == 0 || is_dense || self.factors.tables().is_none() {
            return false;
        }
        let found = self.find_patterns(moving, moves, scratch);
        let most = COMPACT * (count * EARLIER.len()) as f64;
        found.is_ok_and(|neighbours| (neighbours as f64) < most)
    }

    /// Determines the pattern of every moving cell. Returns the number of moving neighbours of all cells.
    fn find_patterns(
        &self,
        moving: &FreeCells,
        moves: &[f64],
        scratch: &mut SparseScratch<N>,
    ) -> Result<usize> {
        let (layout, columns) = (moving.layout(), self.columns);
        let halo = layout.with_halo(moves, REACH)?;
        layout.collective_result(scratch.resize(halo.values.len()))?;
        let pattern = |cell: usize| {
            let pattern = earlier(&halo.values, cell, columns, |moves| {
                moves.bits(|moves| moves > 0.0)
            });
            pattern & inside(cell % columns, columns)
        };
        let own = halo.before..halo.before + layout.cells();
        for cell in own.end..halo.values.len() {
            let moves = halo.values[cell] > 0.0;
            scratch.patterns[cell] = if moves { pattern(cell) } else { NOTHING };
        }
        for part in &mut scratch.half {
            part.fill(0.0);
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
    pub(super) fn apply(
        &self,
        moving: &FreeCells,
        direction: [&[f64]; N],
        image: &mut [Vec<f64>; N],
        scratch: &mut SparseScratch<N>,
    ) -> bool {
        let (layout, columns) = (moving.layout(), self.columns);
        let Some(tables) = self.factors.tables() else {
            return false;
        };
        let SparseScratch { patterns, half } = scratch;
        let patterns = &patterns[..];
        for ((table, direction), (half, image)) in
            tables.iter().zip(direction).zip(half.iter_mut().zip(image))
        {
            let Ok(halo) = layout.with_halo(direction, REACH) else {
                return false;
            };
            let residual = &*halo.values;
            let first = |cell: usize| {
                let row = &table[usize::from(patterns[cell])];
                let sum = earlier(residual, cell, columns, |neighbours| {
                    neighbours.sum(|entry, residual| row[entry] * residual)
                });
                sum + row[EARLIER.len()] * residual[cell]
            };
            let own = halo.before..halo.before + layout.cells();
            for (cell, half) in (own.end..).zip(&mut half[own.end..]) {
                *half = first(cell);
            }
            let before = halo.before;
            let blocks = layout.blocks(&mut half[own]);
            moving.sweep(blocks, |entries, half| {
                for place in entries.places() {
                    half.items[place] = first(before + entries.chunk.start + place);
                }
            });
            let half = &half[..];
            let second = |cell: usize| {
                let sum = later(patterns, cell, columns, |patterns| {
                    later(half, cell, columns, |half| {
                        patterns.sum_with(half, |entry, pattern, half| {
                            table[usize::from(pattern)][entry] * half
                        })
                    })
                });
                sum + table[usize::from(patterns[cell])][EARLIER.len()] * half[cell]
            };
            moving.sweep(layout.blocks(image), |entries, image| {
                for place in entries.places() {
                    image.items[place] = second(before + entries.chunk.start + place);
                }
            });
        }
        true
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

    /// Adds one term for each later neighbour. The entries count from the last neighbour to the first, because the cell is an
    /// earlier neighbour at the opposite offset.
    #[inline]
    fn sum_with<U: Copy>(self, other: Neighbours<'_, U>, term: impl Fn(usize, T, U) -> f64) -> f64 {
        let far = |n: usize| term(2 - n, self.far[n], other.far[n]);
        let near = |n: usize| term(7 - n, self.near[n], other.near[n]);
        let own = |n: usize| term(9 - n, self.own[n], other.own[n]);
        let next = (near(0) + near(1)) + (near(2) + near(3)) + near(4);
        (far(0) + far(1) + far(2)) + next + (own(0) + own(1))
    }

    /// Returns the pattern of the earlier neighbours that satisfy a condition.
    #[inline]
    fn bits(self, holds: impl Fn(T) -> bool) -> u16 {
        let values = self.far.iter().chain(self.near).chain(self.own);
        values.enumerate().fold(0, |bits, (bit, &value)| {
            bits | u16::from(holds(value)) << bit
        })
    }
}

/// Calls `f` with the values at the earlier neighbours of a cell. Values beyond the ends of the vector are zero. A neighbour
/// beyond the side of the grid has the value of a different cell.
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
        None => at_end(values, cell, columns, false, f),
    }
}

/// Calls `f` with the values at the cells of which a cell is the earlier neighbour.
#[inline]
fn later<T: Copy + Default, R>(
    values: &[T],
    cell: usize,
    columns: usize,
    f: impl Fn(Neighbours<'_, T>) -> R,
) -> R {
    let inside = || {
        let values = values.get(cell..)?;
        Some(Neighbours {
            far: values.get(2 * columns - 1..)?.first_chunk()?,
            near: values.get(columns.checked_sub(2)?..)?.first_chunk()?,
            own: values.get(1..)?.first_chunk()?,
        })
    };
    match inside() {
        Some(neighbours) => f(neighbours),
        None => at_end(values, cell, columns, true, f),
    }
}

/// Calls `f` with the values at the earlier or later neighbours of a cell near an end of the vector.
#[cold]
fn at_end<T: Copy + Default, R>(
    values: &[T],
    cell: usize,
    columns: usize,
    is_later: bool,
    f: impl Fn(Neighbours<'_, T>) -> R,
) -> R {
    let value = |entry: usize| {
        let [x, y] = EARLIER[entry];
        let (x, rows) = (isize::from(x), usize::from(y.unsigned_abs()));
        let place = if is_later {
            (cell + rows * columns).checked_add_signed(-x)
        } else {
            let above = cell.checked_sub(rows * columns);
            above.and_then(|above| above.checked_add_signed(x))
        };
        let value = place.and_then(|place| values.get(place));
        value.copied().unwrap_or_default()
    };
    let entry =
        |first: usize, last: usize, n: usize| value(if is_later { last - n } else { first + n });
    f(Neighbours {
        far: &std::array::from_fn(|n| entry(0, 2, n)),
        near: &std::array::from_fn(|n| entry(3, 7, n)),
        own: &std::array::from_fn(|n| entry(8, 9, n)),
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::parallel::layout::Layout;

    const SIZE: [usize; 2] = [11, 9];

    /// Returns the coefficient of two cells at a distance, which decays like the compliance of a half-space.
    fn coefficient(columns: usize, rows: usize) -> f64 {
        if columns + rows == 0 {
            3.5
        } else {
            1.0 / (columns as f64).hypot(1.1 * rows as f64)
        }
    }

    fn inverse(columns: usize) -> SparseInverse<1> {
        SparseInverse {
            factors: Arc::new(SparseFactors::new(|_, x, y| coefficient(x, y))),
            columns,
        }
    }

    /// Returns the matrix of the sparse inverse on the cells that move.
    fn matrix([columns, rows]: [usize; 2], moves: impl Fn(usize) -> bool + Sync) -> Vec<Vec<f64>> {
        let layout = Layout::of([columns, rows]);
        let mut moving = FreeCells::new(layout.clone()).unwrap();
        moving.update(&moves);
        let marks: Vec<f64> = (0..layout.cells())
            .map(|cell| f64::from(u8::from(moves(cell))))
            .collect();
        let (inverse, mut scratch) = (inverse(columns), SparseScratch::new());
        inverse
            .find_patterns(&moving, &marks, &mut scratch)
            .unwrap();
        let unit = |cell: usize| {
            let mut unit = vec![0.0; layout.cells()];
            unit[cell] = 1.0;
            let mut image = [vec![0.0; layout.cells()]];
            assert!(inverse.apply(&moving, [&unit], &mut image, &mut scratch));
            let [image] = image;
            (0..layout.cells())
                .filter(|cell| moves(*cell))
                .map(|cell| image[cell])
                .collect()
        };
        (0..layout.cells())
            .filter(|cell| moves(*cell))
            .map(unit)
            .collect()
    }

    /// Returns the coefficients of the cells that move.
    fn compliance([columns, rows]: [usize; 2], moves: impl Fn(usize) -> bool) -> Vec<Vec<f64>> {
        let cells: Vec<_> = (0..columns * rows).filter(|cell| moves(*cell)).collect();
        let entry = |a: usize, b: usize| {
            let along = |of: fn(usize, usize) -> usize| of(a, columns).abs_diff(of(b, columns));
            coefficient(along(|a, n| a % n), along(|a, n| a / n))
        };
        let row = |&a: &usize| cells.iter().map(|&b| entry(a, b)).collect();
        cells.iter().map(row).collect()
    }

    fn product(a: &[Vec<f64>], b: &[Vec<f64>]) -> Vec<Vec<f64>> {
        let entry =
            |row: &[f64], column: usize| row.iter().zip(b).map(|(a, b)| a * b[column]).sum::<f64>();
        a.iter()
            .map(|row| (0..b.len()).map(|column| entry(row, column)).collect())
            .collect()
    }

    fn assert_is_inverse(size: [usize; 2], moves: impl Fn(usize) -> bool + Sync) {
        let unity = product(&matrix(size, &moves), &compliance(size, &moves));
        for (a, row) in unity.iter().enumerate() {
            for (b, value) in row.iter().enumerate() {
                let unit = f64::from(u8::from(a == b));
                assert!((value - unit).abs() < 1e-12, "{a} {b} {value}");
            }
        }
    }

    /// The inverse is exact if every cell is an earlier neighbour of all later cells.
    #[test]
    fn sparse_inverse_of_few_adjacent_cells_is_the_inverse() {
        for corner in [0, 4, 9, 11, 40, 11 * 7, 11 * 7 + 9] {
            let moves = move |cell: usize| [0, 1, 11, 12].iter().any(|step| corner + step == cell);
            assert_is_inverse(SIZE, moves);
        }
        assert_is_inverse([1, 30], |cell| (7..10).contains(&cell));
        assert_is_inverse([30, 1], |cell| (7..10).contains(&cell));
        assert_is_inverse([2, 9], |cell| (6..10).contains(&cell));
    }

    /// The first and the last cell of two adjacent rows are not neighbours.
    #[test]
    fn ends_of_adjacent_rows_are_not_neighbours() {
        let ends = [10, 11, 22, 32];
        let found = matrix(SIZE, |cell| ends.contains(&cell));
        let own = 1.0 / coefficient(0, 0);
        // Cells 11 and 22 are adjacent, as are cells 10 and 32, which are two rows apart.
        assert!((found[0][0] - own).abs() > 1e-3 && (found[1][1] - own).abs() > 1e-3);
        for [a, b] in [[0, 1], [0, 2], [1, 3], [2, 3]] {
            assert!(found[a][b].abs() < f64::MIN_POSITIVE, "{a} {b}");
        }
    }

    /// Among all factors with this pattern, the row minimises `g'Cg` for its diagonal entry. Therefore `G C G'` has a unit
    /// diagonal.
    #[test]
    fn rows_have_unit_energy() {
        let factors = SparseFactors::<1>::new(|_, x, y| coefficient(x, y));
        let [table] = factors.tables().unwrap();
        assert_eq!(table.len(), PATTERNS + 1);
        let place = |entry: usize| EARLIER.get(entry).copied().unwrap_or([0; 2]);
        for (pattern, row) in table[..PATTERNS].iter().enumerate() {
            for entry in 0..ENTRIES {
                let product: f64 = (0..ENTRIES)
                    .map(|other| {
                        let ([x, y], [u, v]) = (place(entry), place(other));
                        coefficient(x.abs_diff(u).into(), y.abs_diff(v).into()) * row[other]
                    })
                    .sum();
                let is_own = entry == EARLIER.len();
                if pattern >> entry & 1 == 1 && !is_own {
                    assert!(product.abs() < 1e-12, "pattern {pattern}, entry {entry}");
                } else if is_own {
                    assert!((product * row[entry] - 1.0).abs() < 1e-12);
                } else {
                    assert!(row[entry].abs() < f64::MIN_POSITIVE);
                }
            }
        }
    }

    #[test]
    fn indefinite_coefficients_are_rejected() {
        let factors = SparseFactors::<1>::new(|_, x, y| if x + y == 0 { 1.0 } else { -2.0 });
        assert!(factors.tables().is_none());
    }

    #[test]
    fn sparse_inverse_is_for_few_scattered_cells() {
        let suits = |moves: fn(usize) -> bool| {
            let layout = Layout::of([80, 80]);
            let mut moving = FreeCells::new(layout.clone()).unwrap();
            moving.update(moves);
            let marks: Vec<f64> = (0..layout.cells())
                .map(|cell| f64::from(u8::from(moves(cell))))
                .collect();
            inverse(80).prepare(&moving, &marks, &mut SparseScratch::new())
        };
        assert!(suits(|cell| cell % 7 == 0));
        // Half of the cells.
        assert!(!suits(|cell| cell % 2 == 0));
        // A square of 40 x 40 cells, and 16 squares of 4 x 4 cells.
        assert!(!suits(|cell| cell % 80 < 40 && cell / 80 < 40));
        assert!(suits(|cell| cell % 20 < 4 && cell / 80 % 20 < 4));
    }

    #[test]
    fn sparse_inverse_is_symmetric_and_positive_definite() {
        let mut state = 1_u64;
        let mut random = move || {
            state = state
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1);
            (state >> 11) as f64 / (1_u64 << 53) as f64
        };
        for case in 0..50 {
            let fraction = random();
            let moves: Vec<bool> = (0..SIZE[0] * SIZE[1])
                .map(|_| random() < fraction)
                .collect();
            let found = matrix(SIZE, |cell| moves[cell]);
            let vector: Vec<f64> = found.iter().map(|_| random() - 0.5).collect();
            let (mut energy, mut square) = (0.0, 0.0);
            for (a, row) in found.iter().enumerate() {
                for (b, value) in row.iter().enumerate() {
                    assert!((value - found[b][a]).abs() < 1e-14, "case {case}");
                    energy += vector[a] * value * vector[b];
                }
                square += vector[a] * vector[a];
            }
            assert!(energy >= 1e-3 * square, "case {case}");
        }
    }
}
