//! Statistics of surfaces.

use pyo3::prelude::*;
use stickslip::surface;

use crate::digits::in_python;
use crate::field::Samples;
use crate::pickle::picklable;
use crate::sequence::pair;
use crate::surface::numbers;
use crate::work::unobserved_on;

/// Parameters of a surface according to ISO 25178-2.
///
/// Parameters
/// ----------
/// heights : Field or topography
///     The heights (lengths), without missing values.
#[pyclass(frozen, eq, module = "stickslip.surface")]
#[derive(Clone, PartialEq)]
pub(crate) struct Statistics(surface::Statistics);

picklable!(Statistics: surface::Statistics);

numbers! { Statistics:
    /// Mean height (a length).
    mean_height,
    /// Arithmetic mean height Sa (a length).
    arithmetic_mean_height,
    /// Root mean square height Sq (a length).
    rms_height,
    /// Skewness Ssk.
    skewness,
    /// Kurtosis Sku; 3 for Gaussian heights.
    kurtosis,
    /// Highest peak Sp above the mean (a length).
    highest_peak,
    /// Deepest valley Sv below the mean (a length).
    deepest_valley,
    /// Sum of the highest peak and the deepest valley, Sz (a length).
    height_range,
    /// Root mean square slope from finite differences of neighbouring cells, Sdq.
    finite_difference_rms_slope,
    /// Root mean square slope from the spectrum, for a periodic surface.
    spectral_rms_slope,
    /// Developed area ratio Sdr.
    developed_area_ratio,
}

#[pymethods]
impl Statistics {
    #[new]
    fn new(py: Python<'_>, heights: Samples<'_>) -> PyResult<Self> {
        let heights = heights.alone("heights")?;
        unobserved_on(py, heights.grid(), || surface::Statistics::of(&heights)).map(Self)
    }

    /// Root mean square slopes of profiles along x and y.
    #[getter]
    fn profile_rms_slope(&self) -> (f64, f64) {
        pair(self.0.profile_rms_slope())
    }

    fn __repr__(&self, py: Python<'_>) -> PyResult<String> {
        Ok(format!(
            "Statistics({})",
            in_python(py, &self.0.to_string())?
        ))
    }
}
