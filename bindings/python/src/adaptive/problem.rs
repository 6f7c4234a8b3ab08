//! Problems that are solved to a required accuracy.

use std::time::Duration;

use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyTuple};
use stickslip::adaptive::{AdaptiveStatus, GapFunction, Quantity};
use stickslip::surface::Interpolation;
use stickslip::{Coupling, Error, NormalLoad, TangentialModel};

use crate::adaptive::gap::{Gap, GapArgument, ObservedGap, SharedObserver};
use crate::adaptive::target::{OfQuantities, Target};
use crate::adaptive::{AdaptiveSolution, Region};
use crate::choice::Choice;
use crate::conversion;
use crate::digits::short;
use crate::error::OrRaise;
use crate::friction::{Friction, GridlessFriction};
use crate::kernel::Kernel;
use crate::load::{self, LoadStep, TangentialArgument, TangentialLoad, keywords};
use crate::material::{Bodies, ElasticPair};
use crate::pickle::Recipe;
use crate::progress::Progress;
use crate::real::{Count, Real};
use crate::report::warn;
use crate::settings::duration;
use crate::unit::Unit;
use crate::work::solve_in_stages;

/// Bodies, gap, load and required accuracy of a contact, whose grid the solve chooses.
///
/// The solve finds the part of the region where the bodies touch. It refines a grid on this part until all estimated errors
/// are at most their targets, or until a limit is reached. The estimates are not bounds.
///
/// The search for the contact evaluates the gap at 192 x 192 positions of the region. It does not find a bump between these
/// positions. The docs of the Rust module ``adaptive`` describe the method and the estimates.
///
/// Parameters
/// ----------
/// pair : ElasticPair, two Materials, or Kernel
///     The two bodies; z points into the first.
/// gap : callable or Field
///     The gap before loading (lengths). A function ``gap(x, y)`` receives two arrays of one dimension and equal length, the
///     coordinates of positions in the region (lengths). It returns an array of their shape. A Field contains samples on a
///     grid that is centred on the origin. The cells are not smaller than the distance between the samples.
/// region : Region
///     The region where contact may occur. The samples of a Field must cover it.
/// force, approach : float
///     Exactly one of the two: the normal force (not negative), or the approach of the bodies from the datum of the gap
///     (a length, positive when they move together). The tangential load has other keywords.
/// target : float or dict, default 0.01
///     The largest estimated errors, each between 0 and 1. A number is the target of the pressure, and of the traction if
///     there is friction. A dictionary contains the target of each :class:`Quantity`, such as ``{"area": 1e-3}``.
/// interpolation : Interpolation or str, default "cubic"
///     Interpolation between the samples of a Field: "cubic" or "linear".
/// friction : Friction or float, optional
///     Coulomb friction with a uniform coefficient (dimensionless, not negative). Friction requires a tangential load or
///     ``first_step``.
/// load : TangentialLoad, optional
///     The tangential load as an object, instead of by keywords. It acts on the contact under its final pressure, as in a
///     :class:`~stickslip.TangentialProblem`.
/// shift, spring, force_x, force_y, shift_x, shift_y, spring_x, spring_y, twist : optional
///     The tangential load; see :class:`~stickslip.TangentialLoad`.
/// first_step : LoadStep, optional
///     The first step of a history, instead of a tangential load. The normal load of the problem replaces the normal load of
///     the step. :attr:`AdaptiveSolution.history` can then take further steps on the same grid.
/// model : TangentialModel or str, default "scalar"
///     "scalar" computes the traction along the axis of the load, "vector" both components.
/// coupling : Coupling or str, optional
///     Coupling for bodies of different materials: by default "one_way", or "full" with ``first_step``.
/// cell_limit : int, default 1048576
///     The largest number of cells of a grid, at least 1024.
/// time_limit : float, optional
///     Wall time (s) after which no further grid is solved; no limit by default.
///
/// Raises
/// ------
/// Tolerance, Sample, UnsupportedByModel, BelowMinimum
///
/// Examples
/// --------
/// >>> import stickslip as ss
/// >>> steel = ss.Material(213e9, 0.29)
/// >>> region = ss.adaptive.Region.rectangle((-20e-3, 20e-3), (-20e-3, 20e-3))
/// >>> ball = lambda x, y: (x**2 + y**2) / 7e-3
/// >>> problem = ss.adaptive.AdaptiveProblem((steel, steel), ball, region, force=100.0, target={"approach": 1e-3})
/// >>> contact = problem.solve()
/// >>> hertz = ss.analytical.HertzSphere(ss.ElasticPair(steel, steel), radius=3.5e-3, load=100.0)
/// >>> contact.is_reached, abs(contact.approach / hertz.approach - 1.0) < 1e-3
/// (True, True)
#[pyclass(frozen, module = "stickslip.adaptive")]
pub(crate) struct AdaptiveProblem {
    input: Input,
    recipe: Recipe,
}

/// Input of a problem of the crate. The problem refers to the gap and does not own it.
struct Input {
    bodies: stickslip::Kernel,
    gap: Gap,
    /// Unit of the gap.
    unit: Option<Unit>,
    load: NormalLoad,
    region: stickslip::adaptive::Region,
    shear: Option<(stickslip::Friction, Shear)>,
    model: Option<TangentialModel>,
    coupling: Option<Coupling>,
    targets: Vec<(Quantity, f64)>,
    cell_limit: Option<usize>,
    time_limit: Option<Duration>,
}

/// Load that shears a contact.
enum Shear {
    Load(stickslip::TangentialLoad),
    FirstStep(Box<stickslip::LoadStep>),
}

impl Input {
    /// Creates the problem of the crate with a different gap.
    fn problem<'a>(
        &self,
        gap: &'a (dyn GapFunction + Sync),
    ) -> stickslip::Result<stickslip::adaptive::AdaptiveProblem<'a>> {
        let bodies = self.bodies.clone();
        let mut builder =
            stickslip::adaptive::AdaptiveProblem::builder(bodies, gap, self.load, self.region);
        for &(quantity, target) in &self.targets {
            builder = builder.target(quantity, target);
        }
        if let Some((friction, shear)) = &self.shear {
            builder = match shear {
                Shear::Load(load) => builder.shear(friction.clone(), *load),
                Shear::FirstStep(step) => builder.first_step(friction.clone(), **step),
            };
        }
        if let Some(model) = self.model {
            builder = builder.model(model);
        }
        if let Some(coupling) = self.coupling {
            builder = builder.coupling(coupling);
        }
        if let Some(cells) = self.cell_limit {
            builder = builder.cell_limit(cells);
        }
        if let Some(time) = self.time_limit {
            builder = builder.time_limit(time);
        }
        builder.build()
    }
}

#[pymethods]
impl AdaptiveProblem {
    #[new]
    #[pyo3(signature = (pair, gap, region, *positional, force=None, approach=None, target=Target::OfFields(0.01),
        interpolation=None, friction=None, load=None, shift=None, spring=None, force_x=None, force_y=None, shift_x=None,
        shift_y=None, spring_x=None, spring_y=None, twist=None, first_step=None, model=None, coupling=None,
        cell_limit=None, time_limit=None),
        text_signature = "(pair, gap, region, *, force=None, approach=None, target=0.01, interpolation=None, friction=None, \
            load=None, shift=None, spring=None, force_x=None, force_y=None, shift_x=None, shift_y=None, spring_x=None, \
            spring_y=None, twist=None, first_step=None, model=None, coupling=None, cell_limit=None, time_limit=None)")]
    fn new(
        py: Python<'_>,
        pair: Bodies,
        gap: GapArgument<'_>,
        region: Region,
        positional: &Bound<'_, PyTuple>,
        force: Option<Real>,
        approach: Option<Real>,
        target: Target,
        interpolation: Option<Choice<Interpolation>>,
        friction: Option<GridlessFriction>,
        load: Option<TangentialArgument>,
        shift: Option<conversion::Shift>,
        spring: Option<conversion::Springs>,
        force_x: Option<Real>,
        force_y: Option<Real>,
        shift_x: Option<Real>,
        shift_y: Option<Real>,
        spring_x: Option<conversion::Spring>,
        spring_y: Option<conversion::Spring>,
        twist: Option<Real>,
        first_step: Option<LoadStep>,
        model: Option<Choice<TangentialModel>>,
        coupling: Option<Choice<Coupling>>,
        cell_limit: Option<Count>,
        time_limit: Option<Real>,
    ) -> PyResult<Self> {
        load::by_keyword("AdaptiveProblem", positional, "force= or approach=")?;
        let normal = load::needed(force, approach)?;
        let keywords = keywords![
            None, shift, spring, force_x, force_y, shift_x, shift_y, spring_x, spring_y, twist
        ];
        let has_load = load.is_some() || !keywords.is_empty();
        let tangential = if has_load {
            Some(keywords.load_or(load)?)
        } else {
            None
        };
        let friction = friction.map(|friction| friction.0);
        let targets = target.of_quantities(py, friction.is_some())?;
        let time_limit = time_limit
            .map(|Real(seconds)| duration(seconds))
            .transpose()?;
        let (own_gap, unit) = (Gap::new(py, &gap, interpolation)?, gap.unit());
        let recipe = Recipe::new(
            py,
            (object_of(py, &pair.0)?, object_of_gap(py, gap)?, region),
        )?
        .with_normal(py, normal, "force")?
        .with(py, "target", Some(OfQuantities(targets.clone())))?
        .with(py, "interpolation", interpolation)?
        .with(py, "friction", friction.clone().map(Friction))?
        .with(py, "load", tangential.map(TangentialLoad))?
        .with(py, "first_step", first_step.clone())?
        .with(py, "model", model)?
        .with(py, "coupling", coupling)?
        .with(py, "cell_limit", cell_limit.map(|cells| cells.0))?
        .with(py, "time_limit", time_limit.map(|time| time.as_secs_f64()))?;
        let input = Input {
            bodies: pair.0,
            gap: own_gap,
            unit,
            load: normal,
            region: region.get().or_raise(py)?,
            shear: shear(friction, tangential, first_step)?,
            model: model.map(|model| model.0),
            coupling: coupling.map(|coupling| coupling.0),
            targets,
            cell_limit: cell_limit.map(|cells| cells.0),
            time_limit,
        };
        // The gap is not evaluated before the solve.
        input.problem(&|_, _| 0.0).or_raise(py)?;
        Ok(Self { input, recipe })
    }

    /// Targets of the estimated errors, by the names of the quantities.
    #[getter]
    fn targets(&self) -> OfQuantities {
        OfQuantities(self.input.targets.clone())
    }

    /// Solves the contact on finer and finer grids until all estimates are at most their targets or a limit is reached.
    ///
    /// A limit is not an error. The solution then belongs to the finest grid: its status states the limit, and a warning is
    /// issued. An exception of the gap function ends the solve and is raised unchanged. Ctrl-C takes effect between grids, or
    /// between calls of the gap function.
    ///
    /// Parameters
    /// ----------
    /// progress : callable or bool, optional
    ///     A function that is called with a :class:`GridRecord` after the solve on each grid. If it returns ``False``, the
    ///     solve ends with the solution on this grid and the status "cancelled". An exception in the function ends the solve.
    ///     ``True`` shows a progress bar of tqdm.
    /// warn : bool, default True
    ///     Whether the warnings of the solution are also issued through ``warnings``, each kind once per location.
    ///
    /// Returns
    /// -------
    /// AdaptiveSolution
    ///
    /// Raises
    /// ------
    /// EmptyContact
    ///     If the bodies do not touch.
    /// Sample
    ///     If the gap is not finite at a position.
    /// BeyondSamples
    ///     If the samples of the gap do not cover the region.
    /// ValueError
    ///     If the array that the gap function returns has a wrong shape.
    ///
    /// Notes
    /// -----
    /// Exceptions of the contact on a grid can also occur, such as :class:`~stickslip.errors.BeyondFrictionCapacity`.
    #[pyo3(signature = (*, progress=None, warn=true))]
    fn solve(
        &self,
        py: Python<'_>,
        progress: Option<Bound<'_, PyAny>>,
        #[pyo3(from_py_with = crate::real::flag)] warn: bool,
    ) -> PyResult<AdaptiveSolution> {
        let progress = Progress::of_grids(progress.as_ref())?;
        let input = &self.input;
        let cells = input.cell_limit.unwrap_or(usize::MAX);
        let mut cancelled = None;
        let outcome = solve_in_stages(py, cells, progress, |observer| {
            let observer = SharedObserver::new(observer);
            let gap = ObservedGap {
                gap: &input.gap,
                observer: &observer,
            };
            let problem = input.problem(&gap)?;
            let solution = problem.solve_observed(|record| observer.call(Some(record)))?;
            match solution.status() {
                // An exception that interrupted the solve is raised instead of this error.
                AdaptiveStatus::Cancelled => {
                    cancelled = Some(solution);
                    Err(Error::EmptyPath)
                }
                _ => Ok(solution),
            }
        })?;
        let solution = match cancelled {
            Some(solution) => solution,
            None => outcome.or_raise(py)?,
        };
        let warnings = solution.warnings().or_raise(py)?;
        self::warn(py, warn, || warnings)?;
        Ok(AdaptiveSolution::new(
            solution,
            input.targets.clone(),
            input.unit.clone(),
        ))
    }

    fn __getnewargs_ex__<'py>(
        &self,
        py: Python<'py>,
    ) -> PyResult<(Bound<'py, PyTuple>, Bound<'py, PyDict>)> {
        self.recipe.parts(py)
    }

    fn __repr__(&self) -> String {
        let targets = self.input.targets.iter();
        let targets: Vec<_> = targets
            .map(|&(quantity, target)| format!("'{}': {}", Choice(quantity).name(), short(target)))
            .collect();
        format!("AdaptiveProblem(target={{{}}})", targets.join(", "))
    }
}

/// Returns friction and the load that shears the contact. One requires the other.
fn shear(
    friction: Option<stickslip::Friction>,
    load: Option<stickslip::TangentialLoad>,
    first_step: Option<LoadStep>,
) -> PyResult<Option<(stickslip::Friction, Shear)>> {
    let refused = |message| Err(PyTypeError::new_err(message));
    let shear = match (load, first_step) {
        (Some(_), Some(_)) => {
            return refused("give either a tangential load or first_step=, not both");
        }
        (Some(load), None) => Some(Shear::Load(load)),
        (None, Some(step)) => Some(Shear::FirstStep(Box::new(step.0))),
        (None, None) => None,
    };
    match (friction, shear) {
        (Some(friction), Some(shear)) => Ok(Some((friction, shear))),
        (None, None) => Ok(None),
        (Some(_), None) => refused(
            "friction requires a tangential load: give a tangential force by force_x=, a shift by shift_x=, or first_step=",
        ),
        (None, Some(_)) => refused("a tangential load requires friction: give friction="),
    }
}

/// Returns the bodies as an object with which the problem can be constructed again.
fn object_of<'py>(py: Python<'py>, bodies: &stickslip::Kernel) -> PyResult<Bound<'py, PyAny>> {
    let pair = bodies.pair();
    if pair.stands_for_kernel() {
        Bound::new(py, Kernel(bodies.clone())).map(Bound::into_any)
    } else {
        Bound::new(py, ElasticPair(*pair)).map(Bound::into_any)
    }
}

fn object_of_gap<'py>(py: Python<'py>, gap: GapArgument<'py>) -> PyResult<Bound<'py, PyAny>> {
    match gap {
        GapArgument::Function(function) => Ok(function),
        GapArgument::Samples(field) => Bound::new(py, field).map(Bound::into_any),
    }
}
