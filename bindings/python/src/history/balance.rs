//! Energy balance of a step or a cycle.

use pyo3::prelude::*;

use crate::digits::{rough, short};
use crate::pickle::picklable;
use crate::readers::{readers, record};

/// Energy balance of the work of the tangential load in a step or in the steps of a cycle (energies).
///
/// The balance holds for any two states. A balance that closes verifies the bookkeeping of the step, and not the laws of
/// contact.
#[pyclass(frozen, eq, module = "stickslip.history")]
#[derive(Clone, Copy, PartialEq)]
pub(crate) struct EnergyBalance(pub(crate) stickslip::history::EnergyBalance);

readers! { EnergyBalance.0:
    /// Work of the tangential load: mean force times change of the shift, plus mean moment times change of the twist.
    /// Cells that come into contact contribute only the part of the motion that they follow. The work of a changing
    /// relative displacement is included, and so is the work of the normal load if pressure and traction are solved
    /// simultaneously.
    work: f64,
    /// Elastic energy of shear before the step or cycle; energy of pressure and traction if both are solved
    /// simultaneously.
    elastic_before: f64,
    /// Elastic energy of shear after the step or cycle; energy of pressure and traction if both are solved
    /// simultaneously.
    elastic_after: f64,
    /// Dissipated energy, computed from the tractions at the end of the step, not negative. If pressure and friction do
    /// not change and the load does not turn within the step, this value is exact for any length of the step. Compare this value
    /// of a :class:`Cycle` with Mindlin's energy of a loop, and not ``dissipated_energy_midpoint``.
    dissipated_energy: f64,
    /// Dissipated energy, computed from the mean of the tractions before and after the step. This value closes the
    /// balance. It is not negative if pressure and friction do not change. In partial slip it depends on the length of the
    /// steps and approaches ``dissipated_energy`` with shorter steps.
    dissipated_energy_midpoint: f64,
    /// Energy released by the tractions of cells that leave the contact.
    released: f64,
    /// Work on the residual motion that the tolerance permits in stick cells.
    residual: f64,
    /// Deficit of the balance, relative to its largest term.
    imbalance(): f64,
}

#[pymethods]
impl EnergyBalance {
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

record!(EnergyBalance: work, elastic_before, elastic_after, dissipated_energy, dissipated_energy_midpoint, released,
    residual, imbalance);
