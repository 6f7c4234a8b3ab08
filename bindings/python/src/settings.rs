//! Method, tolerance and limits of an iteration.

use std::time::Duration;

use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

use crate::argument::by_value;
use crate::choice::Choice;
use crate::digits::short;
use crate::error::OrRaise;
use crate::pickle::picklable;
use crate::readers::readers;
use crate::real::{Count, Real};

/// Method, tolerance and limits of an iteration. Every problem, solver and history accepts them together as ``settings``,
/// or individually by the same keywords.
///
/// Parameters
/// ----------
/// tolerance : float, default 1e-8
///     Upper limit for the certified error in the energy norm, relative to the norm of the solution, and for the largest residual.
///     A tolerance of 0.1 permits errors of forces, areas and stick ratios of tens of per cent, without a warning.
/// method : Method or str, default "active_set"
///     "active_set", or "polonsky_keer" for problems with one unknown per cell.
/// max_iterations : int, default 10000
///     Maximum number of conjugate-gradient steps.
/// time_limit : float, optional
///     Maximum wall time of a solve (s).
///
/// Raises
/// ------
/// Tolerance, IterationLimit
#[pyclass(frozen, eq, module = "stickslip")]
#[derive(Clone, Copy, PartialEq)]
pub(crate) struct Settings(pub(crate) stickslip::cgm::Settings);

readers! { Settings.0:
    /// Tolerance of the error.
    tolerance: f64,
    /// Method of the iteration.
    method: Choice<stickslip::cgm::Method> => Choice,
    /// Maximum number of conjugate-gradient steps.
    max_iterations: usize,
}

by_value!(Settings);

#[pymethods]
impl Settings {
    #[new]
    #[pyo3(signature = (*, tolerance=None, method=None, max_iterations=None, time_limit=None))]
    fn new(
        py: Python<'_>,
        tolerance: Option<Real>,
        method: Option<Choice<stickslip::cgm::Method>>,
        max_iterations: Option<Count>,
        time_limit: Option<Real>,
    ) -> PyResult<Self> {
        let settings = chosen(None, tolerance, method, max_iterations, time_limit)?;
        settings.check().or_raise(py)?;
        Ok(Self(settings))
    }

    /// Maximum wall time (s), or ``None``.
    #[getter]
    fn time_limit(&self) -> Option<f64> {
        self.0.time_limit.map(|limit| limit.as_secs_f64())
    }

    fn __repr__(&self) -> String {
        let limit = self.time_limit().map_or("None".into(), short);
        format!(
            "Settings(tolerance={}, method='{}', max_iterations={}, time_limit={limit})",
            short(self.0.tolerance),
            self.method().name(),
            self.0.max_iterations
        )
    }
}

picklable!(Settings: stickslip::cgm::Settings);

/// Returns the settings of a call: the common settings, overridden by the individual ones.
pub(crate) fn chosen(
    settings: Option<Settings>,
    tolerance: Option<Real>,
    method: Option<Choice<stickslip::cgm::Method>>,
    max_iterations: Option<Count>,
    time_limit: Option<Real>,
) -> PyResult<stickslip::cgm::Settings> {
    let mut chosen = settings.map(|settings| settings.0).unwrap_or_default();
    if let Some(Real(tolerance)) = tolerance {
        chosen = chosen.tolerance(tolerance);
    }
    if let Some(method) = method {
        chosen = chosen.method(method.0);
    }
    if let Some(Count(most)) = max_iterations {
        chosen = chosen.max_iterations(most);
    }
    if let Some(Real(seconds)) = time_limit {
        chosen = chosen.time_limit(duration(seconds)?);
    }
    Ok(chosen)
}

/// Returns the duration of a time limit in seconds.
pub(crate) fn duration(seconds: f64) -> PyResult<Duration> {
    Duration::try_from_secs_f64(seconds).map_err(|_| {
        PyValueError::new_err(format!(
            "time_limit must be a non-negative number of seconds, got {seconds}"
        ))
    })
}
