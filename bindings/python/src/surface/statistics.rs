//! Statistics of surfaces.

use pyo3::prelude::*;
use stickslip::surface;

use crate::digits::in_python;
use crate::pickle::picklable;
use crate::readers::{iso_names, readers};
use crate::samples::Samples;
use crate::sequence::pair;
use crate::surface::numbers;
use crate::work::unobserved_on;

/// Height and slope parameters of a surface according to ISO 25178-2. Heights are relative to their mean, and are neither
/// filtered nor levelled.
///
/// Parameters
/// ----------
/// heights : Field or topography
///     The heights (lengths). Missing heights (NaN) have no weight: slopes use pairs of measured neighbours, the developed
///     area uses groups of four measured neighbours, and the spectral slope is NaN.
///
/// Raises
/// ------
/// Sample, Undetermined, NotFinite
///
/// Examples
/// --------
/// >>> import numpy as np, stickslip as ss
/// >>> grid = ss.Grid.square(64, 64.0)
/// >>> wave = ss.Field(grid, np.tile(2.0 * np.cos(2.0 * np.pi * grid.x / 8.0), (64, 1)))
/// >>> found = ss.surface.Statistics(wave)
/// >>> round(found.Sq, 6), round(found.Sku, 6), found.measured_points
/// (1.414214, 1.5, 4096)
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
    /// Root mean square gradient Sdq, from the differences of neighbouring heights along x and y.
    finite_difference_rms_slope,
    /// Root mean square slope from the spectrum, for a periodic surface.
    spectral_rms_slope,
    /// Developed area ratio Sdr.
    developed_area_ratio,
}

readers! { Statistics.0:
    /// Number of measured heights, on which the parameters are based.
    measured_points(): usize,
    /// Root mean square slopes of profiles along x and y.
    profile_rms_slope(): (f64, f64) => pair,
}

iso_names! { Statistics:
    Sa = arithmetic_mean_height,
    Sq = rms_height,
    Ssk = skewness,
    Sku = kurtosis,
    Sp = highest_peak,
    Sv = deepest_valley,
    Sz = height_range,
    Sdq = finite_difference_rms_slope,
    Sdr = developed_area_ratio;
    measured_points, mean_height, spectral_rms_slope
}

#[pymethods]
impl Statistics {
    #[new]
    fn new(py: Python<'_>, heights: Samples<'_>) -> PyResult<Self> {
        let heights = heights.alone("heights")?;
        unobserved_on(py, heights.grid(), || surface::Statistics::of(&heights)).map(Self)
    }

    fn __repr__(&self, py: Python<'_>) -> PyResult<String> {
        Ok(format!(
            "Statistics({})",
            in_python(py, &self.0.to_string())?
        ))
    }
}
