//! The reusable solver of a normal contact.

use std::ops::ControlFlow;

use crate::cgm::{self, Iteration, Method, NonNegative, solver_settings};
use crate::clock::Instant;
use crate::error::{Error, Result};
use crate::fft::ConvolutionWorkspace;
use crate::field::Field;
use crate::half_space::{ElasticOperator, HalfSpace};
use crate::influence::{Component, Direction};
use crate::normal::nested::PressureScene;
use crate::normal::problem::check_gap;
use crate::normal::{NormalLoad, NormalProblem, NormalSolution};
use crate::operator::Operator;
use crate::parallel;
use crate::report::{Report, Status};
use crate::stage::{
    Nested, Observer, Stage, may_go_on, nested_start, with_counts_of, with_limits_left, with_memory,
};
use crate::window::Window;

/// Solves normal contacts on one grid again and again, each time from the last answer.
///
/// Owns plans, buffers and the last pressure; the load and the gap may change between calls.
///
/// ```
/// use stickslip::{ElasticPair, Grid, HalfSpace, Material, NormalLoad, NormalProblem, surface};
/// let grid = Grid::square(32, 8.0)?;
/// let bodies = HalfSpace::new(grid, ElasticPair::new(Material::new(1.0, 0.3)?, Material::rigid())?)?;
/// let ball = surface::sphere(grid, 10.0)?;
/// let mut solver = NormalProblem::builder(&bodies, &ball, NormalLoad::Force(0.5)).build()?.into_solver()?;
/// let mut contact = solver.new_solution();
/// for force in [0.5, 1.0, 0.7] {
///     solver.set_load(NormalLoad::Force(force))?;
///     solver.solve_into(&mut contact)?;
///     assert!((contact.force() - force).abs() < 1e-12);
/// }
/// # Ok::<(), stickslip::Error>(())
/// ```
#[derive(Debug, Clone)]
pub struct NormalSolver {
    problem: NormalProblem,
    /// What the last solve worked with; `None` before the first.
    engine: Option<Engine>,
    /// The last pressure on the whole grid, the start of the next solve.
    pressure: Vec<f64>,
    /// The gap from its least value, or from the approach where that is prescribed.
    linear: Vec<f64>,
    report: Report,
}

/// The engine, set up where it works: around the contact, if that is much smaller than the grid.
#[derive(Debug, Clone)]
struct Engine {
    window: Window,
    stage: Stage,
    /// What it takes to see the rest of the grid, if there is a rest.
    whole: Option<Whole>,
}

#[derive(Debug, Clone)]
struct Whole {
    operator: ElasticOperator,
    workspace: ConvolutionWorkspace,
    displacement: Vec<f64>,
}

impl Engine {
    /// On a window, or on the whole grid if it repeats or the window saves too little.
    fn new(bodies: &HalfSpace, window: Window) -> Result<Self> {
        let (window, whole) = (bodies.confined(window), Window::whole(bodies.grid()));
        let is_whole = 5 * window.cells() > 4 * whole.cells();
        let window = if is_whole { whole } else { window };
        let whole = if is_whole {
            None
        } else {
            let operator = bodies.operator(Component::ZZ)?;
            Some(Whole {
                workspace: operator.workspace(),
                displacement: vec![0.0; operator.cells()],
                operator,
            })
        };
        Ok(Self {
            window,
            stage: Stage::new(bodies, Direction::Z, window.size)?,
            whole,
        })
    }

    /// The displacement of the whole grid.
    fn displacement(&self) -> &[f64] {
        match &self.whole {
            Some(whole) => &whole.displacement,
            None => self.stage.product(),
        }
    }
}

impl NormalSolver {
    pub(super) fn new(problem: NormalProblem) -> Result<Self> {
        let cells = problem.gap.grid().cells();
        // A kernel that cannot be had is better known now.
        problem.bodies.operator(Component::ZZ)?;
        Ok(Self {
            problem,
            engine: None,
            pressure: vec![0.0; cells],
            linear: vec![0.0; cells],
            report: Report::with_room(),
        })
    }

    /// Changes the load of the next solve.
    ///
    /// # Errors
    /// [`Error::Negative`], [`Error::NotFinite`] or, on a periodic grid,
    /// [`Error::ApproachBeyondMeanGap`]; the load is then as it was.
    pub fn set_load(&mut self, load: NormalLoad) -> Result<()> {
        load.check(&self.problem.bodies, &self.problem.gap)?;
        self.problem.load = load;
        Ok(())
    }

    /// Changes the gap of the next solve, as wear does; copies it without allocating.
    ///
    /// # Errors
    /// [`Error::GridMismatch`], [`Error::Sample`] or, on a periodic grid,
    /// [`Error::ApproachBeyondMeanGap`]; the gap is then as it was.
    pub fn set_gap(&mut self, gap: &Field) -> Result<()> {
        check_gap(&self.problem.bodies, gap)?;
        self.problem.load.check(&self.problem.bodies, gap)?;
        self.problem
            .gap
            .as_mut_slice()
            .copy_from_slice(gap.as_slice());
        Ok(())
    }

    /// The gap before loading.
    pub(crate) fn gap(&self) -> &Field {
        &self.problem.gap
    }

    /// Where the engine works; `None` before the first solve.
    pub(crate) fn window(&self) -> Option<Window> {
        self.engine.as_ref().map(|engine| engine.window)
    }

    /// Goes on as after the solve that found this pressure, on the window it ended with.
    pub(crate) fn resume(&mut self, pressure: &[f64], window: Option<Window>) -> Result<()> {
        self.pressure.copy_from_slice(pressure);
        if self.window() != window {
            let remake = |window| Engine::new(&self.problem.bodies, window);
            self.engine = window.map(remake).transpose()?;
        }
        Ok(())
    }

    solver_settings!();

    /// Forgets the last answer: the next solve starts as the first did.
    pub fn reset(&mut self) {
        self.engine = None;
    }

    /// An empty solution of the right size for [`NormalSolver::solve_into`].
    #[must_use]
    pub fn new_solution(&self) -> NormalSolution {
        NormalSolution::empty(&self.problem.gap, &self.problem.bodies)
    }

    /// Solves into `solution`, whose last content does not matter.
    ///
    /// # Errors
    /// [`Error::GridMismatch`] or [`Error::BoundaryMismatch`] if the solution is of another grid or boundary, nothing
    /// changed; as [`HalfSpace::operator`]; [`Error::NotConverged`] with the last feasible iterate in `solution`.
    pub fn solve_into(&mut self, solution: &mut NormalSolution) -> Result<()> {
        self.solve_observed(solution, |_| ControlFlow::Continue(()))
    }

    /// [`NormalSolver::solve_into`] with an observer that sees every step and may cancel.
    ///
    /// # Errors
    /// As [`NormalSolver::solve_into`].
    pub fn solve_observed(
        &mut self,
        solution: &mut NormalSolution,
        mut observer: impl FnMut(&Iteration) -> ControlFlow<()> + Send,
    ) -> Result<()> {
        let gap = &self.problem.gap;
        let bodies = &self.problem.bodies;
        bodies.check_host("solution", solution.grid(), solution.boundary())?;
        let start = Instant::now();
        let mut observer = with_memory(&mut observer);
        // Without a datum far from the contact the sums keep their last digits.
        let (datum, total) = match self.problem.load {
            NormalLoad::Force(force) => (gap.min(), Some(force / gap.grid().cell_area())),
            NormalLoad::Approach(approach) => (approach, None),
        };
        let samples = gap.as_slice();
        parallel::update(&mut self.linear, |first, chunk| {
            for (linear, gap) in chunk.iter_mut().zip(&samples[first..]) {
                *linear = gap - datum;
            }
        });
        let is_cold = self.engine.is_none();
        let mut engine = match self.engine.take() {
            Some(engine) => engine,
            None => self.start_cold(total, start, &mut observer)?,
        };
        let outcome = self.solve_on_window(&mut engine, total, start, &mut observer);
        if !matches!(outcome, Ok(()) | Err(Error::NotConverged(_))) {
            return outcome;
        }
        self.report.time = start.elapsed();
        let approach = datum + engine.stage.multiplier();
        let displacement = engine.displacement();
        solution.fill(
            self.problem.bodies.pair(),
            &self.problem.gap,
            &self.pressure,
            displacement,
            approach,
            &self.report,
        );
        // From numbers that are none there is no start, and a first solve without contact has not found where to
        // work.
        let touches = self.pressure.iter().any(|&p| p > 0.0);
        let is_start = self.report.certified_gap.is_finite() && (touches || !is_cold);
        self.engine = is_start.then_some(engine);
        outcome.map_err(|_| Error::NotConverged(Box::new(self.report.clone())))
    }

    /// From nothing: the answer on coarser cells, and the engine set up around its contact.
    fn start_cold(
        &mut self,
        total: Option<f64>,
        start: Instant,
        observer: Observer<'_>,
    ) -> Result<Engine> {
        let NormalProblem {
            bodies, settings, ..
        } = &self.problem;
        let (grid, whole) = (bodies.grid(), Window::whole(bodies.grid()));
        let scene = PressureScene {
            linear: self.linear.clone(),
        };
        if settings.method == Method::PolonskyKeer {
            self.pressure = scene.plain_start(total);
            return Engine::new(bodies, whole);
        }
        self.pressure = nested_start(bodies, whole.size, &scene, total, settings, start, observer)?;
        match Window::around(grid, |i| self.pressure[i] > 0.0) {
            Some(contact) => Engine::new(bodies, contact.widened(grid)),
            None => Engine::new(bodies, whole),
        }
    }

    /// Solves on the window and looks at the whole grid; where bodies overlap beyond the window it
    /// was too small, and the work goes on in a larger one.
    fn solve_on_window(
        &mut self,
        engine: &mut Engine,
        total: Option<f64>,
        start: Instant,
        observer: Observer<'_>,
    ) -> Result<()> {
        let NormalProblem {
            bodies, settings, ..
        } = &self.problem;
        let mut aim = settings.tolerance;
        self.report.clone_from(&Report::unsolved());
        loop {
            let Engine {
                window,
                stage,
                whole,
            } = &mut *engine;
            window.gather(&self.linear, &mut stage.linear);
            window.gather(&self.pressure, &mut stage.x);
            let left = with_limits_left(settings, start, &self.report).tolerance(aim);
            let outcome = stage.minimise(
                NonNegative,
                total,
                &left,
                &mut with_counts_of(&self.report, observer),
            );
            if !matches!(outcome, Ok(()) | Err(Error::NotConverged(_))) {
                return outcome;
            }
            self.pressure.fill(0.0);
            window.scatter(&stage.x, &mut self.pressure);
            self.report.go_on(stage.report());
            let Some(Whole {
                operator,
                workspace,
                displacement,
            }) = whole
            else {
                return outcome;
            };

            operator.apply([&self.pressure], [displacement], workspace);
            self.report.convolutions += 1;
            let multiplier = stage.multiplier();
            let findings = cgm::examine(
                &self.pressure,
                displacement,
                &self.linear,
                &NonNegative,
                total,
                multiplier,
                operator.lower_bound(),
            );
            findings.write_to(&mut self.report);
            // What has stalled may have done so because the contact is elsewhere.
            if !matches!(self.report.status, Status::Converged | Status::Stalled) {
                return outcome;
            }

            let round_off = ROUND_OFF * findings.displacement;
            let overlaps = |i: usize| {
                displacement[i] + self.linear[i] - multiplier < -round_off && !window.contains(i)
            };
            let missed = Window::around(bodies.grid(), overlaps);
            if missed.is_none() && (outcome.is_err() || self.report.is_within(settings.tolerance)) {
                return outcome;
            }
            // While the engine can still show what the iterate does.
            may_go_on(settings, &mut self.report)?;
            if let Some(missed) = missed {
                let wider = window.union(missed).widened(bodies.grid());
                *engine = Engine::new(bodies, wider)?;
            } else if aim < 0.1 * settings.tolerance {
                self.report.status = Status::Stalled;
                return Err(Error::NotConverged(Box::new(self.report.clone())));
            } else {
                // The bound for the whole grid is a little wider than that for the window.
                aim *= 0.5;
            }
        }
    }
}

/// Overlap beyond the window, relative to the largest displacement, that a product may show by itself.
const ROUND_OFF: f64 = 1e-13;
