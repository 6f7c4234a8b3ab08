//! Normal contact problems.

use std::sync::Arc;

use pyo3::prelude::*;
use pyo3::types::{PyDict, PyTuple};
use stickslip::{NormalLoad, cgm};

use crate::argument::Object;
use crate::choice::Choice;
use crate::field::Field;
use crate::grid::size;
use crate::half_space::HalfSpace;
use crate::load;
use crate::normal::{AnyHardness, Hardness, NormalSolution, NormalSolver};
use crate::pickle::Recipe;
use crate::real::{Count, Real};
use crate::samples::Samples;
use crate::settings::{Settings, chosen};
use crate::solver::solve_once;
use crate::unit::set_in;
use crate::work::unobserved_on;

/// Bodies, gap and load of a normal contact.
///
/// Parameters
/// ----------
/// bodies : HalfSpace
///     The two bodies and the grid.
/// gap : Field or array_like of shape (ny, nx)
///     The gap before loading (lengths). An array is copied, a Field is shared.
/// force, approach : float
///     Exactly one of the two: the normal force (not negative), or the approach of the bodies from the datum of the gap
///     (a length, positive when they move together). On a grid that is periodic along x and y, the approach is the mean
///     initial gap minus the mean gap under load, and must be less than the mean initial gap.
/// hardness : Hardness, float or array_like of shape (ny, nx), optional
///     The largest pressure that the cells can carry; no limit by default.
/// settings : Settings, optional
///     Method, tolerance and limits; ``Settings()`` by default.
/// tolerance, method, max_iterations, time_limit : optional
///     See :class:`Settings`; these arguments take precedence over ``settings``.
///
/// Raises
/// ------
/// GridMismatch, Shape, Sample, NegativeOrNotFinite, NotFinite, Tolerance, IterationLimit, ApproachBeyondMeanGap, BeyondHardness
///
/// Examples
/// --------
/// >>> import stickslip
/// >>> grid = stickslip.Grid.square(64, 0.4e-3)
/// >>> steel = stickslip.Material(213e9, 0.29)
/// >>> bodies = stickslip.HalfSpace(grid, (steel, steel))
/// >>> ball = stickslip.surface.sphere(grid, 3.5e-3)
/// >>> contact = stickslip.NormalProblem(bodies, ball, force=100.0).solve()
/// >>> hertz = stickslip.analytical.HertzSphere(bodies.pair, radius=3.5e-3, load=100.0)
/// >>> bool(abs(contact.pressure.max() / hertz.max_pressure - 1.0) < 2e-3)
/// True
#[pyclass(frozen, module = "stickslip")]
pub(crate) struct NormalProblem {
    problem: stickslip::NormalProblem,
    load: NormalLoad,
    gap: Field,
    recipe: Recipe,
}

#[pymethods]
impl NormalProblem {
    #[new]
    #[pyo3(signature = (bodies, gap, *positional, force=None, approach=None, hardness=None, settings=None, tolerance=None,
        method=None, max_iterations=None, time_limit=None),
        text_signature = "(bodies, gap, *, force=None, approach=None, hardness=None, settings=None, tolerance=None, \
            method=None, max_iterations=None, time_limit=None)")]
    pub(super) fn new(
        py: Python<'_>,
        bodies: Object<HalfSpace>,
        gap: Samples<'_>,
        positional: &Bound<'_, PyTuple>,
        force: Option<Real>,
        approach: Option<Real>,
        hardness: Option<AnyHardness<'_>>,
        settings: Option<Settings>,
        tolerance: Option<Real>,
        method: Option<Choice<cgm::Method>>,
        max_iterations: Option<Count>,
        time_limit: Option<Real>,
    ) -> PyResult<Self> {
        load::by_keyword("NormalProblem", positional, "force= or approach=")?;
        let settings = chosen(settings, tolerance, method, max_iterations, time_limit)?;
        let grid = bodies.0.grid();
        let gap = gap.gap(py, grid)?;
        let load = load::needed(force, approach)?;
        let hardness = hardness.map(|hardness| hardness.on(py, grid)).transpose()?;
        let recipe = Recipe::new(py, (bodies.clone(), gap.clone()))?
            .with_normal(py, load, "force")?
            .with(py, "hardness", hardness.clone().map(Hardness))?
            .with(py, "settings", Some(Settings(settings)))?;
        let problem = unobserved_on(py, grid, || {
            let gap = Arc::clone(&gap.0);
            let builder = stickslip::NormalProblem::builder(&bodies.0, gap, load);
            let builder = builder.settings(settings);
            match hardness {
                None => builder.build(),
                Some(hardness) => builder.hardness(hardness).build(),
            }
        })?;
        Ok(Self {
            problem,
            load,
            gap,
            recipe,
        })
    }

    /// Solves the problem once.
    ///
    /// Parameters
    /// ----------
    /// progress : callable or bool, optional
    ///     A function that is called with an :class:`Iteration` before each product. If it returns ``False``, the solve is
    ///     cancelled and raises ``NotConverged``, whose report has the status "cancelled". All other results, such as ``None``,
    ///     continue the solve, and an exception in the function ends it. ``True`` shows a progress bar of tqdm.
    /// warn : bool, default True
    ///     Whether the warnings of the solution are also issued through ``warnings``, each kind once per location.
    ///
    /// Returns
    /// -------
    /// NormalSolution
    ///
    /// Raises
    /// ------
    /// NotConverged
    ///     The exception has the attributes ``report`` and ``last_iterate``.
    #[pyo3(signature = (*, progress=None, warn=true))]
    fn solve<'py>(
        &self,
        py: Python<'py>,
        progress: Option<Bound<'py, PyAny>>,
        #[pyo3(from_py_with = crate::real::flag)] warn: bool,
    ) -> PyResult<Bound<'py, NormalSolution>> {
        let solver = || self.problem.clone().into_solver();
        let outcome = solve_once(py, self.gap.0.grid().cells(), solver, progress, warn);
        set_in(outcome, py, self.gap.1.as_ref())
    }

    /// Returns a solver of this problem, which keeps its buffers and starts each solve from the last solution.
    pub(super) fn solver(&self, py: Python<'_>) -> PyResult<NormalSolver> {
        let solver = || self.problem.clone().into_solver();
        NormalSolver::of(py, solver, self.load, self.gap.clone())
    }

    fn __getnewargs_ex__<'py>(
        &self,
        py: Python<'py>,
    ) -> PyResult<(Bound<'py, PyTuple>, Bound<'py, PyDict>)> {
        self.recipe.parts(py)
    }

    fn __repr__(&self) -> String {
        format!("NormalProblem({})", size(self.gap.0.grid()))
    }
}
