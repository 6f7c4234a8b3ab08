//! A generated surface and its parameters.

use num_complex::Complex;

use super::crop_window::CropWindow;
use super::moments::{Standardised, mean_of};
use crate::error::Result;
use crate::grid::field::Field;
use crate::observer::WorkObserver;
use crate::surface::waves::Waves;

/// A surface made by [`SelfAffine`](super::SelfAffine), with its parameters.
#[derive(Debug, Clone, PartialEq)]
pub struct RoughSurface {
    heights: Field,
    rms_height: f64,
    rms_slope: f64,
    skewness: f64,
    kurtosis: f64,
    iterations: usize,
}

impl RoughSurface {
    /// The part of the waves within a cut, minus its mean.
    ///
    /// # Errors
    /// [`Error::NotConverged`](crate::Error::NotConverged) if the observer cancels.
    pub(super) fn new(
        waves: &Waves,
        cut: &CropWindow,
        iterations: usize,
        watch: &mut WorkObserver<'_>,
    ) -> Result<Self> {
        watch.notify_observer()?;
        let mut heights = cut.of(&waves.clone().into_field());
        let mean = mean_of(&heights, |z| z);
        for height in heights.as_mut_slice() {
            *height -= mean;
        }
        let mut square_slope = |axis: usize| {
            watch.notify_observer()?;
            let mut slopes = waves.clone();
            slopes.update(|mode, wave| wave * Complex::i() * mode.wave_vector[axis]);
            let slopes = cut.of(&slopes.into_field());
            Ok(mean_of(&slopes, |slope| slope * slope))
        };
        let rms_slope = (square_slope(0)? + square_slope(1)?).sqrt();
        let surface = Standardised::new(heights.clone());
        Ok(Self {
            heights,
            rms_height: surface.deviation,
            rms_slope,
            skewness: surface.skewness,
            kurtosis: surface.kurtosis,
            iterations,
        })
    }

    /// All heights and slopes multiplied by a number.
    pub(super) fn scaled(mut self, factor: f64) -> Self {
        for height in self.heights.as_mut_slice() {
            *height *= factor;
        }
        Self {
            rms_height: self.rms_height * factor,
            rms_slope: self.rms_slope * factor,
            ..self
        }
    }

    /// Heights above the mean plane (lengths), pointing out of the body;
    /// [`gap_from_heights`](crate::surface::gap_from_heights) turns them into a gap.
    #[must_use]
    pub fn heights(&self) -> &Field {
        &self.heights
    }

    /// The heights, without the parameters.
    #[must_use]
    pub fn into_heights(self) -> Field {
        self.heights
    }

    /// Root mean square of the heights (a length), $`S_q = \sqrt{\langle z^2\rangle}`$.
    #[must_use]
    pub fn rms_height(&self) -> f64 {
        self.rms_height
    }

    /// Root mean square of the gradient, $`\sqrt{\langle |\nabla z|^2\rangle}`$, of the sum of waves
    /// at the cell centres; finite differences of the samples give less.
    #[doc(alias = "rms slope")]
    #[must_use]
    pub fn rms_slope(&self) -> f64 {
        self.rms_slope
    }

    /// Skewness of the heights, $`\langle z^3\rangle / S_q^3`$: negative for plateaus with valleys.
    #[must_use]
    pub fn skewness(&self) -> f64 {
        self.skewness
    }

    /// Kurtosis of the heights, $`\langle z^4\rangle / S_q^4`$; about 3 for a Gaussian surface.
    #[must_use]
    pub fn kurtosis(&self) -> f64 {
        self.kurtosis
    }

    /// Iterations made for the requested skewness and kurtosis; zero if neither was requested.
    #[must_use]
    pub fn iterations(&self) -> usize {
        self.iterations
    }
}
