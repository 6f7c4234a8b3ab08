//! Rough surfaces: made, and described by their statistics.

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

/// Each wave has the amplitude of the spectrum, and only its phase is random (default).
pub const STICKSLIP_EXACT: i32 = 0;
/// The amplitudes are random too, as of filtered white noise.
pub const STICKSLIP_GAUSSIAN: i32 = 1;

/// A random surface with a self-affine power spectrum; stickslip_self_affine_default() has the defaults. Wavelengths are
/// lengths. A spectrum constant from the longest wavelength to the roll-off falls with the wave number q as q^(-2 - 2 H) from
/// there to the cut-off.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct stickslip_self_affine {
    /// Root-mean-square height (a length); 0 if the slope is given.
    pub rms_height: f64,
    /// Root-mean-square slope; 0 if the height is given.
    pub rms_slope: f64,
    /// Hurst exponent H, in [0, 1] (default 0.8).
    pub hurst: f64,
    /// Longest wavelength, where the spectrum begins; 0 (default): the longer side of the grid.
    pub longest_wavelength: f64,
    /// Roll-off wavelength, where the spectrum begins to fall; 0 (default): the longest wavelength.
    pub roll_off_wavelength: f64,
    /// Cut-off wavelength, where the spectrum ends, at least two cells; 0 (default): eight cells, of their longer side.
    pub cut_off_wavelength: f64,
    /// STICKSLIP_EXACT (default) or STICKSLIP_GAUSSIAN.
    pub amplitudes: i32,
    /// Not zero: the middle of a larger surface, which does not repeat; else (default) the surface repeats along x and y.
    pub cropped: i32,
    /// Skewness of the heights; NaN (default): as it follows from the phases, or 0 if a kurtosis is given.
    pub skewness: f64,
    /// Kurtosis of the heights; NaN (default): as it follows from the phases, or 3 if a skewness is given.
    pub kurtosis: f64,
    /// Another seed is another surface (default 0).
    pub seed: u64,
    /// Room for members to come: zero.
    pub reserved: [u64; 8],
}

/// The options of a self-affine surface by default; height or slope is to be given.
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
                let message = "rms_height and rms_slope are both given: one must be zero";
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
            other => Err(Failure::option("kind of amplitudes", other)),
        }
    }
}

/// Writes the heights of a random surface (lengths, positive out of the body, of zero mean) to heights, which has count
/// entries. The gap of this surface to a plane is any constant less the height.
///
/// STICKSLIP_INVALID_ARGUMENT if height and slope are both given, STICKSLIP_NOT_POSITIVE for height, slope or a wavelength,
/// STICKSLIP_HURST for the exponent, STICKSLIP_NOT_FINITE for skewness or kurtosis; STICKSLIP_BELOW_MINIMUM for a cut-off of less
/// than two cells, a wavelength less than the next shorter one or a kurtosis less than the squared skewness plus one;
/// STICKSLIP_NO_WAVE_IN_BAND if no wave fits the wavelengths, STICKSLIP_HEIGHT_MOMENTS_NOT_REACHED if no heights of such skewness and
/// kurtosis are found; STICKSLIP_SAMPLE for the first height that overflows. heights is then as it was.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_surface_self_affine(
    grid: *const stickslip_grid,
    surface: *const stickslip_self_affine,
    heights: *mut f64,
    count: usize,
) -> stickslip_status {
    let nobody = std::ptr::null();
    // SAFETY: the rule for pointers.
    unsafe { stickslip_surface_self_affine_observed(grid, surface, nobody, heights, count) }
}

/// The same with an observer (may be NULL), which is called before each transform of the surface, also of the iterations for
/// skewness and kurtosis, and may end it: STICKSLIP_NOT_CONVERGED.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_surface_self_affine_observed(
    grid: *const stickslip_grid,
    surface: *const stickslip_self_affine,
    observer: *const stickslip_observer,
    heights: *mut f64,
    count: usize,
) -> stickslip_status {
    // SAFETY: the rule for pointers.
    call(|| unsafe {
        let recipe = input("surface", surface)?.checked()?;
        let watch = watch(optional("observer", observer)?);
        let make = |grid| Ok(recipe.generate_observed(grid, watch)?.into_heights());
        shape(grid, make, ("heights", heights, count))
    })
}

/// Statistics of heights about their mean, as in ISO 25178-2.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct stickslip_statistics {
    /// Mean height (a length), from which all other heights count.
    pub mean_height: f64,
    /// Arithmetic mean height Sa (a length).
    pub arithmetic_mean_height: f64,
    /// Root-mean-square height Sq (a length).
    pub rms_height: f64,
    /// Skewness Ssk; NaN for a flat surface.
    pub skewness: f64,
    /// Kurtosis Sku, 3 for a Gaussian surface; NaN for a flat one.
    pub kurtosis: f64,
    /// Height of the highest peak Sp (a length).
    pub highest_peak: f64,
    /// Depth of the deepest valley Sv (a length, positive).
    pub deepest_valley: f64,
    /// Root-mean-square slope Sdq by finite differences, without those across the edge.
    pub finite_difference_rms_slope: f64,
    /// Root-mean-square slope of the waves of the surface, continued periodically.
    pub spectral_rms_slope: f64,
    /// Excess of the area over its projection, relative to the projection, Sdr.
    pub developed_area_ratio: f64,
    /// Room for members to come: zero.
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

/// The statistics of count heights (lengths) on a grid. STICKSLIP_SAMPLE for the first height that is NaN or infinite,
/// STICKSLIP_NOT_FINITE if their range or the square of their slopes overflows.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_surface_statistics(
    grid: *const stickslip_grid,
    heights: *const f64,
    count: usize,
    statistics: *mut stickslip_statistics,
) -> stickslip_status {
    // SAFETY: the rule for pointers.
    call(|| unsafe {
        answer("statistics", statistics, || {
            let grid = input("grid", grid)?.checked()?;
            let heights = field("heights", grid, heights, count)?;
            Ok(enter(grid.cells(), || Statistics::of(&heights))?.into())
        })
    })
}
