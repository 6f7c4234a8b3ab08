//! Self-affine rough surfaces.

pub(super) mod on_bodies;

mod crop_window;
mod generate;
mod johnson;
mod law;
mod moments;
mod phases;
mod rank_order;
mod rough_surface;

use crate::error::{Result, positive};

pub use rough_surface::RoughSurface;

/// Distribution of the moduli of the waves.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub enum Amplitudes {
    /// Every wave has the modulus of the law, and only its phase is random (Wu 2000). Every surface meets the target
    /// exactly.
    #[default]
    Exact,
    /// Real and imaginary parts are independent and normally distributed, as for filtered white noise (Hu and Tonder
    /// 1992). The mean square of the whole periodic surface, averaged over all seeds, meets the target.
    Gaussian,
}

/// A random surface with a self-affine power spectrum.
///
/// The heights are a sum of waves that are periodic on the surface. The sum includes all waves whose wave number
/// $`q = 2\pi/\lambda`$ lies within the band:
///
/// ```math
/// z(x, y) = \sum_{ij} A_{ij} \cos(q_i x + q_j y + \varphi_{ij}) , \qquad
/// A_{ij}^2 \propto C(q) = \begin{cases}
///   1 & q_\text{longest} \le q \le q_\text{roll-off} \\
///   (q/q_\text{roll-off})^{-2(1+H)} & q_\text{roll-off} < q \le q_\text{cut-off} \\
///   0 & \text{otherwise,} \end{cases}
/// ```
///
/// which is equation 36 of Wang et al. (2021). Waves of two cells along an axis are omitted, because the grid does not
/// resolve their phase. The common factor follows from the waves in the band and from the target. The target is the
/// root mean square of the heights or of the slopes.
///
/// | option | default |
/// |---|---|
/// | [`hurst`](Self::hurst) | 0.8 |
/// | [`longest_wavelength`](Self::longest_wavelength) | the longer side of the periodic surface |
/// | [`roll_off_wavelength`](Self::roll_off_wavelength) | the longest wavelength: no plateau |
/// | [`cut_off_wavelength`](Self::cut_off_wavelength) | 8 cells, of their longer side |
/// | [`amplitudes`](Self::amplitudes) | [`Amplitudes::Exact`] |
/// | [`cropped`](Self::cropped) | no: the surface is periodic |
/// | [`skewness`](Self::skewness), [`kurtosis`](Self::kurtosis) | as they follow from the phases |
/// | [`seed`](Self::seed) | 0 |
///
/// # Refining the grid
/// Each wave has a modulus and a phase in the middle of the grid. Both depend only on the seed and on the two numbers
/// of periods per side. A finer grid over the same rectangle therefore samples the same surface if the cut-off
/// wavelength is given and exceeds two cells. Otherwise the surface on the finer grid also contains shorter waves, and
/// its common factor differs. If a skewness or kurtosis is given, the phases depend on the heights of all cells, and
/// the surfaces differ.
///
/// ```
/// use stickslip::{Grid, surface::SelfAffine};
/// // A square millimetre, in micrometres.
/// let rough = SelfAffine::with_rms_height(0.5)
///     .roll_off_wavelength(250.0)
///     .cut_off_wavelength(100.0)
///     .seed(7);
/// let coarse = rough.generate(Grid::square(32, 1000.0)?)?;
/// let fine = rough.generate(Grid::square(96, 1000.0)?)?;
/// assert!((coarse.rms_height() - 0.5).abs() < 1e-12);
/// // Every third cell of the fine grid has the centre of a coarse cell.
/// let difference = coarse.heights().as_slice()[0] - fine.heights().as_slice()[97];
/// assert!(difference.abs() < 1e-12);
/// # Ok::<(), stickslip::Error>(())
/// ```
///
/// # Heights that are not Gaussian
/// The sum of many waves of random phases has Gaussian heights. If a skewness or a kurtosis is given, the phases are
/// changed while the moduli remain unchanged to round-off. The spectrum, the rms height and the rms slope are then the
/// same as for the Gaussian surface.
///
/// At first two steps alternate, as in Perez-Rafols and Almqvist (2019) after Schreiber and Schmitz (1996). The first
/// step replaces the heights by the heights of the same rank of a Johnson distribution (1949). The second step restores
/// the moduli. Then Newton's method changes the phases as little as possible until skewness and kurtosis are met to
/// 1e-9. For a cropped surface, the spectrum of the periodic surface is kept.
///
/// The heights follow the Johnson distribution to about 0.01 of their rms if many waves contribute to the spectrum.
/// They follow it to 0.1 of their rms if few waves contribute, or near the limits of the attainable values. If the
/// requested values cannot be attained, the function returns an error and never an approximation. A grid of a few cells
/// per side has only two or three waves, with which few values can be attained. The table lists the kurtoses that were
/// attained with each of eight seeds on a square of side `L`. The kurtoses 2.1, 2.25, 2.5, 2.75, 3, 4, 5, 6, 8 and 12
/// were tried:
///
/// | roll-off, cut-off | skewness 0, ±0.5 | skewness ±1 |
/// |---|---|---|
/// | no plateau, `L/4` | 2.1 to 5 | 2.5 to 6 |
/// | no plateau, `L/8` | 2.1 to 6 | 2.5 to 8 |
/// | no plateau, `L/16` | 2.1 to 8 | 2.25 to 12 |
/// | `L/4`, `L/8` | 2.1 to 12 | 2.75 to 12 |
/// | `L/8`, `L/32` | 2.1 to 12 | 2.5 to 12 |
/// | no plateau, `L/8`, cropped | 2.1 to 12 | 2.25 to 12 |
///
/// The generation takes 10 to 30 iterations, about a second on a grid of 1024 x 1024 cells. A Gaussian surface takes a
/// twentieth of this time.
///
/// ```
/// use stickslip::{Grid, surface::SelfAffine};
/// // A plateau-honed surface: deep valleys and few peaks.
/// let honed = SelfAffine::with_rms_slope(0.1).skewness(-1.0).kurtosis(4.5);
/// let surface = honed.generate(Grid::square(64, 1.0)?)?;
/// assert!((surface.skewness() + 1.0).abs() < 1e-8);
/// assert!((surface.kurtosis() - 4.5).abs() < 1e-8);
/// assert!((surface.rms_slope() - 0.1).abs() < 1e-12);
/// assert!(-surface.heights().min() > 1.5 * surface.heights().max());
/// # Ok::<(), stickslip::Error>(())
/// ```
///
/// # References
/// - J.-J. Wu, Simulation of rough surfaces with FFT, *Tribol. Int.* 33 (2000) 47-58,
///   [doi:10.1016/S0301-679X(00)00016-5](https://doi.org/10.1016/S0301-679X(00)00016-5).
/// - Y. Z. Hu and K. Tonder, Simulation of 3-D random rough surface by 2-D digital filter and Fourier
///   analysis, *Int. J. Mach. Tools Manuf.* 32 (1992) 83-90,
///   [doi:10.1016/0890-6955(92)90064-N](https://doi.org/10.1016/0890-6955(92)90064-N).
/// - F. Perez-Rafols and A. Almqvist, Generating randomly rough surfaces with given height
///   probability distribution and power spectrum, *Tribol. Int.* 131 (2019) 591-604,
///   [doi:10.1016/j.triboint.2018.11.020](https://doi.org/10.1016/j.triboint.2018.11.020).
/// - T. Schreiber and A. Schmitz, Improved surrogate data for nonlinearity tests, *Phys. Rev. Lett.*
///   77 (1996) 635-638, [doi:10.1103/PhysRevLett.77.635](https://doi.org/10.1103/PhysRevLett.77.635).
/// - N. L. Johnson, Systems of frequency curves generated by methods of translation, *Biometrika* 36
///   (1949) 149-176, [doi:10.1093/biomet/36.1-2.149](https://doi.org/10.1093/biomet/36.1-2.149).
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(deny_unknown_fields)
)]
pub struct SelfAffine {
    target: HeightTarget,
    #[cfg_attr(feature = "serde", serde(default = "default_hurst"))]
    hurst: f64,
    longest_wavelength: Option<f64>,
    roll_off_wavelength: Option<f64>,
    cut_off_wavelength: Option<f64>,
    #[cfg_attr(feature = "serde", serde(default))]
    amplitudes: Amplitudes,
    #[cfg_attr(feature = "serde", serde(default, rename = "cropped"))]
    is_cropped: bool,
    skewness: Option<f64>,
    kurtosis: Option<f64>,
    #[cfg_attr(feature = "serde", serde(default))]
    seed: u64,
}

/// Target that determines the common factor of the waves.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(rename_all = "snake_case")
)]
enum HeightTarget {
    RmsHeight(f64),
    RmsSlope(f64),
}

impl HeightTarget {
    fn checked(self) -> Result<f64> {
        match self {
            Self::RmsHeight(height) => positive("rms height", height),
            Self::RmsSlope(slope) => positive("rms slope", slope),
        }
    }
}

/// Lower bound of the memory in bytes per cell during generation, including all waves.
const BYTES_PER_CELL: usize = 24;

fn default_hurst() -> f64 {
    0.8
}

impl SelfAffine {
    /// Creates a surface with the given root-mean-square height (a length) as the target.
    #[must_use]
    pub fn with_rms_height(rms_height: f64) -> Self {
        Self::with(HeightTarget::RmsHeight(rms_height))
    }

    /// Creates a surface with the given root-mean-square gradient $`|\nabla z|`$ of the sum of waves as the target.
    #[doc(alias = "rms slope")]
    #[must_use]
    pub fn with_rms_slope(rms_slope: f64) -> Self {
        Self::with(HeightTarget::RmsSlope(rms_slope))
    }

    fn with(target: HeightTarget) -> Self {
        Self {
            target,
            hurst: default_hurst(),
            longest_wavelength: None,
            roll_off_wavelength: None,
            cut_off_wavelength: None,
            amplitudes: Amplitudes::default(),
            is_cropped: false,
            skewness: None,
            kurtosis: None,
            seed: 0,
        }
    }

    /// Sets the Hurst exponent $`H`$, 0 to 1 (default 0.8). The fractal dimension is $`3 - H`$.
    #[must_use]
    pub fn hurst(self, hurst: f64) -> Self {
        Self { hurst, ..self }
    }

    /// Sets the longest wavelength of the spectrum (default the longer side of the periodic surface).
    #[must_use]
    pub fn longest_wavelength(self, wavelength: f64) -> Self {
        Self {
            longest_wavelength: Some(wavelength),
            ..self
        }
    }

    /// Sets the wavelength below which the spectrum decreases. The default is the longest wavelength, so that the
    /// spectrum has no plateau.
    #[must_use]
    pub fn roll_off_wavelength(self, wavelength: f64) -> Self {
        Self {
            roll_off_wavelength: Some(wavelength),
            ..self
        }
    }

    /// Sets the shortest wavelength of the spectrum, which must be at least two cells. The default is 8 cells, measured
    /// along the longer side of a cell.
    #[must_use]
    pub fn cut_off_wavelength(self, wavelength: f64) -> Self {
        Self {
            cut_off_wavelength: Some(wavelength),
            ..self
        }
    }

    /// Sets the distribution of the moduli of the waves (default [`Amplitudes::Exact`]).
    #[must_use]
    pub fn amplitudes(self, amplitudes: Amplitudes) -> Self {
        Self { amplitudes, ..self }
    }

    /// Cuts the surface out of the middle of a periodic surface of twice the side lengths. Opposite edges then do not
    /// match. The mean of the cropped surface is removed. For [`Amplitudes::Exact`] the cropped surface is scaled to
    /// the target. Skewness and kurtosis apply to the cropped surface.
    ///
    /// With [`Amplitudes::Gaussian`] the cropped surface is not scaled, and removing its mean reduces its mean square.
    /// If no longest wavelength is given, the mean square of the heights is about 0.7 times the square of the target.
    /// This factor is the average over all seeds.
    #[must_use]
    pub fn cropped(self) -> Self {
        Self {
            is_cropped: true,
            ..self
        }
    }

    /// Sets the skewness of the heights, $`\langle z^3\rangle/\langle z^2\rangle^{3/2}`$. If only the kurtosis is
    /// given, the default is 0.
    #[must_use]
    pub fn skewness(self, skewness: f64) -> Self {
        Self {
            skewness: Some(skewness),
            ..self
        }
    }

    /// Sets the kurtosis of the heights, $`\langle z^4\rangle/\langle z^2\rangle^2`$. The kurtosis must be at least the
    /// squared skewness plus one. If only the skewness is given, the default is 3, the value of a Gaussian surface.
    #[must_use]
    pub fn kurtosis(self, kurtosis: f64) -> Self {
        Self {
            kurtosis: Some(kurtosis),
            ..self
        }
    }

    /// Sets the seed that selects a random surface (default 0). A seed yields the same surface on every machine,
    /// to round-off.
    #[must_use]
    pub fn seed(self, seed: u64) -> Self {
        Self { seed, ..self }
    }
}
