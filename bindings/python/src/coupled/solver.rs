//! Reusable solvers of coupled contacts.

use std::sync::Mutex;

use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;

use crate::array::{Array, snapshot};
use crate::coupled::CoupledSolution;
use crate::error::OrRaise;
use crate::field::Field;
use crate::load::{self, TangentialArgument};
use crate::real::Real;
use crate::samples::Samples;
use crate::sensitivity::sensitive;
use crate::solution_pool::lock;
use crate::solver::{Reused, created_by, frictional, solver};
use crate::unit::{Unit, set_in};

/// Solves coupled contacts repeatedly, each time from the last solution; created by :meth:`CoupledProblem.solver`.
#[pyclass(frozen, module = "stickslip")]
pub(crate) struct CoupledSolver(
    Reused<stickslip::CoupledSolver>,
    Mutex<Loads>,
    /// Unit of the gap.
    Mutex<Option<Unit>>,
);

/// Normal and tangential load of the next solve.
pub(super) type Loads = (stickslip::NormalLoad, stickslip::TangentialLoad);

impl CoupledSolver {
    pub(super) fn of(
        py: Python<'_>,
        grid: stickslip::Grid,
        loads: Loads,
        unit: Option<Unit>,
        solver: impl FnOnce() -> stickslip::Result<stickslip::CoupledSolver> + Send,
    ) -> PyResult<Self> {
        let solver = Reused::new(py, grid, solver)?;
        Ok(Self(solver, Mutex::new(loads), Mutex::new(unit)))
    }
}

created_by! { CoupledSolver: "CoupledProblem(bodies, gap, friction, normal_force=..., force_x=...)" }
solver!(CoupledSolver: CoupledSolution);
sensitive!(CoupledSolver: CoupledSolution);
frictional!(CoupledSolver);

#[pymethods]
impl CoupledSolver {
    /// Solves for the current loads, gap and friction; see :meth:`NormalProblem.solve`. The method accepts no loads: set them by
    /// :meth:`set_loads`.
    #[pyo3(signature = (*, progress=None, warn=true))]
    fn solve<'py>(
        &self,
        py: Python<'py>,
        progress: Option<Bound<'py, PyAny>>,
        #[pyo3(from_py_with = crate::real::flag)] warn: bool,
    ) -> PyResult<Bound<'py, CoupledSolution>> {
        let unit = lock(&self.2, "solver")?;
        let outcome = self.0.solve(py, |_| Ok(()), progress, warn);
        set_in(outcome, py, unit.as_ref())
    }

    /// Sets the loads of the next solve: the tangential load, and either a normal force (not negative) or an approach (a
    /// length). An omitted load keeps its last value.
    #[pyo3(signature = (load=None, *, normal_force=None, approach=None))]
    fn set_loads(
        &self,
        py: Python<'_>,
        load: Option<TangentialArgument>,
        normal_force: Option<Real>,
        approach: Option<Real>,
    ) -> PyResult<()> {
        let normal = load::normal(normal_force, approach)?;
        if normal.is_none() && load.is_none() {
            return Err(PyTypeError::new_err(
                "give a tangential load by TangentialLoad(...), or the normal load by normal_force= or approach=",
            ));
        }
        let mut last = lock(&self.1, "solver")?;
        let loads = (
            normal.unwrap_or(last.0),
            load.map_or(last.1, |load| load.0.0),
        );
        self.0
            .with(|solver| solver.set_loads(loads.0, loads.1))?
            .or_raise(py)?;
        *last = loads;
        Ok(())
    }

    /// The gap before loading of the next solve (lengths), as last set; a read-only copy.
    #[getter]
    fn gap<'py>(&self, py: Python<'py>) -> PyResult<Array<'py>> {
        self.0.with(|solver| snapshot(py, solver.gap()))
    }

    /// Sets the gap of the next solve (lengths).
    ///
    /// Raises
    /// ------
    /// GapUnderLoad
    ///     If the gap is the gap of the last solution, which is the gap under load.
    /// ValueError
    ///     If the unit of the gap differs from that of the earlier gaps.
    fn set_gap(&self, py: Python<'_>, gap: Samples<'_>) -> PyResult<()> {
        let mut last = lock(&self.2, "solver")?;
        let Field(gap, unit) = gap.next_gap(py, self.0.grid(), last.as_ref())?;
        self.0.change(py, |solver| solver.set_gap(&gap))?;
        *last = unit;
        Ok(())
    }
}
