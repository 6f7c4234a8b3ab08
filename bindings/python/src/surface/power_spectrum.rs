//! Power spectra of surfaces.

use pyo3::prelude::*;
use stickslip::surface;

use crate::array::{Array, view_slice};
use crate::digits::short;
use crate::pickle::picklable;
use crate::samples::Samples;
use crate::surface::numbers;
use crate::work::unobserved_on;

/// The radial average of the power spectrum of a periodic surface.
///
/// Parameters
/// ----------
/// heights : Field or topography
///     The heights (lengths), without missing values.
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
        unobserved_on(py, heights.grid(), || surface::PowerSpectrum::of(&heights)).map(Self)
    }

    /// Mean wave number ``2 pi / wavelength`` of the waves of each ring (radians over lengths), in ascending order.
    #[getter]
    fn wave_numbers<'py>(slf: &Bound<'py, Self>) -> Array<'py> {
        view_slice(slf, |spectrum| spectrum.0.wave_numbers())
    }

    /// Mean spectral density C of the waves of each ring (a length to the fourth): ``2 pi`` times the integral of ``C q`` over
    /// the wave numbers q is the square of the rms height.
    #[getter]
    fn values<'py>(slf: &Bound<'py, Self>) -> Array<'py> {
        view_slice(slf, |spectrum| spectrum.0.values())
    }

    /// Number of wave vectors in each ring; q and -q are counted separately.
    #[getter]
    fn modes<'py>(&self, py: Python<'py>) -> Array<'py, u64> {
        Array::new(py, self.0.modes().iter().map(|&modes| modes as u64))
    }

    /// Spectral moments m0 (a length squared), m2 (a number) and m4 (one over a length squared).
    #[getter]
    fn moments(&self) -> (f64, f64, f64) {
        self.0.moments().into()
    }

    fn __repr__(&self) -> String {
        let rings = self.0.values().len();
        format!(
            "PowerSpectrum({rings} rings, nayak_parameter={})",
            short(self.0.nayak_parameter())
        )
    }
}

picklable!(PowerSpectrum: surface::PowerSpectrum);
