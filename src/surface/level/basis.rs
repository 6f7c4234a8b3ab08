//! Polynomial basis of a form.

use std::ops::Range;

use super::triangle::Triangle;
use crate::grid::field::Field;
use crate::parallel;
use crate::parallel::layout::Layout;
use crate::parallel::reduce::Reduction;
use crate::surface::level::HIGHEST_DEGREE;
use crate::surface::slab::Slab;

/// Largest number of sums computed together: the number of terms of the form of highest degree.
const MOST: usize = (HIGHEST_DEGREE + 1) * (HIGHEST_DEGREE + 2) / 2;

/// Largest number of terms whose sums are reduced row by row. Several ranks require this order. A plane, the largest
/// form on ranks, has three terms. With more terms, the sums are reduced in equal chunks of cells.
const IN_ROWS: usize = 9;

/// Number of rows that are reduced together. For the highest degree these rows need 120 kB.
const ROWS_AT_ONCE: usize = 64;

/// Products of Legendre polynomials up to a total degree.
pub(super) struct Basis<'a> {
    slab: &'a Slab,
    /// Order of the sums.
    layout: Layout,
    nx: usize,
    degree: usize,
    /// Degrees of each product along x and along y.
    terms: Vec<[usize; 2]>,
    /// Polynomials of degrees `0..=degree` at each column.
    along_x: Vec<f64>,
    /// Polynomials of degrees `0..=degree` at each row.
    along_y: Vec<f64>,
}

impl<'a> Basis<'a> {
    pub(super) fn new(heights: &Field, slab: &'a Slab, degree: usize) -> Self {
        let grid = slab.whole();
        let (nx, ny) = (grid.nx(), grid.ny());
        let terms: Vec<_> = (0..=degree)
            .flat_map(|total| (0..=total).map(move |j| [total - j, j]))
            .filter(|&[i, j]| (nx > 1 || i == 0) && (ny > 1 || j == 0))
            .collect();
        let [columns, rows] = known_extent(slab, heights.as_slice());
        let layout = if terms.len() > IN_ROWS {
            Layout::flat(heights.grid().cells())
        } else {
            slab.layout().clone()
        };
        Self {
            slab,
            layout,
            nx,
            degree,
            terms,
            along_x: legendre(nx, columns, degree),
            along_y: legendre(ny, rows, degree),
        }
    }

    /// Returns the number of products.
    pub(super) fn terms(&self) -> usize {
        self.terms.len()
    }

    /// Returns the value of a product in a cell.
    fn at(&self, cell: usize, term: usize) -> f64 {
        let [i, j] = self.terms[term];
        let width = self.degree + 1;
        let row = self.slab.first_row() + cell / self.nx;
        self.along_x[cell % self.nx * width + i] * self.along_y[row * width + j]
    }

    /// Returns the sum of all terms in a cell.
    pub(super) fn value(&self, coefficients: &[f64], cell: usize) -> f64 {
        let terms = coefficients.iter().enumerate();
        terms.map(|(term, c)| c * self.at(cell, term)).sum()
    }

    /// Computes `A'A`, row by row, where `A` has a row for each known height and a column for each term.
    pub(super) fn products(&self, z: &[f64]) -> Vec<f64> {
        let count = self.terms();
        self.sums(z, count * count, |cell, sums| {
            for (first, row) in sums.chunks_exact_mut(count).enumerate() {
                for (second, sum) in row.iter_mut().enumerate() {
                    *sum += self.at(cell, first) * self.at(cell, second);
                }
            }
        })
    }

    /// Computes `count` sums over all known heights. `add` adds the terms of one cell.
    fn sums(&self, z: &[f64], count: usize, add: impl Fn(usize, &mut [f64]) + Sync) -> Vec<f64> {
        let leaf = |range: Range<usize>| {
            let mut sums = [0.0; MOST];
            for cell in range.filter(|&cell| !z[cell].is_nan()) {
                add(cell, &mut sums[..count]);
            }
            sums
        };
        self.layout.fold(leaf, Reduction::plus)[..count].to_vec()
    }

    /// Computes `R` of `A = QR` by reduction of blocks of rows.
    pub(super) fn reduced(&self, z: &[f64]) -> Triangle {
        let count = self.terms();
        let leaf = |range: Range<usize>| {
            let known: Vec<usize> = range.filter(|&cell| !z[cell].is_nan()).collect();
            let mut triangle = Triangle::from_fn(count, |_, _| 0.0);
            for cells in known.chunks(ROWS_AT_ONCE) {
                let row = |&cell: &usize| (0..count).map(move |term| self.at(cell, term));
                triangle.absorb(&mut cells.iter().flat_map(row).collect::<Vec<_>>());
            }
            triangle
        };
        parallel::fold(z.len(), leaf, Triangle::with)
    }

    /// Computes `A' (z - A c)`, the projection of the residual of the known heights onto the terms.
    pub(super) fn projection_of_rest(&self, z: &[f64], coefficients: &[f64]) -> Vec<f64> {
        self.sums(z, coefficients.len(), |cell, sums| {
            let rest = z[cell] - self.value(coefficients, cell);
            for (term, sum) in sums.iter_mut().enumerate() {
                *sum += rest * self.at(cell, term);
            }
        })
    }
}

/// Returns the extent of the rectangle that encloses the known heights of all ranks. The first pair contains the first
/// and the last column, the second pair the first and the last row.
fn known_extent(slab: &Slab, z: &[f64]) -> [[usize; 2]; 2] {
    let nx = slab.whole().nx();
    let around =
        |[first, last]: [usize; 2], place: [usize; 2]| [first.min(place[0]), last.max(place[1])];
    let both = |[a, b]: [[usize; 2]; 2], [c, d]: [[usize; 2]; 2]| [around(a, c), around(b, d)];
    let known = (0..z.len()).filter(|&cell| !z[cell].is_nan());
    let places = known.map(|cell| [cell % nx, slab.first_row() + cell / nx].map(|at| [at; 2]));
    slab.layout()
        .combined(places.fold([[usize::MAX, 0]; 2], both), both)
}

/// Tabulates the Legendre polynomials of degrees `0..=degree` at the positions `0..count`. Their interval extends from
/// the first to the last position with a known height.
fn legendre(count: usize, [first, last]: [usize; 2], degree: usize) -> Vec<f64> {
    let (first, last) = (first as f64, last as f64);
    let half = (0.5 * (last - first)).max(0.5);
    let mut table = Vec::with_capacity(count * (degree + 1));
    for place in 0..count {
        let x = (place as f64 - 0.5 * (first + last)) / half;
        let (mut before, mut here) = (0.0, 1.0);
        for n in 0..=degree {
            table.push(here);
            let n = n as f64;
            // Recurrence: (n + 1) P_{n+1} = (2n + 1) x P_n - n P_{n-1}.
            (before, here) = (here, ((2.0 * n + 1.0) * x * here - n * before) / (n + 1.0));
        }
    }
    table
}
