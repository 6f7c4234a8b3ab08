//! Rolling contact problems.

use pyo3::prelude::*;
use pyo3::types::{PyDict, PyTuple};
use stickslip::cgm;
use stickslip::history::EntryRule;
use stickslip::rolling::{self, LeadingEdge};

use crate::argument::Object;
use crate::choice::Choice;
use crate::conversion;
use crate::friction::{AnyFriction, Friction};
use crate::grid::size;
use crate::half_space::HalfSpace;
use crate::load;
use crate::normal::NormalSolution;
use crate::pickle::Recipe;
use crate::real::{Count, Real};
use crate::rolling::control::{Controls, Keywords};
use crate::rolling::{RollingSolution, RollingSolver};
use crate::settings::{Settings, chosen};
use crate::solver::solve_sheared;
use crate::unit::Unit;
use crate::work::unobserved_on;

/// Bodies, normal contact, friction and controls of steady rolling.
///
/// At least one creepage, force, spin or moment is required. The creepage is zero along an axis without a given creepage or
/// force.
///
/// Parameters
/// ----------
/// bodies : HalfSpace
///     The two bodies and the grid.
/// normal : NormalSolution
///     A solved normal contact of these bodies.
/// friction : Friction, float or array_like of shape (ny, nx)
///     Coulomb friction; a number or an array is the coefficient of friction (dimensionless, not negative).
/// creepage, creepage_x, creepage_y : pair of float, float, optional
///     The creepages, the motion of body 2 over body 1 per unit length rolled (dimensionless). A positive creepage
///     causes a positive force. Kalker and CONTACT define creepage and spin as motions of body 1 over body 2, with
///     the opposite sign.
/// force, force_x, force_y : pair of float, float, optional
///     The tangential force that body 2 exerts on body 1, less than the friction capacity; the creepage follows from it.
/// spin : float, default 0
///     Rotation of body 2 relative to body 1 about the origin of the grid per unit length rolled (one over a length,
///     positive from x to y).
/// moment : float, optional
///     The moment on body 1 about the origin of the grid (a force times a length, positive from x to y), less than the
///     friction capacity. It replaces the spin, which follows from it.
/// leading_edge : LeadingEdge or str, default "plus_x"
///     The edge where particles enter the contact.
/// step : int, default 1
///     Number of cells that a particle passes in a step. Longer steps cost less and are less accurate. The grid
///     must extend by this number of cells ahead of the contact; otherwise the problem raises
///     :class:`~stickslip.errors.GridTooShort`. The entry rule needs the slope of the gap two cells further ahead. If
///     the grid ends before, this slope is one-sided.
/// entry_rule : EntryRule or str, default "since_touch"
///     Rule for the motion of cells that enter the contact; "whole_step", the rule of CONTACT, is less accurate.
/// slip_corrections : int, default 0
///     Number of corrections of the direction of slip. Two corrections raise the order of convergence of the forces
///     under spin from 1 to between 1.5 and 2.
/// settings : Settings, optional
///     Method, tolerance and limits; ``Settings()`` by default.
/// tolerance, method, max_iterations, time_limit : optional
///     See :class:`Settings`; these arguments take precedence over ``settings``.
///
/// Raises
/// ------
/// NotConverged, GridMismatch, BoundaryMismatch, CellValueMismatch, MaterialMismatch, EmptyContact, NotFinite, NotPositive,
/// UnsupportedByModel, GridTooShort, BeyondFrictionCapacity, BeyondFrictionMoment, Tolerance, IterationLimit, Method
///
/// Examples
/// --------
/// >>> import stickslip
/// >>> grid = stickslip.Grid.square(24, 3.0)
/// >>> body = stickslip.Material.from_shear_modulus(1.0, 0.25)
/// >>> bodies = stickslip.HalfSpace(grid, (body, body))
/// >>> ball = stickslip.surface.sphere(grid, 1.0)
/// >>> normal = stickslip.NormalProblem(bodies, ball, force=1.0).solve()
/// >>> rolling = stickslip.rolling.RollingProblem(bodies, normal, 0.3, creepage_x=1e-5).solve()
/// >>> a = stickslip.analytical.HertzSphere(bodies.pair, radius=1.0, load=1.0).contact_radius
/// >>> abs(rolling.force[0] / (a * a * 1e-5) / 4.12 - 1.0) < 0.02  # Kalker's coefficient C11
/// True
#[pyclass(frozen, module = "stickslip.rolling")]
pub(crate) struct RollingProblem {
    problem: rolling::RollingProblem,
    grid: stickslip::Grid,
    controls: Controls,
    recipe: Recipe,
    /// Unit of the gap of the normal solution.
    unit: Option<Unit>,
}

#[pymethods]
impl RollingProblem {
    #[new]
    #[pyo3(signature = (bodies, normal, friction, *positional, creepage=None, creepage_x=None, creepage_y=None, force=None,
        force_x=None, force_y=None, spin=None, moment=None, leading_edge=None, step=None, entry_rule=None, slip_corrections=None, settings=None,
        tolerance=None, method=None, max_iterations=None, time_limit=None),
        text_signature = "(bodies, normal, friction, *, creepage=None, creepage_x=None, creepage_y=None, force=None, \
            force_x=None, force_y=None, spin=None, moment=None, leading_edge=None, step=None, entry_rule=None, \
            slip_corrections=None, settings=None, tolerance=None, method=None, max_iterations=None, \
            time_limit=None)")]
    fn new(
        py: Python<'_>,
        bodies: Object<HalfSpace>,
        normal: Object<NormalSolution>,
        friction: AnyFriction<'_>,
        positional: &Bound<'_, PyTuple>,
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
        load::by_keyword("RollingProblem", positional, "creepage_x= or force_x=")?;
        let settings = chosen(settings, tolerance, method, max_iterations, time_limit)?;
        let keywords = Keywords::new(
            (creepage, force),
            [creepage_x, creepage_y],
            [force_x, force_y],
            (spin, moment),
        )?;
        keywords.needed()?;
        let grid = bodies.0.grid();
        let friction = friction.on(py, grid)?;
        let given = (
            bodies.clone(),
            normal.object(py),
            Friction(friction.clone()),
        );
        let recipe = Recipe::new(py, given)?
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
        let unit = normal.unit_of_gap().cloned();
        let normal = normal.get();
        let built = unobserved_on(py, grid, || {
            let Controls {
                along: [x, y],
                spin,
            } = keywords.controls();
            let mut builder = rolling::RollingProblem::builder(&bodies.0, normal, friction)
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
            recipe,
            unit,
        })
    }

    /// Solves the problem once; see :meth:`NormalProblem.solve`. The warnings that the normal solution also has are not issued
    /// again; the attribute ``warnings`` of the result lists them.
    #[pyo3(signature = (*, progress=None, warn=true))]
    fn solve<'py>(
        &self,
        py: Python<'py>,
        progress: Option<Bound<'py, PyAny>>,
        #[pyo3(from_py_with = crate::real::flag)] warn: bool,
    ) -> PyResult<Bound<'py, RollingSolution>> {
        let solver = || self.problem.clone().into_solver();
        let of_contact = || self.recipe.warnings_of_normal(py, 1);
        solve_sheared(py, self.grid.cells(), solver, progress, warn, of_contact)
    }

    /// Returns a solver of this problem, which keeps its buffers and starts each solve from the last solution.
    fn solver(&self, py: Python<'_>) -> PyResult<RollingSolver> {
        let solver = || self.problem.clone().into_solver();
        RollingSolver::of(py, self.grid, self.controls, self.unit.clone(), solver)
    }

    fn __getnewargs_ex__<'py>(
        &self,
        py: Python<'py>,
    ) -> PyResult<(Bound<'py, PyTuple>, Bound<'py, PyDict>)> {
        self.recipe.parts(py)
    }

    fn __repr__(&self) -> String {
        format!("RollingProblem({})", size(self.grid))
    }
}
