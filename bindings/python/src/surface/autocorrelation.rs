//! Autocorrelation functions of surfaces.

use pyo3::prelude::*;
use stickslip::surface;

use crate::digits::short;
use crate::field::Field;
use crate::pickle::picklable;
use crate::readers::record;
use crate::real::{Real, out_of_range};
use crate::samples::Samples;
use crate::work::unobserved_on;

/// Threshold of the parameters by default (ISO 25178-3).
const THRESHOLD: f64 = 0.2;

/// Returns the threshold, or an error if it is not between 0 and 1.
fn checked(py: Python<'_>, threshold: Real) -> PyResult<f64> {
    let Real(threshold) = threshold;
    if threshold > 0.0 && threshold < 1.0 {
        return Ok(threshold);
    }
    let message = format!("must lie strictly between 0 and 1, got {threshold:?}");
    Err(out_of_range(py, "threshold", &message))
}

/// The autocorrelation function of a surface, with the spatial parameters of ISO 25178-2.
///
/// The function is the mean product of the heights of all pairs of measured points at a lag, relative to its value without a
/// lag. Lags extend to half the length of the grid along each axis. Level the surface first.
///
/// Parameters
/// ----------
/// heights : Field or topography
///     The heights (lengths). Missing heights (NaN) form no pairs.
/// periodic : bool, default False
///     Whether the surface continues periodically beyond its edges.
///
/// Raises
/// ------
/// Sample, Undetermined, Memory
///
/// Examples
/// --------
/// >>> import numpy as np, stickslip as ss
/// >>> grid = ss.Grid.square(256, 256.0)
/// >>> wave = ss.Field(grid, np.tile(np.sin(2.0 * np.pi * grid.x / 128.0), (256, 1)))
/// >>> correlation = ss.surface.Autocorrelation(wave, periodic=True)
/// >>> round(correlation.Sal / 128.0, 3), round(float(np.arccos(0.2) / (2.0 * np.pi)), 3)
/// (0.218, 0.218)
#[pyclass(frozen, eq, module = "stickslip.surface")]
#[derive(Clone, PartialEq)]
pub(crate) struct Autocorrelation(surface::Autocorrelation);

picklable!(Autocorrelation: surface::Autocorrelation);

record!(Autocorrelation: Sal, Str);

#[pymethods]
#[allow(non_snake_case, reason = "the names of the standard")]
impl Autocorrelation {
    #[new]
    #[pyo3(signature = (heights, *, periodic=false))]
    fn new(
        py: Python<'_>,
        heights: Samples<'_>,
        #[pyo3(from_py_with = crate::real::flag)] periodic: bool,
    ) -> PyResult<Self> {
        let heights = heights.alone("heights")?;
        let of = if periodic {
            surface::Autocorrelation::of_periodic
        } else {
            surface::Autocorrelation::of
        };
        unobserved_on(py, heights.grid(), || of(&heights)).map(Self)
    }

    /// The function on a grid of lags; the lag of a cell is its position, and the lag zero is in the middle. NaN at lags
    /// without a pair of measured points.
    #[getter]
    fn values(&self) -> Field {
        self.0.values().clone().into()
    }

    /// Returns the autocorrelation length Sal (a length): the smallest distance over which the function falls to a
    /// threshold between 0 and 1; ``None`` if it remains above the threshold at all lags.
    ///
    /// Raises
    /// ------
    /// ArgumentRange
    ///     If the threshold is not between 0 and 1.
    #[pyo3(signature = (threshold=Real(THRESHOLD)))]
    fn decay_length(&self, py: Python<'_>, threshold: Real) -> PyResult<Option<f64>> {
        Ok(self.0.decay_length(checked(py, threshold)?))
    }

    /// Returns the texture aspect ratio Str, from 0 to 1: the smallest divided by the largest distance over which the
    /// function falls to a threshold between 0 and 1; ``None`` if it remains above the threshold at all lags. In directions in which
    /// the function does not fall to the threshold, the largest lag is used, so the true ratio is smaller.
    ///
    /// Raises
    /// ------
    /// ArgumentRange
    ///     If the threshold is not between 0 and 1.
    #[pyo3(signature = (threshold=Real(THRESHOLD)))]
    fn texture_aspect_ratio(&self, py: Python<'_>, threshold: Real) -> PyResult<Option<f64>> {
        Ok(self.0.texture_aspect_ratio(checked(py, threshold)?))
    }

    /// Autocorrelation length (ISO 25178-2) for the threshold 0.2: :meth:`decay_length`.
    #[getter]
    fn Sal(&self) -> Option<f64> {
        self.0.decay_length(THRESHOLD)
    }

    /// Texture aspect ratio (ISO 25178-2) for the threshold 0.2: :meth:`texture_aspect_ratio`.
    #[getter]
    fn Str(&self) -> Option<f64> {
        self.0.texture_aspect_ratio(THRESHOLD)
    }

    fn __repr__(&self) -> String {
        let shown = |value: Option<f64>| value.map_or("None".into(), short);
        format!(
            "Autocorrelation(Sal={}, Str={})",
            shown(self.0.decay_length(THRESHOLD)),
            shown(self.0.texture_aspect_ratio(THRESHOLD))
        )
    }
}
