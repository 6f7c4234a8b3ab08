//! Pressure and shear found together, of bodies of different materials.

use std::sync::{Arc, Mutex};

use pyo3::exceptions::PyRuntimeError;
use pyo3::prelude::*;
use stickslip::cgm;

use crate::array::{Array, view};
use crate::choice::Choice;
use crate::error::{OrRaise, with_iterate};
use crate::field::Samples;
use crate::friction::AnyFriction;
use crate::grid::Grid;
use crate::half_space::HalfSpace;
use crate::held::{Spare, lock, pair};
use crate::load::{self, Tangential, TangentialLoad};
use crate::normal::NormalSolution;
use crate::pickle::{Reduced, Stored, picklable, reduced};
use crate::progress::Progress;
use crate::report::{Report, Warning, warn};
use crate::settings::{Settings, chosen};
use crate::tangential::{RelativeDisplacement, TangentialSolution, whole_load};
use crate::work::{solve, unobserved};

/// Estimated errors of a coupled contact as a whole, each in its energy norm: not bounds.
#[pyclass(frozen, eq, module = "stickslip.coupled")]
#[derive(Clone, Copy, PartialEq)]
pub(crate) struct ErrorEstimate(stickslip::coupled::ErrorEstimate);

#[pymethods]
impl ErrorEstimate {
    /// Of the pressure.
    #[getter]
    fn pressure(&self) -> f64 {
        self.0.pressure
    }

    /// Of the traction.
    #[getter]
    fn traction(&self) -> f64 {
        self.0.traction
    }

    fn __repr__(&self) -> String {
        format!(
            "ErrorEstimate(pressure={:.1e}, traction={:.1e})",
            self.0.pressure, self.0.traction
        )
    }
}

/// How a coupled solve ended, what it cost, and what its halves certify.
#[pyclass(frozen, eq, module = "stickslip.coupled")]
#[derive(Clone, PartialEq)]
pub(crate) struct CoupledReport(stickslip::coupled::CoupledReport);

#[pymethods]
impl CoupledReport {
    /// Why the iteration ended, products with the whole tensor, residual and time.
    #[getter]
    fn work(&self) -> Report {
        Report::of(&self.0.work)
    }

    /// Steps and products with the normal part alone.
    #[getter]
    fn normal(&self) -> Report {
        Report::of(&self.0.normal)
    }

    /// Steps and products with the tangential part alone.
    #[getter]
    fn tangential(&self) -> Report {
        Report::of(&self.0.tangential)
    }

    /// Bound of the error of the pressure at the tractions as they are.
    #[getter]
    fn pressure_error_bound(&self) -> f64 {
        self.0.pressure_error_bound
    }

    /// Bound of the error of the tractions at the pressure as it is.
    #[getter]
    fn traction_error_bound(&self) -> f64 {
        self.0.traction_error_bound
    }

    /// Bounds of the errors of pressure and traction as a whole, where friction is weak enough for them.
    #[getter]
    fn error_bounds(&self) -> Option<(f64, f64)> {
        self.0.error_bounds.map(pair)
    }

    /// What the errors of the whole are likely to be.
    #[getter]
    fn error_estimate(&self) -> Option<ErrorEstimate> {
        self.0.error_estimate.map(ErrorEstimate)
    }

    /// Whether the tolerance was reached.
    #[getter]
    fn is_converged(&self) -> bool {
        self.0.is_converged()
    }

    fn __repr__(&self) -> String {
        format!(
            "CoupledReport({}, pressure error <= {:.1e}, traction error <= {:.1e} as halves)",
            self.0.work, self.0.pressure_error_bound, self.0.traction_error_bound
        )
    }
}

picklable!(CoupledReport: stickslip::coupled::CoupledReport);

/// Both halves of a coupled contact, with the displacements that they cause together. Halves and arrays share its memory.
#[pyclass(frozen, module = "stickslip")]
pub(crate) struct CoupledSolution(pub(crate) Arc<stickslip::CoupledSolution>);

impl Stored for CoupledSolution {
    type Content = stickslip::CoupledSolution;

    const KIND: &'static str = "CoupledSolution";

    fn of_content(content: Self::Content) -> Self {
        Self(Arc::new(content))
    }
}

#[pymethods]
impl CoupledSolution {
    /// The normal half.
    #[getter]
    fn normal(&self) -> NormalSolution {
        NormalSolution::of_coupled(&self.0)
    }

    /// The tangential half.
    #[getter]
    fn shear(&self) -> TangentialSolution {
        TangentialSolution::of_coupled(&self.0)
    }

    /// Displacements of all cells along x, y and z (lengths).
    #[getter]
    fn displacement<'py>(slf: &Bound<'py, Self>) -> (Array<'py>, Array<'py>, Array<'py>) {
        (
            view(slf, |solution| solution.0.displacement()[0]),
            view(slf, |solution| solution.0.displacement()[1]),
            view(slf, |solution| solution.0.displacement()[2]),
        )
    }

    /// Elastic energy of both bodies.
    #[getter]
    fn elastic_energy(&self) -> f64 {
        self.0.elastic_energy()
    }

    /// How the solve ended, what it cost, and what is certified.
    #[getter]
    fn report(&self) -> CoupledReport {
        CoupledReport(self.0.report().clone())
    }

    /// Remarks that the result may mislead.
    #[getter]
    fn warnings(&self) -> Vec<Warning> {
        Warning::all(self.0.warnings())
    }

    fn __reduce__<'py>(&self, py: Python<'py>) -> PyResult<Reduced<'py>> {
        reduced::<Self>(py, &self.0)
    }

    fn __repr__(&self) -> String {
        let (normal, [x, y]) = (self.0.normal(), self.0.shear().force());
        format!(
            "CoupledSolution(normal_force={:.6e}, force=({x:.6e}, {y:.6e}), stick_ratio={:.4}, {})",
            normal.force(),
            self.0.shear().stick_ratio(),
            self.0.report().work.status
        )
    }
}

/// Bodies, gap, friction and loads of a contact whose pressure and shear are found together: from rest, in one step.
///
/// Parameters
/// ----------
/// bodies : HalfSpace
/// gap : Field or array_like of shape (ny, nx)
///     Copied.
/// friction : Friction, float or array_like of shape (ny, nx)
/// load : TangentialLoad, optional
///     Instead of the keywords that it has too.
/// normal_force, approach : float
///     One of the two.
/// relative_displacement : RelativeDisplacement, optional
/// settings, tolerance, method, max_iterations, time_limit : optional
///     As of :class:`Settings`.
///
/// Examples
/// --------
/// >>> import stickslip
/// >>> grid = stickslip.Grid.square(32, 0.3)
/// >>> pair = (stickslip.Material(70e3, 0.33), stickslip.Material(210e3, 0.3))
/// >>> bodies = stickslip.HalfSpace(grid, pair)
/// >>> ball = stickslip.surface.sphere(grid, 3.5)
/// >>> contact = stickslip.CoupledProblem(bodies, ball, 0.1, normal_force=60.0).solve()
/// >>> contact.shear.slip_area > 0.0  # pressing alone makes the rim slip
/// True
#[pyclass(frozen, module = "stickslip")]
pub(crate) struct CoupledProblem(stickslip::CoupledProblem, Grid);

#[pymethods]
impl CoupledProblem {
    #[new]
    #[pyo3(signature = (bodies, gap, friction, load=None, *, normal_force=None, approach=None, force=None, shift=None,
        spring=None, force_x=None, force_y=None, shift_x=None, shift_y=None, spring_x=None, spring_y=None, twist=None,
        relative_displacement=None, settings=None, tolerance=None, method=None, max_iterations=None, time_limit=None))]
    fn new(
        py: Python<'_>,
        bodies: &HalfSpace,
        gap: Samples<'_>,
        friction: AnyFriction<'_>,
        load: Option<TangentialLoad>,
        normal_force: Option<f64>,
        approach: Option<f64>,
        force: Option<[f64; 2]>,
        shift: Option<[f64; 2]>,
        spring: Option<([f64; 2], f64)>,
        force_x: Option<f64>,
        force_y: Option<f64>,
        shift_x: Option<f64>,
        shift_y: Option<f64>,
        spring_x: Option<(f64, f64)>,
        spring_y: Option<(f64, f64)>,
        twist: Option<f64>,
        relative_displacement: Option<RelativeDisplacement>,
        settings: Option<Settings>,
        tolerance: Option<f64>,
        method: Option<Choice<cgm::Method>>,
        max_iterations: Option<usize>,
        time_limit: Option<f64>,
    ) -> PyResult<Self> {
        let settings = chosen(settings, tolerance, method, max_iterations, time_limit)?;
        let given = Tangential {
            force,
            shift,
            spring,
            force_x,
            force_y,
            shift_x,
            shift_y,
            spring_x,
            spring_y,
        };
        let (normal, load) = (
            load::needed(normal_force, approach)?,
            whole_load(load, &given, twist)?,
        );
        let grid = bodies.0.grid();
        let gap = gap.on(py, "gap", grid)?;
        let friction = friction.on(py, grid)?;
        let built = unobserved(py, grid.cells(), || {
            let builder =
                stickslip::CoupledProblem::builder(&bodies.0, &gap, friction, normal, load);
            let builder = builder.settings(settings);
            match relative_displacement {
                None => builder.build(),
                Some(relative) => builder.relative_displacement(relative.0).build(),
            }
        })?;
        Ok(Self(built, Grid(grid)))
    }

    /// Solves from rest; see :meth:`NormalProblem.solve`.
    #[pyo3(signature = (*, progress=None, warn=false))]
    fn solve<'py>(
        &self,
        py: Python<'py>,
        progress: Option<Bound<'py, PyAny>>,
        warn: bool,
    ) -> PyResult<Bound<'py, CoupledSolution>> {
        let progress = Progress::of(progress.as_ref())?;
        let mut solution = None;
        let outcome = solve(py, self.1.0.cells(), progress, |observer| {
            let mut solver = self.0.clone().into_solver()?;
            let solution = solution.insert(solver.new_solution());
            solver.solve_observed(solution, |iteration| observer(Some(iteration)))
        })?;
        finished(py, outcome, solution.map(Arc::new), warn)
    }

    /// The reusable form.
    fn solver(&self, py: Python<'_>) -> PyResult<CoupledSolver> {
        let solver = unobserved(py, self.1.0.cells(), || self.0.clone().into_solver())?;
        let work = Work {
            solver,
            spare: Spare::new(),
        };
        Ok(CoupledSolver {
            work: Mutex::new(work),
            grid: self.1,
        })
    }

    fn __repr__(&self) -> String {
        format!(
            "CoupledProblem({} x {} cells)",
            self.1.0.nx(),
            self.1.0.ny()
        )
    }
}

fn finished(
    py: Python<'_>,
    outcome: stickslip::Result<()>,
    solution: Option<Arc<stickslip::CoupledSolution>>,
    is_warned: bool,
) -> PyResult<Bound<'_, CoupledSolution>> {
    let object = || {
        let solution = solution.ok_or_else(|| PyRuntimeError::new_err("the solve left nothing"))?;
        Bound::new(py, CoupledSolution(solution))
    };
    match outcome {
        Ok(()) => {
            let solution = object()?;
            warn(py, is_warned, || solution.get().0.warnings())?;
            Ok(solution)
        }
        Err(error) => Err(with_iterate(py, error, || object().map(Bound::into_any))),
    }
}

/// Solves coupled contacts again and again, each from the last answer; made by :meth:`CoupledProblem.solver`.
#[pyclass(frozen, module = "stickslip")]
pub(crate) struct CoupledSolver {
    work: Mutex<Work>,
    grid: Grid,
}

struct Work {
    solver: stickslip::CoupledSolver,
    spare: Spare<stickslip::CoupledSolution>,
}

#[pymethods]
impl CoupledSolver {
    /// Solves for the loads and the gap set.
    #[pyo3(signature = (*, progress=None, warn=false))]
    fn solve<'py>(
        &self,
        py: Python<'py>,
        progress: Option<Bound<'py, PyAny>>,
        warn: bool,
    ) -> PyResult<Bound<'py, CoupledSolution>> {
        let progress = Progress::of(progress.as_ref())?;
        let mut work = lock(&self.work, "solver")?;
        let Work { solver, spare } = &mut *work;
        let mut solution = spare.take(|| solver.new_solution());
        let into = Arc::get_mut(&mut solution);
        let into = into.ok_or_else(|| PyRuntimeError::new_err("the solution is held"))?;
        let outcome = solve(py, self.grid.0.cells(), progress, |observer| {
            solver.solve_observed(into, |iteration| observer(Some(iteration)))
        })?;
        spare.keep(&solution);
        finished(py, outcome, Some(solution), warn)
    }

    /// Changes the normal load of the next solve.
    #[pyo3(signature = (*, force=None, approach=None))]
    fn set_normal(
        &self,
        py: Python<'_>,
        force: Option<f64>,
        approach: Option<f64>,
    ) -> PyResult<()> {
        let normal = load::needed(force, approach)?;
        lock(&self.work, "solver")?
            .solver
            .set_normal(normal)
            .or_raise(py)
    }

    /// Changes the tangential load of the next solve.
    fn set_load(&self, py: Python<'_>, load: TangentialLoad) -> PyResult<()> {
        lock(&self.work, "solver")?
            .solver
            .set_load(load.0)
            .or_raise(py)
    }

    /// Changes the gap of the next solve.
    fn set_gap(&self, py: Python<'_>, gap: Samples<'_>) -> PyResult<()> {
        let gap = gap.on(py, "gap", self.grid.0)?;
        let mut work = lock(&self.work, "solver")?;
        let solver = &mut work.solver;
        unobserved(py, self.grid.0.cells(), || solver.set_gap(&gap))
    }

    /// Changes the friction of the next solve.
    fn set_friction(&self, py: Python<'_>, friction: AnyFriction<'_>) -> PyResult<()> {
        let friction = friction.on(py, self.grid.0)?;
        lock(&self.work, "solver")?
            .solver
            .set_friction(&friction)
            .or_raise(py)
    }

    /// The settings of the next solve; may be assigned.
    #[getter]
    fn settings(&self) -> PyResult<Settings> {
        Ok(Settings(*lock(&self.work, "solver")?.solver.settings()))
    }

    #[setter]
    fn set_settings(&self, py: Python<'_>, settings: Settings) -> PyResult<()> {
        let mut work = lock(&self.work, "solver")?;
        work.solver.set_settings(settings.0).or_raise(py)
    }

    /// Forgets the last answer.
    fn reset(&self) -> PyResult<()> {
        lock(&self.work, "solver")?.solver.reset();
        Ok(())
    }

    fn __repr__(&self) -> String {
        format!(
            "CoupledSolver({} x {} cells)",
            self.grid.0.nx(),
            self.grid.0.ny()
        )
    }
}
