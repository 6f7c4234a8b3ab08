//! Uniform wear coefficient, or wear coefficient per cell.

use crate::error::{Result, non_negative};
use crate::grid::Grid;
use crate::grid::field::Field;
use crate::history::wear::check;

/// Wear coefficient, uniform or per cell. The wear laws accept a number or a field as the coefficient.
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
    /// Coefficient of all cells.
    Uniform(f64),
    /// Coefficient of each cell.
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
    /// Returns the value that must agree on all ranks, or `None` for a coefficient per cell.
    pub(super) fn common(self) -> Option<f64> {
        match self {
            Self::Uniform(coefficient) => Some(coefficient),
            Self::PerCell(_) => None,
        }
    }

    /// Returns an error if the coefficient is negative or not finite, or belongs to a different grid.
    pub(super) fn check(self, grid: Grid) -> Result<()> {
        let quantity = "wear coefficient";
        match self {
            Self::Uniform(coefficient) => non_negative(quantity, coefficient).map(|_| ()),
            Self::PerCell(field) => check(quantity, field, grid),
        }
    }

    /// Returns the largest coefficient of all cells.
    pub(super) fn largest(self) -> f64 {
        match self {
            Self::Uniform(coefficient) => coefficient,
            Self::PerCell(field) => greatest(field),
        }
    }

    /// Returns the coefficient of a cell.
    pub(super) fn at(self, index: usize) -> f64 {
        match self {
            Self::Uniform(coefficient) => coefficient,
            Self::PerCell(field) => field.as_slice()[index],
        }
    }
}

/// Returns the largest value of a non-negative field, or zero if a rank has no cells.
pub(super) fn greatest(field: &Field) -> f64 {
    field.max().max(0.0)
}
