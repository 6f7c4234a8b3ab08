//! Normal contact.

use std::sync::{Arc, Mutex};

use pyo3::exceptions::PyRuntimeError;
use pyo3::prelude::*;
use stickslip::{NormalControl, cgm};

use crate::array::{Array, copy, view};
use crate::choice::Choice;
use crate::error::{OrRaise, with_iterate};
use crate::field::Samples;
use crate::friction::AnyHardness;
use crate::grid::{Boundary, ElasticPair, Grid};
use crate::half_space::HalfSpace;
use crate::held::{Spare, lock, pair};
use crate::load;
use crate::pickle::{Reduced, Stored, reduced};
use crate::progress::Progress;
use crate::report::{Report, Warning, warn};
use crate::settings::{Settings, chosen};
use crate::spots::ContactSpots;
use crate::stiffness::NormalStiffness;
use crate::work::{solve, unobserved};

/// Whose memory a normal solution is.
#[derive(Clone)]
enum Source {
    Own(Arc<stickslip::NormalSolution>),
    OfCoupled(Arc<stickslip::CoupledSolution>),
    OfState(Arc<stickslip::history::State>),
}

/// Pressure, gap and approach of a normal contact. Arrays are read-only views of its memory.
#[pyclass(frozen, module = "stickslip")]
pub(crate) struct NormalSolution(Source);

impl NormalSolution {
    pub(crate) fn own(solution: Arc<stickslip::NormalSolution>) -> Self {
        Self(Source::Own(solution))
    }

    pub(crate) fn of_coupled(solution: &Arc<stickslip::CoupledSolution>) -> Self {
        Self(Source::OfCoupled(Arc::clone(solution)))
    }

    pub(crate) fn of_state(state: &Arc<stickslip::history::State>) -> Self {
        Self(Source::OfState(Arc::clone(state)))
    }

    pub(crate) fn get(&self) -> &stickslip::NormalSolution {
        match &self.0 {
            Source::Own(solution) => solution,
            Source::OfCoupled(solution) => solution.normal(),
            Source::OfState(state) => state.normal(),
        }
    }
}

impl Stored for NormalSolution {
    type Content = stickslip::NormalSolution;

    const KIND: &'static str = "NormalSolution";

    fn of_content(content: Self::Content) -> Self {
        Self::own(Arc::new(content))
    }
}

#[pymethods]
impl NormalSolution {
    /// The grid of its fields.
    #[getter]
    fn grid(&self) -> Grid {
        Grid(self.get().grid())
    }

    /// Pressure p >= 0, shape (ny, nx); exactly zero outside the contact.
    #[getter]
    fn pressure<'py>(slf: &Bound<'py, Self>) -> Array<'py> {
        view(slf, |solution| solution.get().pressure())
    }

    /// Gap under load (lengths), shape (ny, nx): zero in the contact up to the residual, negative where cells yield.
    #[getter]
    fn gap<'py>(slf: &Bound<'py, Self>) -> Array<'py> {
        view(slf, |solution| solution.get().gap())
    }

    /// Approach of the bodies from the datum of the initial gap (a length).
    #[getter]
    fn approach(&self) -> f64 {
        self.get().approach()
    }

    /// Normal force, the integral of the pressure.
    #[getter]
    fn force(&self) -> f64 {
        self.get().force()
    }

    /// Moments about x and y, at the origin, that the pressure exerts on body 1.
    #[getter]
    fn moments(&self) -> (f64, f64) {
        pair(self.get().moments())
    }

    /// Where the normal force acts (lengths); ``None`` without contact.
    #[getter]
    fn centre_of_pressure(&self) -> Option<(f64, f64)> {
        self.get().centre_of_pressure().map(pair)
    }

    /// Number of contact cells.
    #[getter]
    fn contact_cells(&self) -> usize {
        self.get().contact_cells()
    }

    /// Contact area by counting cells.
    #[getter]
    fn contact_area(&self) -> f64 {
        self.get().contact_area()
    }

    /// Contact area less the excess of counting along the perimeter.
    #[getter]
    fn contact_area_corrected(&self) -> f64 {
        self.get().contact_area_corrected()
    }

    /// Sides of the contact's bounding box along x and y (lengths); ``None`` without contact.
    #[getter]
    fn contact_extent(&self) -> Option<(f64, f64)> {
        self.get().contact_extent().map(pair)
    }

    /// Normal force over contact area; zero without contact.
    #[getter]
    fn mean_pressure(&self) -> f64 {
        self.get().mean_pressure()
    }

    /// Cells at their hardness.
    #[getter]
    fn yielded_cells(&self) -> usize {
        self.get().yielded_cells()
    }

    /// What lies beyond the edge of the grid.
    #[getter]
    fn boundary(&self) -> Boundary {
        Boundary(self.get().boundary())
    }

    /// The two bodies.
    #[getter]
    fn pair(&self) -> ElasticPair {
        ElasticPair(*self.get().pair())
    }

    /// How the solve ended, what it cost, how large its error can be.
    #[getter]
    fn report(&self) -> Report {
        Report::of(self.get().report())
    }

    /// Remarks that the result may mislead.
    #[getter]
    fn warnings(&self) -> Vec<Warning> {
        Warning::all(self.get().warnings())
    }

    /// The contact spots, one by one.
    #[getter]
    fn spots(&self) -> ContactSpots {
        ContactSpots::of(self.get().spots())
    }

    /// Normal displacement of all cells by the pressure (lengths), shape (ny, nx): one product.
    fn displacement<'py>(&self, py: Python<'py>, bodies: &HalfSpace) -> PyResult<Array<'py>> {
        let solution = self.get();
        let moved = unobserved(py, solution.grid().cells(), || {
            solution.displacement(&bodies.0)
        })?;
        Ok(copy(py, &moved))
    }

    /// Elastic energy of the normal contact: one product.
    fn elastic_energy(&self, py: Python<'_>, bodies: &HalfSpace) -> PyResult<f64> {
        let solution = self.get();
        unobserved(py, solution.grid().cells(), || {
            solution.elastic_energy(&bodies.0)
        })
    }

    /// The normal stiffness, the slope of the force by the approach: one solve on the contact cells.
    fn stiffness(&self, py: Python<'_>, bodies: &HalfSpace) -> PyResult<NormalStiffness> {
        let solution = self.get();
        let found = unobserved(py, solution.grid().cells(), || {
            solution.stiffness(&bodies.0)
        });
        found.map(NormalStiffness)
    }

    fn __eq__(&self, other: &Self) -> bool {
        self.get() == other.get()
    }

    fn __reduce__<'py>(&self, py: Python<'py>) -> PyResult<Reduced<'py>> {
        reduced::<Self>(py, self.get())
    }

    fn __repr__(&self) -> String {
        let solution = self.get();
        format!(
            "NormalSolution(force={:.6e}, approach={:.6e}, contact_cells={} of {}, {})",
            solution.force(),
            solution.approach(),
            solution.contact_cells(),
            solution.grid().cells(),
            solution.report().status
        )
    }
}

/// Bodies, gap and load of a normal contact.
///
/// Parameters
/// ----------
/// bodies : HalfSpace
/// gap : Field or array_like of shape (ny, nx)
///     The gap before loading (lengths). An array is copied, a Field is shared.
/// force, approach : float
///     One of the two: the normal force, or the approach of the bodies from the datum of the gap.
/// hardness : Hardness, float or array_like, optional
///     The largest pressure that the cells carry.
/// settings : Settings, optional
/// tolerance, method, max_iterations, time_limit : optional
///     As of :class:`Settings`; they take precedence over it.
///
/// Raises
/// ------
/// GridMismatch, Shape, Sample, Negative, NotFinite, Tolerance, IterationLimit, ApproachBeyondMeanGap, BeyondHardness
///
/// Examples
/// --------
/// >>> import stickslip
/// >>> grid = stickslip.Grid.square(64, 0.4e-3)
/// >>> steel = stickslip.Material(213e9, 0.29)
/// >>> bodies = stickslip.HalfSpace(grid, (steel, steel))
/// >>> ball = stickslip.surface.sphere(grid, 3.5e-3)
/// >>> contact = stickslip.NormalProblem(bodies, ball, force=100.0).solve()
/// >>> hertz = stickslip.analytical.HertzSphere(bodies.pair, 3.5e-3, 100.0)
/// >>> bool(abs(contact.pressure.max() / hertz.max_pressure - 1.0) < 2e-3)
/// True
#[pyclass(frozen, module = "stickslip")]
pub(crate) struct NormalProblem(stickslip::NormalProblem, Grid);

#[pymethods]
impl NormalProblem {
    #[new]
    #[pyo3(signature = (bodies, gap, *, force=None, approach=None, hardness=None, settings=None, tolerance=None,
        method=None, max_iterations=None, time_limit=None))]
    fn new(
        py: Python<'_>,
        bodies: &HalfSpace,
        gap: Samples<'_>,
        force: Option<f64>,
        approach: Option<f64>,
        hardness: Option<AnyHardness<'_>>,
        settings: Option<Settings>,
        tolerance: Option<f64>,
        method: Option<Choice<cgm::Method>>,
        max_iterations: Option<usize>,
        time_limit: Option<f64>,
    ) -> PyResult<Self> {
        let settings = chosen(settings, tolerance, method, max_iterations, time_limit)?;
        let grid = bodies.0.grid();
        let gap = gap.on(py, "gap", grid)?;
        let load = load::needed(force, approach)?;
        let hardness = hardness.map(|hardness| hardness.on(py, grid)).transpose()?;
        let built = unobserved(py, grid.cells(), || {
            let builder =
                stickslip::NormalProblem::builder(&bodies.0, gap, load).settings(settings);
            match hardness {
                None => builder.build(),
                Some(hardness) => builder.hardness(hardness).build(),
            }
        })?;
        Ok(Self(built, Grid(grid)))
    }

    /// Solves once.
    ///
    /// Parameters
    /// ----------
    /// progress : callable or bool, optional
    ///     Called with an :class:`Iteration` before each product; what it raises ends the solve. ``True`` shows a bar of
    ///     tqdm.
    /// warn : bool, default False
    ///     Whether the remarks of the solution go to ``warnings.warn`` too.
    ///
    /// Raises
    /// ------
    /// NotConverged
    ///     With ``report`` and ``last_iterate``.
    #[pyo3(signature = (*, progress=None, warn=false))]
    fn solve<'py>(
        &self,
        py: Python<'py>,
        progress: Option<Bound<'py, PyAny>>,
        warn: bool,
    ) -> PyResult<Bound<'py, NormalSolution>> {
        let progress = Progress::of(progress.as_ref())?;
        let cells = self.1.0.cells();
        let mut solution = None;
        let outcome = solve(py, cells, progress, |observer| {
            let mut solver = self.0.clone().into_solver()?;
            let solution = solution.insert(solver.new_solution());
            solver.solve_observed(solution, |iteration| observer(Some(iteration)))
        })?;
        finished(py, outcome, solution.map(Arc::new), warn)
    }

    /// The reusable form.
    fn solver(&self, py: Python<'_>) -> PyResult<NormalSolver> {
        let solver = unobserved(py, self.1.0.cells(), || self.0.clone().into_solver())?;
        Ok(NormalSolver::of(solver, self.1))
    }

    fn __repr__(&self) -> String {
        format!("NormalProblem({} x {} cells)", self.1.0.nx(), self.1.0.ny())
    }
}

/// The solution as an object, or the exception, which has the last iterate.
fn finished(
    py: Python<'_>,
    outcome: stickslip::Result<()>,
    solution: Option<Arc<stickslip::NormalSolution>>,
    is_warned: bool,
) -> PyResult<Bound<'_, NormalSolution>> {
    let object = || {
        let solution = solution.ok_or_else(|| PyRuntimeError::new_err("the solve left nothing"))?;
        Bound::new(py, NormalSolution::own(solution))
    };
    match outcome {
        Ok(()) => {
            let solution = object()?;
            warn(py, is_warned, || solution.get().get().warnings())?;
            Ok(solution)
        }
        Err(error) => Err(with_iterate(py, error, || object().map(Bound::into_any))),
    }
}

/// Solves normal contacts on one grid again and again, each time from the last answer. Takes what
/// :class:`NormalProblem` takes; load and gap may change between calls.
///
/// One thread at a time may use it. The memory of a solution that nobody holds any more is used again.
///
/// Examples
/// --------
/// >>> import stickslip
/// >>> grid = stickslip.Grid.square(32, 8.0)
/// >>> bodies = stickslip.HalfSpace(grid, (stickslip.Material(1.0, 0.3), stickslip.Material.rigid()))
/// >>> solver = stickslip.NormalSolver(bodies, stickslip.surface.sphere(grid, 10.0), force=0.5)
/// >>> [round(solver.solve(force=force).force, 12) for force in (0.5, 1.0, 0.7)]
/// [0.5, 1.0, 0.7]
#[pyclass(frozen, module = "stickslip")]
pub(crate) struct NormalSolver {
    work: Mutex<Work>,
    grid: Grid,
}

struct Work {
    solver: stickslip::NormalSolver,
    spare: Spare<stickslip::NormalSolution>,
}

impl NormalSolver {
    fn of(solver: stickslip::NormalSolver, grid: Grid) -> Self {
        let work = Work {
            solver,
            spare: Spare::new(),
        };
        Self {
            work: Mutex::new(work),
            grid,
        }
    }

    fn change(
        &self,
        py: Python<'_>,
        load: Option<NormalControl>,
        gap: Option<Samples<'_>>,
    ) -> PyResult<()> {
        let gap = gap.map(|gap| gap.on(py, "gap", self.grid.0)).transpose()?;
        let mut work = lock(&self.work, "solver")?;
        let solver = &mut work.solver;
        if let Some(gap) = gap {
            unobserved(py, self.grid.0.cells(), || solver.set_gap(&gap))?;
        }
        match load {
            Some(load) => solver.set_load(load).or_raise(py),
            None => Ok(()),
        }
    }
}

#[pymethods]
impl NormalSolver {
    #[new]
    #[pyo3(signature = (bodies, gap, *, force=None, approach=None, hardness=None, settings=None, tolerance=None,
        method=None, max_iterations=None, time_limit=None))]
    fn new(
        py: Python<'_>,
        bodies: &HalfSpace,
        gap: Samples<'_>,
        force: Option<f64>,
        approach: Option<f64>,
        hardness: Option<AnyHardness<'_>>,
        settings: Option<Settings>,
        tolerance: Option<f64>,
        method: Option<Choice<cgm::Method>>,
        max_iterations: Option<usize>,
        time_limit: Option<f64>,
    ) -> PyResult<Self> {
        let problem = NormalProblem::new(
            py,
            bodies,
            gap,
            force,
            approach,
            hardness,
            settings,
            tolerance,
            method,
            max_iterations,
            time_limit,
        )?;
        problem.solver(py)
    }

    /// Solves, for this load and gap if they are given, else for those of before.
    ///
    /// Parameters
    /// ----------
    /// force, approach : float, optional
    /// gap : Field or array_like of shape (ny, nx), optional
    ///     Copied.
    /// progress : callable or bool, optional
    /// warn : bool, default False
    #[pyo3(signature = (*, force=None, approach=None, gap=None, progress=None, warn=false))]
    fn solve<'py>(
        &self,
        py: Python<'py>,
        force: Option<f64>,
        approach: Option<f64>,
        gap: Option<Samples<'_>>,
        progress: Option<Bound<'py, PyAny>>,
        warn: bool,
    ) -> PyResult<Bound<'py, NormalSolution>> {
        let progress = Progress::of(progress.as_ref())?;
        self.change(py, load::normal(force, approach)?, gap)?;
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

    /// Changes the load of the next solve.
    #[pyo3(signature = (*, force=None, approach=None))]
    fn set_load(&self, py: Python<'_>, force: Option<f64>, approach: Option<f64>) -> PyResult<()> {
        self.change(py, Some(load::needed(force, approach)?), None)
    }

    /// Changes the gap of the next solve, as wear does.
    fn set_gap(&self, py: Python<'_>, gap: Samples<'_>) -> PyResult<()> {
        self.change(py, None, Some(gap))
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
            "NormalSolver({} x {} cells)",
            self.grid.0.nx(),
            self.grid.0.ny()
        )
    }
}
