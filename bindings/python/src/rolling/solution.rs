//! Solutions of rolling contacts.

use std::sync::Arc;

use pyo3::prelude::*;
use stickslip::rolling;

use crate::array::{Array, energies_per_area, snapshot, view, zones};
use crate::digits::{short, tuple};
use crate::error::OrRaise;
use crate::grid::Grid;
use crate::pickle::picklable;
use crate::readers::readers;
use crate::report::{Report, Warning, ending};
use crate::sequence::pair;

/// Traction, slip, zones, creepage and dissipation of steady rolling. Vectors are (x, y). Arrays are read-only views of
/// the memory of this object, except for the zones and the dissipation, which are read-only copies.
#[pyclass(frozen, eq, module = "stickslip.rolling")]
#[derive(PartialEq)]
pub(crate) struct RollingSolution(Arc<rolling::RollingSolution>);

impl From<Arc<rolling::RollingSolution>> for RollingSolution {
    fn from(solution: Arc<rolling::RollingSolution>) -> Self {
        Self(solution)
    }
}

readers! { RollingSolution.0:
    /// Grid of the fields.
    grid(): Grid => Grid,
    /// The creepages along x and y, prescribed or caused by the force (dimensionless).
    creepage(): (f64, f64) => pair,
    /// The spin, prescribed or caused by the moment (one over a length, positive from x to y).
    spin(): f64,
    /// Tangential force that body 2 exerts on body 1 along x and y.
    force(): (f64, f64) => pair,
    /// Moment about z, at the origin of the grid, on body 1 (a force times a length, positive from x to y).
    moment(): f64,
    /// Work of creepages and spin per unit length rolled (a force). The displacement of a particle due to the spin is
    /// evaluated at the midpoint of its path, and so is the moment in this work. Between bodies of the same material,
    /// all of the work is dissipated. Between bodies of different materials, the pressure also does work, which is not
    /// included.
    work(): f64,
    /// Ratio of stick cells to contact cells; zero without contact.
    stick_ratio(): f64,
    /// Termination, cost and error bound of the solve.
    report(): Report => Report::of,
    /// Warnings about a result that might mislead; empty if there are none.
    warnings(): Vec<Warning> => Warning::all,
}

#[pymethods]
impl RollingSolution {
    /// Traction on body 1 along x and y (pressures); zero outside the contact.
    #[getter]
    fn traction<'py>(slf: &Bound<'py, Self>) -> (Array<'py>, Array<'py>) {
        (
            view(slf, |solution| solution.0.traction()[0]),
            view(slf, |solution| solution.0.traction()[1]),
        )
    }

    /// Slip of the surface of body 1 over the surface of body 2 along x and y per unit length rolled (dimensionless),
    /// averaged over the step that brought the particles to the cell. It is opposite to the traction in slip cells and
    /// zero elsewhere.
    #[getter]
    fn slip<'py>(slf: &Bound<'py, Self>) -> (Array<'py>, Array<'py>) {
        (
            view(slf, |solution| solution.0.slip()[0]),
            view(slf, |solution| solution.0.slip()[1]),
        )
    }

    /// Zone of each cell, a uint8 array of shape (ny, nx) with the values of :class:`Zone`: 0 separated, 1 stick, 2 slip.
    ///
    /// The array also compares equal to the names of the zones; see :attr:`TangentialSolution.zones`.
    #[getter]
    fn zones<'py>(&self, py: Python<'py>) -> PyResult<Array<'py, u8>> {
        zones(py, self.0.grid(), self.0.zones())
    }

    /// Energy dissipated by slip in each cell per area and per length rolled (a pressure). The cells are fixed in the contact,
    /// and the particles of both surfaces pass through them. The value of a cell is therefore not the wear of a particle. In
    /// each passage, a particle loses the wear coefficient times the sum of the values over the cells of its line along the
    /// rolling direction, times their side along this line. Add this depth to whole lines of the gap. A wheel with the
    /// circumference U makes L/U passages over the length L. The laws of :mod:`stickslip.wear` reject this array, because they
    /// divide energies by the area of a cell. Between bodies of the same material, the integral of this energy is less than the
    /// work; the difference decreases with the cell size.
    #[getter]
    fn dissipation_per_area<'py>(&self, py: Python<'py>) -> PyResult<Array<'py>> {
        let dissipation = self.0.dissipation_per_area().or_raise(py)?;
        energies_per_area(py, &snapshot(py, &dissipation), dissipation.grid())
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

picklable!(RollingSolution: rolling::RollingSolution);
