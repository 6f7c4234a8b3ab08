//! Height and slope parameters of a surface.

use std::fmt;

use super::differences::{developed_area_ratio, rms_slopes};
use super::heights::{about_mean, finite_or_missing, measured_points, or_zero};
use super::power_spectrum::moments;
use super::slab::Slab;
use super::waves::Waves;
use crate::error::{Error, Result, finite};
use crate::grid::field::Field;
use crate::parallel;
use crate::parallel::reduce;

/// S-parameters of a surface (ISO 25178-2:2021), computed from its heights relative to their mean.
///
/// Heights point out of the body, so that a peak is positive. The heights are not filtered, and no form except the mean
/// is removed. Apply [`level`](super::level()) first to a tilted or curved surface. The heights $`z`$ are relative to
/// the mean, and $`\langle\,\rangle`$ is the mean over the measured points:
///
/// ```math
/// S_a = \langle |z| \rangle, \quad S_q^2 = \langle z^2 \rangle, \quad
/// S_{sk} = \frac{\langle z^3 \rangle}{S_q^3}, \quad S_{ku} = \frac{\langle z^4 \rangle}{S_q^4} ,
/// ```
///
/// The kurtosis is not the excess kurtosis: its value is 3 for a Gaussian surface.
///
/// # Missing heights
/// Missing heights (NaN) have no weight. [`measured_points`](Statistics::measured_points) is the number of the other heights.
/// Slopes use pairs of measured neighbours, and the developed area uses groups of four measured neighbours. The spectral slope
/// requires a complete surface and is otherwise NaN (see [`fill_missing`](super::fill_missing)).
///
/// # Slopes
/// On a grid the slope depends on the method of differentiation. The effect is stronger for shorter waves. Each method
/// therefore has a separate function. A wave of wave number $`q`$ along x has the finite-difference slope
/// $`\sin(q\,\Delta x/2)/(q\,\Delta x/2)`$ times the spectral slope. The factor is 0.97 at eight cells per period and
/// $`2/\pi`$ at two cells per period.
///
/// ```
/// use std::f64::consts::TAU;
/// use stickslip::{Field, Grid, surface::Statistics};
/// let grid = Grid::square(64, 64.0)?;
/// let wave = Statistics::of(&Field::from_fn(grid, |x, _| 5.0 + 2.0 * (TAU * x / 8.0).cos()))?;
/// assert!((wave.mean_height() - 5.0).abs() < 1e-12);
/// assert!((wave.rms_height() - 2.0_f64.sqrt()).abs() < 1e-12);
/// assert!(wave.skewness().abs() < 1e-12 && (wave.kurtosis() - 1.5).abs() < 1e-12);
/// let slope = wave.rms_height() * TAU / 8.0;
/// assert!((wave.spectral_rms_slope() - slope).abs() < 1e-12);
/// // The pair across the edge is not counted; its heights are equal.
/// let ratio = wave.finite_difference_rms_slope() / slope;
/// assert!((ratio - 0.9745 * (64.0_f64 / 63.0).sqrt()).abs() < 1e-4);
/// # Ok::<(), stickslip::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Statistics {
    measured_points: usize,
    mean_height: f64,
    arithmetic_mean_height: f64,
    rms_height: f64,
    #[cfg_attr(feature = "serde", serde(with = "crate::support::serialise::number"))]
    skewness: f64,
    #[cfg_attr(feature = "serde", serde(with = "crate::support::serialise::number"))]
    kurtosis: f64,
    highest_peak: f64,
    deepest_valley: f64,
    #[cfg_attr(feature = "serde", serde(with = "crate::support::serialise::array"))]
    profile_rms_slope: [f64; 2],
    #[cfg_attr(feature = "serde", serde(with = "crate::support::serialise::number"))]
    developed_area_ratio: f64,
    #[cfg_attr(feature = "serde", serde(with = "crate::support::serialise::number"))]
    spectral_rms_slope: f64,
}

impl Statistics {
    /// Computes the statistics of a surface. For a distributed surface use
    /// [`HalfSpace::statistics`](crate::HalfSpace::statistics).
    ///
    /// # Errors
    /// - [`Error::Sample`] with the first infinite height.
    /// - [`Error::Undetermined`] if all heights are missing.
    /// - [`Error::NotFinite`] if the range of the heights or the square of their slopes overflows.
    /// - [`Error::Memory`] if memory runs out.
    pub fn of(heights: &Field) -> Result<Self> {
        Self::of_slab(heights, &Slab::alone(heights)?)
    }

    /// Computes the statistics of a surface from its local slab. The surface may be distributed over ranks.
    pub(crate) fn of_slab(heights: &Field, slab: &Slab) -> Result<Self> {
        slab.layout()
            .collective_result(finite_or_missing(heights))?;
        let measured_points = measured_points(heights, slab);
        let cells = slab.whole().cells();
        if measured_points == 0 {
            return Err(Error::Undetermined {
                quantity: "surface",
                unknowns: cells,
                known: 0,
            });
        }
        let (deviations, mean_height) = about_mean(heights, slab, measured_points);
        let highest_peak = slab.layout().combined(deviations.max(), f64::max);
        let deepest_valley = -slab.layout().combined(deviations.min(), f64::min);
        let z = deviations.as_slice();
        // Powers of heights in units of the largest deviation neither overflow nor underflow.
        let largest = highest_peak.max(deepest_valley);
        let unit = if largest > 0.0 { largest } else { 1.0 };
        let [first, second, third, fourth] = reduce::sum(slab.layout(), |i| {
            let z = or_zero(z[i] / unit);
            [z.abs(), z * z, z * z * z, (z * z) * (z * z)]
        })
        .map(|sum| sum / measured_points as f64);
        let is_complete = measured_points == cells;
        let m2 = if is_complete {
            let waves = || Waves::of_slab(&deviations, slab).map(|waves| moments(&waves)[1]);
            parallel::enter_with(heights.grid().cells(), waves)?
        } else {
            f64::NAN
        };
        let z = slab.with_next_row(&deviations)?;
        let profile_rms_slope = rms_slopes(&z, slab);
        let developed_area_ratio = developed_area_ratio(&z, slab);
        slab.layout().check()?;
        for (quantity, value) in [
            ("range of the heights", highest_peak + deepest_valley),
            ("second moment of the spectrum", m2),
            ("slope along x", profile_rms_slope[0]),
            ("slope along y", profile_rms_slope[1]),
            ("developed area ratio", developed_area_ratio),
        ] {
            let is_undetermined = value.is_nan() && !is_complete;
            if !is_undetermined {
                finite(quantity, value)?;
            }
        }
        Ok(Self {
            measured_points,
            mean_height,
            arithmetic_mean_height: unit * first,
            rms_height: unit * second.sqrt(),
            skewness: third / (second * second.sqrt()),
            kurtosis: fourth / (second * second),
            highest_peak,
            deepest_valley,
            profile_rms_slope,
            developed_area_ratio,
            spectral_rms_slope: (2.0 * m2).sqrt(),
        })
    }

    /// Returns the number of measured heights, on which the parameters are based.
    #[must_use]
    pub fn measured_points(&self) -> usize {
        self.measured_points
    }

    /// Returns the mean of the original heights (a length), the datum of all other parameters.
    #[must_use]
    pub fn mean_height(&self) -> f64 {
        self.mean_height
    }

    /// Returns the arithmetic mean height Sa $`= \langle |z| \rangle`$ (a length).
    #[doc(alias = "Sa")]
    #[must_use]
    pub fn arithmetic_mean_height(&self) -> f64 {
        self.arithmetic_mean_height
    }

    /// Returns the root-mean-square height Sq $`= \langle z^2 \rangle^{1/2}`$ (a length).
    #[doc(alias = "Sq")]
    #[doc(alias = "roughness")]
    #[must_use]
    pub fn rms_height(&self) -> f64 {
        self.rms_height
    }

    /// Returns the skewness Ssk $`= \langle z^3 \rangle/S_q^3`$. It is negative if the valleys are deeper than the
    /// peaks are high, and NaN for a flat surface.
    #[doc(alias = "Ssk")]
    #[must_use]
    pub fn skewness(&self) -> f64 {
        self.skewness
    }

    /// Returns the kurtosis Sku $`= \langle z^4 \rangle/S_q^4`$, at least $`S_{sk}^2 + 1`$. It is 3 for a Gaussian
    /// surface and NaN for a flat surface.
    #[doc(alias = "Sku")]
    #[must_use]
    pub fn kurtosis(&self) -> f64 {
        self.kurtosis
    }

    /// Returns the height of the highest peak above the mean, Sp (a length).
    #[must_use]
    pub fn highest_peak(&self) -> f64 {
        self.highest_peak
    }

    /// Returns the depth of the deepest valley below the mean, Sv (a length, positive).
    #[must_use]
    pub fn deepest_valley(&self) -> f64 {
        self.deepest_valley
    }

    /// Returns the height Sz from the deepest valley to the highest peak (a length).
    #[doc(alias = "Sz")]
    #[must_use]
    pub fn height_range(&self) -> f64 {
        self.highest_peak + self.deepest_valley
    }

    /// Returns the root-mean-square gradient Sdq of the surface by forward differences,
    ///
    /// ```math
    /// S_{dq}^2 = \frac{1}{(n_x-1)\,n_y} \sum \left(\frac{z_{i+1,j}-z_{ij}}{\Delta x}\right)^2
    ///          + \frac{1}{n_x\,(n_y-1)} \sum \left(\frac{z_{i,j+1}-z_{ij}}{\Delta y}\right)^2 ,
    /// ```
    ///
    /// over the pairs of measured neighbours within the grid, without pairs across its edge. The formula is for a complete
    /// surface. Use this slope for a measured surface, which is not periodic. The slope along an axis of one cell is zero. It is
    /// NaN along an axis without a pair of measured neighbours.
    #[doc(alias = "Sdq")]
    #[doc(alias = "rms slope")]
    #[doc(alias = "rms gradient")]
    #[must_use]
    pub fn finite_difference_rms_slope(&self) -> f64 {
        let [along_x, along_y] = self.profile_rms_slope;
        along_x.hypot(along_y)
    }

    /// Returns the root-mean-square gradient of the periodically continued surface. The gradient is exact for the waves
    /// of the surface: $`\langle |\nabla z|^2 \rangle = \sum |q|^2 |a_q|^2 = 2 m_2`$.
    ///
    /// A wave of two cells per period contributes the full mean square of its samples. The samples do not determine the
    /// phase of this wave and hence not its slope. If the heights are not periodic, the step at the edge of the grid is
    /// included. The slope is NaN if a height is missing. See [`PowerSpectrum`](super::PowerSpectrum).
    #[doc(alias = "rms slope")]
    #[must_use]
    pub fn spectral_rms_slope(&self) -> f64 {
        self.spectral_rms_slope
    }

    /// Returns the root-mean-square slopes of the profiles along x and of the profiles along y, the two terms of
    /// [`finite_difference_rms_slope`](Self::finite_difference_rms_slope). See equation 34 of Wang et al. (2021).
    ///
    /// On an isotropic surface each of the two values is $`1/\sqrt2`$ times the slope of the surface.
    #[must_use]
    pub fn profile_rms_slope(&self) -> [f64; 2] {
        self.profile_rms_slope
    }

    /// Returns the developed interfacial area ratio Sdr. It is the excess of the area of the surface over the area of
    /// its projection, as a fraction of the projected area. It is not a percentage.
    ///
    /// Every four neighbouring heights span two triangles, which are separated by one of the two diagonals. The result
    /// is the mean over both diagonals. For small slopes the ratio is half the square of the slope. It is NaN if no four
    /// neighbouring heights are measured.
    #[doc(alias = "Sdr")]
    #[must_use]
    pub fn developed_area_ratio(&self) -> f64 {
        self.developed_area_ratio
    }
}

impl fmt::Display for Statistics {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            formatter,
            "Sa {:.4e}, Sq {:.4e}, Ssk {:.4}, Sku {:.4}, Sp {:.4e}, Sv {:.4e}, Sdq {:.4e} (spectral {:.4e}), Sdr {:.4e}",
            self.arithmetic_mean_height,
            self.rms_height,
            self.skewness,
            self.kurtosis,
            self.highest_peak,
            self.deepest_valley,
            self.finite_difference_rms_slope(),
            self.spectral_rms_slope,
            self.developed_area_ratio,
        )
    }
}
