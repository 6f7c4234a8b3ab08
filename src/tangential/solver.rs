//! Reusable solver of a tangential contact.

use crate::cgm::Settings;
use crate::contact::{
    Cancellation, Contact, Model, SolveContext, Solver, has_iterate, model_fields,
};
use crate::error::{Error, Result};
use crate::memory::fallible::{self, TryClone};
use crate::observer::Observer;
use crate::report::Report;
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
/// let normal = NormalProblem::builder(&bodies, &ball, NormalLoad::Force(0.5)).build()?.solve()?;
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
pub type TangentialSolver = Solver<TangentialProblem>;

/// Engine of a tangential contact. The pressure and the limits of the problem are candidates for the next solve, which must
/// pass a check before use.
#[derive(Clone)]
pub(crate) struct TangentialBuffers {
    /// Step on the bounding box of the contact, with the last traction as the start of the next solve.
    increment: TangentialIncrement,
    is_warm: bool,
    report: Report,
}

impl TangentialSolver {
    /// Changes the load of the next solve. The new load replaces the earlier load along both axes and its twist. A load along the
    /// other axis requires the operator of that axis. No other change of the load allocates memory.
    ///
    /// Each solve starts from zero slip, so it does not continue from the previous load. A [`History`](crate::History) computes
    /// sequences of loads with memory of slip.
    ///
    /// # Errors
    /// - [`Error::NotFinite`] or [`Error::NotPositive`] if a number of the load is invalid.
    /// - [`Error::ObliqueLoad`] or [`Error::UnsupportedByModel`] if the model does not support the load, or if a spring is too long.
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
        let demand = load.demand();
        let mut axes = load.axes(self.problem.model)?;
        // The axes remain unchanged if they support the load. They always support a zero load.
        let check = |axes| demand.check(axes, bodies, [0.0; 2]);
        if check(self.engine.increment.axes()).is_ok() {
            axes = self.engine.increment.axes();
        }
        check(axes)?;
        let limits = &self.engine.increment.pressed.limits;
        limits.check(demand.force(), bodies.grid().cell_area())?;
        if axes != self.engine.increment.axes() {
            if let Some(relative) = relative {
                bodies.collective_result(relative.check(bodies, axes))?;
            }
            let pressed = self.engine.increment.pressed.try_clone()?;
            self.engine.increment = self.problem.increment(axes, pressed)?;
            self.engine.is_warm = false;
        }
        self.problem.load = load;
        Ok(())
    }

    /// Returns the friction of the next solve, with its cap: the last friction that was given or [set](Self::set_friction).
    #[must_use]
    pub fn friction(&self) -> &Friction {
        &self.problem.friction
    }

    /// Changes the friction of the next solve. The new friction replaces the earlier coefficient and the earlier cap.
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
        let pressure = &self.engine.increment.pressed.pressure;
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
        let (bodies, source) = (&self.problem.bodies, pressure.into());
        let samples = bodies.collective_result(source.checked(bodies))?;
        let contact = contact_window(bodies, samples)?;
        if self.engine.increment.pressed.window().covers(contact) {
            self.problem.pressed.set(samples, &self.problem.friction);
            self.check_load(&self.problem.pressed)?;
            self.take_candidate();
            self.problem.is_prescribed = source.is_prescribed();
            self.engine.increment.draw(self.problem.relative.as_ref());
            return Ok(());
        }
        // The window is slightly wider than the contact, so that the contact can grow.
        let mut pressed = PressureOnWindow::new(bodies, contact.widened(bodies.grid()))?;
        pressed.set(samples, &self.problem.friction);
        self.check_load(&pressed)?;
        let candidate = pressed.try_clone()?;
        let axes = self.engine.increment.axes();
        let mut wider = self.problem.increment(axes, pressed)?;
        self.engine.increment.hand_over(&mut wider)?;
        (self.engine.increment, self.problem.pressed) = (wider, candidate);
        self.problem.is_prescribed = source.is_prescribed();
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
        bodies.collective_result(relative.check(bodies, self.engine.increment.axes()))?;
        fallible::replace(&mut self.problem.relative, relative)?;
        self.engine.increment.draw(self.problem.relative.as_ref());
        Ok(())
    }

    /// Returns the pressure and the limits of the next solve.
    pub(crate) fn pressed(&self) -> &PressureOnWindow {
        &self.engine.increment.pressed
    }

    /// Makes the candidate pressure and limits current.
    fn take_candidate(&mut self) {
        std::mem::swap(
            &mut self.problem.pressed,
            &mut self.engine.increment.pressed,
        );
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
        self.engine.increment.pressed.limits.sum * self.problem.bodies.grid().cell_area()
    }
}

impl Contact for TangentialProblem {
    type Solution = TangentialSolution;
    type Report = Report;
}

impl Model<TangentialSolution> for TangentialProblem {
    type Engine = TangentialBuffers;

    model_fields!(settings);

    fn check_settings(&self, settings: &Settings) -> Result<()> {
        self.model.check(settings)
    }

    fn engine(&self) -> Result<TangentialBuffers> {
        let axes = self.load.axes(self.model)?;
        Ok(TangentialBuffers {
            increment: self.increment(axes, self.pressed.try_clone()?)?,
            is_warm: false,
            report: Report::with_room(),
        })
    }

    fn empty_solution(&self) -> Result<TangentialSolution> {
        TangentialSolution::empty(&self.bodies)
    }

    fn check_solution(&self, solution: &TangentialSolution) -> Result<()> {
        let (grid, boundary) = (solution.grid(), solution.boundary());
        self.bodies.check_host("solution", grid, boundary)
    }

    fn solve(
        solver: &mut TangentialSolver,
        solution: &mut TangentialSolution,
        observer: Observer<'_>,
    ) -> Result<()> {
        let TangentialSolver { problem, engine } = solver;
        let cancellation = Cancellation::default();
        let mut observer = cancellation.watch(&problem.settings, observer);
        let mut conditions = SolveContext::new(&problem.settings, &mut observer);
        let start = if engine.is_warm {
            Start::Present(engine.increment.motion().shift)
        } else {
            Start::Nested
        };
        let demand = problem.load.demand();
        let outcome =
            engine
                .increment
                .solve(&demand, RigidMotion::default(), start, &mut conditions);
        let is_answered = has_iterate(&outcome);
        // The next solve must not start from NaN.
        engine.is_warm = is_answered && engine.increment.report().residual.is_finite();
        engine.report.clone_from(engine.increment.report());
        let bodies = &problem.bodies;
        let outcome = cancellation.applied(bodies, outcome, || engine.report.cancelled());
        if !is_answered {
            return outcome;
        }
        engine.report.time = conditions.start.elapsed();
        let axis = Axis::only(engine.increment.axes());
        let answer = engine.increment.answer();
        let input = (axis, &problem.friction, problem.relative.as_ref());
        solution.fill(bodies, input, &answer, &engine.report);
        let is_drawn = problem.coupling.is_one_way(bodies.pair());
        solution.set_neglected_traction(answer.neglected_traction(bodies, problem.coupling));
        solution.set_pressed_at_once(is_drawn && engine.increment.pressed.limits.sum > 0.0);
        let of_pressure = || engine.increment.pressed.pressure_warning(bodies);
        solution.set_pressure_warning(problem.is_prescribed.then(of_pressure).flatten());
        engine.increment.rest();
        outcome.map_err(|_| Error::NotConverged(Box::new(engine.report.clone())))
    }

    fn report(solver: &TangentialSolver) -> &Report {
        &solver.engine.report
    }

    fn reset(solver: &mut TangentialSolver) {
        solver.engine.is_warm = false;
    }
}
