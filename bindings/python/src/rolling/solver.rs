//! Reusable solvers of rolling contacts.

use std::sync::Mutex;

use pyo3::prelude::*;
use stickslip::rolling;

use crate::argument::Object;
use crate::conversion;
use crate::error::OrRaise;
use crate::load;
use crate::normal::NormalSolver;
use crate::progress::Progress;
use crate::real::Real;
use crate::report::{self, Report};
use crate::rolling::control::{Controls, Keywords};
use crate::rolling::{CreepForces, RollingSolution};
use crate::solution_pool::lock;
use crate::solver::{Reused, created_by, frictional, solver};
use crate::tangential::pressure::Pressure;
use crate::unit::{Unit, of_next_gap};
use crate::work::watch;

/// Solves for successive creepages, forces or spins, each time from the last solution; created by
/// :meth:`RollingProblem.solver`.
#[pyclass(frozen, module = "stickslip.rolling")]
pub(crate) struct RollingSolver(
    Reused<rolling::RollingSolver>,
    /// Controls of the next solve, which the solver of the crate does not return.
    Mutex<Controls>,
    /// Unit of the gaps of the normal contacts.
    Mutex<Option<Unit>>,
);

impl RollingSolver {
    pub(super) fn of(
        py: Python<'_>,
        grid: stickslip::Grid,
        controls: Controls,
        unit: Option<Unit>,
        solver: impl FnOnce() -> stickslip::Result<rolling::RollingSolver> + Send,
    ) -> PyResult<Self> {
        let solver = Reused::new(py, grid, solver)?;
        Ok(Self(solver, Mutex::new(controls), Mutex::new(unit)))
    }
}

created_by! { RollingSolver: "RollingProblem(bodies, normal, friction, creepage_x=...)" }
solver!(rolling::RollingSolver as RollingSolver: rolling::RollingSolution as RollingSolution,
    rolling::RollingSolution::warnings);
frictional!(RollingSolver);

#[pymethods]
impl RollingSolver {
    /// Solves for the given creepages, forces, spin or moment. Omitted arguments keep their last values.
    ///
    /// The arguments set the problem of the solver. They remain set if the solve fails or is cancelled; invalid arguments
    /// leave it unchanged.
    ///
    /// Parameters
    /// ----------
    /// creepage, creepage_x, creepage_y, force, force_x, force_y, spin, moment : optional
    ///     See :class:`RollingProblem`. A creepage or force along an axis replaces the last one along that axis only, and a
    ///     spin or moment replaces the last spin or moment.
    /// progress, warn : optional
    ///     See :meth:`NormalProblem.solve`.
    ///
    /// Returns
    /// -------
    /// RollingSolution
    ///
    /// Raises
    /// ------
    /// NotFinite, UnsupportedByModel, BeyondFrictionCapacity, BeyondFrictionMoment
    ///     If the prescribed values are invalid; they are then unchanged.
    /// NotConverged
    ///     The exception has the attributes ``report`` and ``last_iterate``.
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
        #[pyo3(from_py_with = crate::real::flag)] warn: bool,
    ) -> PyResult<Bound<'py, RollingSolution>> {
        let keywords = Keywords::new(
            (creepage, force),
            [creepage_x, creepage_y],
            [force_x, force_y],
            (spin, moment),
        )?;
        let mut last = lock(&self.1, "solver")?;
        let set = |solver: &mut rolling::RollingSolver| {
            if !keywords.is_empty() {
                let controls = keywords.after(*last);
                let outcome = solver.set_load(controls.along, controls.spin);
                outcome.or_raise(py)?;
                *last = controls;
            }
            Ok(())
        };
        self.0.solve(py, set, progress, warn)
    }

    /// Sets the pressure of the next solve. A field contains no gap and therefore requires a solver with
    /// ``entry_rule="whole_step"``.
    ///
    /// Raises
    /// ------
    /// UnsupportedByModel, GridMismatch, BoundaryMismatch, CellValueMismatch, MaterialMismatch, NotConverged, Sample, EmptyContact,
    /// GridTooShort, NotFinite, BeyondFrictionCapacity, BeyondFrictionMoment
    ///     The pressure is unchanged after an exception.
    /// ValueError
    ///     If the unit of its gap differs from that of the earlier gaps.
    fn set_pressure(&self, py: Python<'_>, pressure: Pressure<'_>) -> PyResult<()> {
        let mut last = lock(&self.2, "solver")?;
        let unit = of_next_gap(last.as_ref(), pressure.unit_of_gap())?;
        let pressure = pressure.given(py, self.0.grid())?;
        self.0
            .change(py, |solver| solver.set_pressure(pressure.source()))?;
        *last = unit;
        Ok(())
    }

    /// Sets the normal solver that computes the pressure for a new load. The solver is copied, with its gap, hardness and
    /// settings.
    ///
    /// This call does not change the pressure. :meth:`set_normal_load` solves for the pressure over the gap of ``solver``, which
    /// therefore need not have solved before. Its gap may differ from that of the present pressure, for example after wear.
    /// Grid, boundary, cell values and materials must be equal.
    ///
    /// Raises
    /// ------
    /// GridMismatch, BoundaryMismatch, CellValueMismatch, MaterialMismatch
    /// ValueError
    ///     If the unit of its gap differs from that of the earlier gaps.
    fn set_normal_solver(&self, py: Python<'_>, solver: Object<NormalSolver>) -> PyResult<()> {
        let mut last = lock(&self.2, "solver")?;
        let unit = of_next_gap(last.as_ref(), solver.unit_of_gap()?)?;
        let normal = solver.copied()?;
        self.0
            .change(py, |solver| solver.set_normal_solver(normal))?;
        *last = unit;
        Ok(())
    }

    /// Sets the normal load of the next solve, and computes the pressure starting from the last pressure. The normal
    /// solver must have been set by :meth:`set_normal_solver`.
    ///
    /// Parameters
    /// ----------
    /// normal_force, approach : float, optional
    ///     Exactly one of the two; see ``force`` and ``approach`` of :class:`NormalProblem`.
    ///
    /// Raises
    /// ------
    /// UnsupportedByModel
    ///     Without a normal solver.
    /// NegativeOrNotFinite, NotFinite, NotConverged, EmptyContact, GridTooShort, BeyondFrictionCapacity, BeyondFrictionMoment
    ///     The solver is unchanged after an exception.
    #[pyo3(signature = (*, normal_force=None, approach=None))]
    fn set_normal_load(
        &self,
        py: Python<'_>,
        normal_force: Option<Real>,
        approach: Option<Real>,
    ) -> PyResult<()> {
        let load = load::needed_as("normal_force", normal_force, approach)?;
        self.0.change(py, |solver| solver.set_normal_load(load))
    }

    /// Largest tangential force that friction can carry: the integral of the friction limit.
    #[getter]
    fn friction_capacity(&self) -> PyResult<f64> {
        self.0.with(|solver| solver.friction_capacity())
    }

    /// Returns the derivatives of the forces along x and y and the moment (rows) with respect to the creepages along x
    /// and y and the spin (columns) at the last solution. The entries are forces; the column of the spin and the row of
    /// the moment each add a factor of length. Stick cells follow the change and slip cells remain at their limits.
    /// Before the first solve, all cells stick, and the entries are Kalker's coefficients times G a b and powers of a
    /// length.
    ///
    /// Raises
    /// ------
    /// OutdatedSolution
    ///     If a load, the pressure or the friction has changed since the last solve.
    /// NotConverged
    ///     If the last solve has not converged, or if a column does not converge.
    fn stiffness(&self, py: Python<'_>) -> PyResult<[[f64; 3]; 3]> {
        self.0.observed(py, |solver, observer| {
            solver.stiffness_observed(watch(observer))
        })
    }

    /// Computes the loads at all points of a creep curve, or of a creep surface row by row. Each solve starts from the
    /// solution of the previous point. The last point remains prescribed. All points are checked before the first solve.
    /// After Ctrl-C, the point whose solve was ended remains prescribed.
    ///
    /// Any exception after the first solve has the attribute ``partial`` with the :class:`CreepForces` of the points solved
    /// before, also ``KeyboardInterrupt``.
    ///
    /// Parameters
    /// ----------
    /// points : array_like of shape (n, 3)
    ///     Points ``(creepage_x, creepage_y, spin)`` (dimensionless, dimensionless, one over a length). Consecutive
    ///     points should be close to each other. The columns of a table of pandas are recognised by these names.
    /// progress : callable or bool, optional
    ///     A function that is called with the :class:`CreepForce` of each solved point. It ends the call by returning
    ///     ``False``, as in :meth:`NormalProblem.solve`. ``True`` shows a progress bar of the points.
    /// warn : bool, default True
    ///     Whether the warnings of the points are also issued through ``warnings``. Each kind is issued once, for the last
    ///     point that has it.
    ///
    /// Returns
    /// -------
    /// CreepForces
    ///     The points with their loads, as a sequence and as arrays.
    ///
    /// Raises
    /// ------
    /// NotFinite, UnsupportedByModel
    ///     If any of the points is invalid; the solver is then unchanged.
    /// NotConverged
    ///     At the first point that fails or is cancelled, which remains prescribed.
    #[pyo3(signature = (points, *, progress=None, warn=true))]
    fn creep_forces<'py>(
        &self,
        py: Python<'py>,
        points: conversion::CreepPoints,
        progress: Option<Bound<'py, PyAny>>,
        #[pyo3(from_py_with = crate::real::flag)] warn: bool,
    ) -> PyResult<CreepForces> {
        let progress = Progress::of_points(progress.as_ref(), points.0.len())?;
        let mut last = lock(&self.1, "solver")?;
        let (mut found, mut is_started) = (Vec::new(), false);
        let prescribed = points.0.clone();
        let outcome = self.0.observed_in_stages(py, progress, |solver, observer| {
            let mut shown = 0;
            solver.creep_forces_into(points.0, &mut found, |_, solved| {
                is_started = true;
                let point = (solved.len() > shown).then(|| solved[shown]);
                shown = solved.len();
                observer(point.as_ref())
            })?;
            // All points are solved, so that the answer to the last point has no effect.
            let _ = found.last().map(|last| observer(Some(last)));
            Ok(())
        });
        // The point after the solved points, or the last point, remains prescribed.
        if let Some(&point) = prescribed
            .get(found.len())
            .or(prescribed.last())
            .filter(|_| is_started)
        {
            *last = Controls::creepage(point);
        }
        match outcome {
            Ok(()) => {
                report::warn(py, warn, || last_of_each_kind(&found))?;
                Ok(found.into())
            }
            Err(exception) => {
                let partial = Bound::new(py, CreepForces::from(found))?;
                exception.value(py).setattr("partial", partial)?;
                Err(exception)
            }
        }
    }

    /// Report of the last solve.
    #[getter]
    fn report(&self) -> PyResult<Report> {
        self.0.with(|solver| Report::of(solver.report()))
    }
}

/// Returns the warnings of the points of a creep curve, for each kind the warning of the last point that has it.
fn last_of_each_kind(points: &[rolling::CreepForce]) -> Vec<stickslip::Warning> {
    let mut last: Vec<stickslip::Warning> = Vec::new();
    for warning in points.iter().rev().flat_map(rolling::CreepForce::warnings) {
        let kind = std::mem::discriminant(&warning);
        if last
            .iter()
            .all(|other| std::mem::discriminant(other) != kind)
        {
            last.push(warning);
        }
    }
    last
}
