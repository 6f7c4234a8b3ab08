//! Tangential solver with a common interface for one and two components of the traction.

use std::borrow::Cow;
use std::fmt::Debug;

use crate::bodies::component::{Component, Direction};
use crate::bodies::coupling::Coupling;
use crate::cgm::{Ball, CellCompliance, InitialGuess, Method, NormBound, Settings, Total};
use crate::contact::{ElasticSolver, MultilevelProblem, SolveContext, nested_start};
use crate::error::Result;
use crate::grid::field::Field;
use crate::half_space::HalfSpace;
use crate::memory::fallible::{self, try_each};
use crate::observer::Observer;
use crate::operator::Operator;
use crate::report::Report;
use crate::tangential::Axis;
use crate::tangential::friction_problem::FrictionProblem;

/// Vector in the plane for the cells of a window, `[x, y]`. A component that the model omits has no cells.
pub(crate) type TangentialVector = [Vec<f64>; 2];

/// Creates zero components along these axes.
pub(crate) fn zeros(axes: &[Axis], cells: usize) -> Result<TangentialVector> {
    let mut both = TangentialVector::default();
    for axis in axes {
        both[axis.index()] = fallible::zeros(cells)?;
    }
    Ok(both)
}

/// Returns `[x, y]` of a cell, with zero for a component that the model omits.
#[inline]
pub(crate) fn at<V: AsRef<[f64]>>(vector: &[V; 2], cell: usize) -> [f64; 2] {
    let part = |axis: usize| vector[axis].as_ref().get(cell).copied().unwrap_or(0.0);
    [part(0), part(1)]
}

/// Input of a tangential solve.
#[derive(Debug, Clone, Copy)]
pub(super) struct TangentialRequest<'a> {
    pub(super) limits: &'a [f64],
    /// Entry compliance of the cells. Empty if no cell comes into contact.
    pub(super) own: CellCompliance<'a>,
    pub(super) linear: &'a TangentialVector,
    pub(super) totals: [Total; 2],
    /// Whether the limits of all cells are zero.
    pub(super) is_frictionless: bool,
    /// Multipliers at which the start was a solution, or `None` if the start was not a solution.
    pub(super) known: Option<[f64; 2]>,
    /// Unit of the tractions if their squares would otherwise overflow or underflow. The operator is linear, so
    /// displacements scale with the unit.
    pub(super) unit: Option<f64>,
}

/// Interface of the tangential solver for any number of components.
pub(super) trait TangentialEngine: Debug + Send + Sync {
    /// Minimises the energy in place, starting from `traction`.
    fn minimise(
        &mut self,
        task: TangentialRequest<'_>,
        traction: &mut TangentialVector,
        settings: &Settings,
        observer: Observer<'_>,
    ) -> Result<()>;

    /// Returns the tractions of the start, which are the solution on coarser cells. If the method has no nested start
    /// or the whole contact slides, the tractions are proportional to the friction limits.
    fn start(
        &self,
        bodies: &HalfSpace,
        size: [usize; 2],
        task: TangentialRequest<'_>,
        is_sliding: bool,
        conditions: &mut SolveContext<'_, '_>,
    ) -> Result<TangentialVector>;

    /// Computes the displacements that tractions cause. The last solution is unchanged.
    ///
    /// # Errors
    /// - [`Error::Memory`](crate::Error::Memory) if memory runs out.
    fn apply(
        &mut self,
        traction: &TangentialVector,
        displacement: &mut TangentialVector,
    ) -> Result<()>;

    /// Returns the displacements of the last solution.
    fn product(&self) -> [&[f64]; 2];

    /// Returns the shift that forces and springs cause in addition to the prescribed shift.
    fn multiplier(&self) -> [f64; 2];

    fn report(&self) -> &Report;

    /// Returns the buffers to their pools. The displacements of the solution are lost.
    fn rest(&mut self);

    fn boxed(&self) -> Box<dyn TangentialEngine>;
}

impl Clone for Box<dyn TangentialEngine> {
    fn clone(&self) -> Self {
        self.boxed()
    }
}

/// Creates the solver for tractions along these axes, x first.
pub(super) fn engine_along(
    bodies: &HalfSpace,
    axes: &[Axis],
    size: [usize; 2],
) -> Result<Box<dyn TangentialEngine>> {
    Ok(match axes {
        [axis] => Box::new(AxesEngine::new(bodies, [*axis], size)?),
        _ => Box::new(AxesEngine::new(bodies, [Axis::X, Axis::Y], size)?),
    })
}

/// Returns an error if the bodies lack an operator for tractions along these axes. The operator of the displacement due
/// to pressure along these axes is also required if the coupling includes this displacement.
pub(crate) fn check_axes(bodies: &HalfSpace, axes: &[Axis], coupling: Coupling) -> Result<()> {
    match axes {
        [axis] => bodies.check_directions([axis.direction()], false)?,
        _ => bodies.check_directions([Direction::X, Direction::Y], false)?,
    }
    let moved = axes.iter().filter(|_| coupling.is_one_way(bodies.pair()));
    for axis in moved {
        let component = Component::of(axis.direction(), Direction::Z);
        bodies.check_components([[component]], false)?;
    }
    Ok(())
}

/// Computes the displacements of the whole grid that tractions along these axes cause.
pub(crate) fn displacement(
    bodies: &HalfSpace,
    axes: &[Axis],
    traction: [&Field; 2],
) -> Result<[Field; 2]> {
    let mut displacement = try_each(|_| Field::try_zeros(bodies.grid()))?;
    if let [axis] = axes {
        let (direction, axis) = (axis.direction(), axis.index());
        let operator = bodies.operator(Component::of(direction, direction))?;
        operator.apply(
            [traction[axis].as_slice()],
            [displacement[axis].as_mut_slice()],
            &mut operator.scratch()?,
        );
    } else {
        let operator = bodies.tensor_operator([Direction::X, Direction::Y])?;
        operator.apply(
            traction.map(Field::as_slice),
            displacement.each_mut().map(Field::as_mut_slice),
            &mut operator.scratch()?,
        );
    }
    bodies.joint(Ok(displacement))
}

/// Solver for `N` components of the traction.
#[derive(Debug, Clone)]
struct AxesEngine<const N: usize>
where
    NormBound: Ball<N>,
{
    axes: [Axis; N],
    solver: ElasticSolver<<NormBound as Ball<N>>::Set, N>,
}

impl<const N: usize> AxesEngine<N>
where
    NormBound: Ball<N>,
{
    fn new(bodies: &HalfSpace, axes: [Axis; N], size: [usize; 2]) -> Result<Self> {
        let solver = ElasticSolver::new(bodies, axes.map(Axis::direction), size)?;
        Ok(Self { axes, solver })
    }

    /// Returns `[x, y]` from these components, with the default value for a component that the model omits.
    fn both<T: Default>(&self, values: [T; N]) -> [T; 2] {
        let mut both = <[T; 2]>::default();
        for (axis, value) in self.axes.iter().zip(values) {
            both[axis.index()] = value;
        }
        both
    }
}

/// Returns the components along these axes.
fn of<const N: usize>(axes: [Axis; N], both: &TangentialVector) -> [&[f64]; N] {
    axes.map(|axis| both[axis.index()].as_slice())
}

/// Returns the input of the solve along these axes, in the unit of the tractions.
fn scene<const N: usize>(
    axes: [Axis; N],
    task: TangentialRequest<'_>,
) -> Result<FrictionProblem<'_, N>> {
    let unit = task.unit.unwrap_or(1.0);
    let in_unit = |field| measured(field, task.unit);
    let linear = of(axes, task.linear);
    Ok(FrictionProblem {
        directions: axes.map(Axis::direction),
        limits: in_unit(task.limits)?,
        own: task.own,
        linear: try_each(|n| in_unit(linear[n]))?,
        totals: axes.map(|axis| task.totals[axis.index()].in_unit(unit)),
    })
}

/// Returns a field in a unit, or the unchanged field without a unit.
fn measured(field: &[f64], unit: Option<f64>) -> Result<Cow<'_, [f64]>> {
    let Some(unit) = unit else {
        return Ok(field.into());
    };
    let values = field.iter().map(|value| value / unit);
    fallible::collected(field.len(), values).map(Cow::from)
}

fn rescale(vector: &mut TangentialVector, factor: f64) {
    for value in vector.iter_mut().flatten() {
        *value *= factor;
    }
}

/// Returns mutable components along these axes.
fn of_mut<const N: usize>(axes: [Axis; N], both: &mut TangentialVector) -> [&mut [f64]; N] {
    let mut parts = both.each_mut().map(Some);
    // Each axis occurs at most once.
    axes.map(|axis| parts[axis.index()].take().map_or(&mut [][..], |part| part))
}

impl<const N: usize> TangentialEngine for AxesEngine<N>
where
    NormBound: Ball<N>,
{
    fn minimise(
        &mut self,
        task: TangentialRequest<'_>,
        traction: &mut TangentialVector,
        settings: &Settings,
        observer: Observer<'_>,
    ) -> Result<()> {
        let unit = task.unit.unwrap_or(1.0);
        let known = task.known.map_or(InitialGuess::Nothing, |multiplier| {
            InitialGuess::PreviousSolution(self.axes.map(|axis| multiplier[axis.index()] / unit))
        });
        let scene = scene(self.axes, task)?;
        let problem = scene.problem(&self.solver);
        if task.unit.is_some() {
            rescale(traction, 1.0 / unit);
        }
        let from = (of_mut(self.axes, traction), known);
        let compliance = if task.is_frictionless {
            [None; N]
        } else {
            problem.uniform_compliance()
        };
        let outcome = (self.solver).minimise_with(&problem, compliance, from, settings, observer);
        if task.unit.is_some() {
            rescale(traction, unit);
            self.solver.rescale(unit);
        }
        outcome
    }

    fn start(
        &self,
        bodies: &HalfSpace,
        size: [usize; 2],
        task: TangentialRequest<'_>,
        is_sliding: bool,
        conditions: &mut SolveContext<'_, '_>,
    ) -> Result<TangentialVector> {
        let scene = scene(self.axes, task)?;
        let found = if is_sliding || conditions.settings.method == Method::PolonskyKeer {
            scene.plain_start(&bodies.layout(size))?
        } else {
            nested_start(bodies, size, &scene, conditions)?
        };
        let mut found = self.both(found);
        if let Some(unit) = task.unit {
            rescale(&mut found, unit);
        }
        Ok(found)
    }

    fn apply(
        &mut self,
        traction: &TangentialVector,
        displacement: &mut TangentialVector,
    ) -> Result<()> {
        let traction = of(self.axes, traction);
        self.solver.apply(traction, of_mut(self.axes, displacement))
    }

    fn product(&self) -> [&[f64]; 2] {
        self.both(self.solver.product())
    }

    fn multiplier(&self) -> [f64; 2] {
        self.both(self.solver.multiplier())
    }

    fn report(&self) -> &Report {
        self.solver.report()
    }

    fn rest(&mut self) {
        self.solver.rest();
    }

    fn boxed(&self) -> Box<dyn TangentialEngine> {
        Box::new(self.clone())
    }
}

impl Axis {
    /// Returns the direction of tractions along the axis.
    pub(crate) const fn direction(self) -> Direction {
        match self {
            Self::X => Direction::X,
            Self::Y => Direction::Y,
        }
    }
}
