//! Reusable solver of a tangential contact.

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

/// Solver of a sequence of tangential contacts. Each solve starts from the last solution.
///
/// The solver owns plans, buffers and the last traction, all of the size of the bounding box of the contact. Load,
/// friction and pressure may change between calls. Each solve is one monotonic step from the unsheared state and does
/// not depend on earlier slip.
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
    /// Problem to solve. Its pressure and limits are candidates for the next solve, which must pass a check before use.
    problem: TangentialProblem,
    /// Step on the bounding box of the contact, with the last traction as the start of the next solve.
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

    /// Changes the load of the next solve. A load along the other axis requires the operator of that axis. No other
    /// change of the load allocates memory.
    ///
    /// # Errors
    /// - [`Error::NotFinite`] or [`Error::NotPositive`] if a number of the load is invalid.
    /// - [`Error::ObliqueLoad`] or [`Error::UnsupportedByModel`] if the model does not support the load.
    /// - [`Error::BeyondFrictionCapacity`] if the force exceeds the friction capacity.
    /// - Errors of [`HalfSpace::operator`](crate::HalfSpace::operator) for a load along the other axis.
    /// - [`Error::Ranks`] if ranks fail or pass different loads.
    ///
    /// The load is unchanged after an error.
    pub fn set_load(&mut self, load: TangentialLoad) -> Result<()> {
        let TangentialProblem {
            bodies, relative, ..
        } = &self.problem;
        bodies.collective_result_checked(Ok(()), &[("tangential load", &load)])?;
        let (demand, boundary) = (load.demand(), bodies.boundary());
        let mut axes = load.axes(self.problem.model)?;
        // The axes remain unchanged if they support the load. They always support a zero load.
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
    /// - [`Error::GridMismatch`] if the grid differs.
    /// - [`Error::NotFinite`] if the limits overflow.
    /// - [`Error::BeyondFrictionCapacity`] if the present load exceeds the capacity of the new friction.
    /// - [`Error::Ranks`] if ranks fail or pass different friction.
    ///
    /// The friction is unchanged after an error.
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

    /// Changes the pressure of the next solve, for instance after wear or a change of the normal load. The source of
    /// the pressure is a solved normal contact or a field. The function allocates memory only if the contact has left
    /// its bounding box.
    ///
    /// # Errors
    /// - [`Error::GridMismatch`], [`Error::BoundaryMismatch`] or [`Error::MaterialMismatch`] if the pressure belongs to
    ///   other bodies.
    /// - [`Error::NotConverged`] if the normal contact has not converged.
    /// - [`Error::Sample`] if a pressure is negative or not finite.
    /// - [`Error::EmptyContact`] if no cell carries pressure.
    /// - [`Error::NotFinite`] if the limits overflow.
    /// - [`Error::BeyondFrictionCapacity`] if the present load exceeds the friction capacity under this pressure.
    /// - Errors of [`HalfSpace::operator`](crate::HalfSpace::operator) if the contact has left its bounding box.
    /// - [`Error::Ranks`] if ranks fail.
    ///
    /// The pressure is unchanged after an error.
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
        // The window is slightly wider than the contact, so that the contact can grow.
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

    /// Sets the relative displacement of the next solve, which the contact does not cause. The function allocates
    /// memory only if no such displacement was set earlier.
    ///
    /// # Errors
    /// - [`Error::GridMismatch`] if the grid differs.
    /// - [`Error::UnsupportedByModel`] if the displacement is not zero along an axis without tractions.
    /// - [`Error::Sample`] for a bulk strain along an axis in which the grid is periodic.
    /// - [`Error::Ranks`] if ranks fail.
    ///
    /// The displacement is unchanged after an error.
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

    /// Makes the candidate pressure and limits current.
    fn take_candidate(&mut self) {
        std::mem::swap(&mut self.problem.pressed, &mut self.increment.pressed);
    }

    fn check_load(&self, pressed: &PressureOnWindow) -> Result<()> {
        let cell_area = self.problem.bodies.grid().cell_area();
        pressed
            .limits
            .check(self.problem.load.demand().force(), cell_area)
    }

    /// Returns the largest tangential force that friction can carry, the integral of the friction limit.
    #[must_use]
    pub fn friction_capacity(&self) -> f64 {
        self.increment.pressed.limits.sum * self.problem.bodies.grid().cell_area()
    }

    solver_settings!(problem.settings, problem.bodies, |solver, settings| {
        solver.problem.model.check(settings)
    });

    /// Discards the last solution. The next solve starts in the same way as the first.
    pub fn reset(&mut self) {
        self.is_warm = false;
    }

    solver_methods!(TangentialSolution, problem.bodies);

    /// Creates a solution like [`Self::new_solution`], but returns an error if memory runs out.
    ///
    /// # Errors
    /// - [`Error::Memory`] if memory runs out.
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
        // The next solve must not start from NaN.
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
