//! Removal of tilt and curvature from a measured surface.

mod basis;
mod triangle;

use super::heights::finite_or_missing;
use super::slab::Slab;
use crate::error::{Error, Result};
use crate::grid::field::Field;
use crate::grid::record::checked_struct;
use crate::parallel;
use basis::Basis;
use triangle::Triangle;

/// Highest degree of a form, which has 231 coefficients.
const HIGHEST_DEGREE: usize = 20;

/// Number of refinement steps. The first step computes the coefficients, and the later steps reduce their error to
/// round-off.
const REFINEMENTS: usize = 3;

/// Smooth form that is removed from a measured surface.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub enum Form {
    /// Mean height.
    Mean,
    /// Plane $`c_0 + c_1 x + c_2 y`$, the tilt of the specimen.
    Plane,
    /// Polynomial in x and y of this total degree, at most 20. Degree 2 removes the curvature of a ball or a cylinder.
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

    /// Computes `R` of `A = QR`, with a row of `A` for each known height and a column for each term.
    fn triangle(self, basis: &Basis<'_>, z: &[f64]) -> Triangle {
        match self {
            Self::Mean | Self::Plane => Triangle::of_products(basis.terms(), &basis.products(z)),
            Self::Polynomial(_) => basis.reduced(z),
        }
    }
}

checked_struct! {
    /// A levelled surface and the form that was removed from it.
    #[derive(Debug, Clone, PartialEq)]
    pub struct Levelled {
        heights: Field,
        form: Field,
    }
    #[serde(remote = "Levelled", deny_unknown_fields)]
    check(read) {
        let grid = read.heights.grid();
        grid.check_equal("form", read.form.grid())
    }
}

impl Levelled {
    /// Returns the heights above the form (lengths). Missing heights stay missing.
    #[must_use]
    pub fn heights(&self) -> &Field {
        &self.heights
    }

    /// Returns the form (lengths) in every cell, including cells with missing heights.
    #[must_use]
    pub fn form(&self) -> &Field {
        &self.form
    }

    /// Returns the heights without the form.
    #[must_use]
    pub fn into_heights(self) -> Field {
        self.heights
    }
}

/// Removes a form from a measured surface by a least-squares fit to the heights that are not NaN.
///
/// The remainder is orthogonal to every polynomial of the form, to round-off. On a profile (a grid of one row or one
/// column) the form varies along the profile only. Missing heights stay missing. They can be filled afterwards with
/// [`fill_missing`](super::fill_missing). For a distributed surface use [`HalfSpace::level`](crate::HalfSpace::level).
///
/// The form is a sum of products of Legendre polynomials over the rectangle of the known heights. The matrix $`A`$ of
/// the least-squares problem is never stored. Only a triangular factor $`R`$ is computed. For a mean or a plane it is
/// the Cholesky factor of $`A^T A = R^T R`$. For a polynomial, blocks of 4096 cells are reduced to their factors. The
/// factors are then combined in pairs until $`A = QR`$ (Demmel et al. 2012). Three steps of
/// $`R^T R\,\Delta c = A^T (z - A c)`$ determine the coefficients $`c`$ to round-off. These steps are the corrected
/// seminormal equations (Björck 1987).
///
/// # Errors
/// - [`Error::Sample`] with the first infinite height.
/// - [`Error::Degree`] if the degree exceeds 20.
/// - [`Error::Undetermined`] if there are too few known heights. The error is also returned if the known heights lie
///   too close to a zero curve of a polynomial of the form.
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
    level_slab(heights, &Slab::alone(heights)?, form)
}

/// Removes a form from the local slab of a surface, which may be distributed over ranks.
pub(crate) fn level_slab(heights: &Field, slab: &Slab, form: Form) -> Result<Levelled> {
    if let Form::Polynomial(_) = form {
        slab.layout().check_alone("the removal of a polynomial")?;
    }
    slab.layout()
        .collective_result(finite_or_missing(heights))?;
    let (degree, limit) = (form.degree(), HIGHEST_DEGREE);
    if degree > limit {
        return Err(Error::Degree { degree, limit });
    }
    let z = heights.as_slice();
    let basis = Basis::new(heights, slab, degree);
    let known = z.iter().filter(|z| !z.is_nan()).count();
    let known = slab.layout().combined(known, |a, b| a + b);
    let unknowns = basis.terms();
    let undetermined = Error::Undetermined {
        quantity: "form",
        unknowns,
        known,
    };
    slab.layout().check()?;
    if known < unknowns {
        return Err(undetermined);
    }
    let cells = z.len();
    let triangle = parallel::enter_with(cells, || form.triangle(&basis, z));
    slab.layout().check()?;
    if !triangle.is_independent() {
        return Err(undetermined);
    }
    let mut coefficients = vec![0.0; unknowns];
    for _ in 0..REFINEMENTS {
        let mut change = parallel::enter_with(cells, || basis.projection_of_rest(z, &coefficients));
        triangle.solve_squared(&mut change);
        for (coefficient, change) in coefficients.iter_mut().zip(change) {
            *coefficient += change;
        }
    }
    slab.layout().check()?;
    let mut form = Field::zeros(heights.grid());
    parallel::enter_with(cells, || {
        parallel::update(form.as_mut_slice(), |first, chunk| {
            for (cell, value) in (first..).zip(chunk) {
                *value = basis.value(&coefficients, cell);
            }
        });
    });
    let mut heights = heights.clone();
    for (height, form) in heights.as_mut_slice().iter_mut().zip(form.as_slice()) {
        *height -= form;
    }
    Ok(Levelled { heights, form })
}
