//! The report of a coupled rolling solve: status, cost and error bounds.

use crate::error::{Result, check_converged};
use crate::grid::field::clone_in_place;
use crate::report::{Report, Status};

/// Report of coupled steady rolling: status, cost, passes and certified errors.
///
/// The equations have two halves: the pressure for given tractions, and the tractions for a given pressure. The error of
/// each half has a rigorous bound. As for [`CoupledReport`](crate::coupled::CoupledReport), no bound is known for the
/// coupled problem as a whole.
#[derive(Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub struct CoupledRollingReport {
    /// Report of the coupled solve: status, iterations and products of all passes, and the larger residual of the two
    /// halves. The duality gap is infinite for coupled bodies.
    pub work: Report,
    /// Report of the normal half: iterations and products for the pressure, with the certificate of the last pass.
    pub normal: Report,
    /// Report of the rolling half: iterations and products for the tractions, with the certificate of the last pass.
    pub rolling: Report,
    /// Number of passes. Each pass solves for the pressure and then for the tractions.
    pub passes: usize,
    /// Residual of the coupling. It is half the range of the lift that the last pass added within the contact, divided by the
    /// largest normal displacement. If the approach is prescribed, the largest absolute value of this lift replaces half its
    /// range.
    #[cfg_attr(feature = "serde", serde(with = "crate::support::serialise::number"))]
    pub coupling_residual: f64,
    /// Change of the pressure in the last pass divided by the pressure (root mean squares). The change is zero if a
    /// single pass is exact.
    #[cfg_attr(feature = "serde", serde(with = "crate::support::serialise::number"))]
    pub pressure_change: f64,
    /// Bound on the relative error of the pressure in the energy norm, for the tractions of the solution.
    #[cfg_attr(feature = "serde", serde(with = "crate::support::serialise::number"))]
    pub pressure_error_bound: f64,
    /// Bound on the relative error of the tractions in the norm of [rolling](crate::rolling#uniqueness-and-error), for
    /// the pressure of the solution.
    #[cfg_attr(feature = "serde", serde(with = "crate::support::serialise::number"))]
    pub traction_error_bound: f64,
    /// Estimate of the relative error of the pressure in the energy norm for the whole coupled contact. The estimate is not a
    /// bound. The estimate assumes the sensitivities of [`ErrorEstimate`](crate::coupled::ErrorEstimate). It is `None` if the
    /// product of these sensitivities is one or more.
    pub error_estimate: Option<f64>,
}

clone_in_place!(CoupledRollingReport {
    work,
    normal,
    rolling,
    passes,
    coupling_residual,
    pressure_change,
    pressure_error_bound,
    traction_error_bound,
    error_estimate,
});

impl CoupledRollingReport {
    pub(super) fn unsolved() -> Self {
        Self {
            work: Report::with_room(),
            normal: Report::with_room(),
            rolling: Report::with_room(),
            passes: 0,
            coupling_residual: f64::INFINITY,
            pressure_change: f64::INFINITY,
            pressure_error_bound: f64::INFINITY,
            traction_error_bound: f64::INFINITY,
            error_estimate: None,
        }
    }

    /// Resets the report before a solve and keeps its memory.
    pub(super) fn clear(&mut self) {
        for report in [&mut self.work, &mut self.normal, &mut self.rolling] {
            report.clear();
        }
        self.passes = 0;
        (self.coupling_residual, self.pressure_change) = (f64::INFINITY, f64::INFINITY);
        (self.pressure_error_bound, self.traction_error_bound) = (f64::INFINITY, f64::INFINITY);
        self.error_estimate = None;
    }

    /// Returns the largest of the errors of both halves and of their coupling.
    pub(super) fn merit(&self) -> f64 {
        [
            self.work.residual,
            self.work.load_error,
            self.pressure_error_bound,
            self.traction_error_bound,
        ]
        .into_iter()
        .fold(0.0, crate::cgm::reduce::larger)
    }

    /// Sets the status and returns an error if the status is not [`Status::Converged`].
    pub(super) fn end(&mut self, status: Status) -> Result<()> {
        self.work.status = status;
        check_converged(&self.work)
    }

    /// Returns whether the tolerance was reached.
    #[must_use]
    pub fn is_converged(&self) -> bool {
        self.work.is_converged()
    }
}
