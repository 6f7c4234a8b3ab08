//! Report of a coupled solve: status, cost and error bounds.

use crate::cgm::cone::ConeMeasures;
use crate::error::{Result, check_converged};
use crate::grid::field::clone_in_place;
use crate::report::{Report, Status};

/// Report of a coupled solve: status, cost, and certificates of its normal and tangential halves.
///
/// The equations of a coupled contact are not the optimality conditions of any energy. A bound on the whole error is
/// known only for weak friction. Therefore one product yields certificates for the two halves. The certificate of the
/// normal half bounds the distance of the pressure from the exact pressure under the computed tractions. The
/// certificate of the tangential half bounds the distance of the tractions from the exact tractions under the computed
/// pressure. If friction is weak, the two certificates also bound the whole error.
#[derive(Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub struct CoupledReport {
    /// Report of the coupled solve on the cells of the finest window: status, GMRES steps, products, residual, load
    /// error and time. The products are products with the tensor of all coefficients. The duality gap is infinite
    /// because the whole error is not certified. The eigenvalue bound is the weaker of the two bounds used for the
    /// halves.
    pub work: Report,
    /// Report of the normal half: its steps and products with the normal operator in the alternating sweeps.
    pub normal: Report,
    /// Report of the tangential half: its steps and products with the tangential operator in the alternating sweeps.
    pub tangential: Report,
    /// Bound on the error of the pressure for the computed tractions. The error is measured in the energy norm,
    /// relative to the square root of `x' C x`.
    #[cfg_attr(feature = "serde", serde(with = "crate::support::serialise::number"))]
    pub pressure_error_bound: f64,
    /// Bound on the error of the tractions for the computed pressure. The error is measured in the energy norm,
    /// relative to the square root of `x' C x`.
    #[cfg_attr(feature = "serde", serde(with = "crate::support::serialise::number"))]
    pub traction_error_bound: f64,
    /// Rigorous bounds on the whole errors of pressure and traction. Each error is measured in its energy norm,
    /// relative to the square root of `x' C x`. The bounds exist if friction is weak enough for the grid and no
    /// tangential force is prescribed. Otherwise, and on periodic grids, the value is `None`, and only the halves are
    /// certified.
    pub error_bounds: Option<[f64; 2]>,
    /// Estimated errors of the whole solution, or `None` if friction is too strong.
    pub error_estimate: Option<ErrorEstimate>,
}

/// Estimated errors of a whole coupled solution. Each error is measured in its energy norm, relative to the square root
/// of `x' C x`. The estimates are not bounds.
///
/// The estimate has the form of [`CoupledReport::error_bounds`] but uses the sensitivities observed in measured
/// contacts. The change of the pressure was at most $`0.7\,|\beta|`$ times the change of the traction that caused it.
/// The change of the traction was at most $`0.7\,|\beta| + \mu`$ times the change of the pressure that caused it. The
/// estimate is `None` unless the product of the two factors is below one. At $`\beta = 1/2`$ the estimate is `None` for
/// $`\mu > 2.5`$.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub struct ErrorEstimate {
    /// Estimated error of the pressure.
    pub pressure: f64,
    /// Estimated error of the traction.
    pub traction: f64,
}

clone_in_place!(CoupledReport {
    work,
    normal,
    tangential,
    pressure_error_bound,
    traction_error_bound,
    error_bounds,
    error_estimate,
});

impl CoupledReport {
    pub(super) fn unsolved() -> Self {
        Self {
            work: Report::with_room(),
            normal: Report::with_room(),
            tangential: Report::with_room(),
            pressure_error_bound: f64::INFINITY,
            traction_error_bound: f64::INFINITY,
            error_bounds: None,
            error_estimate: None,
        }
    }

    /// Resets the report before a solve and keeps its memory.
    pub(super) fn clear(&mut self) {
        for report in [&mut self.work, &mut self.normal, &mut self.tangential] {
            report.clear();
        }
        (self.pressure_error_bound, self.traction_error_bound) = (f64::INFINITY, f64::INFINITY);
        (self.error_bounds, self.error_estimate) = (None, None);
    }

    /// Sets the report of separated bodies: converged, with zero errors.
    pub(super) fn apart(&mut self) {
        self.clear();
        self.work.status = Status::Converged;
        (self.work.residual, self.work.load_error) = (0.0, 0.0);
        (self.pressure_error_bound, self.traction_error_bound) = (0.0, 0.0);
        self.error_bounds = Some([0.0; 2]);
    }

    pub(super) fn take(&mut self, findings: &ConeMeasures) {
        self.work.residual = findings.residual;
        self.work.load_error = findings.load_error;
        [self.pressure_error_bound, self.traction_error_bound] = findings.bounds;
    }

    /// Sets the final status and returns an error unless the solve has converged.
    pub(super) fn end(&mut self, status: Status) -> Result<()> {
        self.work.status = status;
        self.work.duality_gap = f64::INFINITY;
        check_converged(&self.work)
    }

    /// Returns whether the tolerance was reached.
    #[must_use]
    pub fn is_converged(&self) -> bool {
        self.work.is_converged()
    }
}
