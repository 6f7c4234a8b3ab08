//! Rough surfaces: generation and statistics.

use stickslip_rs::surface::{Amplitudes, SelfAffine, Statistics};

use crate::call::{Outcome, call};
use crate::error::Failure;
use crate::inputs::stickslip_grid;
use crate::observer::{stickslip_observer, watch};
use crate::pointer::{answer, field, input, optional};
use crate::reserved::known;
use crate::status::{STICKSLIP_INVALID_ARGUMENT, stickslip_status};
use crate::surface::shape;
use crate::threads::enter;

/// Amplitudes: each wave has the amplitude of the spectrum and a random phase (default).
pub const STICKSLIP_EXACT: i32 = 0;
/// Amplitudes: amplitudes and phases are random, like those of filtered white noise.
pub const STICKSLIP_GAUSSIAN: i32 = 1;

/// Random surface with a self-affine power spectrum; stickslip_self_affine_default() returns the defaults. Wavelengths are
/// lengths. The spectrum is constant from the longest wavelength to the roll-off. From there to the cut-off it decreases
/// with the wave number q as q^(-2 - 2 H).
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct stickslip_self_affine {
    /// Root-mean-square height (a length); 0 if the slope is prescribed.
    pub rms_height: f64,
    /// Root-mean-square slope; 0 if the height is prescribed.
    pub rms_slope: f64,
    /// Hurst exponent H, in [0, 1] (default 0.8).
    pub hurst: f64,
    /// Longest wavelength, at which the spectrum starts; 0 (default) for the longer side of the grid.
    pub longest_wavelength: f64,
    /// Roll-off wavelength, at which the spectrum starts to decrease; 0 (default) for the longest wavelength.
    pub roll_off_wavelength: f64,
    /// Cut-off wavelength, at which the spectrum ends, at least two cells; 0 (default) for eight times the longer side of a
    /// cell.
    pub cut_off_wavelength: f64,
    /// Amplitudes of the waves: STICKSLIP_EXACT (default) or STICKSLIP_GAUSSIAN.
    pub amplitudes: i32,
    /// Nonzero to crop the middle of a larger surface, which is not periodic; zero (default) for a surface that is periodic
    /// along x and y.
    pub cropped: i32,
    /// Skewness of the heights; NaN (default) for the value that results from the phases, or for 0 if a kurtosis is given.
    pub skewness: f64,
    /// Kurtosis of the heights; NaN (default) for the value that results from the phases, or for 3 if a skewness is given.
    pub kurtosis: f64,
    /// Seed of the random numbers (default 0); different seeds give different surfaces.
    pub seed: u64,
    /// Reserved for future members: zero.
    pub reserved: [u64; 8],
}

/// Returns the default options of a self-affine surface; the caller must set the height or the slope.
#[unsafe(no_mangle)]
pub extern "C" fn stickslip_self_affine_default() -> stickslip_self_affine {
    stickslip_self_affine {
        rms_height: 0.0,
        rms_slope: 0.0,
        hurst: 0.8,
        longest_wavelength: 0.0,
        roll_off_wavelength: 0.0,
        cut_off_wavelength: 0.0,
        amplitudes: STICKSLIP_EXACT,
        cropped: 0,
        skewness: f64::NAN,
        kurtosis: f64::NAN,
        seed: 0,
        reserved: [0; 8],
    }
}

impl stickslip_self_affine {
    fn checked(&self) -> Outcome<SelfAffine> {
        type Choice = (f64, fn(SelfAffine, f64) -> SelfAffine);
        known("the self-affine surface", &self.reserved)?;
        let mut recipe = match (self.rms_height, self.rms_slope) {
            (height, 0.0) => SelfAffine::with_rms_height(height),
            (0.0, slope) => SelfAffine::with_rms_slope(slope),
            _ => {
                let message = "rms_height and rms_slope are both given: set one of them to zero";
                return Err(Failure::new(STICKSLIP_INVALID_ARGUMENT, message.into()));
            }
        };
        recipe = recipe.hurst(self.hurst).seed(self.seed);
        let wavelengths: [Choice; 3] = [
            (self.longest_wavelength, SelfAffine::longest_wavelength),
            (self.roll_off_wavelength, SelfAffine::roll_off_wavelength),
            (self.cut_off_wavelength, SelfAffine::cut_off_wavelength),
        ];
        let moments: [Choice; 2] = [
            (self.skewness, SelfAffine::skewness),
            (self.kurtosis, SelfAffine::kurtosis),
        ];
        let wavelengths = wavelengths.into_iter().filter(|(length, _)| *length != 0.0);
        let moments = moments.into_iter().filter(|(moment, _)| !moment.is_nan());
        for (value, set) in wavelengths.chain(moments) {
            recipe = set(recipe, value);
        }
        if self.cropped != 0 {
            recipe = recipe.cropped();
        }
        match self.amplitudes {
            STICKSLIP_EXACT => Ok(recipe.amplitudes(Amplitudes::Exact)),
            STICKSLIP_GAUSSIAN => Ok(recipe.amplitudes(Amplitudes::Gaussian)),
            other => Err(Failure::option(
                "kind of amplitudes",
                other,
                "STICKSLIP_EXACT or STICKSLIP_GAUSSIAN",
            )),
        }
    }
}

/// Writes the heights of a random surface (lengths, positive out of the body, with zero mean) to heights, which has count
/// entries. The gap between the surface and a plane is a constant minus the height.
///
/// Returns STICKSLIP_INVALID_ARGUMENT if both height and slope are given. Returns STICKSLIP_NOT_POSITIVE for an invalid
/// height, slope or wavelength, STICKSLIP_HURST for an invalid exponent, and STICKSLIP_NOT_FINITE for an invalid skewness
/// or kurtosis. Returns STICKSLIP_BELOW_MINIMUM if the cut-off is less than two cells, the longest wavelength is less than
/// the roll-off, the roll-off is less than the cut-off, or the kurtosis is less than the squared skewness plus one. Returns
/// STICKSLIP_NO_WAVE_IN_BAND if no wave has a wavelength within the limits, STICKSLIP_HEIGHT_MOMENTS_NOT_REACHED if no
/// heights with this skewness and kurtosis are found, and STICKSLIP_SAMPLE for the first height that overflows. A failure
/// leaves heights unchanged.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_surface_self_affine(
    grid: *const stickslip_grid,
    surface: *const stickslip_self_affine,
    heights: *mut f64,
    count: usize,
) -> stickslip_status {
    let nobody = std::ptr::null();
    // SAFETY: the caller follows the rule for pointers.
    unsafe { stickslip_surface_self_affine_observed(grid, surface, nobody, heights, count) }
}

/// Writes the heights of a random surface with an observer (may be NULL), like stickslip_surface_self_affine. The observer
/// is called before each transform of the surface, including those of the iterations for skewness and kurtosis. It may end
/// the call, which then returns STICKSLIP_NOT_CONVERGED.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_surface_self_affine_observed(
    grid: *const stickslip_grid,
    surface: *const stickslip_self_affine,
    observer: *const stickslip_observer,
    heights: *mut f64,
    count: usize,
) -> stickslip_status {
    // SAFETY: the caller follows the rule for pointers.
    call(|| unsafe {
        let recipe = input("surface", surface)?.checked()?;
        let watch = watch(optional("observer", observer)?);
        let make = |grid| Ok(recipe.generate_observed(grid, watch)?.into_heights());
        shape(grid, make, ("heights", heights, count))
    })
}

/// Statistics of heights about their mean, according to ISO 25178-2.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct stickslip_statistics {
    /// Mean height (a length), the reference of all other heights.
    pub mean_height: f64,
    /// Arithmetic mean height Sa (a length).
    pub arithmetic_mean_height: f64,
    /// Root-mean-square height Sq (a length).
    pub rms_height: f64,
    /// Skewness Ssk; NaN for a flat surface.
    pub skewness: f64,
    /// Kurtosis Sku, 3 for a Gaussian surface; NaN for a flat surface.
    pub kurtosis: f64,
    /// Height of the highest peak Sp (a length).
    pub highest_peak: f64,
    /// Depth of the deepest valley Sv (a length, positive).
    pub deepest_valley: f64,
    /// Root-mean-square slope Sdq from finite differences, without differences across the edge.
    pub finite_difference_rms_slope: f64,
    /// Root-mean-square slope from the waves of the periodically continued surface.
    pub spectral_rms_slope: f64,
    /// Developed area ratio Sdr: excess of the surface area over its projection, relative to the projection.
    pub developed_area_ratio: f64,
    /// Reserved for future members: zero.
    pub reserved: [u64; 8],
}

impl From<Statistics> for stickslip_statistics {
    fn from(of: Statistics) -> Self {
        Self {
            mean_height: of.mean_height(),
            arithmetic_mean_height: of.arithmetic_mean_height(),
            rms_height: of.rms_height(),
            skewness: of.skewness(),
            kurtosis: of.kurtosis(),
            highest_peak: of.highest_peak(),
            deepest_valley: of.deepest_valley(),
            finite_difference_rms_slope: of.finite_difference_rms_slope(),
            spectral_rms_slope: of.spectral_rms_slope(),
            developed_area_ratio: of.developed_area_ratio(),
            reserved: [0; 8],
        }
    }
}

/// Computes the statistics of count heights (lengths) on a grid. Missing heights (NaN) have no weight; the spectral slope is
/// then NaN. Returns STICKSLIP_SAMPLE for the first infinite height, STICKSLIP_INVALID_ARGUMENT if all heights are missing, and
/// STICKSLIP_NOT_FINITE if the range of heights or the square of the slopes overflows.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_surface_statistics(
    grid: *const stickslip_grid,
    heights: *const f64,
    count: usize,
    statistics: *mut stickslip_statistics,
) -> stickslip_status {
    // SAFETY: the caller follows the rule for pointers.
    call(|| unsafe {
        answer("statistics", statistics, || {
            let grid = input("grid", grid)?.checked()?;
            let heights = field("heights", grid, heights, count)?;
            Ok(enter(grid.cells(), || Statistics::of(&heights))?.into())
        })
    })
}
