//! Tangential contacts solved again and again.

use pyo3::prelude::*;

use crate::conversion;
use crate::error::OrRaise;
use crate::friction::AnyFriction;
use crate::load::{Keywords, TangentialLoad};
use crate::real::Real;
use crate::solver::{Reused, solver};
use crate::tangential::pressure::Pressure;
use crate::tangential::{RelativeDisplacement, TangentialSolution};
use crate::work::unobserved_on;

/// Solves tangential contacts again and again, each time from the last answer; made by
/// :meth:`TangentialProblem.solver`. Load, friction and pressure may change between calls. It does not remember slip.
#[pyclass(frozen, module = "stickslip")]
pub(crate) struct TangentialSolver(Reused<stickslip::TangentialSolver>);

impl TangentialSolver {
    pub(super) fn of(
        py: Python<'_>,
        grid: stickslip::Grid,
        solver: impl FnOnce() -> stickslip::Result<stickslip::TangentialSolver> + Send,
    ) -> PyResult<Self> {
        Reused::new(py, grid, solver).map(Self)
    }
}

solver!(TangentialSolver: TangentialSolution);

#[pymethods]
impl TangentialSolver {
    /// Solves, for this load if one is given, else for the last one.
    ///
    /// Parameters
    /// ----------
    /// load, force, shift, spring, force_x, ... : optional
    ///     As of :class:`TangentialProblem`.
    /// progress, warn : optional
    ///     As of :meth:`NormalProblem.solve`.
    ///
    /// Returns
    /// -------
    /// TangentialSolution
    ///
    /// Raises
    /// ------
    /// NotFinite, NotPositive, ObliqueLoad, UnsupportedByModel, BeyondFrictionCapacity
    ///     For the load, which is then as it was.
    /// NotConverged
    ///     With ``report`` and ``last_iterate``.
    #[pyo3(signature = (load=None, *, force=None, shift=None, spring=None, force_x=None, force_y=None, shift_x=None,
        shift_y=None, spring_x=None, spring_y=None, twist=None, progress=None, warn=true))]
    fn solve<'py>(
        &self,
        py: Python<'py>,
        load: Option<TangentialLoad>,
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
        warn: bool,
    ) -> PyResult<Bound<'py, TangentialSolution>> {
        let keywords = Keywords::new(
            (force, shift, spring),
            [force_x, force_y],
            [shift_x, shift_y],
            [spring_x, spring_y],
            twist,
        );
        let is_new = load.is_some() || !keywords.is_empty();
        let load = keywords.load_or(load)?;
        let set = |solver: &mut stickslip::TangentialSolver| {
            if is_new {
                unobserved_on(py, self.0.grid(), || solver.set_load(load))?;
            }
            Ok(())
        };
        self.0.solve(py, set, progress, warn)
    }

    /// Changes the friction of the next solve.
    fn set_friction(&self, py: Python<'_>, friction: AnyFriction<'_>) -> PyResult<()> {
        let friction = friction.on(py, self.0.grid())?;
        self.0.change(py, |solver| solver.set_friction(&friction))
    }

    /// Changes the pressure of the next solve.
    fn set_pressure(&self, py: Python<'_>, pressure: Pressure<'_>) -> PyResult<()> {
        let pressure = pressure.given(py, self.0.grid())?;
        self.0
            .change(py, |solver| solver.set_pressure(pressure.source()))
    }

    /// Changes the relative displacement of the next solve.
    fn set_relative_displacement(
        &self,
        py: Python<'_>,
        relative: RelativeDisplacement,
    ) -> PyResult<()> {
        let changed = self
            .0
            .with(|solver| solver.set_relative_displacement(&relative.0))?;
        changed.or_raise(py)
    }

    /// Largest tangential force that friction holds: the integral of the friction limit.
    #[getter]
    fn friction_capacity(&self) -> PyResult<f64> {
        self.0.with(|solver| solver.friction_capacity())
    }
}
