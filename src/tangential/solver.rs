//! The reusable solver of a tangential contact.

use std::ops::ControlFlow;

use crate::buffer::{TryClone, or_abort};
use crate::cgm::{Iteration, Settings, solver_settings};
use crate::contact::{Conditions, with_memory};
use crate::coupling::Coupling;
use crate::elastic::Observer;
use crate::error::{Error, Result};
use crate::half_space::HalfSpace;
use crate::parallel;
use crate::report::Report;
use crate::shown::shown;
use crate::tangential::increment::{Increment, Start};
use crate::tangential::motion::Motion;
use crate::tangential::pressure::contact_window;
use crate::tangential::{
    Axis, Friction, Pressed, PressureSource, RelativeDisplacement, TangentialLoad, TangentialModel,
    TangentialProblem, TangentialSolution,
};

/// Solves tangential contacts again and again, each time from the last answer.
///
/// Owns plans, buffers and the last traction, all of the size of the contact's bounding box; load,
/// friction and pressure may change between calls. Each solve is one monotonic step from the
/// unsheared state: it does not remember slip.
///
/// ```
/// use stickslip::*;
/// let grid = Grid::square(32, 8.0)?;
/// let rubber = Material::new(1.0, 0.5)?;
/// let bodies = HalfSpace::new(grid, ElasticPair::new(rubber, Material::rigid())?)?;
/// let ball = surface::sphere(grid, 10.0)?;
/// let normal = NormalProblem::builder(&bodies, &ball, NormalControl::Force(0.5)).build()?.solve()?;
/// let friction = Friction::coulomb(0.3)?;
/// let mut solver =
///     TangentialProblem::builder(&bodies, &normal, friction, TangentialLoad::force([0.0, 0.0]))
///         .build()?
///         .into_solver()?;
/// let mut tangential = solver.new_solution();
/// let mut stick = Vec::new();
/// for force in [0.0, 0.05, 0.10, 0.149] {
///     solver.set_load(TangentialLoad::force([0.0, force]))?;
///     solver.solve_into(&mut tangential)?;
///     stick.push(tangential.stick_ratio());
/// }
/// assert!(stick[0] == 1.0 && stick.is_sorted_by(|a, b| a > b));
/// # Ok::<(), Error>(())
/// ```
#[derive(Clone)]
pub struct TangentialSolver {
    bodies: HalfSpace,
    friction: Friction,
    load: TangentialLoad,
    model: TangentialModel,
    coupling: Coupling,
    relative: Option<RelativeDisplacement>,
    settings: Settings,
    /// The step on the contact's bounding box, with the last traction, the start of the next.
    increment: Increment,
    is_warm: bool,
    report: Report,
    /// Pressure and limits under examination, not yet in force.
    candidate: Pressed,
}

shown!(TangentialSolver: bodies, friction, load, model, coupling, relative, settings);

impl TangentialSolver {
    pub(super) fn new(problem: TangentialProblem) -> Result<Self> {
        let TangentialProblem {
            bodies,
            pressed,
            friction,
            load,
            model,
            coupling,
            relative,
            settings,
        } = problem;
        let candidate = pressed.try_clone()?;
        let mut increment = Increment::new(&bodies, load.axes(model)?, pressed, coupling)?;
        increment.draw(relative.as_ref());
        Ok(Self {
            candidate,
            increment,
            is_warm: false,
            report: Report::with_room(),
            bodies,
            friction,
            load,
            model,
            coupling,
            relative,
            settings,
        })
    }

    /// Changes the load of the next solve. A load along the other axis brings in that axis's
    /// operator, the one change that allocates.
    ///
    /// # Errors
    /// [`Error::NotFinite`], [`Error::NotPositive`], [`Error::ObliqueLoad`], [`Error::NotModelled`] or
    /// [`Error::BeyondFrictionCapacity`]; for one along the other axis as
    /// [`HalfSpace::operator`](crate::HalfSpace::operator); [`Error::Ranks`]; the load is then as it was.
    pub fn set_load(&mut self, load: TangentialLoad) -> Result<()> {
        self.bodies
            .agreed_alike(Ok(()), &[("tangential load", &load)])?;
        let demand = load.demand();
        let mut axes = load.axes(self.model)?;
        // A solver at rest keeps its axis.
        if demand
            .check(self.increment.axes(), self.bodies.boundary())
            .is_ok()
        {
            axes = self.increment.axes();
        }
        demand.check(axes, self.bodies.boundary())?;
        let limits = &self.increment.pressed.limits;
        limits.check(demand.force(), self.bodies.grid().cell_area())?;
        if axes != self.increment.axes() {
            if let Some(relative) = &self.relative {
                self.bodies.agreed(relative.check(&self.bodies, axes))?;
            }
            let pressed = self.increment.pressed.try_clone()?;
            self.increment = Increment::new(&self.bodies, axes, pressed, self.coupling)?;
            self.increment.draw(self.relative.as_ref());
            self.is_warm = false;
        }
        self.load = load;
        Ok(())
    }

    /// Changes the friction of the next solve.
    ///
    /// # Errors
    /// [`Error::GridMismatch`], [`Error::NotFinite`] if the limits overflow, or [`Error::BeyondFrictionCapacity`] if
    /// the present load is more than the new friction holds; [`Error::Ranks`]; the friction is then as it was.
    pub fn set_friction(&mut self, friction: &Friction) -> Result<()> {
        friction.check_on(&self.bodies)?;
        let pressure = &self.increment.pressed.pressure;
        self.candidate.pressure.copy_from_slice(pressure);
        self.candidate.set_friction(friction);
        let copy = if self.friction.has_room_for(friction) {
            None
        } else {
            Some(friction.try_clone()?)
        };
        self.take_candidate()?;
        match copy {
            Some(copy) => self.friction = copy,
            None => self.friction.clone_from(friction),
        }
        Ok(())
    }

    /// Changes the pressure of the next solve to that of a solved normal contact or a field, as wear or another
    /// normal load does. Allocates only if the contact has left the bounding box it had.
    ///
    /// # Errors
    /// [`Error::GridMismatch`], [`Error::BoundaryMismatch`], [`Error::MaterialMismatch`],
    /// [`Error::NotConverged`], [`Error::Sample`], [`Error::EmptyContact`], [`Error::NotFinite`] if the limits
    /// overflow, or [`Error::BeyondFrictionCapacity`] if the present load is more than friction now holds; as
    /// [`HalfSpace::operator`](crate::HalfSpace::operator) where the contact has left its box; [`Error::Ranks`]; the
    /// pressure is then as it was.
    pub fn set_pressure<'a>(&mut self, pressure: impl Into<PressureSource<'a>>) -> Result<()> {
        let samples = self.bodies.agreed(pressure.into().checked(&self.bodies))?;
        let contact = contact_window(&self.bodies, samples)?;
        if self.increment.pressed.window().covers(contact) {
            self.candidate.set(samples, &self.friction);
            self.take_candidate()?;
            self.increment.draw(self.relative.as_ref());
            return Ok(());
        }
        // A little wider than the contact, so that it may grow some more.
        let mut pressed = Pressed::new(&self.bodies, contact.widened(self.bodies.grid()))?;
        pressed.set(samples, &self.friction);
        self.check_load(&pressed)?;
        let candidate = pressed.try_clone()?;
        let axes = self.increment.axes();
        let mut wider = Increment::new(&self.bodies, axes, pressed, self.coupling)?;
        wider.draw(self.relative.as_ref());
        self.increment.hand_over(&mut wider)?;
        (self.increment, self.candidate) = (wider, candidate);
        Ok(())
    }

    /// Changes the displacement of body 1 relative to body 2 that the contact does not cause of the next solve. Allocates
    /// only if there was none.
    ///
    /// # Errors
    /// [`Error::GridMismatch`]; [`Error::NotModelled`] for one along an axis of which the model finds no traction;
    /// [`Error::Sample`] for a bulk strain along an axis on which the grid repeats; [`Error::Ranks`]; the displacement is
    /// then as it was.
    pub fn set_relative_displacement(&mut self, relative: &RelativeDisplacement) -> Result<()> {
        let checked = relative.check(&self.bodies, self.increment.axes());
        self.bodies.agreed(checked)?;
        match &mut self.relative {
            Some(own) => own.try_clone_from(relative)?,
            none => *none = Some(relative.try_clone()?),
        }
        self.increment.draw(self.relative.as_ref());
        Ok(())
    }

    /// Puts pressure and limits under examination in force, if they hold the load.
    fn take_candidate(&mut self) -> Result<()> {
        self.check_load(&self.candidate)?;
        std::mem::swap(&mut self.candidate, &mut self.increment.pressed);
        Ok(())
    }

    fn check_load(&self, pressed: &Pressed) -> Result<()> {
        let cell_area = self.bodies.grid().cell_area();
        pressed.limits.check(self.load.demand().force(), cell_area)
    }

    /// Largest tangential force friction holds: the integral of the friction limit.
    #[must_use]
    pub fn friction_capacity(&self) -> f64 {
        self.increment.pressed.limits.sum * self.bodies.grid().cell_area()
    }

    solver_settings!(settings, bodies, |solver, settings| solver
        .model
        .check(settings));

    /// Forgets the last answer: the next solve starts as the first did.
    pub fn reset(&mut self) {
        self.is_warm = false;
    }

    /// An empty solution of the right size for [`TangentialSolver::solve_into`].
    #[must_use]
    pub fn new_solution(&self) -> TangentialSolution {
        or_abort(self.try_new_solution())
    }

    /// [`Self::new_solution`] where memory may run out.
    ///
    /// # Errors
    /// [`Error::Memory`].
    pub fn try_new_solution(&self) -> Result<TangentialSolution> {
        TangentialSolution::empty(self.bodies.grid(), self.bodies.boundary())
    }

    /// Solves into `solution`, whose last content does not matter.
    ///
    /// # Errors
    /// [`Error::GridMismatch`] or [`Error::BoundaryMismatch`] if the solution is of another grid or boundary, nothing
    /// changed; as [`HalfSpace::operator`](crate::HalfSpace::operator); [`Error::NotConverged`] with the last feasible
    /// iterate in `solution`; [`Error::Ranks`].
    pub fn solve_into(&mut self, solution: &mut TangentialSolution) -> Result<()> {
        self.solve_observed(solution, |_| ControlFlow::Continue(()))
    }

    /// [`TangentialSolver::solve_into`] with an observer that sees every step and may cancel.
    ///
    /// # Errors
    /// As [`TangentialSolver::solve_into`].
    pub fn solve_observed(
        &mut self,
        solution: &mut TangentialSolution,
        mut observer: impl FnMut(&Iteration) -> ControlFlow<()> + Send,
    ) -> Result<()> {
        let (grid, boundary) = (solution.grid(), solution.boundary());
        let bodies = self.bodies.clone();
        bodies.agreed(bodies.check_host("solution", grid, boundary))?;
        bodies.joint(parallel::enter_with(grid.cells(), || {
            self.solve_checked(solution, &mut observer)
        }))
    }

    fn solve_checked(
        &mut self,
        solution: &mut TangentialSolution,
        observer: Observer<'_>,
    ) -> Result<()> {
        let mut observer = with_memory(observer);
        let mut conditions = Conditions::new(&self.settings, &mut observer);
        let start = if self.is_warm {
            Start::Present(self.increment.motion().shift)
        } else {
            Start::Nested
        };
        let demand = self.load.demand();
        let outcome = self
            .increment
            .solve(&demand, Motion::default(), start, &mut conditions);
        let is_answered = matches!(outcome, Ok(()) | Err(Error::NotConverged(_)));
        // Do not warm-start from NaN.
        self.is_warm = is_answered && self.increment.report().residual.is_finite();
        if !is_answered {
            return outcome;
        }
        self.report.clone_from(self.increment.report());
        self.report.time = conditions.start.elapsed();
        let axis = Axis::only(self.increment.axes());
        solution.fill(&self.bodies, axis, &self.increment.answer(), &self.report);
        self.increment.rest();
        outcome.map_err(|_| Error::NotConverged(Box::new(self.report.clone())))
    }
}
