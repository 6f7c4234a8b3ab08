//! Reusable solvers of coupled contacts.

use std::sync::Mutex;

use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;

use crate::array::{Array, snapshot};
use crate::coupled::CoupledSolution;
use crate::error::OrRaise;
use crate::field::Samples;
use crate::friction::AnyFriction;
use crate::load::{self, TangentialArgument};
use crate::real::Real;
use crate::sensitivity::sensitive;
use crate::solution_pool::lock;
use crate::solver::{Reused, created_by, solver};

/// Solves coupled contacts repeatedly, each time from the last solution; created by :meth:`CoupledProblem.solver`.
#[pyclass(frozen, module = "stickslip")]
pub(crate) struct CoupledSolver(Reused<stickslip::CoupledSolver>, Mutex<Loads>);

/// Normal and tangential load of the next solve.
type Loads = (stickslip::NormalLoad, stickslip::TangentialLoad);

impl CoupledSolver {
    pub(super) fn of(
        py: Python<'_>,
        grid: stickslip::Grid,
        cap: Option<f64>,
        loads: Loads,
        solver: impl FnOnce() -> stickslip::Result<stickslip::CoupledSolver> + Send,
    ) -> PyResult<Self> {
        Reused::new(py, grid, cap, solver).map(|solver| Self(solver, Mutex::new(loads)))
    }
}

created_by! { CoupledSolver: "CoupledProblem(bodies, gap, friction, normal_force=..., force_x=...)" }
solver!(CoupledSolver: CoupledSolution);
sensitive!(CoupledSolver: CoupledSolution);

#[pymethods]
impl CoupledSolver {
    /// Solves for the current loads, gap and friction; see :meth:`NormalProblem.solve`. The method accepts no loads: set them by
    /// :meth:`set_loads`.
    #[pyo3(signature = (*, progress=None, warn=true))]
    fn solve<'py>(
        &self,
        py: Python<'py>,
        progress: Option<Bound<'py, PyAny>>,
        warn: bool,
    ) -> PyResult<Bound<'py, CoupledSolution>> {
        self.0.solve(py, |_| Ok(()), progress, warn)
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
    fn set_gap(&self, py: Python<'_>, gap: Samples<'_>) -> PyResult<()> {
        let gap = gap.per_cell(py, "gap", self.0.grid())?;
        self.0.change(py, |solver| solver.set_gap(&gap))
    }

    /// Sets the friction of the next solve. A law or a coefficient replaces the last law, with its ``max_shear_stress``. A coefficient
    /// alone has none; a warning is issued if the last law had one.
    fn set_friction(&self, py: Python<'_>, friction: AnyFriction<'_>) -> PyResult<()> {
        let set =
            |solver: &mut stickslip::CoupledSolver, friction: &_| solver.set_friction(friction);
        self.0.set_friction(py, friction, set)
    }
}
