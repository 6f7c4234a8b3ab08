//! Computation of the gap between bodies from their heights.

use super::heights::complete;
use crate::error::{Result, finite};
use crate::grid::field::Field;

/// Returns the inverted surface, `-z`: peaks become valleys, as in a replica.
#[must_use]
pub fn inverted(heights: &Field) -> Field {
    let mut inverted = heights.clone();
    for z in inverted.as_mut_slice() {
        *z = -*z;
    }
    inverted
}

/// Returns the surface mirrored along x, `z(-x, y)`.
///
/// A body may be measured from above and then turned over about the y axis to face a second body. The mirrored surface
/// is then the surface of the measured body in the frame of the second body. The heights still point out of the
/// measured body. Missing heights stay missing.
#[must_use]
pub fn mirror_x(heights: &Field) -> Field {
    let mut mirrored = heights.clone();
    let nx = heights.grid().nx();
    for row in mirrored.as_mut_slice().chunks_exact_mut(nx) {
        row.reverse();
    }
    mirrored
}

/// Computes the gap between a rough body and a plane that touches its highest peak, `h = max z - z`.
///
/// `heights` point out of the body. The gap is a length with minimum zero. The highest peak is the maximum of the given
/// heights. For a slab of a distributed surface use [`HalfSpace::max_of`](crate::HalfSpace::max_of).
///
/// # Errors
/// - [`Error::Sample`](crate::Error::Sample) with the first height that is missing or infinite.
/// - [`Error::NotFinite`](crate::Error::NotFinite) if the range of the heights overflows.
pub fn gap_from_heights(heights: &Field) -> Result<Field> {
    complete("height", heights)?;
    let highest = heights.max();
    finite("range of the heights", highest - heights.min())?;
    let mut gap = heights.clone();
    for z in gap.as_mut_slice() {
        *z = highest - *z;
    }
    Ok(gap)
}

/// Computes the gap between two rough bodies that touch at one point, `h = max(z_1 + z_2) - (z_1 + z_2)`.
///
/// The heights of each surface point out of its body and towards the other body. The peaks of both bodies therefore
/// reduce the gap. Both surfaces must be given in the same frame. First apply [`mirror_x`] to the body that was turned
/// over. The gap is a length with minimum zero.
///
/// # Errors
/// - [`Error::GridMismatch`](crate::Error::GridMismatch) if the grids differ.
/// - [`Error::Sample`](crate::Error::Sample) with the first height that is missing or infinite.
/// - [`Error::NotFinite`](crate::Error::NotFinite) if the range of the sum overflows.
///
/// ```
/// use stickslip::{Field, Grid, surface};
/// let grid = Grid::new(3, 1, 1.0, 1.0)?;
/// let lower = Field::from_vec(grid, vec![0.0, 1.0, 0.5])?;
/// let measured = Field::from_vec(grid, vec![2.0, 0.25, 0.0])?;
/// let upper = surface::mirror_x(&measured);
/// let gap = surface::gap_between(&upper, &lower)?;
/// assert_eq!(gap.as_slice(), [2.5, 1.25, 0.0]);
/// # Ok::<(), stickslip::Error>(())
/// ```
pub fn gap_between(upper: &Field, lower: &Field) -> Result<Field> {
    lower.grid().check_equal("upper surface", upper.grid())?;
    complete("upper surface", upper)?;
    complete("lower surface", lower)?;
    let mut sum = upper.clone();
    for (z, lower) in sum.as_mut_slice().iter_mut().zip(lower.as_slice()) {
        *z += lower;
    }
    gap_from_heights(&sum)
}
