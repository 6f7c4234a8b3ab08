//! The sum of shapes.

use crate::error::{Error, Result};
use crate::grid::field::Field;

/// The sum of fields, cell by cell: a rough ball is a ball plus roughness, and the gap between two
/// bodies is the sum of both shapes.
///
/// # Errors
/// [`Error::Length`] if there is no field, [`Error::GridMismatch`] if the fields are on different grids.
///
/// ```
/// use stickslip::{Grid, surface};
/// let grid = Grid::square(32, 2.0)?;
/// let ball = surface::sphere(grid, 10.0)?;
/// let rough = surface::SelfAffine::with_rms_height(1e-3).generate(grid)?;
/// let roughness = surface::gap_from_heights(rough.heights())?;
/// let gap = surface::sum(&[&ball, &roughness])?;
/// assert_eq!(gap.as_slice()[5], ball.as_slice()[5] + roughness.as_slice()[5]);
/// # Ok::<(), stickslip::Error>(())
/// ```
pub fn sum(fields: &[&Field]) -> Result<Field> {
    let (first, others) = fields.split_first().ok_or(Error::Length {
        quantity: "list of fields",
        expected: 1,
        found: 0,
    })?;
    let mut sum = Field::clone(first);
    for other in others {
        sum.grid().expect("a summand", other.grid())?;
        for (sum, term) in sum.as_mut_slice().iter_mut().zip(other.as_slice()) {
            *sum += term;
        }
    }
    Ok(sum)
}
