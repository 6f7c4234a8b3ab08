//! The reusable solver of a tangential contact.

use crate::cgm::solver_settings;
use crate::contact::{Cancellation, SolveContext, has_iterate, solver_methods};
use crate::error::{Error, Result};
use crate::memory::fallible::TryClone;
use crate::observer::Observer;
use crate::report::Report;
use crate::support::debug::shown;
use crate::tangential::increment::{Start, TangentialIncrement};
use crate::tangential::pressure_source::contact_window;
use crate::tangential::rigid_motion::RigidMotion;
use crate::tangential::{
    Axis, Friction, PressureOnWindow, PressureSource, RelativeDisplacement, TangentialLoad,
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
    /// Its pressure and limits are those under examination, not yet in force.
    problem: TangentialProblem,
    /// The step on the contact's bounding box, with the last traction, the start of the next.
    increment: TangentialIncrement,
    is_warm: bool,
    report: Report,
}

shown!(TangentialSolver: problem);

impl TangentialSolver {
    pub(super) fn new(problem: TangentialProblem) -> Result<Self> {
        let axes = problem.load.axes(problem.model)?;
        let pressed = problem.pressed.try_clone()?;
        Ok(Self {
            increment: problem.increment(axes, pressed)?,
            is_warm: false,
            report: Report::with_room(),
            problem,
        })
    }

    /// Changes the load of the next solve. A load along the other axis brings in that axis's
    /// operator, the one change that allocates.
    ///
    /// # Errors
    /// [`Error::NotFinite`], [`Error::NotPositive`], [`Error::ObliqueLoad`], [`Error::UnsupportedByModel`] or
    /// [`Error::BeyondFrictionCapacity`]; for one along the other axis as
    /// [`HalfSpace::operator`](crate::HalfSpace::operator); [`Error::Ranks`]; the load is then as it was.
    pub fn set_load(&mut self, load: TangentialLoad) -> Result<()> {
        let TangentialProblem {
            bodies, relative, ..
        } = &self.problem;
        bodies.collective_result_checked(Ok(()), &[("tangential load", &load)])?;
        let (demand, boundary) = (load.demand(), bodies.boundary());
        let mut axes = load.axes(self.problem.model)?;
        // A solver at rest keeps its axis.
        if demand.check(self.increment.axes(), boundary).is_ok() {
            axes = self.increment.axes();
        }
        demand.check(axes, boundary)?;
        let limits = &self.increment.pressed.limits;
        limits.check(demand.force(), bodies.grid().cell_area())?;
        if axes != self.increment.axes() {
            if let Some(relative) = relative {
                bodies.collective_result(relative.check(bodies, axes))?;
            }
            let pressed = self.increment.pressed.try_clone()?;
            self.increment = self.problem.increment(axes, pressed)?;
            self.is_warm = false;
        }
        self.problem.load = load;
        Ok(())
    }

    /// Changes the friction of the next solve.
    ///
    /// # Errors
    /// [`Error::GridMismatch`], [`Error::NotFinite`] if the limits overflow, or [`Error::BeyondFrictionCapacity`] if
    /// the present load is more than the new friction holds; [`Error::Ranks`]; the friction is then as it was.
    pub fn set_friction(&mut self, friction: &Friction) -> Result<()> {
        friction.check_on(&self.problem.bodies)?;
        let pressure = &self.increment.pressed.pressure;
        self.problem.pressed.pressure.copy_from_slice(pressure);
        self.problem.pressed.set_friction(friction);
        self.check_load(&self.problem.pressed)?;
        self.problem.friction.try_clone_from(friction)?;
        self.take_candidate();
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
        let bodies = &self.problem.bodies;
        let samples = bodies.collective_result(pressure.into().checked(bodies))?;
        let contact = contact_window(bodies, samples)?;
        if self.increment.pressed.window().covers(contact) {
            self.problem.pressed.set(samples, &self.problem.friction);
            self.check_load(&self.problem.pressed)?;
            self.take_candidate();
            self.increment.draw(self.problem.relative.as_ref());
            return Ok(());
        }
        // A little wider than the contact, so that it may grow some more.
        let mut pressed = PressureOnWindow::new(bodies, contact.widened(bodies.grid()))?;
        pressed.set(samples, &self.problem.friction);
        self.check_load(&pressed)?;
        let candidate = pressed.try_clone()?;
        let axes = self.increment.axes();
        let mut wider = self.problem.increment(axes, pressed)?;
        self.increment.hand_over(&mut wider)?;
        (self.increment, self.problem.pressed) = (wider, candidate);
        Ok(())
    }

    /// Changes the displacement of body 1 relative to body 2 that the contact does not cause of the next solve. Allocates
    /// only if there was none.
    ///
    /// # Errors
    /// [`Error::GridMismatch`]; [`Error::UnsupportedByModel`] for one along an axis of which the model finds no traction;
    /// [`Error::Sample`] for a bulk strain along an axis on which the grid repeats; [`Error::Ranks`]; the displacement is
    /// then as it was.
    pub fn set_relative_displacement(&mut self, relative: &RelativeDisplacement) -> Result<()> {
        let bodies = &self.problem.bodies;
        bodies.collective_result(relative.check(bodies, self.increment.axes()))?;
        match &mut self.problem.relative {
            Some(own) => own.try_clone_from(relative)?,
            none => *none = Some(relative.try_clone()?),
        }
        self.increment.draw(self.problem.relative.as_ref());
        Ok(())
    }

    /// Puts pressure and limits under examination in force.
    fn take_candidate(&mut self) {
        std::mem::swap(&mut self.problem.pressed, &mut self.increment.pressed);
    }

    fn check_load(&self, pressed: &PressureOnWindow) -> Result<()> {
        let cell_area = self.problem.bodies.grid().cell_area();
        pressed
            .limits
            .check(self.problem.load.demand().force(), cell_area)
    }

    /// Largest tangential force friction holds: the integral of the friction limit.
    #[must_use]
    pub fn friction_capacity(&self) -> f64 {
        self.increment.pressed.limits.sum * self.problem.bodies.grid().cell_area()
    }

    solver_settings!(problem.settings, problem.bodies, |solver, settings| {
        solver.problem.model.check(settings)
    });

    /// Forgets the last answer: the next solve starts as the first did.
    pub fn reset(&mut self) {
        self.is_warm = false;
    }

    solver_methods!(TangentialSolution, problem.bodies);

    /// [`Self::new_solution`] where memory may run out.
    ///
    /// # Errors
    /// [`Error::Memory`].
    pub fn try_new_solution(&self) -> Result<TangentialSolution> {
        let bodies = &self.problem.bodies;
        TangentialSolution::empty(bodies)
    }

    fn solve_checked(
        &mut self,
        solution: &mut TangentialSolution,
        observer: Observer<'_>,
    ) -> Result<()> {
        let cancellation = Cancellation::default();
        let mut observer = cancellation.watch(observer);
        let mut conditions = SolveContext::new(&self.problem.settings, &mut observer);
        let start = if self.is_warm {
            Start::Present(self.increment.motion().shift)
        } else {
            Start::Nested
        };
        let demand = self.problem.load.demand();
        let outcome = self
            .increment
            .solve(&demand, RigidMotion::default(), start, &mut conditions);
        let is_answered = has_iterate(&outcome);
        // Do not warm-start from NaN.
        self.is_warm = is_answered && self.increment.report().residual.is_finite();
        self.report.clone_from(self.increment.report());
        let bodies = &self.problem.bodies;
        let outcome = cancellation.applied(bodies, outcome, || self.report.cancelled());
        if !is_answered {
            return outcome;
        }
        self.report.time = conditions.start.elapsed();
        let axis = Axis::only(self.increment.axes());
        let answer = self.increment.answer();
        let TangentialProblem {
            bodies, coupling, ..
        } = &self.problem;
        solution.fill(bodies, axis, &answer, &self.report);
        let is_drawn = coupling.is_one_way(bodies.pair());
        solution.set_pressed_at_once(is_drawn && self.increment.pressed.limits.sum > 0.0);
        self.increment.rest();
        outcome.map_err(|_| Error::NotConverged(Box::new(self.report.clone())))
    }
}
