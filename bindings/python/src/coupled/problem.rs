//! Coupled contact problems.

use pyo3::prelude::*;
use pyo3::types::{PyDict, PyTuple};
use stickslip::cgm;

use crate::argument::Object;
use crate::choice::Choice;
use crate::conversion;
use crate::coupled::{CoupledSolution, CoupledSolver, Loads};
use crate::field::Field;
use crate::friction::{AnyFriction, Friction};
use crate::grid::size;
use crate::half_space::HalfSpace;
use crate::load::{self, TangentialArgument, TangentialLoad, keywords};
use crate::normal::{AnyHardness, Hardness};
use crate::pickle::Recipe;
use crate::real::{Count, Real};
use crate::samples::Samples;
use crate::settings::{Settings, chosen};
use crate::solver::solve_once;
use crate::tangential::RelativeDisplacement;
use crate::unit::{Unit, check_relative, set_in};
use crate::work::unobserved_on;

/// Bodies, gap, friction and loads of a contact whose pressure and tractions are solved simultaneously, from rest in one
/// step.
///
/// Parameters
/// ----------
/// bodies : HalfSpace
///     The two bodies and the grid.
/// gap : Field or array_like of shape (ny, nx)
///     The gap before loading (lengths). An array is copied, a Field is shared.
/// friction : Friction, float or array_like of shape (ny, nx)
///     Coulomb friction; a number or an array is the coefficient of friction (dimensionless, not negative).
/// load : TangentialLoad, optional
///     The tangential load as an object, instead of by keywords.
/// force, shift, spring, force_x, force_y, shift_x, shift_y, spring_x, spring_y, twist : optional
///     The tangential load; see :class:`TangentialLoad`. No force by default, which presses the bodies only.
/// normal_force, approach : float
///     Exactly one of the two: the normal force (not negative), or the approach of the bodies from the datum of the gap
///     (a length, positive when they move together).
/// relative_displacement : RelativeDisplacement, optional
///     A displacement of body 1 relative to body 2 that is not caused by the contact. It grows proportionally to the
///     load; none by default.
/// hardness : Hardness, float or array_like of shape (ny, nx), optional
///     The largest pressure that the cells can carry; no limit by default.
/// settings : Settings, optional
///     Method, tolerance and limits; ``Settings()`` by default.
/// tolerance, method, max_iterations, time_limit : optional
///     See :class:`Settings`; these arguments take precedence over ``settings``.
///
/// Raises
/// ------
/// GridMismatch, Shape, Sample, NegativeOrNotFinite, NotFinite, NotPositive, UnsupportedByModel, ApproachBeyondMeanGap,
/// BeyondHardness, Method, Tolerance, IterationLimit
///
/// Examples
/// --------
/// >>> import stickslip
/// >>> grid = stickslip.Grid.square(32, 0.3)
/// >>> pair = (stickslip.Material(70e3, 0.33), stickslip.Material(210e3, 0.3))
/// >>> bodies = stickslip.HalfSpace(grid, pair)
/// >>> ball = stickslip.surface.sphere(grid, 3.5)
/// >>> contact = stickslip.CoupledProblem(bodies, ball, 0.1, normal_force=60.0).solve()
/// >>> contact.tangential.slip_area > 0.0  # pressing alone makes the rim slip
/// True
#[pyclass(frozen, module = "stickslip")]
pub(crate) struct CoupledProblem(
    stickslip::CoupledProblem,
    stickslip::Grid,
    Recipe,
    Loads,
    /// Unit of the gap.
    Option<Unit>,
);

#[pymethods]
impl CoupledProblem {
    #[new]
    #[pyo3(signature = (bodies, gap, friction, load=None, *, normal_force=None, approach=None, force=None, shift=None,
        spring=None, force_x=None, force_y=None, shift_x=None, shift_y=None, spring_x=None, spring_y=None, twist=None,
        relative_displacement=None, hardness=None, settings=None, tolerance=None, method=None, max_iterations=None,
        time_limit=None))]
    fn new(
        py: Python<'_>,
        bodies: Object<HalfSpace>,
        gap: Samples<'_>,
        friction: AnyFriction<'_>,
        load: Option<TangentialArgument>,
        normal_force: Option<Real>,
        approach: Option<Real>,
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
        relative_displacement: Option<RelativeDisplacement>,
        hardness: Option<AnyHardness<'_>>,
        settings: Option<Settings>,
        tolerance: Option<Real>,
        method: Option<Choice<cgm::Method>>,
        max_iterations: Option<Count>,
        time_limit: Option<Real>,
    ) -> PyResult<Self> {
        let settings = chosen(settings, tolerance, method, max_iterations, time_limit)?;
        let keywords = keywords![
            force, shift, spring, force_x, force_y, shift_x, shift_y, spring_x, spring_y, twist
        ];
        let (normal, load) = (
            load::needed_as("normal_force", normal_force, approach)?,
            keywords.load_or(load)?,
        );
        let grid = bodies.0.grid();
        let gap = gap.gap_before_friction(py, grid)?;
        let friction = friction.on(py, grid)?;
        let hardness = hardness.map(|hardness| hardness.on(py, grid)).transpose()?;
        let bodies_and_surfaces = (
            bodies.clone(),
            gap.clone(),
            Friction(friction.clone()),
            TangentialLoad(load),
        );
        let recipe = Recipe::new(py, bodies_and_surfaces)?
            .with_normal(py, normal, "normal_force")?
            .with(py, "relative_displacement", relative_displacement.clone())?
            .with(py, "hardness", hardness.clone().map(Hardness))?
            .with(py, "settings", Some(Settings(settings)))?;
        let Field(gap, unit) = gap;
        if let Some(relative) = &relative_displacement {
            check_relative("the gap", unit.as_ref(), relative.1.as_ref())?;
        }
        let built = unobserved_on(py, grid, || {
            let mut builder =
                stickslip::CoupledProblem::builder(&bodies.0, gap, friction, normal, load)
                    .settings(settings);
            if let Some(relative) = relative_displacement {
                builder = builder.relative_displacement(relative.0);
            }
            if let Some(hardness) = hardness {
                builder = builder.hardness(hardness);
            }
            builder.build()
        })?;
        Ok(Self(built, grid, recipe, (normal, load), unit))
    }

    /// Solves from rest; see :meth:`NormalProblem.solve`. A force that makes the contact slide raises
    /// :class:`~stickslip.errors.BeyondFrictionCapacity`.
    #[pyo3(signature = (*, progress=None, warn=true))]
    fn solve<'py>(
        &self,
        py: Python<'py>,
        progress: Option<Bound<'py, PyAny>>,
        #[pyo3(from_py_with = crate::real::flag)] warn: bool,
    ) -> PyResult<Bound<'py, CoupledSolution>> {
        let solver = || self.0.clone().into_solver();
        let outcome = solve_once(py, self.1.cells(), solver, progress, warn);
        set_in(outcome, py, self.4.as_ref())
    }

    /// Returns a solver of this problem, which keeps its buffers and starts each solve from the last solution.
    fn solver(&self, py: Python<'_>) -> PyResult<CoupledSolver> {
        let solver = || self.0.clone().into_solver();
        CoupledSolver::of(py, self.1, self.3, self.4.clone(), solver)
    }

    fn __getnewargs_ex__<'py>(
        &self,
        py: Python<'py>,
    ) -> PyResult<(Bound<'py, PyTuple>, Bound<'py, PyDict>)> {
        self.2.parts(py)
    }

    fn __repr__(&self) -> String {
        format!("CoupledProblem({})", size(self.1))
    }
}
