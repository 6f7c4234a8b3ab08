//! Generated rough surfaces.

use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;
use stickslip::surface;

use crate::argument::Object;
use crate::array::{Array, view};
use crate::choice::Choice;
use crate::digits::short;
use crate::field::Field;
use crate::grid::{Grid, size};
use crate::half_space::HalfSpace;
use crate::numpy_functions::as_numpy;
use crate::pickle::{parts, picklable};
use crate::real::{Real, Seed};
use crate::surface::numbers;
use crate::work::{observed_on, watch};
use crate::xarray::only_first_operand;

/// Parameters of self-affine roughness. With a given cut-off wavelength, the surface does not change when the grid is
/// refined.
///
/// Parameters
/// ----------
/// rms_height, rms_slope : float
///     Exactly one of the two: the root mean square of the heights (a length) or of the gradient (dimensionless).
/// hurst : float, default 0.8
///     The Hurst exponent H, in [0, 1]; the fractal dimension is 3 - H.
/// longest_wavelength : float, optional
///     Upper end of the spectrum (a length); the longer side of the grid by default.
/// roll_off_wavelength : float, optional
///     Wavelength at which the plateau of the spectrum ends and the spectrum begins to fall (a length). The default is
///     the longest wavelength, without a plateau.
/// cut_off_wavelength : float, optional
///     Lower end of the spectrum (a length), at least two cells; by default eight times the longer side of a cell.
/// amplitudes : Amplitudes or str, default "exact"
///     "exact" gives each wave the amplitude of the spectrum, and only its phase is random; "gaussian" scatters the
///     amplitudes too, as filtered white noise does.
/// cropped : bool, default False
///     Whether the surface is the middle of a larger surface and therefore not periodic.
/// skewness, kurtosis : float, optional
///     Skewness and kurtosis of the heights (Gaussian heights have kurtosis 3). By default they follow from the phases.
/// seed : int
///     Seed of the random numbers, not negative; required. Each seed gives a different surface, and equal seeds give equal
///     surfaces.
///
/// Examples
/// --------
/// >>> import stickslip
/// >>> recipe = stickslip.surface.SelfAffine(rms_slope=0.1, hurst=0.8, seed=1)
/// >>> rough = recipe.generate(stickslip.Grid.square(64, 1.0))
/// >>> round(rough.rms_slope, 6)
/// 0.1
#[pyclass(frozen, eq, module = "stickslip.surface")]
#[derive(Clone, PartialEq)]
pub(crate) struct SelfAffine(surface::SelfAffine);

#[pymethods]
impl SelfAffine {
    #[new]
    #[pyo3(signature = (*, rms_height=None, rms_slope=None, hurst=None, longest_wavelength=None,
        roll_off_wavelength=None, cut_off_wavelength=None, amplitudes=None, cropped=false, skewness=None,
        kurtosis=None, seed))]
    fn new(
        rms_height: Option<Real>,
        rms_slope: Option<Real>,
        hurst: Option<Real>,
        longest_wavelength: Option<Real>,
        roll_off_wavelength: Option<Real>,
        cut_off_wavelength: Option<Real>,
        amplitudes: Option<Choice<surface::Amplitudes>>,
        #[pyo3(from_py_with = crate::real::flag)] cropped: bool,
        skewness: Option<Real>,
        kurtosis: Option<Real>,
        seed: Seed,
    ) -> PyResult<Self> {
        use surface::SelfAffine as Recipe;
        type Setting = (Option<Real>, fn(Recipe, f64) -> Recipe);
        let mut recipe = match (rms_height, rms_slope) {
            (Some(Real(height)), None) => Recipe::with_rms_height(height),
            (None, Some(Real(slope))) => Recipe::with_rms_slope(slope),
            _ => {
                return Err(PyTypeError::new_err("give either rms_height or rms_slope"));
            }
        };
        let numbers: [Setting; 6] = [
            (hurst, Recipe::hurst),
            (longest_wavelength, Recipe::longest_wavelength),
            (roll_off_wavelength, Recipe::roll_off_wavelength),
            (cut_off_wavelength, Recipe::cut_off_wavelength),
            (skewness, Recipe::skewness),
            (kurtosis, Recipe::kurtosis),
        ];
        for (number, set) in numbers {
            if let Some(Real(number)) = number {
                recipe = set(recipe, number);
            }
        }
        if let Some(amplitudes) = amplitudes {
            recipe = recipe.amplitudes(amplitudes.0);
        }
        if cropped {
            recipe = recipe.cropped();
        }
        Ok(Self(recipe.seed(seed.0)))
    }

    /// Generates the surface on a grid.
    ///
    /// Raises
    /// ------
    /// NotPositive, NotFinite, Hurst, BelowMinimum, NoWaveInBand, HeightMomentsNotReached, Memory
    fn generate(&self, py: Python<'_>, grid: Object<Grid>) -> PyResult<RoughSurface> {
        self.generated(py, grid.0).map(RoughSurface)
    }

    /// Generates the heights on the grid of bodies (lengths).
    fn generate_on(&self, py: Python<'_>, bodies: Object<HalfSpace>) -> PyResult<Field> {
        let surface = self.generated(py, bodies.0.grid())?;
        Ok(surface.into_heights().into())
    }

    fn __repr__(&self) -> PyResult<String> {
        #[derive(serde::Deserialize)]
        enum Target {
            RmsHeight(f64),
            RmsSlope(f64),
        }
        #[derive(serde::Deserialize)]
        struct Parts {
            target: Target,
            hurst: f64,
            longest_wavelength: Option<f64>,
            roll_off_wavelength: Option<f64>,
            cut_off_wavelength: Option<f64>,
            amplitudes: surface::Amplitudes,
            cropped: bool,
            skewness: Option<f64>,
            kurtosis: Option<f64>,
            seed: u64,
        }
        let parts: Parts = parts(&self.0)?;
        let (name, target) = match parts.target {
            Target::RmsHeight(height) => ("rms_height", height),
            Target::RmsSlope(slope) => ("rms_slope", slope),
        };
        let numbers = [
            (name, Some(target)),
            ("hurst", Some(parts.hurst)),
            ("longest_wavelength", parts.longest_wavelength),
            ("roll_off_wavelength", parts.roll_off_wavelength),
            ("cut_off_wavelength", parts.cut_off_wavelength),
            ("skewness", parts.skewness),
            ("kurtosis", parts.kurtosis),
        ];
        let given = |(name, number): (&str, Option<f64>)| {
            number.map(|number| format!("{name}={}", short(number)))
        };
        let mut shown: Vec<_> = numbers.into_iter().filter_map(given).collect();
        shown.push(format!("amplitudes='{}'", Choice(parts.amplitudes).name()));
        if parts.cropped {
            shown.push("cropped=True".into());
        }
        shown.push(format!("seed={}", parts.seed));
        Ok(format!("SelfAffine({})", shown.join(", ")))
    }
}

impl SelfAffine {
    fn generated(&self, py: Python<'_>, grid: stickslip::Grid) -> PyResult<surface::RoughSurface> {
        observed_on(py, grid, |observer| {
            self.0.generate_observed(grid, watch(observer))
        })
    }
}

picklable!(SelfAffine: surface::SelfAffine);

/// A generated rough surface.
#[pyclass(frozen, eq, module = "stickslip.surface")]
#[derive(Clone, PartialEq)]
pub(crate) struct RoughSurface(surface::RoughSurface);

numbers! { RoughSurface:
    /// Root mean square height (a length).
    rms_height,
    /// Root mean square slope.
    rms_slope,
    /// Skewness of the heights.
    skewness,
    /// Kurtosis of the heights.
    kurtosis,
}

#[pymethods]
impl RoughSurface {
    /// The heights (lengths), with zero mean.
    #[getter]
    fn heights(&self) -> Field {
        self.0.heights().clone().into()
    }

    /// Read-only array of the heights, without a copy.
    #[getter]
    fn array<'py>(slf: &Bound<'py, Self>) -> Array<'py> {
        view(slf, |rough| rough.0.heights())
    }

    #[pyo3(signature = (dtype=None, copy=None))]
    fn __array__<'py>(
        slf: &Bound<'py, Self>,
        dtype: Option<Bound<'py, PyAny>>,
        copy: Option<bool>,
    ) -> PyResult<Bound<'py, PyAny>> {
        as_numpy(Self::array(slf).0, dtype, copy)
    }

    /// Number of iterations for a prescribed skewness or kurtosis.
    #[getter]
    fn iterations(&self) -> usize {
        self.0.iterations()
    }

    fn __repr__(&self) -> String {
        format!(
            "RoughSurface({}, rms_height={}, rms_slope={})",
            size(self.0.heights().grid()),
            short(self.0.rms_height()),
            short(self.0.rms_slope())
        )
    }
}

only_first_operand!(RoughSurface);
picklable!(RoughSurface: surface::RoughSurface);
