//! Selection of columns and rows of a surface.

use std::ops::Range;

use crate::error::{Error, Result};
use crate::grid::Grid;
use crate::grid::field::Field;

/// Returns the columns and rows of a surface in the given ranges, as a surface on a new grid.
///
/// The new grid has cells of the same size. Every grid is centred on the origin, so the positions of the heights shift
/// by the distance between the two centres. Missing heights stay missing.
///
/// # Errors
/// - [`Error::Range`] if a range is empty or extends beyond the grid.
///
/// ```
/// use stickslip::{Field, Grid, surface};
/// let measured = Field::from_fn(Grid::new(6, 4, 1.0, 1.0)?, |x, y| x + 10.0 * y);
/// let part = surface::crop(&measured, 2..5, 1..3)?;
/// assert_eq!([part.grid().nx(), part.grid().ny()], [3, 2]);
/// assert_eq!(part.get(0, 0), measured.get(2, 1));
/// # Ok::<(), stickslip::Error>(())
/// ```
pub fn crop(heights: &Field, columns: Range<usize>, rows: Range<usize>) -> Result<Field> {
    let grid = heights.grid();
    check("columns", &columns, grid.nx())?;
    check("rows", &rows, grid.ny())?;
    let part = Grid::new(columns.len(), rows.len(), grid.dx(), grid.dy())?;
    let kept = heights.rows().skip(rows.start).take(rows.len());
    let samples = kept.flat_map(|row| &row[columns.clone()]).copied();
    Field::from_vec(part, samples.collect())
}

fn check(quantity: &'static str, range: &Range<usize>, count: usize) -> Result<()> {
    if range.is_empty() || range.end > count {
        Err(Error::Range {
            quantity,
            start: range.start,
            end: range.end,
            count,
        })
    } else {
        Ok(())
    }
}
