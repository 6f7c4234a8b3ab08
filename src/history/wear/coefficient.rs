//! A wear coefficient, uniform or per cell.

use crate::error::{Result, non_negative};
use crate::grid::Grid;
use crate::grid::field::Field;
use crate::history::wear::check;

/// A wear coefficient: one for all cells, or one per cell. The laws take a number or a field for it.
///
/// ```
/// use stickslip::history::wear;
/// use stickslip::{Field, Grid};
/// let grid = Grid::square(16, 1.0)?;
/// // Only the half at positive x wears.
/// let soft = Field::from_fn(grid, |x, _| if x > 0.0 { 0.2 } else { 0.0 });
/// let (energy, mut depth) = (Field::constant(grid, 5.0), Field::zeros(grid));
/// wear::energy(&soft, &energy, &mut depth)?;
/// assert!((depth.integral() - 0.2 * 5.0 * 128.0).abs() < 1e-12);
/// # Ok::<(), stickslip::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum Coefficient<'a> {
    /// One for all cells.
    Uniform(f64),
    /// One per cell.
    PerCell(&'a Field),
}

impl From<f64> for Coefficient<'_> {
    fn from(coefficient: f64) -> Self {
        Self::Uniform(coefficient)
    }
}

impl<'a> From<&'a Field> for Coefficient<'a> {
    fn from(coefficients: &'a Field) -> Self {
        Self::PerCell(coefficients)
    }
}

impl Coefficient<'_> {
    /// That of it which is the same on all ranks; none of one per cell.
    pub(super) fn common(self) -> Option<f64> {
        match self {
            Self::Uniform(coefficient) => Some(coefficient),
            Self::PerCell(_) => None,
        }
    }

    /// `Ok` if it is non-negative and finite in the cells of the grid.
    pub(super) fn check(self, grid: Grid) -> Result<()> {
        let quantity = "wear coefficient";
        match self {
            Self::Uniform(coefficient) => non_negative(quantity, coefficient).map(|_| ()),
            Self::PerCell(field) => check(quantity, field, grid),
        }
    }

    /// The largest of all cells.
    pub(super) fn largest(self) -> f64 {
        match self {
            Self::Uniform(coefficient) => coefficient,
            Self::PerCell(field) => greatest(field),
        }
    }

    /// That of a cell.
    pub(super) fn at(self, index: usize) -> f64 {
        match self {
            Self::Uniform(coefficient) => coefficient,
            Self::PerCell(field) => field.as_slice()[index],
        }
    }
}

/// The largest sample of a quantity that is not negative; zero where a rank holds no cells.
pub(super) fn greatest(field: &Field) -> f64 {
    field.max().max(0.0)
}
