//! Removal of tilt and curvature from a measured surface.

use faer::Mat;

use super::heights::finite_or_missing;
use crate::error::{Error, Result};
use crate::field::Field;
use crate::grid::Grid;
use crate::parallel;

/// Highest degree of a form: 231 coefficients.
const HIGHEST_DEGREE: usize = 20;

/// Least part of a column that must be independent of the columns before it.
const INDEPENDENT: f64 = 1e-5;

/// Steps of refinement: the first finds the coefficients, the others bring them to round-off.
const REFINEMENTS: usize = 3;

/// The smooth form taken off a measured surface.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub enum Form {
    /// The mean height.
    Mean,
    /// The plane $`c_0 + c_1 x + c_2 y`$: the tilt of the specimen.
    Plane,
    /// A polynomial in x and y of this total degree, at most 20; degree 2 takes off the curvature of a
    /// ball or a cylinder.
    Polynomial(usize),
}

impl Form {
    fn degree(self) -> usize {
        match self {
            Self::Mean => 0,
            Self::Plane => 1,
            Self::Polynomial(degree) => degree,
        }
    }
}

/// A levelled surface and the form that was taken off it.
#[derive(Debug, Clone, PartialEq)]
pub struct Levelled {
    heights: Field,
    form: Field,
}

impl Levelled {
    /// The heights above the form (lengths); missing where they were missing.
    #[must_use]
    pub fn heights(&self) -> &Field {
        &self.heights
    }

    /// The form (lengths) in every cell, also where heights are missing.
    #[must_use]
    pub fn form(&self) -> &Field {
        &self.form
    }

    /// The heights, without the form.
    #[must_use]
    pub fn into_heights(self) -> Field {
        self.heights
    }
}

/// Takes a form off a measured surface, by least squares over the heights that are not NaN.
///
/// What remains is orthogonal to every polynomial of the form, to round-off. On a profile, a grid of
/// one row or one column, the form varies along it only. Missing heights stay missing:
/// [`fill_missing`](super::fill_missing) comes after.
///
/// The form is a sum of products of Legendre polynomials over the rectangle of the known heights. Its
/// matrix is never held at once: blocks of 4096 cells are reduced to their triangular factors, and these
/// in pairs to one, $`A = QR`$ (Demmel et al. 2012); then $`R^T R\,\Delta c = A^T (z - A c)`$ is solved
/// until the coefficients $`c`$ no longer change (corrected seminormal equations, Björck 1987).
///
/// # Errors
/// [`Error::Sample`] for the first infinite height; [`Error::Degree`] above degree 20;
/// [`Error::Undetermined`] if the known heights are too few for the form, or lie too nearly on a curve
/// that the form cannot tell from zero.
///
/// # References
/// - Å. Björck, *Linear Algebra Appl.* 88-89 (1987) 31-48,
///   [doi:10.1016/0024-3795(87)90101-7](https://doi.org/10.1016/0024-3795(87)90101-7).
/// - J. Demmel, L. Grigori, M. Hoemmen, J. Langou, *SIAM J. Sci. Comput.* 34 (2012) A206-A239,
///   [doi:10.1137/080731992](https://doi.org/10.1137/080731992).
///
/// ```
/// use stickslip::{Field, Grid, surface};
/// let grid = Grid::new(40, 30, 1.0, 1.0)?;
/// let mut measured = Field::from_fn(grid, |x, y| 3.0 + 0.1 * x - 0.2 * y + (x * y).sin());
/// measured.as_mut_slice()[17] = f64::NAN;
/// let levelled = surface::level(&measured, surface::Form::Plane)?;
/// let [left, right] = [0, 39].map(|ix| levelled.form().get(ix, 7));
/// let tilt = right.zip(left).map(|(right, left)| (right - left) / 39.0);
/// assert!(tilt.is_some_and(|tilt| (tilt - 0.1).abs() < 0.01));
/// assert!(levelled.heights().as_slice()[17].is_nan());
/// # Ok::<(), stickslip::Error>(())
/// ```
pub fn level(heights: &Field, form: Form) -> Result<Levelled> {
    finite_or_missing(heights)?;
    let (degree, limit) = (form.degree(), HIGHEST_DEGREE);
    if degree > limit {
        return Err(Error::Degree { degree, limit });
    }
    let z = heights.as_slice();
    let basis = Basis::new(heights, degree);
    let triangle = basis.triangle(z)?;
    let mut coefficients = vec![0.0; basis.terms.len()];
    for _ in 0..REFINEMENTS {
        let projection = basis.projection_of_rest(z, &coefficients);
        let mut change = Mat::from_fn(projection.len(), 1, |term, _| projection[term]);
        triangle
            .transpose()
            .solve_lower_triangular_in_place(&mut change);
        triangle.solve_upper_triangular_in_place(&mut change);
        for (term, coefficient) in coefficients.iter_mut().enumerate() {
            *coefficient += change[(term, 0)];
        }
    }
    let mut form = Field::zeros(heights.grid());
    parallel::update(form.as_mut_slice(), |first, chunk| {
        for (cell, value) in (first..).zip(chunk) {
            *value = basis.value(&coefficients, cell);
        }
    });
    let mut heights = heights.clone();
    for (height, form) in heights.as_mut_slice().iter_mut().zip(form.as_slice()) {
        *height -= form;
    }
    Ok(Levelled { heights, form })
}

/// Products of Legendre polynomials up to a total degree.
struct Basis {
    nx: usize,
    degree: usize,
    /// Degrees along x and along y of each product.
    terms: Vec<[usize; 2]>,
    /// The polynomials of degrees `0..=degree` at each column, and at each row.
    along_x: Vec<f64>,
    along_y: Vec<f64>,
}

impl Basis {
    fn new(heights: &Field, degree: usize) -> Self {
        let grid = heights.grid();
        let (nx, ny) = (grid.nx(), grid.ny());
        let terms = (0..=degree)
            .flat_map(|total| (0..=total).map(move |j| [total - j, j]))
            .filter(|&[i, j]| (nx > 1 || i == 0) && (ny > 1 || j == 0))
            .collect();
        let [columns, rows] = known_extent(grid, heights.as_slice());
        Self {
            nx,
            degree,
            terms,
            along_x: legendre(nx, columns, degree),
            along_y: legendre(ny, rows, degree),
        }
    }

    /// The product of a term in a cell.
    fn at(&self, cell: usize, term: usize) -> f64 {
        let [i, j] = self.terms[term];
        let width = self.degree + 1;
        self.along_x[cell % self.nx * width + i] * self.along_y[cell / self.nx * width + j]
    }

    /// The sum of the products in a cell.
    fn value(&self, coefficients: &[f64], cell: usize) -> f64 {
        let terms = coefficients.iter().enumerate();
        terms.map(|(term, c)| c * self.at(cell, term)).sum()
    }

    /// `R` of `A = QR`, with a row of `A` for each known height and a column for each term.
    fn triangle(&self, z: &[f64]) -> Result<Mat<f64>> {
        let count = self.terms.len();
        let reduced = |matrix: Mat<f64>| {
            if matrix.nrows() > count {
                matrix.qr().thin_R().to_owned()
            } else {
                matrix
            }
        };
        let rows = parallel::fold(
            z.len(),
            |range| {
                let known: Vec<usize> = range.filter(|&cell| !z[cell].is_nan()).collect();
                let entry = |row: usize, term| self.at(known[row], term);
                reduced(Mat::from_fn(known.len(), count, entry))
            },
            |a, b| {
                let height = a.nrows();
                reduced(Mat::from_fn(height + b.nrows(), count, |row, term| {
                    if row < height {
                        a[(row, term)]
                    } else {
                        b[(row - height, term)]
                    }
                }))
            },
        );
        let undetermined = Error::Undetermined {
            quantity: "form",
            unknowns: count,
            known: z.iter().filter(|z| !z.is_nan()).count(),
        };
        if rows.nrows() < count {
            return Err(undetermined);
        }
        let triangle = rows.qr().thin_R().to_owned();
        let is_independent =
            |term: usize| triangle[(term, term)].abs() > INDEPENDENT * triangle.col(term).norm_l2();
        if (0..count).all(is_independent) {
            Ok(triangle)
        } else {
            Err(undetermined)
        }
    }

    /// `A' (z - A c)`: what the terms still find in the known heights.
    fn projection_of_rest(&self, z: &[f64], coefficients: &[f64]) -> Vec<f64> {
        parallel::fold(
            z.len(),
            |range| {
                let mut sums = vec![0.0; coefficients.len()];
                for cell in range.filter(|&cell| !z[cell].is_nan()) {
                    let rest = z[cell] - self.value(coefficients, cell);
                    for (term, sum) in sums.iter_mut().enumerate() {
                        *sum += rest * self.at(cell, term);
                    }
                }
                sums
            },
            |a, b| a.iter().zip(b).map(|(a, b)| a + b).collect(),
        )
    }
}

/// First and last column, and first and last row, of the rectangle that holds every known height.
fn known_extent(grid: Grid, z: &[f64]) -> [[usize; 2]; 2] {
    let known = |cell: &usize| !z[*cell].is_nan();
    let extent = |places: &mut dyn Iterator<Item = usize>| {
        places.fold([usize::MAX, 0], |[first, last], place| {
            [first.min(place), last.max(place)]
        })
    };
    let cells = || (0..grid.cells()).filter(known);
    [
        extent(&mut cells().map(|cell| cell % grid.nx())),
        extent(&mut cells().map(|cell| cell / grid.nx())),
    ]
}

/// Legendre polynomials of degrees `0..=degree` at the places `0..count`, on the interval from the
/// first known place to the last.
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
            // (n + 1) P_{n+1} = (2n + 1) x P_n - n P_{n-1}
            (before, here) = (here, ((2.0 * n + 1.0) * x * here - n * before) / (n + 1.0));
        }
    }
    table
}
