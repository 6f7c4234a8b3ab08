//! Creep curves and creep surfaces.

use pyo3::prelude::*;
use stickslip::rolling;

use crate::array::Array;
use crate::digits::{counted, short, tuple};
use crate::pickle::picklable;
use crate::readers::{frame, readers};
use crate::report::Warning;
use crate::sequence::{Entries, entry, pair};
use crate::work::Stage;

/// Point of a creep curve or a creep surface: creepages, spin and the resulting loads.
#[pyclass(frozen, eq, module = "stickslip.rolling")]
#[derive(Clone, Copy, PartialEq)]
pub(crate) struct CreepForce(rolling::CreepForce);

readers! { CreepForce.0:
    /// The creepages along x and y (dimensionless).
    creepage: (f64, f64) => pair,
    /// The spin (one over a length, positive from x to y).
    spin: f64,
    /// Tangential force on body 1 along x and y.
    force: (f64, f64) => pair,
    /// Moment on body 1 about the origin of the grid (a force times a length, positive from x to y).
    moment: f64,
    /// Ratio of stick cells to contact cells.
    stick_ratio: f64,
}

#[pymethods]
impl CreepForce {
    /// Warnings about a large creepage, a large coefficient of friction and a neglected lift. The warnings about the
    /// contact are those of a :class:`RollingSolution`.
    #[getter]
    fn warnings(&self) -> Vec<Warning> {
        Warning::all(self.0.warnings())
    }

    fn __repr__(&self) -> String {
        format!(
            "CreepForce(creepage={}, spin={}, force={})",
            tuple(&self.0.creepage),
            short(self.0.spin),
            tuple(&self.0.force)
        )
    }
}

picklable!(CreepForce: rolling::CreepForce);

impl Stage for rolling::CreepForce {
    fn object(self, py: Python<'_>) -> PyResult<Bound<'_, PyAny>> {
        Bound::new(py, CreepForce(self)).map(Bound::into_any)
    }
}

/// The points of a creep curve or a creep surface: a sequence of :class:`CreepForce`, and arrays with one number per
/// point, in their order. Vectors are (x, y).
#[pyclass(frozen, eq, module = "stickslip.rolling", sequence)]
#[derive(Clone, PartialEq)]
pub(crate) struct CreepForces(Vec<rolling::CreepForce>);

impl From<Vec<rolling::CreepForce>> for CreepForces {
    fn from(points: Vec<rolling::CreepForce>) -> Self {
        Self(points)
    }
}

impl CreepForces {
    fn numbers<'py>(
        &self,
        py: Python<'py>,
        of: impl Fn(&rolling::CreepForce) -> f64,
    ) -> Array<'py> {
        Array::new(py, self.0.iter().map(of))
    }
}

#[pymethods]
impl CreepForces {
    /// The creepages along x and y (dimensionless).
    #[getter]
    fn creepage<'py>(&self, py: Python<'py>) -> (Array<'py>, Array<'py>) {
        (
            self.numbers(py, |point| point.creepage[0]),
            self.numbers(py, |point| point.creepage[1]),
        )
    }

    /// The spin (one over a length, positive from x to y).
    #[getter]
    fn spin<'py>(&self, py: Python<'py>) -> Array<'py> {
        self.numbers(py, |point| point.spin)
    }

    /// Tangential force on body 1 along x and y.
    #[getter]
    fn force<'py>(&self, py: Python<'py>) -> (Array<'py>, Array<'py>) {
        (
            self.numbers(py, |point| point.force[0]),
            self.numbers(py, |point| point.force[1]),
        )
    }

    /// Moment on body 1 about the origin of the grid (a force times a length, positive from x to y).
    #[getter]
    fn moment<'py>(&self, py: Python<'py>) -> Array<'py> {
        self.numbers(py, |point| point.moment)
    }

    /// Ratio of stick cells to contact cells.
    #[getter]
    fn stick_ratio<'py>(&self, py: Python<'py>) -> Array<'py> {
        self.numbers(py, |point| point.stick_ratio)
    }

    fn __len__(&self) -> usize {
        self.0.len()
    }

    fn __iter__(&self) -> Entries<CreepForce> {
        Entries::of(&self.0, CreepForce)
    }

    fn __getitem__(&self, index: isize) -> PyResult<CreepForce> {
        entry(&self.0, index, "point").copied().map(CreepForce)
    }

    fn __repr__(&self) -> String {
        format!("CreepForces({})", counted(self.0.len(), "point"))
    }
}

picklable!(CreepForces: Vec<rolling::CreepForce>);

frame!(CreepForces, record: creepage, spin, force, moment, stick_ratio);
