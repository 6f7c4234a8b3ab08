//! The solution of a rolling contact.

use std::sync::Arc;

use pyo3::prelude::*;
use stickslip::rolling;

use crate::array::{Array, copy, view, zones};
use crate::digits::{short, tuple};
use crate::error::OrRaise;
use crate::grid::Grid;
use crate::report::{Report, Warning, ending};
use crate::sequence::pair;

/// Traction, slip, zones, creepage and dissipation of steady rolling. Vectors are (x, y). Arrays are read-only views of its
/// memory, those of the zones and the dissipation copies.
#[pyclass(frozen, module = "stickslip.rolling")]
pub(crate) struct RollingSolution(Arc<rolling::RollingSolution>);

impl From<Arc<rolling::RollingSolution>> for RollingSolution {
    fn from(solution: Arc<rolling::RollingSolution>) -> Self {
        Self(solution)
    }
}

#[pymethods]
impl RollingSolution {
    /// The grid of its fields.
    #[getter]
    fn grid(&self) -> Grid {
        Grid(self.0.grid())
    }

    /// Traction on body 1 along x and y (pressures); zero outside the contact.
    #[getter]
    fn traction<'py>(slf: &Bound<'py, Self>) -> (Array<'py>, Array<'py>) {
        (
            view(slf, |solution| solution.0.traction()[0]),
            view(slf, |solution| solution.0.traction()[1]),
        )
    }

    /// Slip of the surface of body 1 over that of body 2 along x and y for each length rolled (dimensionless), over the
    /// step that brought the particles here: against the traction in slip cells, zero elsewhere.
    #[getter]
    fn slip<'py>(slf: &Bound<'py, Self>) -> (Array<'py>, Array<'py>) {
        (
            view(slf, |solution| solution.0.slip()[0]),
            view(slf, |solution| solution.0.slip()[1]),
        )
    }

    /// The zone of every cell, bytes of shape (ny, nx): the numbers of :class:`Zone`, 0 separated, 1 stick, 2 slip.
    #[getter]
    fn zones<'py>(&self, py: Python<'py>) -> Array<'py, u8> {
        zones(py, self.0.grid(), self.0.zones())
    }

    /// The creepages along x and y, prescribed or caused by the force (dimensionless).
    #[getter]
    fn creepage(&self) -> (f64, f64) {
        pair(self.0.creepage())
    }

    /// The spin, prescribed or caused by the moment (one over a length, positive from x to y).
    #[getter]
    fn spin(&self) -> f64 {
        self.0.spin()
    }

    /// Tangential force that body 2 exerts on body 1 along x and y.
    #[getter]
    fn force(&self) -> (f64, f64) {
        pair(self.0.force())
    }

    /// Moment about z, at the origin of the grid, on body 1 (a force times a length, positive from x to y).
    #[getter]
    fn moment(&self) -> f64 {
        self.0.moment()
    }

    /// Work of creepages and spin for each length rolled (a force). The spin moves particles as the middles of their
    /// paths, so that its moment is taken there. Between bodies of the same material all of the work is dissipated.
    /// Between others the pressure does work as well, which is not included.
    #[getter]
    fn work(&self) -> f64 {
        self.0.work()
    }

    /// Energy that slip dissipates in each cell for each length rolled (a pressure): what wear follows. Between bodies of
    /// the same material its integral is less than the work by a part that falls with the size of the cells.
    #[getter]
    fn dissipation<'py>(&self, py: Python<'py>) -> PyResult<Array<'py>> {
        let dissipation = self.0.dissipation().or_raise(py)?;
        Ok(copy(py, &dissipation))
    }

    /// Cells that stick over cells in contact; zero without contact.
    #[getter]
    fn stick_ratio(&self) -> f64 {
        self.0.stick_ratio()
    }

    /// How the solve ended, what it cost, how large its error can be.
    #[getter]
    fn report(&self) -> Report {
        Report::of(self.0.report())
    }

    /// Remarks on a result that may mislead; empty if there are none.
    #[getter]
    fn warnings(&self) -> Vec<Warning> {
        Warning::all(self.0.warnings())
    }

    fn __repr__(&self) -> String {
        format!(
            "RollingSolution(creepage={}, spin={}, force={}, stick_ratio={}, {})",
            tuple(&self.0.creepage()),
            short(self.0.spin()),
            tuple(&self.0.force()),
            short(self.0.stick_ratio()),
            ending(self.0.report(), &self.0.warnings())
        )
    }
}
