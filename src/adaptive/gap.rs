//! Sources of the gap: functions of the position, and samples.

use crate::error::{Result, samples_obey};
#[cfg(feature = "roughness")]
use crate::grid::field::Field;
use crate::memory::fallible::filled;
#[cfg(feature = "roughness")]
use crate::surface::{Interpolation, interpolate};

/// Gap between the undeformed bodies at any position.
///
/// Functions `f(x, y)` that return the gap implement this trait.
pub trait GapFunction {
    /// Writes the gap at each position `[x, y]` (lengths) into `gaps`.
    ///
    /// # Errors
    /// The solve ends and returns the error.
    fn evaluate(&self, positions: &[[f64; 2]], gaps: &mut [f64]) -> Result<()>;

    /// Returns the distances between samples along x and y (lengths), or `None` if the gap is defined everywhere.
    ///
    /// Smaller cells resolve only the interpolation between the samples. A solve therefore uses no cells below this size.
    fn sample_spacing(&self) -> Option<[f64; 2]> {
        None
    }
}

impl<F: Fn(f64, f64) -> f64> GapFunction for F {
    fn evaluate(&self, positions: &[[f64; 2]], gaps: &mut [f64]) -> Result<()> {
        for (gap, &[x, y]) in gaps.iter_mut().zip(positions) {
            *gap = self(x, y);
        }
        Ok(())
    }
}

/// Gap interpolated between samples, for instance of a measured surface.
#[cfg(feature = "roughness")]
#[derive(Debug, Clone, PartialEq)]
pub struct SampledGap {
    samples: Field,
    interpolation: Interpolation,
}

#[cfg(feature = "roughness")]
impl SampledGap {
    /// Creates the gap from its samples at the centres of the cells of a grid that is centred on the origin.
    /// [`gap_from_heights`](crate::surface::gap_from_heights) computes the gap of measured heights.
    ///
    /// # Errors
    /// - [`Error::Sample`](crate::Error::Sample) if a sample is missing or infinite.
    pub fn new(gap: Field, interpolation: Interpolation) -> Result<Self> {
        gap.check("gap", gap.grid())?;
        Ok(Self {
            samples: gap,
            interpolation,
        })
    }

    /// Returns the samples of the gap (lengths).
    #[must_use]
    pub fn samples(&self) -> &Field {
        &self.samples
    }
}

#[cfg(feature = "roughness")]
impl GapFunction for SampledGap {
    fn evaluate(&self, positions: &[[f64; 2]], gaps: &mut [f64]) -> Result<()> {
        interpolate(&self.samples, self.interpolation, positions, gaps)
    }

    fn sample_spacing(&self) -> Option<[f64; 2]> {
        let grid = self.samples.grid();
        Some([grid.dx(), grid.dy()])
    }
}

/// Evaluates the gap at all positions. Returns an error if a gap is not finite.
pub(super) fn evaluate(gap: &dyn GapFunction, positions: &[[f64; 2]]) -> Result<Vec<f64>> {
    let mut gaps = filled(0.0, positions.len())?;
    gap.evaluate(positions, &mut gaps)?;
    let rule = "must be finite at every position of the region";
    samples_obey("gap", &gaps, rule, f64::is_finite)?;
    Ok(gaps)
}
