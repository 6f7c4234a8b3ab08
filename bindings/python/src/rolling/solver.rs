//! Rolling contacts solved again and again.

use pyo3::prelude::*;
use stickslip::rolling;

use crate::conversion;
use crate::error::OrRaise;
use crate::friction::AnyFriction;
use crate::load;
use crate::normal::NormalSolver;
use crate::real::Real;
use crate::report::Report;
use crate::rolling::control::Keywords;
use crate::rolling::{CreepForces, RollingSolution};
use crate::solver::{Reused, solver};
use crate::tangential::pressure::Pressure;

/// Solves for one creepage, force or spin after the other, each from the last answer; made by
/// :meth:`RollingProblem.solver`.
#[pyclass(frozen, module = "stickslip.rolling")]
pub(crate) struct RollingSolver(Reused<rolling::RollingSolver>);

impl RollingSolver {
    pub(super) fn of(
        py: Python<'_>,
        grid: stickslip::Grid,
        solver: impl FnOnce() -> stickslip::Result<rolling::RollingSolver> + Send,
    ) -> PyResult<Self> {
        Reused::new(py, grid, solver).map(Self)
    }
}

solver!(rolling::RollingSolver as RollingSolver: rolling::RollingSolution as RollingSolution,
    rolling::RollingSolution::warnings);

#[pymethods]
impl RollingSolver {
    /// Solves, for these creepages, forces, spin or moment if any is given, else for the last ones.
    ///
    /// Parameters
    /// ----------
    /// creepage, creepage_x, creepage_y, force, force_x, force_y, spin, moment : optional
    ///     As of :class:`RollingProblem`: if one is given, those that are not are zero creepages and no spin.
    /// progress, warn : optional
    ///     As of :meth:`NormalProblem.solve`.
    ///
    /// Returns
    /// -------
    /// RollingSolution
    ///
    /// Raises
    /// ------
    /// NotFinite, UnsupportedByModel, BeyondFrictionCapacity, BeyondFrictionMoment
    ///     For what is prescribed, which is then as it was.
    /// NotConverged
    ///     With ``report`` and ``last_iterate``.
    #[pyo3(signature = (*, creepage=None, creepage_x=None, creepage_y=None, force=None, force_x=None, force_y=None,
        spin=None, moment=None, progress=None, warn=true))]
    fn solve<'py>(
        &self,
        py: Python<'py>,
        creepage: Option<conversion::Creepages>,
        creepage_x: Option<Real>,
        creepage_y: Option<Real>,
        force: Option<conversion::Force>,
        force_x: Option<Real>,
        force_y: Option<Real>,
        spin: Option<Real>,
        moment: Option<Real>,
        progress: Option<Bound<'py, PyAny>>,
        warn: bool,
    ) -> PyResult<Bound<'py, RollingSolution>> {
        let keywords = Keywords::new(
            (creepage, force),
            [creepage_x, creepage_y],
            [force_x, force_y],
            (spin, moment),
        )?;
        let set = |solver: &mut rolling::RollingSolver| {
            if keywords.is_empty() {
                return Ok(());
            }
            let outcome = solver.set_control(keywords.controls(), keywords.spin());
            outcome.or_raise(py)
        };
        self.0.solve(py, set, progress, warn)
    }

    /// Changes the friction of the next solve.
    fn set_friction(&self, py: Python<'_>, friction: AnyFriction<'_>) -> PyResult<()> {
        let friction = friction.on(py, self.0.grid())?;
        self.0.change(py, |solver| solver.set_friction(&friction))
    }

    /// Sets the pressure of the next solve. A field has no gap, so it needs a solver of ``entry_rule="whole_step"``.
    ///
    /// Raises
    /// ------
    /// UnsupportedByModel, GridMismatch, BoundaryMismatch, CellValueMismatch, MaterialMismatch, NotConverged, Sample, EmptyContact,
    /// GridTooShort, NotFinite, BeyondFrictionCapacity, BeyondFrictionMoment
    ///     The pressure is then unchanged.
    fn set_pressure(&self, py: Python<'_>, pressure: Pressure<'_>) -> PyResult<()> {
        let pressure = pressure.given(py, self.0.grid())?;
        self.0
            .change(py, |solver| solver.set_pressure(pressure.source()))
    }

    /// Sets the solver that finds the pressure of a new load; copied, with its gap, hardness and settings.
    fn set_normal_solver(&self, py: Python<'_>, solver: &NormalSolver) -> PyResult<()> {
        let normal = solver.copied()?;
        self.0.change(py, |solver| solver.set_normal_solver(normal))
    }

    /// Sets the normal load of the next solve, and solves for its pressure from the last one. Needs
    /// :meth:`set_normal_solver`.
    ///
    /// Parameters
    /// ----------
    /// force, approach : float, optional
    ///     One of the two, as of :class:`NormalProblem`.
    ///
    /// Raises
    /// ------
    /// UnsupportedByModel
    ///     Without a normal solver.
    /// NegativeOrNotFinite, NotFinite, NotConverged, EmptyContact, GridTooShort, BeyondFrictionCapacity, BeyondFrictionMoment
    ///     The solver is then unchanged.
    #[pyo3(signature = (*, force=None, approach=None))]
    fn set_load(
        &self,
        py: Python<'_>,
        force: Option<Real>,
        approach: Option<Real>,
    ) -> PyResult<()> {
        let load = load::needed(force, approach)?;
        self.0.change(py, |solver| solver.set_load(load))
    }

    /// Largest tangential force that friction holds: the integral of the friction limit.
    #[getter]
    fn friction_capacity(&self) -> PyResult<f64> {
        self.0.with(|solver| solver.friction_capacity())
    }

    /// How forces along x and y and moment (rows) change with the creepages along x and y and the spin (columns) about the
    /// last answer: forces, with the spin forces times lengths, in the row of the moment once more times a length. Cells
    /// that stick follow, cells that slip stay at their limits. Before the first solve all cells stick: these are Kalker's
    /// coefficients, times G a b and lengths.
    fn stiffness(&self, py: Python<'_>) -> PyResult<[[f64; 3]; 3]> {
        self.0.unobserved(py, rolling::RollingSolver::stiffness)
    }

    /// The loads at each of these points, each solved from the answer of the one before: a creep curve, or a creep surface
    /// row by row. The last point stays prescribed. All are checked before the first is solved, and Ctrl-C acts once the last
    /// is.
    ///
    /// Parameters
    /// ----------
    /// points : array_like of shape (n, 3)
    ///     Each ``(creepage_x, creepage_y, spin)`` (dimensionless, dimensionless, one over a length). Neighbours in the
    ///     order should be neighbours in the plane.
    ///
    /// Returns
    /// -------
    /// CreepForces
    ///     Of each point in turn, and arrays of all.
    ///
    /// Raises
    /// ------
    /// NotFinite, UnsupportedByModel
    ///     For any of the points; all is then as it was.
    /// NotConverged
    ///     At the first point that fails, which stays prescribed.
    fn creep_forces(
        &self,
        py: Python<'_>,
        points: conversion::CreepPoints,
    ) -> PyResult<CreepForces> {
        let found = self
            .0
            .unobserved(py, |solver| solver.creep_forces(points.0));
        found.map(CreepForces::from)
    }

    /// How the last solve ended.
    #[getter]
    fn report(&self) -> PyResult<Report> {
        self.0.with(|solver| Report::of(solver.report()))
    }
}
