//! Reusable solvers of tangential contacts.

use std::sync::Mutex;

use pyo3::prelude::*;

use crate::conversion;
use crate::error::OrRaise;
use crate::load::{TangentialArgument, TangentialLoad, keywords};
use crate::real::Real;
use crate::sensitivity::sensitive;
use crate::solution_pool::lock;
use crate::solver::{Reused, created_by, frictional, solver};
use crate::tangential::pressure::Pressure;
use crate::tangential::{RelativeDisplacement, TangentialSolution};
use crate::unit::{Unit, check_relative, of_next_gap};
use crate::work::unobserved_on;

/// Solves tangential contacts repeatedly, each time from the last solution; created by :meth:`TangentialProblem.solver`.
/// Load, friction and pressure may change between calls. Slip is not carried over from one solve to the next.
#[pyclass(frozen, module = "stickslip")]
pub(crate) struct TangentialSolver(
    Reused<stickslip::TangentialSolver>,
    /// Load of the next solve, which the solver of the crate does not return.
    Mutex<TangentialLoad>,
    Mutex<Units>,
);

/// Units of the lengths of a tangential contact. Lengths without a stated unit have none.
#[derive(Clone)]
pub(super) struct Units {
    pub(super) gap: Option<Unit>,
    pub(super) relative: Option<Unit>,
}

impl Units {
    /// Returns an error if both units differ.
    pub(super) fn check(&self) -> PyResult<()> {
        check_relative(
            "the gap of the normal solution",
            self.gap.as_ref(),
            self.relative.as_ref(),
        )
    }
}

impl TangentialSolver {
    pub(super) fn of(
        py: Python<'_>,
        grid: stickslip::Grid,
        load: TangentialLoad,
        units: Units,
        solver: impl FnOnce() -> stickslip::Result<stickslip::TangentialSolver> + Send,
    ) -> PyResult<Self> {
        let solver = Reused::new(py, grid, solver)?;
        Ok(Self(solver, Mutex::new(load), Mutex::new(units)))
    }
}

created_by! { TangentialSolver: "TangentialProblem(bodies, normal, friction, force_x=...)" }
solver!(TangentialSolver: TangentialSolution);
sensitive!(TangentialSolver: TangentialSolution);
frictional!(TangentialSolver);

#[pymethods]
impl TangentialSolver {
    /// Solves for the given load. Omitted arguments keep their last values.
    ///
    /// The arguments set the problem of the solver. They remain set if the solve fails or is cancelled; invalid arguments
    /// leave it unchanged.
    ///
    /// Parameters
    /// ----------
    /// load, force, shift, spring, force_x, ..., twist : optional
    ///     See :class:`TangentialProblem`. A force, shift or spring along an axis replaces the last one along that axis only, and a
    ///     twist replaces the last twist. A ``load`` replaces all of them.
    /// progress, warn : optional
    ///     See :meth:`NormalProblem.solve`.
    ///
    /// Returns
    /// -------
    /// TangentialSolution
    ///
    /// Raises
    /// ------
    /// NotFinite, NotPositive, ObliqueLoad, UnsupportedByModel, BeyondFrictionCapacity
    ///     If the load is invalid; it is then unchanged.
    /// NotConverged
    ///     The exception has the attributes ``report`` and ``last_iterate``.
    #[pyo3(signature = (load=None, *, force=None, shift=None, spring=None, force_x=None, force_y=None, shift_x=None,
        shift_y=None, spring_x=None, spring_y=None, twist=None, progress=None, warn=true))]
    fn solve<'py>(
        &self,
        py: Python<'py>,
        load: Option<TangentialArgument>,
        force: Option<conversion::Force>,
        shift: Option<conversion::Shift>,
        spring: Option<conversion::Springs>,
        force_x: Option<Real>,
        force_y: Option<Real>,
        shift_x: Option<Real>,
        shift_y: Option<Real>,
        spring_x: Option<conversion::Spring>,
        spring_y: Option<conversion::Spring>,
        twist: Option<Real>,
        progress: Option<Bound<'py, PyAny>>,
        #[pyo3(from_py_with = crate::real::flag)] warn: bool,
    ) -> PyResult<Bound<'py, TangentialSolution>> {
        let keywords = keywords![
            force, shift, spring, force_x, force_y, shift_x, shift_y, spring_x, spring_y, twist
        ];
        let is_new = load.is_some() || !keywords.is_empty();
        let mut last = lock(&self.1, "solver")?;
        let load = keywords.load_after(load, last.0)?;
        let set = |solver: &mut stickslip::TangentialSolver| {
            if is_new {
                unobserved_on(py, self.0.grid(), || solver.set_load(load))?;
                *last = TangentialLoad(load);
            }
            Ok(())
        };
        self.0.solve(py, set, progress, warn)
    }

    /// Sets the pressure of the next solve.
    ///
    /// Raises
    /// ------
    /// ValueError
    ///     If the unit of its gap differs from that of the earlier gaps or of the relative displacement.
    fn set_pressure(&self, py: Python<'_>, pressure: Pressure<'_>) -> PyResult<()> {
        let mut last = lock(&self.2, "solver")?;
        let units = Units {
            gap: of_next_gap(last.gap.as_ref(), pressure.unit_of_gap())?,
            relative: last.relative.clone(),
        };
        units.check()?;
        let pressure = pressure.given(py, self.0.grid())?;
        self.0
            .change(py, |solver| solver.set_pressure(pressure.source()))?;
        *last = units;
        Ok(())
    }

    /// Sets the relative displacement of the next solve.
    ///
    /// Raises
    /// ------
    /// GridMismatch
    /// ValueError
    ///     If its unit differs from that of the earlier relative displacements or of the gap of the normal solution.
    fn set_relative_displacement(
        &self,
        py: Python<'_>,
        relative: RelativeDisplacement,
    ) -> PyResult<()> {
        let mut last = lock(&self.2, "solver")?;
        check_relative("the last one", last.relative.as_ref(), relative.1.as_ref())?;
        let units = Units {
            gap: last.gap.clone(),
            relative: last.relative.clone().or(relative.1.clone()),
        };
        units.check()?;
        let changed = self
            .0
            .with(|solver| solver.set_relative_displacement(&relative.0))?;
        changed.or_raise(py)?;
        *last = units;
        Ok(())
    }

    /// Largest tangential force that friction can carry: the integral of the friction limit.
    #[getter]
    fn friction_capacity(&self) -> PyResult<f64> {
        self.0.with(|solver| solver.friction_capacity())
    }
}
