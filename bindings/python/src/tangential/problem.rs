//! Tangential contact problems.

use pyo3::prelude::*;
use pyo3::types::{PyDict, PyTuple};
use stickslip::{Coupling, TangentialModel, cgm};

use crate::argument::Object;
use crate::choice::Choice;
use crate::conversion;
use crate::digits::short;
use crate::friction::{AnyFriction, Friction};
use crate::grid::size;
use crate::half_space::HalfSpace;
use crate::load::{TangentialArgument, TangentialLoad, keywords};
use crate::pickle::Recipe;
use crate::real::{Count, Real};
use crate::settings::{Settings, chosen};
use crate::solver::solve_sheared;
use crate::tangential::pressure::Pressure;
use crate::tangential::solver::Units;
use crate::tangential::{RelativeDisplacement, TangentialSolution, TangentialSolver};
use crate::work::unobserved_on;

/// Bodies, pressure, friction and tangential load of one monotonic step from the unsheared state.
///
/// Parameters
/// ----------
/// bodies : HalfSpace
///     The two bodies and the grid.
/// pressure : NormalSolution, Field or array_like of shape (ny, nx)
///     A solved normal contact of these bodies, or a field of pressures (not negative).
/// friction : Friction, float or array_like of shape (ny, nx)
///     Coulomb friction; a number or an array is the coefficient of friction (dimensionless, not negative).
/// load : TangentialLoad, optional
///     The tangential load as an object, instead of by keywords.
/// force, shift, spring, force_x, force_y, shift_x, shift_y, spring_x, spring_y, twist : optional
///     The tangential load; see :class:`TangentialLoad`. A load is required. With a relative displacement, the default is zero
///     force.
/// model : TangentialModel or str, default "scalar"
///     "scalar" computes the traction along the axis of the load, "vector" both components. Give "vector" for bodies of different
///     materials: with the coupling "one_way", "scalar" omits the tractions across the axis, and the stick radius of a pressed ball
///     is then too large, several times for a small friction coefficient.
/// coupling : Coupling or str, default "one_way"
///     Coupling for bodies of different materials: "one_way" includes the tangential displacements due to pressure,
///     "neglected" omits them. "full" raises ``CoupledMaterials`` for such bodies, because the pressure is given.
///     A :class:`CoupledProblem` or a history with the coupling "full" accepts them. Bodies of
///     the same material are not coupled, and accept every value.
/// relative_displacement : RelativeDisplacement, optional
///     A displacement of body 1 relative to body 2 that is not caused by the contact. It grows proportionally to the
///     load; none by default.
/// settings : Settings, optional
///     Method, tolerance and limits; ``Settings()`` by default.
/// tolerance, method, max_iterations, time_limit : optional
///     See :class:`Settings`; these arguments take precedence over ``settings``.
///
/// Raises
/// ------
/// NotConverged, Sample, GridMismatch, BoundaryMismatch, MaterialMismatch, CoupledMaterials, ObliqueLoad, UnsupportedByModel,
/// NotFinite, EmptyContact, BeyondFrictionCapacity, Tolerance, IterationLimit
/// ValueError
///     If the units of the gap of the normal solution and of the relative displacement differ.
///
/// Examples
/// --------
/// >>> import stickslip
/// >>> grid = stickslip.Grid.square(64, 0.3e-3)
/// >>> steel = stickslip.Material(213e9, 0.29)
/// >>> bodies = stickslip.HalfSpace(grid, (steel, steel))
/// >>> ball = stickslip.surface.sphere(grid, 3.5e-3)
/// >>> normal = stickslip.NormalProblem(bodies, ball, force=100.0).solve()
/// >>> shear = stickslip.TangentialProblem(bodies, normal, 0.5, force_x=20.0).solve()
/// >>> hertz = stickslip.analytical.HertzSphere(bodies.pair, radius=3.5e-3, load=100.0)
/// >>> exact = stickslip.analytical.CattaneoMindlin(hertz, friction=0.5, force=20.0)
/// >>> abs(shear.stick_ratio - exact.stick_ratio) < 0.02
/// True
#[pyclass(frozen, module = "stickslip")]
pub(crate) struct TangentialProblem(
    stickslip::TangentialProblem,
    stickslip::Grid,
    Recipe,
    TangentialLoad,
    Units,
);

#[pymethods]
impl TangentialProblem {
    #[new]
    #[pyo3(signature = (bodies, pressure, friction, load=None, *, force=None, shift=None, spring=None, force_x=None,
        force_y=None, shift_x=None, shift_y=None, spring_x=None, spring_y=None, twist=None, model=None, coupling=None,
        relative_displacement=None, settings=None, tolerance=None, method=None, max_iterations=None, time_limit=None))]
    fn new(
        py: Python<'_>,
        bodies: Object<HalfSpace>,
        pressure: Pressure<'_>,
        friction: AnyFriction<'_>,
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
        model: Option<Choice<TangentialModel>>,
        coupling: Option<Choice<Coupling>>,
        relative_displacement: Option<RelativeDisplacement>,
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
        // A relative displacement shears the contact without a force.
        let load = match &relative_displacement {
            None => keywords.needed_or(load)?,
            Some(_) => keywords.load_or(load)?,
        };
        let grid = bodies.0.grid();
        let friction = friction.on(py, grid)?;
        let given = pressure.given(py, grid)?;
        let recipe = Recipe::new(
            py,
            (
                bodies.clone(),
                given.object(&pressure),
                Friction(friction.clone()),
                TangentialLoad(load),
            ),
        )?
        .with(py, "model", model)?
        .with(py, "coupling", coupling)?
        .with(py, "relative_displacement", relative_displacement.clone())?
        .with(py, "settings", Some(Settings(settings)))?;
        let relative = relative_displacement.as_ref();
        let units = Units {
            gap: pressure.unit_of_gap(),
            relative: relative.and_then(|relative| relative.1.clone()),
        };
        units.check()?;
        let built = unobserved_on(py, grid, || {
            let builder =
                stickslip::TangentialProblem::builder(&bodies.0, given.source(), friction, load);
            let mut builder = builder.settings(settings);
            if let Some(model) = model {
                builder = builder.model(model.0);
            }
            if let Some(coupling) = coupling {
                builder = builder.coupling(coupling.0);
            }
            if let Some(relative) = relative_displacement {
                builder = builder.relative_displacement(relative.0);
            }
            builder.build()
        })?;
        Ok(Self(built, grid, recipe, TangentialLoad(load), units))
    }

    /// Largest tangential force that friction can carry: the integral of the friction limit.
    #[getter]
    fn friction_capacity(&self) -> f64 {
        self.0.friction_capacity()
    }

    /// Solves the problem once; see :meth:`NormalProblem.solve`. The warnings that the normal solution also has are not issued
    /// again; the attribute ``warnings`` of the result lists them.
    #[pyo3(signature = (*, progress=None, warn=true))]
    fn solve<'py>(
        &self,
        py: Python<'py>,
        progress: Option<Bound<'py, PyAny>>,
        #[pyo3(from_py_with = crate::real::flag)] warn: bool,
    ) -> PyResult<Bound<'py, TangentialSolution>> {
        let solver = || self.0.clone().into_solver();
        let of_contact = || self.2.warnings_of_normal(py, 1);
        solve_sheared(py, self.1.cells(), solver, progress, warn, of_contact)
    }

    /// Returns a solver of this problem, which keeps its buffers and starts each solve from the last solution.
    fn solver(&self, py: Python<'_>) -> PyResult<TangentialSolver> {
        let solver = || self.0.clone().into_solver();
        TangentialSolver::of(py, self.1, self.3, self.4.clone(), solver)
    }

    fn __getnewargs_ex__<'py>(
        &self,
        py: Python<'py>,
    ) -> PyResult<(Bound<'py, PyTuple>, Bound<'py, PyDict>)> {
        self.2.parts(py)
    }

    fn __repr__(&self) -> String {
        format!(
            "TangentialProblem({}, friction_capacity={})",
            size(self.1),
            short(self.0.friction_capacity())
        )
    }
}
