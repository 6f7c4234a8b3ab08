//! Reports of coupled solves.

use pyo3::prelude::*;

use crate::digits::{in_python, rough};
use crate::pickle::picklable;
use crate::readers::{readers, record};
use crate::report::Report;
use crate::sequence::pair;

/// Estimated errors of a coupled contact as a whole, each in its energy norm. The estimates are not bounds.
#[pyclass(frozen, eq, module = "stickslip.coupled")]
#[derive(Clone, Copy, PartialEq)]
pub(crate) struct ErrorEstimate(stickslip::coupled::ErrorEstimate);

readers! { ErrorEstimate.0:
    /// Estimated error of the pressure.
    pressure: f64,
    /// Estimated error of the traction.
    traction: f64,
}

#[pymethods]
impl ErrorEstimate {
    fn __repr__(&self) -> String {
        format!(
            "ErrorEstimate(pressure={}, traction={})",
            rough(self.0.pressure),
            rough(self.0.traction)
        )
    }
}

picklable!(ErrorEstimate: stickslip::coupled::ErrorEstimate);

record!(ErrorEstimate: pressure, traction);

/// Termination and cost of a coupled solve, and the certified error bounds of its normal and tangential parts.
#[pyclass(frozen, eq, module = "stickslip.coupled")]
#[derive(Clone, PartialEq)]
pub(crate) struct CoupledReport(stickslip::coupled::CoupledReport);

impl CoupledReport {
    pub(super) fn of(report: &stickslip::coupled::CoupledReport) -> Self {
        Self(report.clone())
    }
}

readers! { CoupledReport.0:
    /// Bound on the error of the pressure for the tractions of the solution.
    pressure_error_bound: f64,
    /// Bound on the error of the tractions for the pressure of the solution.
    traction_error_bound: f64,
    /// Whether the tolerance was reached.
    is_converged(): bool,
}

#[pymethods]
impl CoupledReport {
    /// Report of the whole solve: reason for its end, products with the full operator, residual and time.
    #[getter]
    fn work(&self) -> Report {
        Report::of(&self.0.work)
    }

    /// Report of the steps and products with the normal part alone.
    #[getter]
    fn normal(&self) -> Report {
        Report::of(&self.0.normal)
    }

    /// Report of the steps and products with the tangential part alone.
    #[getter]
    fn tangential(&self) -> Report {
        Report::of(&self.0.tangential)
    }

    /// Bounds on the errors of pressure and traction of the coupled problem; ``None`` unless friction is weak enough for
    /// such bounds.
    #[getter]
    fn error_bounds(&self) -> Option<(f64, f64)> {
        self.0.error_bounds.map(pair)
    }

    /// Estimated errors of the coupled problem, if available.
    #[getter]
    fn error_estimate(&self) -> Option<ErrorEstimate> {
        self.0.error_estimate.map(ErrorEstimate)
    }

    fn __repr__(&self, py: Python<'_>) -> PyResult<String> {
        Ok(format!(
            "CoupledReport({}, pressure error <= {}, traction error <= {} as halves)",
            in_python(py, &self.0.work.to_string())?,
            rough(self.0.pressure_error_bound),
            rough(self.0.traction_error_bound)
        ))
    }
}

picklable!(CoupledReport: stickslip::coupled::CoupledReport);

record!(CoupledReport: is_converged, pressure_error_bound, traction_error_bound, error_bounds, error_estimate, work, normal,
    tangential);
