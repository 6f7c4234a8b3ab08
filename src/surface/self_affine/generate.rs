//! Generation of a self-affine surface on a grid.

use std::f64::consts::TAU;
use std::ops::ControlFlow;

use num_complex::Complex;

use crate::error::{Result, all_finite, at_least, finite, memory};
use crate::grid::Grid;
use crate::observer::{WorkObserver, unwatched};
use crate::parallel;
use crate::report::Iteration;
use crate::surface::self_affine::crop_window::CropWindow;
use crate::surface::self_affine::law::SpectrumLaw;
use crate::surface::self_affine::{
    Amplitudes, BYTES_PER_CELL, HeightTarget, RoughSurface, SelfAffine, phases, rank_order,
};
use crate::surface::waves::Waves;

impl SelfAffine {
    /// Generates the surface on a grid.
    ///
    /// # Errors
    /// - [`Error::NotPositive`](crate::Error::NotPositive) if the target or a wavelength is not positive and finite.
    /// - [`Error::Hurst`](crate::Error::Hurst) if the Hurst exponent is outside 0 to 1.
    /// - [`Error::NotFinite`](crate::Error::NotFinite) if the skewness or the kurtosis is not finite.
    /// - [`Error::BelowMinimum`](crate::Error::BelowMinimum) if the cut-off is shorter than two cells, or if the roll-off is
    ///   shorter than the cut-off or longer than the longest wavelength. The error is also returned if the kurtosis is less than
    ///   the squared skewness plus one.
    /// - [`Error::NoWaveInBand`](crate::Error::NoWaveInBand) if no wave of the surface lies within the band.
    /// - [`Error::HeightMomentsNotReached`](crate::Error::HeightMomentsNotReached) if no phases with the requested skewness and
    ///   kurtosis were found.
    /// - [`Error::Sample`](crate::Error::Sample) with the first height that overflows.
    /// - [`Error::Memory`](crate::Error::Memory) if the memory for the surface cannot be allocated. A cropped surface requires
    ///   four times the cells.
    pub fn generate(&self, grid: Grid) -> Result<RoughSurface> {
        self.generate_observed(grid, unwatched)
    }

    /// Generates the surface like [`generate`](Self::generate), with an observer that may cancel. The observer is called before
    /// the waves are drawn and before each iteration for skewness and kurtosis. It is also called before the heights and each
    /// slope are summed. These sums count as products. The reported residual is the larger of the deviations of skewness and
    /// kurtosis.
    ///
    /// # Errors
    /// - The errors of [`generate`](Self::generate).
    /// - [`Error::NotConverged`](crate::Error::NotConverged) if the observer cancels.
    pub fn generate_observed(
        &self,
        grid: Grid,
        mut observer: impl FnMut(&Iteration) -> ControlFlow<()> + Send,
    ) -> Result<RoughSurface> {
        let watch = &mut WorkObserver::new(&mut observer);
        let wanted = self.moments()?;
        let target = self.target.checked()?;
        let cut = if self.is_cropped {
            CropWindow::middle(grid)?
        } else {
            CropWindow::all(grid)
        };
        memory("the rough surface", cut.whole.size(), BYTES_PER_CELL)?;
        parallel::enter_with(grid.cells(), || self.made(&cut, wanted, target, watch))
    }

    /// Generates the surface. The caller must have checked the arguments.
    fn made(
        &self,
        cut: &CropWindow,
        wanted: Option<[f64; 2]>,
        target: f64,
        watch: &mut WorkObserver<'_>,
    ) -> Result<RoughSurface> {
        watch.notify_observer()?;
        let mut waves = self.waves(cut, Waves::none(cut.whole))?;
        let mut iterations = 0;
        if let Some(wanted) = wanted {
            (waves, iterations) = rank_order::approach(&waves, wanted, watch)?;
            iterations += phases::turn(&mut waves, cut, wanted, watch)?;
        }
        let surface = RoughSurface::new(&waves, cut, iterations, watch)?;
        let unit = if self.is_cropped && self.amplitudes == Amplitudes::Exact {
            match self.target {
                HeightTarget::RmsHeight(_) => surface.rms_height(),
                HeightTarget::RmsSlope(_) => surface.rms_slope(),
            }
        } else {
            1.0
        };
        let surface = surface.scaled(target / unit);
        all_finite("height of the rough surface", surface.heights().as_slice())?;
        Ok(surface)
    }

    /// Returns the requested skewness and kurtosis, or `None` if neither is given.
    pub(super) fn moments(&self) -> Result<Option<[f64; 2]>> {
        if self.skewness.is_none() && self.kurtosis.is_none() {
            return Ok(None);
        }
        let skewness = finite("skewness", self.skewness.unwrap_or(0.0))?;
        let kurtosis = finite("kurtosis", self.kurtosis.unwrap_or(3.0))?;
        let least = skewness * skewness + 1.0;
        at_least("the squared skewness plus one", least, "kurtosis", kurtosis)?;
        Ok(Some([skewness, kurtosis]))
    }

    /// Draws the waves of the periodic surface for a target of one. Squares for this target neither overflow nor underflow.
    pub(super) fn waves(&self, cut: &CropWindow, mut waves: Waves) -> Result<Waves> {
        let law = SpectrumLaw::new(self, cut.whole)?;
        let total = match self.target {
            HeightTarget::RmsHeight(_) => law.total(cut.whole, |_| 1.0)?,
            HeightTarget::RmsSlope(_) => law.total(cut.whole, |mode| mode.wave_number().powi(2))?,
        };
        waves.update(|mode, _| {
            let power = law.power(&mode);
            if power == 0.0 {
                return Complex::default();
            }
            // Two opposite waves along y are both stored. The first wave is drawn, and the second wave is its conjugate.
            let [i, j] = mode.numbers;
            let is_mirrored = i == 0 && j < 0;
            let numbers = [i, if is_mirrored { -j } else { j }];
            let wave = wave(self.seed, numbers, self.amplitudes)
                * Complex::cis(cut.phase_of_first_cell(numbers))
                * (power / total).sqrt();
            if is_mirrored { wave.conj() } else { wave }
        });
        Ok(waves)
    }
}

/// Draws a complex number whose mean square over all seeds is one. Either the modulus of the number is one, or the
/// number is normally distributed.
pub(super) fn wave(seed: u64, numbers: [i64; 2], amplitudes: Amplitudes) -> Complex<f64> {
    let bits = numbers.iter().fold(mix(seed), |bits, number| {
        mix(bits ^ u64::from_le_bytes(number.to_le_bytes()))
    });
    let modulus = match amplitudes {
        Amplitudes::Exact => 1.0,
        // Box-Muller method: the squared modulus of a normal complex number is exponentially distributed.
        Amplitudes::Gaussian => (-(-fraction(mix(bits))).ln_1p()).sqrt(),
    };
    Complex::from_polar(modulus, TAU * fraction(bits))
}

/// Applies the generator splitmix64 of Steele, Lea and Flood (2014).
fn mix(bits: u64) -> u64 {
    let bits = bits.wrapping_add(0x9e37_79b9_7f4a_7c15);
    let bits = (bits ^ (bits >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    let bits = (bits ^ (bits >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    bits ^ (bits >> 31)
}

/// Maps the upper 53 bits to `[0, 1)`.
fn fraction(bits: u64) -> f64 {
    (bits >> 11) as f64 / (1_u64 << 53) as f64
}
