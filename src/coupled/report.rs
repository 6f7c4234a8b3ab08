//! How a coupled solve ended, and how large its error can be.

use crate::cgm::cone::ConeMeasures;
use crate::error::{Error, Result};
use crate::grid::field::clone_in_place;
use crate::report::{Report, Status};

/// How a coupled solve ended, what it cost, and what its halves certify.
///
/// The equations of a coupled contact are not those of a minimum of any energy, and no bound of its whole error is known
/// beyond weak friction.
/// What is certified are the halves, from one product: how far the pressure is from the one that belongs to the
/// tractions as they are, and how far the tractions are from those that belong to the pressure as it is. Where friction is
/// weak, they bound the whole.
#[derive(Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub struct CoupledReport {
    /// Of the cells of the finest window: why the iteration ended, steps of GMRES, products with the tensor of all
    /// coefficients, residual, load error and time. Its duality gap is infinite: nothing is certified of the whole; its eigenvalue bound is
    /// that on which the bounds of the halves rest, the weaker of both.
    pub work: Report,
    /// Steps and products, with the normal part alone, of the sweeps of halves.
    pub normal: Report,
    /// The same with the tangential part.
    pub tangential: Report,
    /// Bound of the error of the pressure in the energy norm, at tractions as they are, over the root of `x' C x`.
    #[cfg_attr(feature = "serde", serde(with = "crate::support::serialise::number"))]
    pub pressure_error_bound: f64,
    /// Bound of the error of the tractions in the energy norm, at the pressure as it is, over the same.
    #[cfg_attr(feature = "serde", serde(with = "crate::support::serialise::number"))]
    pub traction_error_bound: f64,
    /// Bounds of the errors of pressure and of traction as a whole, each in its energy norm over the same: rigorous, where
    /// friction is weak enough for the grid and no tangential force is prescribed. `None` elsewhere, and on grids that
    /// repeat: nothing is certified there but the halves.
    pub error_bounds: Option<[f64; 2]>,
    /// What the errors of the whole are likely to be, of every contact but those of the strongest friction.
    pub error_estimate: Option<ErrorEstimate>,
}

/// Estimated errors of a coupled contact as a whole, each in its energy norm over the root of `x' C x`: not bounds.
///
/// As [`CoupledReport::error_bounds`], but by how pressure and traction depended on one another in measured contacts: a
/// change of the traction changed the pressure by at most $`0.7\,|\beta|`$, one of the pressure the traction by at most
/// $`0.7\,|\beta| + \mu`$. `None` where the product of these is not below one: at $`\beta = 1/2`$ beyond $`\mu = 2.5`$.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub struct ErrorEstimate {
    /// Of the pressure.
    pub pressure: f64,
    /// Of the traction.
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

    /// Before a solve, with the memory there is.
    pub(super) fn clear(&mut self) {
        for report in [&mut self.work, &mut self.normal, &mut self.tangential] {
            report.clear();
        }
        (self.pressure_error_bound, self.traction_error_bound) = (f64::INFINITY, f64::INFINITY);
        (self.error_bounds, self.error_estimate) = (None, None);
    }

    /// Of bodies that do not touch: nothing was to be found, and nothing is wrong.
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

    /// Ends with a status: an error unless it has converged.
    pub(super) fn end(&mut self, status: Status) -> Result<()> {
        self.work.status = status;
        self.work.duality_gap = f64::INFINITY;
        if status == Status::Converged {
            Ok(())
        } else {
            Err(Error::NotConverged(Box::new(self.work.clone())))
        }
    }

    /// Whether the tolerance was reached.
    #[must_use]
    pub fn is_converged(&self) -> bool {
        self.work.is_converged()
    }
}
