//! Surfaces: shapes, roughness, statistics, preparation.

use numpy::IntoPyArray;
use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;
use stickslip::surface;

use crate::array::{Array, view, view_slice};
use crate::choice::Choice;
use crate::error::OrRaise;
use crate::field::{Field, Samples};
use crate::grid::Grid;
use crate::half_space::HalfSpace;
use crate::pickle::picklable;
use crate::sequence::pair;
use crate::work::unobserved;

/// Shapes whose parameters are numbers.
macro_rules! shapes {
    ($($(#[$doc:meta])* $shape:ident($($parameter:ident: $type:ty),+);)+) => {$(
        $(#[$doc])*
        #[pyfunction]
        pub(crate) fn $shape(py: Python<'_>, grid: &Grid, $($parameter: $type),+) -> PyResult<Field> {
            let made = unobserved(py, grid.0.cells(), || surface::$shape(grid.0, $($parameter),+));
            made.map(Into::into)
        }
    )+};
}

shapes! {
    /// The gap under a sphere: a paraboloid of revolution of this radius (a length).
    sphere(radius: f64);
    /// The gap under a paraboloid of two radii of curvature (lengths).
    ellipsoid(radius_x: f64, radius_y: f64);
    /// The gap under a cylinder of this radius (a length), whose axis is along y.
    cylinder(radius: f64);
    /// The gap ``(k_xx x^2 + 2 k_xy x y + k_yy y^2) / 2`` under a paraboloid of curvatures ``(k_xx, k_xy, k_yy)``.
    paraboloid(curvatures: [f64; 3]);
    /// The gap under a cone of this slope.
    cone(slope: f64);
    /// The gap under a flat punch of this radius: zero below it, the recess beyond (lengths).
    flat_punch(radius: f64, recess: f64);
    /// A wave along x, zero where it is highest (lengths).
    sinusoidal(amplitude: f64, wavelength: f64);
    /// A product of waves along x and y, zero where it is highest (lengths).
    bisinusoidal(amplitude: f64, wavelengths: [f64; 2]);
}

/// The sum of fields on one grid.
#[pyfunction]
pub(crate) fn sum(py: Python<'_>, fields: Vec<Samples<'_>>) -> PyResult<Field> {
    let fields: Vec<_> = fields
        .iter()
        .map(|field| field.alone("field"))
        .collect::<PyResult<_>>()?;
    let fields: Vec<&stickslip::Field> = fields.iter().map(|field| &**field).collect();
    surface::sum(&fields).or_raise(py).map(Into::into)
}

/// Heights turned upside down.
#[pyfunction]
pub(crate) fn inverted(heights: Samples<'_>) -> PyResult<Field> {
    Ok(surface::inverted(&*heights.alone("heights")?).into())
}

/// Heights with x mirrored, as the surface of a body that is turned over is seen.
#[pyfunction]
pub(crate) fn mirror_x(heights: Samples<'_>) -> PyResult<Field> {
    Ok(surface::mirror_x(&*heights.alone("heights")?).into())
}

/// The gap of a rough body against a flat one: the largest height less each height (lengths, non-negative).
#[pyfunction]
pub(crate) fn gap_from_heights(py: Python<'_>, heights: Samples<'_>) -> PyResult<Field> {
    let heights = heights.alone("heights")?;
    surface::gap_from_heights(&heights)
        .or_raise(py)
        .map(Into::into)
}

/// The gap between two rough bodies, touching at one point. Heights point out of their body, both as seen from body 1.
#[pyfunction]
pub(crate) fn gap_between(
    py: Python<'_>,
    upper: Samples<'_>,
    lower: Samples<'_>,
) -> PyResult<Field> {
    let (upper, lower) = (upper.alone("upper")?, lower.alone("lower")?);
    surface::gap_between(&upper, &lower)
        .or_raise(py)
        .map(Into::into)
}

/// The part of a surface from one column to before another, and from one row to before another.
#[pyfunction]
pub(crate) fn crop(
    py: Python<'_>,
    heights: Samples<'_>,
    columns: (usize, usize),
    rows: (usize, usize),
) -> PyResult<Field> {
    let heights = heights.alone("heights")?;
    let cropped = surface::crop(&heights, columns.0..columns.1, rows.0..rows.1);
    cropped.or_raise(py).map(Into::into)
}

/// A surface on another grid.
#[pyfunction]
pub(crate) fn resample(py: Python<'_>, heights: Samples<'_>, grid: &Grid) -> PyResult<Field> {
    let heights = heights.alone("heights")?;
    unobserved(py, grid.0.cells(), || surface::resample(&heights, grid.0)).map(Into::into)
}

/// A surface whose missing heights (NaN) are filled smoothly.
#[pyclass(frozen, module = "stickslip.surface")]
pub(crate) struct Filled(surface::Filled);

#[pymethods]
impl Filled {
    /// All heights (lengths).
    #[getter]
    fn heights(&self) -> Field {
        self.0.heights().clone().into()
    }

    /// How many were missing.
    #[getter]
    fn filled_cells(&self) -> usize {
        self.0.filled_cells()
    }

    fn __repr__(&self) -> String {
        format!("Filled(filled_cells={})", self.0.filled_cells())
    }
}

/// Fills missing heights, which are NaN, smoothly.
#[pyfunction]
pub(crate) fn fill_missing(py: Python<'_>, heights: Samples<'_>) -> PyResult<Filled> {
    let heights = heights.alone("heights")?;
    unobserved(py, heights.grid().cells(), || {
        surface::fill_missing(&heights)
    })
    .map(Filled)
}

/// A surface without its form.
#[pyclass(frozen, module = "stickslip.surface")]
pub(crate) struct Levelled(surface::Levelled);

#[pymethods]
impl Levelled {
    /// The heights left (lengths).
    #[getter]
    fn heights(&self) -> Field {
        self.0.heights().clone().into()
    }

    /// What was taken off (lengths).
    #[getter]
    fn form(&self) -> Field {
        self.0.form().clone().into()
    }

    fn __repr__(&self) -> String {
        let (low, high) = (self.0.heights().min(), self.0.heights().max());
        format!("Levelled(heights from {low:.4e} to {high:.4e})")
    }
}

/// The form to be taken off: "mean", "plane", or the degree of a polynomial.
fn form_of(form: &Bound<'_, PyAny>) -> PyResult<surface::Form> {
    if let Ok(degree) = form.extract::<usize>() {
        return Ok(surface::Form::Polynomial(degree));
    }
    match form.extract::<String>().as_deref() {
        Ok("mean") => Ok(surface::Form::Mean),
        Ok("plane") => Ok(surface::Form::Plane),
        _ => Err(PyTypeError::new_err(
            "form must be 'mean', 'plane' or the degree of a polynomial",
        )),
    }
}

/// Takes a form off a surface, by least squares.
///
/// Parameters
/// ----------
/// heights : Field
/// form : "mean", "plane" or int
///     A number is the degree of a polynomial.
#[pyfunction]
pub(crate) fn level(
    py: Python<'_>,
    heights: Samples<'_>,
    form: Bound<'_, PyAny>,
) -> PyResult<Levelled> {
    let (heights, form) = (heights.alone("heights")?, form_of(&form)?);
    unobserved(py, heights.grid().cells(), || {
        surface::level(&heights, form)
    })
    .map(Levelled)
}

/// Parameters of a surface after ISO 25178-2.
///
/// Parameters
/// ----------
/// heights : Field or topography
#[pyclass(frozen, eq, module = "stickslip.surface")]
#[derive(Clone, PartialEq)]
pub(crate) struct Statistics(surface::Statistics);

/// Numbers with getters of the same name.
macro_rules! numbers {
    ($class:ident: $($(#[$doc:meta])* $number:ident),+ $(,)?) => {
        #[pymethods]
        impl $class {
            $(
                $(#[$doc])*
                #[getter]
                fn $number(&self) -> f64 {
                    self.0.$number()
                }
            )+
        }
    };
}

numbers! { Statistics:
    /// Mean height (a length).
    mean_height,
    /// Arithmetic mean height Sa (a length).
    arithmetic_mean_height,
    /// Root mean square height Sq (a length).
    rms_height,
    /// Skewness Ssk.
    skewness,
    /// Kurtosis Sku; 3 of Gaussian heights.
    kurtosis,
    /// Highest peak Sp above the mean (a length).
    highest_peak,
    /// Deepest valley Sv below the mean (a length).
    deepest_valley,
    /// Highest peak and deepest valley together, Sz (a length).
    height_range,
    /// Root mean square slope by differences of neighbours, Sdq.
    finite_difference_rms_slope,
    /// Root mean square slope by the spectrum, of a surface that repeats.
    spectral_rms_slope,
    /// Developed area ratio Sdr.
    developed_area_ratio,
}

#[pymethods]
impl Statistics {
    #[new]
    fn new(py: Python<'_>, heights: Samples<'_>) -> PyResult<Self> {
        let heights = heights.alone("heights")?;
        unobserved(py, heights.grid().cells(), || {
            surface::Statistics::of(&heights)
        })
        .map(Self)
    }

    /// Root mean square slopes of profiles along x and y.
    #[getter]
    fn profile_rms_slope(&self) -> (f64, f64) {
        pair(self.0.profile_rms_slope())
    }

    fn __repr__(&self) -> String {
        format!("Statistics({})", self.0)
    }
}

/// The radial average of the power spectrum of a surface that repeats.
///
/// Parameters
/// ----------
/// heights : Field or topography
#[pyclass(frozen, eq, module = "stickslip.surface")]
#[derive(Clone, PartialEq)]
pub(crate) struct PowerSpectrum(surface::PowerSpectrum);

numbers! { PowerSpectrum:
    /// Nayak's parameter.
    nayak_parameter,
    /// Root mean square of the mean curvature (one over a length).
    rms_mean_curvature,
}

#[pymethods]
impl PowerSpectrum {
    #[new]
    fn new(py: Python<'_>, heights: Samples<'_>) -> PyResult<Self> {
        let heights = heights.alone("heights")?;
        unobserved(py, heights.grid().cells(), || {
            surface::PowerSpectrum::of(&heights)
        })
        .map(Self)
    }

    /// Wave numbers of the rings (one over a length).
    #[getter]
    fn wave_numbers<'py>(slf: &Bound<'py, Self>) -> Array<'py> {
        view_slice(slf, |spectrum| spectrum.0.wave_numbers())
    }

    /// Their mean spectral density (a length to the fourth).
    #[getter]
    fn values<'py>(slf: &Bound<'py, Self>) -> Array<'py> {
        view_slice(slf, |spectrum| spectrum.0.values())
    }

    /// Waves in each ring.
    #[getter]
    fn modes<'py>(&self, py: Python<'py>) -> Array<'py> {
        let modes: Vec<u64> = self.0.modes().iter().map(|&modes| modes as u64).collect();
        Array(modes.into_pyarray(py).into_any())
    }

    /// Spectral moments m0, m2 and m4.
    #[getter]
    fn moments(&self) -> (f64, f64, f64) {
        self.0.moments().into()
    }

    fn __repr__(&self) -> String {
        let rings = self.0.values().len();
        format!(
            "PowerSpectrum({rings} rings, nayak_parameter={:.4})",
            self.0.nayak_parameter()
        )
    }
}

/// A recipe of self-affine roughness, which stays the same surface when the grid is refined.
///
/// Parameters
/// ----------
/// rms_height : float
///     Root mean square height (a length); or
/// rms_slope : float
///     Root mean square slope.
/// hurst : float, default 0.8
///     In [0, 1].
/// longest_wavelength, roll_off_wavelength, cut_off_wavelength : float, optional
///     Of the band (lengths): none longer, a plateau down to, none shorter.
/// amplitudes : Amplitudes or str, optional
///     "exact" or "gaussian".
/// cropped : bool, default False
///     Whether the grid is a part of a larger surface, and does not repeat.
/// skewness, kurtosis : float, optional
///     Of the heights.
/// seed : int, default 0
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
        kurtosis=None, seed=None))]
    fn new(
        rms_height: Option<f64>,
        rms_slope: Option<f64>,
        hurst: Option<f64>,
        longest_wavelength: Option<f64>,
        roll_off_wavelength: Option<f64>,
        cut_off_wavelength: Option<f64>,
        amplitudes: Option<Choice<surface::Amplitudes>>,
        cropped: bool,
        skewness: Option<f64>,
        kurtosis: Option<f64>,
        seed: Option<u64>,
    ) -> PyResult<Self> {
        use surface::SelfAffine as Recipe;
        type Setting = (Option<f64>, fn(Recipe, f64) -> Recipe);
        let mut recipe = match (rms_height, rms_slope) {
            (Some(height), None) => Recipe::with_rms_height(height),
            (None, Some(slope)) => Recipe::with_rms_slope(slope),
            _ => {
                return Err(PyTypeError::new_err("give one of rms_height and rms_slope"));
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
            if let Some(number) = number {
                recipe = set(recipe, number);
            }
        }
        if let Some(amplitudes) = amplitudes {
            recipe = recipe.amplitudes(amplitudes.0);
        }
        if cropped {
            recipe = recipe.cropped();
        }
        if let Some(seed) = seed {
            recipe = recipe.seed(seed);
        }
        Ok(Self(recipe))
    }

    /// The surface on a grid.
    fn generate(&self, py: Python<'_>, grid: &Grid) -> PyResult<RoughSurface> {
        unobserved(py, grid.0.cells(), || self.0.generate(grid.0)).map(RoughSurface)
    }

    /// The heights on the grid of bodies.
    fn generate_on(&self, py: Python<'_>, bodies: &HalfSpace) -> PyResult<Field> {
        let cells = bodies.0.grid().cells();
        unobserved(py, cells, || self.0.generate_on(&bodies.0)).map(Into::into)
    }

    fn __repr__(&self) -> String {
        format!("{:?}", self.0)
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
    /// Its heights (lengths), of zero mean.
    #[getter]
    fn heights(&self) -> Field {
        self.0.heights().clone().into()
    }

    /// Read-only array of the heights, without a copy.
    #[getter]
    fn array<'py>(slf: &Bound<'py, Self>) -> Array<'py> {
        view(slf, |rough| rough.0.heights())
    }

    /// Iterations that a prescribed skewness or kurtosis took.
    #[getter]
    fn iterations(&self) -> usize {
        self.0.iterations()
    }

    fn __repr__(&self) -> String {
        let grid = self.0.heights().grid();
        format!(
            "RoughSurface({} x {} cells, rms_height={:.4e}, rms_slope={:.4e})",
            grid.nx(),
            grid.ny(),
            self.0.rms_height(),
            self.0.rms_slope()
        )
    }
}
