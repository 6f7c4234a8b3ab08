//! Interpolation of a surface to a different grid.

use super::heights::complete;
use crate::error::{Error, Result, all_finite, memory};
use crate::grid::Grid;
use crate::grid::field::Field;
use crate::numerics::interpolation::{CUBIC, LagrangeStencil};
use crate::parallel;

/// Round-off tolerance for the extent of a grid, in cells.
const SLACK: f64 = 1e-9;

/// Interpolates a surface at the cell centres of a different grid.
///
/// The interpolation is bicubic. Along each axis it uses the cubic through the four nearest samples. If the axis has
/// fewer than four samples, it uses the polynomial through all samples. The interpolation is exact for polynomials of
/// degree three in x and in y. For a smooth surface the error falls with the fourth power of the cell sides of
/// `heights`. Interpolated heights can lie slightly above or below the two neighbouring samples. Both grids are centred
/// on the origin.
///
/// On a coarser grid the function evaluates heights at points and does not average them. Waves shorter than two cells
/// of this grid are therefore aliased to longer waves.
///
/// # Errors
/// - [`Error::Sample`] with the first height that is missing or infinite, or that overflows.
/// - [`Error::BeyondSamples`] if a cell centre of the new grid is outside the grid of `heights`. Such a centre is more
///   than half a cell beyond the outermost sample.
/// - [`Error::Memory`] if the field cannot be allocated.
///
/// ```
/// use stickslip::{Field, Grid, surface};
/// let smooth = |x: f64, y: f64| x * x * x - 2.0 * x * y * y;
/// let coarse = Field::from_fn(Grid::square(8, 4.0)?, smooth);
/// let fine = surface::resample(&coarse, Grid::square(20, 4.0)?)?;
/// let expected = Field::from_fn(fine.grid(), smooth);
/// let pairs = fine.as_slice().iter().zip(expected.as_slice());
/// assert!(pairs.into_iter().all(|(a, b)| (a - b).abs() < 1e-13));
/// # Ok::<(), stickslip::Error>(())
/// ```
pub fn resample(heights: &Field, grid: Grid) -> Result<Field> {
    complete("height", heights)?;
    memory("the resampled surface", grid.size(), size_of::<f64>())?;
    let source = heights.grid();
    let columns = SourceAxis {
        name: "x",
        count: source.nx(),
        side: source.dx(),
    };
    let rows = SourceAxis {
        name: "y",
        count: source.ny(),
        side: source.dy(),
    };
    let columns = columns.stencils(grid.nx(), |ix| grid.x(ix))?;
    let rows = rows.stencils(grid.ny(), |iy| grid.y(iy))?;

    let (z, width) = (heights.as_slice(), source.nx());
    let mut resampled = Field::zeros(grid);
    parallel::enter_with(grid.cells(), || {
        parallel::rows(resampled.as_mut_slice(), grid.nx(), |row, out| {
            for (value, column) in out.iter_mut().zip(&columns) {
                *value = rows[row].apply(|iy| column.apply(|ix| z[iy * width + ix]));
            }
        });
    });
    all_finite("resampled surface", resampled.as_slice())?;
    Ok(resampled)
}

/// Interpolation between the samples of a surface.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub enum Interpolation {
    /// The cubic through the four nearest samples along each axis (default), as in [`resample`].
    #[default]
    Cubic,
    /// The line between the two nearest samples along each axis. The values lie between the samples.
    Linear,
}

impl Interpolation {
    /// Returns the number of samples that determine a value, along an axis.
    fn width(self) -> usize {
        match self {
            Self::Cubic => CUBIC,
            Self::Linear => 2,
        }
    }
}

/// Interpolates a surface at any positions `[x, y]` (lengths) within its grid.
pub(crate) fn interpolate(
    heights: &Field,
    interpolation: Interpolation,
    positions: &[[f64; 2]],
    out: &mut [f64],
) -> Result<()> {
    let (grid, z) = (heights.grid(), heights.as_slice());
    let axes = [("x", grid.nx(), grid.dx()), ("y", grid.ny(), grid.dy())];
    for (value, position) in out.iter_mut().zip(positions) {
        let mut stencils = [None, None];
        for ((stencil, &reach), (axis, count, side)) in stencils.iter_mut().zip(position).zip(axes)
        {
            let limit = 0.5 * count as f64 * side;
            if reach.is_nan() || reach.abs() > limit + SLACK * side {
                return Err(Error::BeyondSamples { axis, reach, limit });
            }
            let middle = 0.5 * (count - 1) as f64;
            let width = interpolation.width();
            *stencil = Some(LagrangeStencil::at(reach / side + middle, count, width));
        }
        if let [Some(column), Some(row)] = &stencils {
            *value = row.apply(|iy| column.apply(|ix| z[iy * grid.nx() + ix]));
        }
    }
    Ok(())
}

/// An axis of the source.
struct SourceAxis {
    name: &'static str,
    count: usize,
    side: f64,
}

impl SourceAxis {
    /// Returns the samples and weights that interpolate the values at the centres of an axis of the new grid.
    fn stencils(
        &self,
        count: usize,
        centre: impl Fn(usize) -> f64,
    ) -> Result<Vec<LagrangeStencil>> {
        // The centres are symmetric about the middle, so the last centre is the farthest.
        let reach = centre(count - 1);
        let half_side = 0.5 * self.count as f64 * self.side;
        if reach > half_side + SLACK * self.side {
            return Err(Error::BeyondSamples {
                axis: self.name,
                reach,
                limit: half_side,
            });
        }
        let middle = 0.5 * (self.count - 1) as f64;
        let stencil =
            |i: usize| LagrangeStencil::at(centre(i) / self.side + middle, self.count, CUBIC);
        Ok((0..count).map(stencil).collect())
    }
}
