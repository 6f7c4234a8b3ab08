//! The reusable solver of a tangential contact.

use std::ops::ControlFlow;

use crate::cgm::{Iteration, solver_settings};
use crate::clock::Instant;
use crate::error::{Error, Result};
use crate::report::Report;
use crate::stage::with_memory;
use crate::tangential::pressure::contact_window;
use crate::tangential::problem::Limits;
use crate::tangential::shear::{Demand, Shear};
use crate::tangential::solution::Answer;
use crate::tangential::{
    Axis, Friction, Pressure, TangentialLoad, TangentialProblem, TangentialSolution,
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
/// let normal = NormalProblem::builder(&bodies, &ball, NormalLoad::Force(0.5)).build()?.solve()?;
/// let friction = Friction::coulomb(0.3)?;
/// let mut solver =
///     TangentialProblem::builder(&bodies, &normal, friction, TangentialLoad::Force([0.0, 0.0]))
///         .build()?
///         .into_solver()?;
/// let mut shear = solver.new_solution();
/// let mut stick = Vec::new();
/// for force in [0.0, 0.05, 0.10, 0.149] {
///     solver.set_load(TangentialLoad::Force([0.0, force]))?;
///     solver.solve_into(&mut shear)?;
///     stick.push(shear.stick_ratio());
/// }
/// assert!(stick[0] == 1.0 && stick.is_sorted_by(|a, b| a > b));
/// # Ok::<(), Error>(())
/// ```
#[derive(Debug, Clone)]
pub struct TangentialSolver {
    problem: TangentialProblem,
    /// The engine on the contact's bounding box, with the last traction, the start of the next.
    shear: Shear,
    is_warm: bool,
    report: Report,
    /// Limits under examination, not yet in force.
    spare: Limits,
    spare_pressure: Vec<f64>,
}

impl TangentialSolver {
    pub(super) fn new(problem: TangentialProblem) -> Result<Self> {
        Ok(Self {
            shear: Shear::new(&problem)?,
            is_warm: false,
            report: Report::with_room(),
            spare: problem.limits.clone(),
            spare_pressure: problem.pressure.clone(),
            problem,
        })
    }

    /// Changes the load of the next solve. A load along the other axis brings in that axis's
    /// operator, the one change that allocates.
    ///
    /// # Errors
    /// [`Error::NotFinite`], [`Error::ObliqueLoad`] or [`Error::BeyondSliding`]; for one along the other axis as
    /// [`HalfSpace::operator`](crate::HalfSpace::operator); the load is then as it was.
    pub fn set_load(&mut self, load: TangentialLoad) -> Result<()> {
        self.problem.lateral.check(load)?;
        let cell_area = self.problem.bodies.grid().cell_area();
        self.problem.limits.check(load, cell_area)?;
        let last = std::mem::replace(&mut self.problem.load, load);
        // A solver at rest keeps its axis.
        let turns = match (self.shear.axis(), load.along()) {
            (Some(own), Ok((axis, value))) => axis != own && value != 0.0,
            _ => false,
        };
        if turns {
            match Shear::new(&self.problem) {
                Ok(shear) => self.shear = shear,
                Err(error) => {
                    self.problem.load = last;
                    return Err(error);
                }
            }
            self.is_warm = false;
        }
        Ok(())
    }

    /// Changes the friction of the next solve.
    ///
    /// # Errors
    /// [`Error::GridMismatch`], [`Error::NotFinite`] if the limits overflow, or [`Error::BeyondSliding`] if the present
    /// load is more than the new friction holds; the friction is then as it was.
    pub fn set_friction(&mut self, friction: &Friction) -> Result<()> {
        let grid = self.problem.bodies.grid();
        friction.check(grid)?;
        self.spare
            .set(friction, self.problem.window, &self.problem.pressure);
        self.spare.check(self.problem.load, grid.cell_area())?;
        std::mem::swap(&mut self.spare, &mut self.problem.limits);
        self.problem.friction.clone_from(friction);
        Ok(())
    }

    /// Changes the pressure of the next solve to that of a solved normal contact or a field, as wear or another
    /// normal load does. Allocates only if the contact has left the bounding box it had.
    ///
    /// # Errors
    /// [`Error::GridMismatch`], [`Error::BoundaryMismatch`], [`Error::MaterialMismatch`],
    /// [`Error::NotConverged`], [`Error::Sample`], [`Error::EmptyContact`], [`Error::NotFinite`] if the limits
    /// overflow, or [`Error::BeyondSliding`] if the present load is more than friction now holds; as
    /// [`HalfSpace::operator`](crate::HalfSpace::operator) where the contact has left its box; the pressure is then as
    /// it was.
    pub fn set_pressure<'a>(&mut self, pressure: impl Into<Pressure<'a>>) -> Result<()> {
        let samples = pressure.into().checked(&self.problem.bodies)?;
        let contact = contact_window(&self.problem.bodies, samples)?;
        let cell_area = self.problem.bodies.grid().cell_area();
        let problem = &mut self.problem;
        if problem.window.covers(contact) {
            problem.window.gather(samples, &mut self.spare_pressure);
            self.spare
                .set(&problem.friction, problem.window, &self.spare_pressure);
            self.spare.check(problem.load, cell_area)?;
            std::mem::swap(&mut self.spare, &mut problem.limits);
            std::mem::swap(&mut self.spare_pressure, &mut problem.pressure);
            return Ok(());
        }
        // A little wider than the contact, so that it may grow some more.
        let window = contact.widened(problem.bodies.grid());
        let mut pressure = vec![0.0; window.cells()];
        window.gather(samples, &mut pressure);
        let mut limits = Limits::new(window.cells());
        limits.set(&problem.friction, window, &pressure);
        limits.check(problem.load, cell_area)?;
        let old = std::mem::replace(&mut problem.window, window);
        let mut shear = match Shear::of_axis(problem, self.shear.axis()) {
            Ok(shear) => shear,
            Err(error) => {
                problem.window = old;
                return Err(error);
            }
        };
        let mut whole = vec![0.0; problem.bodies.grid().cells()];
        let tractions = self
            .shear
            .tractions()
            .into_iter()
            .zip(shear.tractions_mut());
        for (last, next) in tractions.filter_map(|(last, next)| last.zip(next)) {
            whole.fill(0.0);
            old.scatter(last, &mut whole);
            window.gather(&whole, next);
        }
        self.shear = shear;
        (self.spare, self.spare_pressure) = (limits.clone(), pressure.clone());
        (problem.pressure, problem.limits) = (pressure, limits);
        Ok(())
    }

    /// Largest tangential force friction holds: the integral of the friction limit.
    #[must_use]
    pub fn sliding_force(&self) -> f64 {
        self.problem.sliding_force()
    }

    solver_settings!();

    /// Forgets the last answer: the next solve starts as the first did.
    pub fn reset(&mut self) {
        self.is_warm = false;
    }

    /// An empty solution of the right size for [`TangentialSolver::solve_into`].
    #[must_use]
    pub fn new_solution(&self) -> TangentialSolution {
        let bodies = &self.problem.bodies;
        TangentialSolution::empty(bodies.grid(), bodies.boundary())
    }

    /// Solves into `solution`, whose last content does not matter.
    ///
    /// # Errors
    /// [`Error::GridMismatch`] or [`Error::BoundaryMismatch`] if the solution is of another grid or boundary, nothing
    /// changed; as [`HalfSpace::operator`](crate::HalfSpace::operator); [`Error::NotConverged`] with the last feasible
    /// iterate in `solution`.
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
        let bodies = &self.problem.bodies;
        bodies.check_host("solution", solution.grid(), solution.boundary())?;
        let grid = bodies.grid();
        let start = Instant::now();
        let mut observer = with_memory(&mut observer);
        let limits = &self.problem.limits;
        let demand = match self.problem.load {
            TangentialLoad::Force(force) => Demand {
                totals: self.prescribed(limits.totals(force, grid.cell_area())),
                shift: [0.0; 2],
            },
            TangentialLoad::Shift(shift) => Demand {
                totals: [None, None],
                shift,
            },
        };
        self.shear.set_shift(demand.shift);
        if !self.is_warm {
            self.shear
                .start_cold(&self.problem, demand, start, &mut observer)?;
        }

        let outcome = self
            .shear
            .minimise(&self.problem, demand, start, &mut observer);
        let is_answered = matches!(outcome, Ok(()) | Err(Error::NotConverged(_)));
        // From numbers that are none there is no start.
        self.is_warm = is_answered && self.shear.report().residual.is_finite();
        if !is_answered {
            return outcome;
        }
        self.report.clone_from(self.shear.report());
        self.report.time = start.elapsed();
        let multiplier = self.shear.multiplier();
        solution.fill(&Answer {
            window: self.problem.window,
            pressure: &self.problem.pressure,
            limits: &self.problem.limits.cells,
            shear: &self.shear,
            shift: [0, 1].map(|axis| demand.shift[axis] + multiplier[axis]),
            report: &self.report,
        });
        outcome.map_err(|_| Error::NotConverged(Box::new(self.report.clone())))
    }

    /// The totals the model carries.
    fn prescribed(&self, [x, y]: [f64; 2]) -> [Option<f64>; 2] {
        match self.shear.axis() {
            Some(Axis::X) => [Some(x), None],
            Some(Axis::Y) => [None, Some(y)],
            None => [Some(x), Some(y)],
        }
    }
}
