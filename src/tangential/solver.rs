//! The reusable solver of a tangential contact.

use std::ops::ControlFlow;
use std::time::Instant;

use crate::cgm::{Iteration, Magnitude, Method};
use crate::error::{Error, Result};
use crate::influence::Component;
use crate::normal::NormalSolution;
use crate::report::Report;
use crate::stage::{Nested, Observer, Stage, nested_start, with_memory, with_time_left};
use crate::tangential::nested::FrictionScene;
use crate::tangential::problem::{Limits, contact_window};
use crate::tangential::solution::Answer;
use crate::tangential::{Axis, Friction, TangentialLoad, TangentialProblem, TangentialSolution};

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
#[derive(Debug)]
pub struct TangentialSolver {
    problem: TangentialProblem,
    axis: Axis,
    /// The engine on the contact's bounding box, with the last traction, the start of the next.
    stage: Stage,
    is_warm: bool,
    report: Report,
    /// Limits under examination, not yet in force.
    spare: Limits,
    spare_pressure: Vec<f64>,
}

impl TangentialSolver {
    pub(super) fn new(problem: TangentialProblem) -> Result<Self> {
        let (axis, _) = problem.load.along()?;
        Ok(Self {
            stage: stage(&problem, axis)?,
            axis,
            is_warm: false,
            report: Report::unsolved(),
            spare: problem.limits.clone(),
            spare_pressure: problem.pressure.clone(),
            problem,
        })
    }

    /// Changes the load of the next solve. A load along the other axis brings in that axis's
    /// operator, the one change that allocates.
    ///
    /// # Errors
    /// [`Error::NotFinite`], [`Error::ObliqueLoad`] or [`Error::BeyondSliding`]; the load is then
    /// as it was.
    pub fn set_load(&mut self, load: TangentialLoad) -> Result<()> {
        let (axis, value) = load.along()?;
        let cell_area = self.problem.bodies.grid().cell_area();
        self.problem.limits.check(load, cell_area)?;
        if axis != self.axis && value != 0.0 {
            self.stage = stage(&self.problem, axis)?;
            self.axis = axis;
            self.is_warm = false;
        }
        self.problem.load = load;
        Ok(())
    }

    /// Changes the friction of the next solve.
    ///
    /// # Errors
    /// [`Error::GridMismatch`], or [`Error::BeyondSliding`] if the present load is more than the
    /// new friction holds; the friction is then as it was.
    pub fn set_friction(&mut self, friction: &Friction) -> Result<()> {
        let grid = self.problem.bodies.grid();
        friction.check(grid)?;
        self.spare
            .set(friction, self.problem.window, &self.problem.pressure);
        self.spare.check(self.problem.load, grid.cell_area())?;
        std::mem::swap(&mut self.spare, &mut self.problem.limits);
        self.problem.friction.copy_from(friction);
        Ok(())
    }

    /// Changes the pressure of the next solve, as wear or another normal load does. Allocates only if
    /// the contact has left the bounding box it had.
    ///
    /// # Errors
    /// [`Error::GridMismatch`], [`Error::NotConverged`], [`Error::EmptyContact`], or
    /// [`Error::BeyondSliding`] if the present load is more than friction now holds; the pressure is
    /// then as it was.
    pub fn set_normal(&mut self, normal: &NormalSolution) -> Result<()> {
        let contact = contact_window(&self.problem.bodies, normal)?;
        let cell_area = self.problem.bodies.grid().cell_area();
        let samples = normal.pressure().as_slice();
        let problem = &mut self.problem;
        if problem.window.union(contact) == problem.window {
            self.spare_pressure.resize(problem.window.cells(), 0.0);
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
        let mut stage = Stage::new(&problem.bodies, component(self.axis), window.size)?;
        let mut traction = vec![0.0; problem.bodies.grid().cells()];
        problem.window.scatter(&self.stage.x, &mut traction);
        window.gather(&traction, &mut stage.x);
        self.stage = stage;
        self.spare = limits.clone();
        (problem.window, problem.pressure, problem.limits) = (window, pressure, limits);
        Ok(())
    }

    /// Largest tangential force friction holds: the integral of the friction limit.
    #[must_use]
    pub fn sliding_force(&self) -> f64 {
        self.problem.sliding_force()
    }

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
    /// [`Error::GridMismatch`] if the solution is of another grid, nothing changed;
    /// [`Error::NotConverged`] with the last feasible iterate in `solution`.
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
        let (_, value) = self.problem.load.along()?;
        let (prescribed_shift, total) = match self.problem.load {
            TangentialLoad::Force(_) => (0.0, Some(limits.total(value, grid.cell_area()))),
            TangentialLoad::Shift(_) => (value, None),
        };
        self.stage.linear.fill(-prescribed_shift);
        if !self.is_warm {
            self.start_cold(value, total, start, &mut observer)?;
        }

        let limits = &self.problem.limits;
        let settings = with_time_left(&self.problem.settings, start);
        let constraint = Magnitude(&limits.cells);
        let outcome = self
            .stage
            .minimise(constraint, total, &settings, &mut observer);
        self.is_warm = matches!(outcome, Ok(()) | Err(Error::NotConverged(_)));
        if !self.is_warm {
            return outcome;
        }
        self.report.clone_from(self.stage.report());
        self.report.time = start.elapsed();
        solution.fill(&Answer {
            window: self.problem.window,
            axis: self.axis,
            pressure: &self.problem.pressure,
            limits: &limits.cells,
            traction: &self.stage.x,
            displacement: self.stage.product(),
            shift: prescribed_shift + self.stage.multiplier(),
            report: &self.report,
        });
        outcome.map_err(|_| Error::NotConverged(Box::new(self.report.clone())))
    }

    /// From nothing: the answer on coarser cells, unless it is known or another method is asked for.
    fn start_cold(
        &mut self,
        value: f64,
        total: Option<f64>,
        start: Instant,
        observer: Observer<'_>,
    ) -> Result<()> {
        let TangentialProblem {
            bodies,
            window,
            limits,
            settings,
            ..
        } = &self.problem;
        if value == 0.0 || limits.sum <= 0.0 {
            self.stage.x.fill(0.0);
            return Ok(());
        }
        let scene = FrictionScene {
            limits: limits.cells.clone(),
            linear: self.stage.linear.clone(),
        };
        let is_sliding = total.is_some_and(|total| total.abs() >= limits.sum);
        self.stage.x = if settings.method == Method::PolonskyKeer || is_sliding {
            scene.plain_start(total)
        } else {
            let settings = with_time_left(settings, start);
            let component = component(self.axis);
            nested_start(
                bodies,
                component,
                window.size,
                &scene,
                total,
                &settings,
                observer,
            )?
        };
        Ok(())
    }
}

/// The influence coefficient of tractions along an axis for displacements along it.
pub(crate) fn component(axis: Axis) -> Component {
    match axis {
        Axis::X => Component::XX,
        Axis::Y => Component::YY,
    }
}

/// The engine for one axis on the window of the contact.
fn stage(problem: &TangentialProblem, axis: Axis) -> Result<Stage> {
    Stage::new(&problem.bodies, component(axis), problem.window.size)
}
