//! Energy balance of a step or a cycle.

use pyo3::prelude::*;

use crate::digits::{rough, short};
use crate::pickle::picklable;

/// Energy balance of the work of the tangential load in a step or in the steps of a cycle (energies).
///
/// The balance holds for any two states. A balance that closes verifies the bookkeeping of the step, and not the laws of
/// contact.
#[pyclass(frozen, eq, module = "stickslip.history")]
#[derive(Clone, Copy, PartialEq)]
pub(crate) struct EnergyBalance(pub(crate) stickslip::history::EnergyBalance);

#[pymethods]
impl EnergyBalance {
    /// Work of the tangential load: mean force times change of the shift, plus mean moment times change of the twist.
    /// Cells that come into contact contribute only the part of the motion that they follow. The work of a changing
    /// relative displacement is included, and so is the work of the normal load if pressure and traction are solved
    /// simultaneously.
    #[getter]
    fn work(&self) -> f64 {
        self.0.work
    }

    /// Elastic energy of shear before the step or cycle; energy of pressure and traction if both are solved
    /// simultaneously.
    #[getter]
    fn elastic_before(&self) -> f64 {
        self.0.elastic_before
    }

    /// Elastic energy of shear after the step or cycle; energy of pressure and traction if both are solved
    /// simultaneously.
    #[getter]
    fn elastic_after(&self) -> f64 {
        self.0.elastic_after
    }

    /// Dissipated energy, computed from the tractions at the end of the step, not negative. If pressure and friction do
    /// not change and the load does not turn within the step, this value is exact for any length of the step.
    #[getter]
    fn dissipated_energy(&self) -> f64 {
        self.0.dissipated_energy
    }

    /// Dissipated energy, computed from the mean of the tractions before and after the step. This value closes the
    /// balance. It is not negative if pressure and friction do not change.
    #[getter]
    fn dissipated_energy_midpoint(&self) -> f64 {
        self.0.dissipated_energy_midpoint
    }

    /// Energy released by the tractions of cells that leave the contact.
    #[getter]
    fn released(&self) -> f64 {
        self.0.released
    }

    /// Work on the residual motion that the tolerance permits in stick cells.
    #[getter]
    fn residual(&self) -> f64 {
        self.0.residual
    }

    /// Deficit of the balance, relative to its largest term.
    #[getter]
    fn imbalance(&self) -> f64 {
        self.0.imbalance()
    }

    fn __repr__(&self) -> String {
        format!(
            "EnergyBalance(work={}, dissipated_energy={}, dissipated_energy_midpoint={}, elastic_after={}, imbalance={})",
            short(self.0.work),
            short(self.0.dissipated_energy),
            short(self.0.dissipated_energy_midpoint),
            short(self.0.elastic_after),
            rough(self.0.imbalance())
        )
    }
}

picklable!(EnergyBalance: stickslip::history::EnergyBalance);
