//! How a coupled solve ended.

use pyo3::prelude::*;

use crate::digits::{in_python, rough};
use crate::pickle::picklable;
use crate::report::Report;
use crate::sequence::pair;

/// Estimated errors of a coupled contact as a whole, each in its energy norm: not bounds.
#[pyclass(frozen, eq, module = "stickslip.coupled")]
#[derive(Clone, Copy, PartialEq)]
pub(crate) struct ErrorEstimate(stickslip::coupled::ErrorEstimate);

#[pymethods]
impl ErrorEstimate {
    /// Of the pressure.
    #[getter]
    fn pressure(&self) -> f64 {
        self.0.pressure
    }

    /// Of the traction.
    #[getter]
    fn traction(&self) -> f64 {
        self.0.traction
    }

    fn __repr__(&self) -> String {
        format!(
            "ErrorEstimate(pressure={}, traction={})",
            rough(self.0.pressure),
            rough(self.0.traction)
        )
    }
}

picklable!(ErrorEstimate: stickslip::coupled::ErrorEstimate);

/// How a coupled solve ended, what it cost, and what its halves certify.
#[pyclass(frozen, eq, module = "stickslip.coupled")]
#[derive(Clone, PartialEq)]
pub(crate) struct CoupledReport(stickslip::coupled::CoupledReport);

impl CoupledReport {
    pub(super) fn of(report: &stickslip::coupled::CoupledReport) -> Self {
        Self(report.clone())
    }
}

#[pymethods]
impl CoupledReport {
    /// Why the iteration ended, products with the whole tensor, residual and time.
    #[getter]
    fn work(&self) -> Report {
        Report::of(&self.0.work)
    }

    /// Steps and products with the normal part alone.
    #[getter]
    fn normal(&self) -> Report {
        Report::of(&self.0.normal)
    }

    /// Steps and products with the tangential part alone.
    #[getter]
    fn tangential(&self) -> Report {
        Report::of(&self.0.tangential)
    }

    /// Bound of the error of the pressure at the tractions as they are.
    #[getter]
    fn pressure_error_bound(&self) -> f64 {
        self.0.pressure_error_bound
    }

    /// Bound of the error of the tractions at the pressure as it is.
    #[getter]
    fn traction_error_bound(&self) -> f64 {
        self.0.traction_error_bound
    }

    /// Bounds of the errors of pressure and traction as a whole, where friction is weak enough for them.
    #[getter]
    fn error_bounds(&self) -> Option<(f64, f64)> {
        self.0.error_bounds.map(pair)
    }

    /// What the errors of the whole are likely to be.
    #[getter]
    fn error_estimate(&self) -> Option<ErrorEstimate> {
        self.0.error_estimate.map(ErrorEstimate)
    }

    /// Whether the tolerance was reached.
    #[getter]
    fn is_converged(&self) -> bool {
        self.0.is_converged()
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
