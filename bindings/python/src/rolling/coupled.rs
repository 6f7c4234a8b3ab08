//! Rolling of dissimilar bodies, with pressure and traction coupled both ways.

use std::sync::{Arc, Mutex};

use pyo3::prelude::*;
use pyo3::types::{PyDict, PyTuple};
use stickslip::cgm;
use stickslip::history::EntryRule;
use stickslip::rolling::{self, LeadingEdge};

use crate::argument::Object;
use crate::array::{Array, snapshot};
use crate::choice::Choice;
use crate::conversion;
use crate::digits::{in_python, rough, short, tuple};
use crate::error::OrRaise;
use crate::field::Field;
use crate::friction::{AnyFriction, Friction};
use crate::grid::size;
use crate::half_space::HalfSpace;
use crate::load;
use crate::normal::NormalSolution;
use crate::pickle::{Recipe, picklable};
use crate::readers::{readers, record};
use crate::real::{Count, Real};
use crate::report::{Report, Warning, ending};
use crate::rolling::RollingSolution;
use crate::rolling::control::{Controls, Keywords};
use crate::samples::Samples;
use crate::settings::{Settings, chosen};
use crate::solution_pool::lock;
use crate::solver::{Reused, created_by, frictional, solve_once, solver};
use crate::unit::Unit;
use crate::work::{unobserved_on, watch};

/// Bodies, gap, friction and loads of steady rolling in which the tractions change the pressure.
///
/// The creepage is zero along an axis without a given creepage or force.
///
/// Parameters
/// ----------
/// bodies : HalfSpace
///     The two bodies and the grid.
/// gap : Field or array_like of shape (ny, nx)
///     The gap before loading (lengths). An array is copied, a Field is shared.
/// friction : Friction, float or array_like of shape (ny, nx)
///     Coulomb friction; a number or an array is the coefficient of friction (dimensionless, not negative).
/// normal_force, approach : float
///     Exactly one of the two: the normal force (not negative), or the approach of the bodies from the datum of the gap
///     (a length, positive when they move together).
/// creepage, creepage_x, creepage_y, force, force_x, force_y, spin, moment : optional
///     See :class:`RollingProblem`.
/// leading_edge, step, entry_rule, slip_corrections : optional
///     See :class:`RollingProblem`.
/// settings : Settings, optional
///     Method, tolerance and limits; ``Settings()`` by default.
/// tolerance, method, max_iterations, time_limit : optional
///     See :class:`Settings`; these arguments take precedence over ``settings``.
///
/// Raises
/// ------
/// GridMismatch, Shape, Sample, NegativeOrNotFinite, NotFinite, NotPositive, UnsupportedByModel, ApproachBeyondMeanGap, Tolerance,
/// IterationLimit, Method
///
/// Examples
/// --------
/// >>> import stickslip
/// >>> grid = stickslip.Grid.square(24, 3.0)
/// >>> bodies = stickslip.HalfSpace(grid, (stickslip.Material(1.0, 0.0), stickslip.Material.rigid()))
/// >>> ball = stickslip.surface.sphere(grid, 1.0)
/// >>> problem = stickslip.rolling.CoupledRollingProblem(bodies, ball, 0.3, normal_force=1.0, force_x=0.0)
/// >>> rolling = problem.solve()
/// >>> smooth = stickslip.NormalProblem(bodies, ball, force=1.0).solve()
/// >>> bool(rolling.normal.pressure.max() > smooth.pressure.max())  # the tractions raise the pressure
/// True
#[pyclass(frozen, module = "stickslip.rolling")]
pub(crate) struct CoupledRollingProblem {
    problem: rolling::CoupledRollingProblem,
    grid: stickslip::Grid,
    controls: Controls,
    /// Unit of the gap.
    unit: Option<Unit>,
    recipe: Recipe,
}

#[pymethods]
impl CoupledRollingProblem {
    #[new]
    #[pyo3(signature = (bodies, gap, friction, *positional, normal_force=None, approach=None, creepage=None, creepage_x=None,
        creepage_y=None, force=None, force_x=None, force_y=None, spin=None, moment=None, leading_edge=None, step=None,
        entry_rule=None, slip_corrections=None, settings=None, tolerance=None, method=None, max_iterations=None, time_limit=None),
        text_signature = "(bodies, gap, friction, *, normal_force=None, approach=None, creepage=None, creepage_x=None, \
            creepage_y=None, force=None, force_x=None, force_y=None, spin=None, moment=None, leading_edge=None, \
            step=None, entry_rule=None, slip_corrections=None, settings=None, tolerance=None, method=None, \
            max_iterations=None, time_limit=None)")]
    fn new(
        py: Python<'_>,
        bodies: Object<HalfSpace>,
        gap: Samples<'_>,
        friction: AnyFriction<'_>,
        positional: &Bound<'_, PyTuple>,
        normal_force: Option<Real>,
        approach: Option<Real>,
        creepage: Option<conversion::Creepages>,
        creepage_x: Option<Real>,
        creepage_y: Option<Real>,
        force: Option<conversion::Force>,
        force_x: Option<Real>,
        force_y: Option<Real>,
        spin: Option<Real>,
        moment: Option<Real>,
        leading_edge: Option<Choice<LeadingEdge>>,
        step: Option<Count>,
        entry_rule: Option<Choice<EntryRule>>,
        slip_corrections: Option<Count>,
        settings: Option<Settings>,
        tolerance: Option<Real>,
        method: Option<Choice<cgm::Method>>,
        max_iterations: Option<Count>,
        time_limit: Option<Real>,
    ) -> PyResult<Self> {
        load::by_keyword(
            "CoupledRollingProblem",
            positional,
            "normal_force= or approach=",
        )?;
        let settings = chosen(settings, tolerance, method, max_iterations, time_limit)?;
        let keywords = Keywords::new(
            (creepage, force),
            [creepage_x, creepage_y],
            [force_x, force_y],
            (spin, moment),
        )?;
        let normal = load::needed_as("normal_force", normal_force, approach)?;
        let grid = bodies.0.grid();
        let gap = gap.gap_before_friction(py, grid)?;
        let friction = friction.on(py, grid)?;
        let given = (bodies.clone(), gap.clone(), Friction(friction.clone()));
        let recipe = Recipe::new(py, given)?
            .with_normal(py, normal, "normal_force")?
            .with(py, "leading_edge", leading_edge)?
            .with(py, "step", step.map(|Count(cells)| cells))?
            .with(py, "entry_rule", entry_rule)?
            .with(
                py,
                "slip_corrections",
                slip_corrections.map(|Count(count)| count),
            )?
            .with(py, "settings", Some(Settings(settings)))?;
        let recipe = keywords.recorded(py, recipe)?;
        let Field(gap, unit) = gap;
        let built = unobserved_on(py, grid, || {
            let Controls {
                along: [x, y],
                spin,
            } = keywords.controls();
            let mut builder =
                rolling::CoupledRollingProblem::builder(&bodies.0, gap, friction, normal)
                    .control(stickslip::Axis::X, x)
                    .control(stickslip::Axis::Y, y)
                    .spin(spin)
                    .settings(settings);
            if let Some(edge) = leading_edge {
                builder = builder.leading_edge(edge.0);
            }
            if let Some(Count(cells)) = step {
                builder = builder.step(cells);
            }
            if let Some(rule) = entry_rule {
                builder = builder.entry_rule(rule.0);
            }
            if let Some(Count(corrections)) = slip_corrections {
                builder = builder.slip_corrections(corrections);
            }
            builder.build()
        })?;
        Ok(Self {
            problem: built,
            grid,
            controls: keywords.controls(),
            unit,
            recipe,
        })
    }

    /// Solves the problem once; see :meth:`NormalProblem.solve`.
    #[pyo3(signature = (*, progress=None, warn=true))]
    fn solve<'py>(
        &self,
        py: Python<'py>,
        progress: Option<Bound<'py, PyAny>>,
        #[pyo3(from_py_with = crate::real::flag)] warn: bool,
    ) -> PyResult<Bound<'py, CoupledRollingSolution>> {
        let solver = || self.problem.clone().into_solver();
        solve_once(py, self.grid.cells(), solver, progress, warn)
    }

    /// Returns a solver of this problem, which keeps its buffers and starts each solve from the last solution.
    fn solver(&self, py: Python<'_>) -> PyResult<CoupledRollingSolver> {
        let solver = || self.problem.clone().into_solver();
        let solver = Reused::new(py, self.grid, solver)?;
        let (controls, unit) = (Mutex::new(self.controls), Mutex::new(self.unit.clone()));
        Ok(CoupledRollingSolver(solver, controls, unit))
    }

    fn __getnewargs_ex__<'py>(
        &self,
        py: Python<'py>,
    ) -> PyResult<(Bound<'py, PyTuple>, Bound<'py, PyDict>)> {
        self.recipe.parts(py)
    }

    fn __repr__(&self) -> String {
        format!("CoupledRollingProblem({})", size(self.grid))
    }
}

/// Solves coupled rolling for successive loads, each time from the last solution; created by
/// :meth:`CoupledRollingProblem.solver`.
#[pyclass(frozen, module = "stickslip.rolling")]
pub(crate) struct CoupledRollingSolver(
    Reused<rolling::CoupledRollingSolver>,
    /// Controls of the next solve, which the solver of the crate does not return.
    Mutex<Controls>,
    /// Unit of the gap.
    Mutex<Option<Unit>>,
);

created_by! { CoupledRollingSolver: "CoupledRollingProblem(bodies, gap, friction, normal_force=..., creepage_x=...)" }
solver!(rolling::CoupledRollingSolver as CoupledRollingSolver:
    rolling::CoupledRollingSolution as CoupledRollingSolution, rolling::CoupledRollingSolution::warnings);
frictional!(CoupledRollingSolver);

#[pymethods]
impl CoupledRollingSolver {
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
    /// normal_force, approach : float, optional
    ///     One of them sets the normal load together with the other arguments.
    /// progress, warn : optional
    ///     See :meth:`NormalProblem.solve`.
    ///
    /// Returns
    /// -------
    /// CoupledRollingSolution
    ///
    /// Raises
    /// ------
    /// NotFinite, UnsupportedByModel
    ///     If the prescribed values are invalid; they are then unchanged.
    /// EmptyContact, GridTooShort, BeyondFrictionCapacity, BeyondFrictionMoment
    ///     If the contact cannot roll under these loads.
    /// NotConverged
    ///     The exception has the attributes ``report`` and ``last_iterate``.
    #[pyo3(signature = (*, creepage=None, creepage_x=None, creepage_y=None, force=None, force_x=None, force_y=None,
        spin=None, moment=None, normal_force=None, approach=None, progress=None, warn=true))]
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
        normal_force: Option<Real>,
        approach: Option<Real>,
        progress: Option<Bound<'py, PyAny>>,
        #[pyo3(from_py_with = crate::real::flag)] warn: bool,
    ) -> PyResult<Bound<'py, CoupledRollingSolution>> {
        let keywords = Keywords::new(
            (creepage, force),
            [creepage_x, creepage_y],
            [force_x, force_y],
            (spin, moment),
        )?;
        let has_normal = normal_force.is_some() || approach.is_some();
        let normal = || load::needed_as("normal_force", normal_force, approach);
        let normal = has_normal.then(normal).transpose()?;
        let mut last = lock(&self.1, "solver")?;
        let set = |solver: &mut rolling::CoupledRollingSolver| {
            let controls = keywords.after(*last);
            let outcome = match (normal, keywords.is_empty()) {
                (None, true) => Ok(()),
                (None, false) => solver.set_load(controls.along, controls.spin),
                (Some(normal), true) => solver.set_normal_load(normal),
                (Some(normal), false) => solver.set_loads(normal, controls.along, controls.spin),
            };
            outcome.or_raise(py)?;
            *last = controls;
            Ok(())
        };
        self.0.solve(py, set, progress, warn)
    }

    /// Sets the normal load of the next solve: a normal force (not negative) or an approach (a length). If friction cannot
    /// carry the prescribed forces under this normal force, the load is unchanged and
    /// :class:`~stickslip.errors.BeyondFrictionCapacity` is raised.
    #[pyo3(signature = (*, normal_force=None, approach=None))]
    fn set_normal_load(
        &self,
        py: Python<'_>,
        normal_force: Option<Real>,
        approach: Option<Real>,
    ) -> PyResult<()> {
        let normal = load::needed_as("normal_force", normal_force, approach)?;
        self.0
            .with(|solver| solver.set_normal_load(normal))?
            .or_raise(py)
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

    /// Returns the derivatives of the forces along x and y and the moment (rows) with respect to the creepages along x
    /// and y and the spin (columns) at the last solution. They include the change of the pressure with the tractions.
    ///
    /// Raises
    /// ------
    /// OutdatedSolution
    ///     If a load, the gap or the friction has changed since the last solve.
    /// NotConverged
    ///     Before the first solve, if it has not converged, or if the solve of a column does not converge.
    fn stiffness(&self, py: Python<'_>) -> PyResult<[[f64; 3]; 3]> {
        self.0.observed(py, |solver, observer| {
            solver.stiffness_observed(watch(observer))
        })
    }

    /// Report of the last solve.
    #[getter]
    fn report(&self) -> PyResult<CoupledRollingReport> {
        self.0
            .with(|solver| CoupledRollingReport(solver.report().clone()))
    }
}

/// Normal and rolling solution of coupled steady rolling.
#[pyclass(frozen, eq, module = "stickslip.rolling")]
#[derive(PartialEq)]
pub(crate) struct CoupledRollingSolution(Arc<rolling::CoupledRollingSolution>);

impl From<Arc<rolling::CoupledRollingSolution>> for CoupledRollingSolution {
    fn from(solution: Arc<rolling::CoupledRollingSolution>) -> Self {
        Self(solution)
    }
}

#[pymethods]
impl CoupledRollingSolution {
    /// The normal solution; a copy.
    #[getter]
    fn normal(&self) -> NormalSolution {
        Arc::new(self.0.normal().clone()).into()
    }

    /// The rolling solution; a copy.
    #[getter]
    fn rolling(&self) -> RollingSolution {
        Arc::new(self.0.rolling().clone()).into()
    }

    /// Report with termination, cost, number of passes and certified error bounds.
    #[getter]
    fn report(&self) -> CoupledRollingReport {
        CoupledRollingReport(self.0.report().clone())
    }

    /// Warnings about a result that might mislead; empty if there are none.
    #[getter]
    fn warnings(&self) -> Vec<Warning> {
        Warning::all(self.0.warnings())
    }

    fn __repr__(&self) -> String {
        let rolling = self.0.rolling();
        format!(
            "CoupledRollingSolution(normal_force={}, creepage={}, force={}, {})",
            short(self.0.normal().force()),
            tuple(&rolling.creepage()),
            tuple(&rolling.force()),
            ending(&self.0.report().work, &self.0.warnings())
        )
    }
}

picklable!(CoupledRollingSolution: rolling::CoupledRollingSolution);

/// Report of coupled rolling: termination, cost, number of passes and certified error bounds.
#[pyclass(frozen, eq, module = "stickslip.rolling")]
#[derive(Clone, PartialEq)]
pub(crate) struct CoupledRollingReport(rolling::CoupledRollingReport);

readers! { CoupledRollingReport.0:
    /// Number of passes: solves of the pressure, each followed by a solve of the tractions.
    passes: usize,
    /// Residual of the coupling: the lift within the contact added by the last pass, relative to the largest normal
    /// displacement.
    coupling_residual: f64,
    /// Relative change of the pressure in the last pass (ratio of root mean squares).
    pressure_change: f64,
    /// Bound on the relative error of the pressure in the energy norm, for the tractions of the solution.
    pressure_error_bound: f64,
    /// Bound on the relative error of the tractions, for the pressure of the solution.
    traction_error_bound: f64,
    /// Estimate of the relative error of the pressure of the coupled problem, if available.
    error_estimate: Option<f64>,
    /// Whether the tolerance was reached.
    is_converged(): bool,
}

#[pymethods]
impl CoupledRollingReport {
    /// Report of all passes: status, steps, products, and the largest residual of the normal and the tangential part.
    #[getter]
    fn work(&self) -> Report {
        Report::of(&self.0.work)
    }

    /// Report of the steps and products for the pressure.
    #[getter]
    fn normal(&self) -> Report {
        Report::of(&self.0.normal)
    }

    /// Report of the steps and products for the tractions.
    #[getter]
    fn rolling(&self) -> Report {
        Report::of(&self.0.rolling)
    }

    fn __repr__(&self, py: Python<'_>) -> PyResult<String> {
        Ok(format!(
            "CoupledRollingReport({}, {} passes, coupling residual {})",
            in_python(py, &self.0.work.to_string())?,
            self.0.passes,
            rough(self.0.coupling_residual)
        ))
    }
}

picklable!(CoupledRollingReport: rolling::CoupledRollingReport);

record!(CoupledRollingReport: is_converged, passes, coupling_residual, pressure_change, pressure_error_bound,
    traction_error_bound, error_estimate, work, normal, rolling);
