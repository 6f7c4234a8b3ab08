//! The reusable solver of a normal contact.

use std::ops::ControlFlow;
use std::sync::Arc;

use crate::cascade::{Conditions, Scene, nested_start};
use crate::cgm::reduce;
use crate::cgm::{Iteration, Known, Method, Total, solver_settings};
use crate::clock::Instant;
use crate::elastic::Observer;
use crate::error::{Error, Result};
use crate::field::Field;
use crate::influence::Direction;
use crate::normal::engine::{Engine, Load};
use crate::normal::nested::PressureScene;
use crate::normal::problem::check_gap;
use crate::normal::{NormalControl, NormalProblem, NormalSolution};
use crate::parallel;
use crate::passes::{check_iterations_left, with_counts_of, with_limits_left, with_memory};
use crate::report::{Report, Status};
use crate::trend::{Ahead, Reached, Trend};
use crate::window::Window;

/// Solves normal contacts on one grid again and again, each time from the last answer, moved on along its trend where the
/// load has changed.
///
/// Owns plans, buffers and the last pressure; the load and the gap may change between calls.
///
/// ```
/// use stickslip::{ElasticPair, Grid, HalfSpace, Material, NormalControl, NormalProblem, surface};
/// let grid = Grid::square(32, 8.0)?;
/// let bodies = HalfSpace::new(grid, ElasticPair::new(Material::new(1.0, 0.3)?, Material::rigid())?)?;
/// let ball = surface::sphere(grid, 10.0)?;
/// let mut solver = NormalProblem::builder(&bodies, &ball, NormalControl::Force(0.5)).build()?.into_solver()?;
/// let mut contact = solver.new_solution();
/// for force in [0.5, 1.0, 0.7] {
///     solver.set_load(NormalControl::Force(force))?;
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
    /// The approach that belongs to it.
    approach: f64,
    least_gap: f64,
    report: Report,
}

impl NormalSolver {
    pub(super) fn new(problem: NormalProblem) -> Result<Self> {
        let grid = problem.bodies.grid();
        // A kernel that cannot be computed is better known now.
        problem
            .bodies
            .compliance([Direction::Z], [grid.nx(), grid.ny()])?;
        Ok(Self {
            least_gap: problem.gap.min(),
            problem,
            engine: None,
            pressure: vec![0.0; grid.cells()],
            approach: 0.0,
            report: Report::with_room(),
        })
    }

    /// Changes the load of the next solve.
    ///
    /// # Errors
    /// [`Error::Negative`], [`Error::NotFinite`] or, on a periodic grid,
    /// [`Error::ApproachBeyondMeanGap`]; the load is then as it was.
    pub fn set_load(&mut self, load: NormalControl) -> Result<()> {
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
        Arc::make_mut(&mut self.problem.gap)
            .as_mut_slice()
            .copy_from_slice(gap.as_slice());
        self.least_gap = gap.min();
        Ok(())
    }

    /// Where the engine works; `None` before the first solve.
    pub(crate) fn window(&self) -> Option<Window> {
        self.engine.as_ref().map(|engine| engine.window)
    }

    /// How the pressure changed with the load on that window, as far as it is known.
    pub(crate) fn trend(&self) -> Option<&Trend<1>> {
        self.engine.as_ref().map(|engine| &engine.trend)
    }

    /// Goes on as after the solve that found this pressure at this approach, on the window it ended with.
    pub(crate) fn resume(
        &mut self,
        pressure: &[f64],
        approach: f64,
        window: Option<Window>,
        trend: &Trend<1>,
    ) -> Result<()> {
        self.pressure.copy_from_slice(pressure);
        self.approach = approach;
        if self.window() != window {
            let remake = |window| Engine::new(&self.problem.bodies, window);
            self.engine = window.map(remake).transpose()?;
        }
        if let Some(engine) = &mut self.engine {
            engine.trend.clone_from(trend);
        }
        Ok(())
    }

    solver_settings!(problem.settings, |_, _| Ok(()));

    /// Forgets the last answer: the next solve starts as the first did.
    pub fn reset(&mut self) {
        self.engine = None;
    }

    /// An empty solution of the right size for [`NormalSolver::solve_into`].
    #[must_use]
    pub fn new_solution(&self) -> NormalSolution {
        let bodies = &self.problem.bodies;
        NormalSolution::empty(&self.problem.gap, bodies.boundary(), bodies.pair())
    }

    /// Solves into `solution`, whose last content does not matter.
    ///
    /// # Errors
    /// [`Error::GridMismatch`] or [`Error::BoundaryMismatch`] if the solution is of another grid or boundary, nothing
    /// changed; as [`HalfSpace::operator`](crate::HalfSpace::operator); [`Error::NotConverged`] with the last feasible iterate in `solution`.
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
        let bodies = &self.problem.bodies;
        bodies.check_host("solution", solution.grid(), solution.boundary())?;
        let cells = bodies.grid().cells();
        parallel::enter_with(cells, || self.solve_checked(solution, &mut observer))
    }

    fn solve_checked(
        &mut self,
        solution: &mut NormalSolution,
        observer: Observer<'_>,
    ) -> Result<()> {
        let is_cold = self.engine.is_none();
        let (mut engine, outcome) = self.find(observer)?;
        let NormalProblem { bodies, gap, .. } = &self.problem;
        solution.fill(
            bodies.pair(),
            gap,
            [&self.pressure, engine.displacement()],
            self.approach,
            &self.report,
        );
        engine.rest();
        // Do not warm-start from NaN; and a first solve without contact has not found where to work.
        let pressure = &self.pressure;
        let touches = reduce::first(pressure.len(), |i| pressure[i] > 0.0).is_some();
        let is_start = self.report.duality_gap.is_finite() && (touches || !is_cold);
        self.engine = is_start.then_some(engine);
        outcome
    }

    /// Solves once; of all that this takes the answer alone stays.
    pub(super) fn into_solution(mut self) -> Result<NormalSolution> {
        let cells = self.problem.bodies.grid().cells();
        parallel::enter_with(cells, || {
            let (engine, outcome) = self.find(&mut |_| ControlFlow::Continue(()))?;
            outcome?;
            let NormalProblem { bodies, gap, .. } = &self.problem;
            NormalSolution::of(
                bodies,
                gap,
                [self.pressure, engine.into_displacement()],
                self.approach,
                self.report,
            )
        })
    }

    /// Finds pressure and approach: with the engine, which has the displacement, and whether the answer is one.
    fn find(&mut self, observer: Observer<'_>) -> Result<(Engine, Result<()>)> {
        let cell_area = self.problem.bodies.grid().cell_area();
        let (settings, mut observer) = (self.problem.settings, with_memory(observer));
        let mut conditions = Conditions {
            settings: &settings,
            start: Instant::now(),
            observer: &mut observer,
        };
        // Without a datum far from the contact the sums keep their last digits.
        let load = match self.problem.load {
            NormalControl::Force(force) => Load {
                datum: self.least_gap,
                total: Total::Sum(force / cell_area),
            },
            NormalControl::Approach(approach) => Load {
                datum: approach,
                total: Total::Free,
            },
            NormalControl::Hold => return Err(Error::NothingToHold),
        };
        let from = [reduce::total(&self.pressure), self.approach];
        let (mut engine, known) = match self.engine.take() {
            Some(mut engine) => {
                let known = self.set_out(&mut engine, load, from);
                (engine, known)
            }
            None => (self.start_cold(load, &mut conditions)?, Known::Nothing),
        };
        let is_found = match self.solve_on_window(&mut engine, load, known, &mut conditions) {
            Ok(()) => true,
            Err(Error::NotConverged(_)) => false,
            Err(error) => return Err(error),
        };
        self.report.time = conditions.start.elapsed();
        let [multiplier] = engine.solver.multiplier();
        self.approach = load.datum + multiplier;
        if is_found && known == Known::Extrapolated {
            let to = [reduce::total(&self.pressure), self.approach];
            engine.note(&self.pressure, from, to);
        }
        let outcome = if is_found {
            Ok(())
        } else {
            Err(Error::NotConverged(Box::new(self.report.clone())))
        };
        Ok((engine, outcome))
    }

    /// From the last answer: as it is under the same load, moved on where the load has changed.
    fn set_out(&mut self, engine: &mut Engine, load: Load, from: Reached) -> Known<1> {
        match load.ahead(from) {
            Ahead::Nothing => Known::Answer([load.of(self.approach - load.datum)]),
            ahead => {
                let parts = engine.trend.parts([ahead]).unwrap_or(0.0);
                engine.extrapolate(parts, &mut self.pressure);
                Known::Extrapolated
            }
        }
    }

    /// From nothing: the answer on coarser cells, and the engine set up around its contact.
    fn start_cold(&mut self, load: Load, conditions: &mut Conditions<'_, '_>) -> Result<Engine> {
        let NormalProblem { bodies, gap, .. } = &self.problem;
        let (grid, whole) = (bodies.grid(), Window::whole(bodies.grid()));
        let mut scene = PressureScene {
            linear: vec![0.0; grid.cells()],
            total: load.total,
        };
        let gap = gap.as_slice();
        parallel::update(&mut scene.linear, |first, chunk| {
            for (linear, gap) in chunk.iter_mut().zip(&gap[first..]) {
                *linear = gap - load.datum;
            }
        });
        if conditions.settings.method == Method::PolonskyKeer {
            [self.pressure] = scene.plain_start();
            return Engine::new(bodies, whole);
        }
        [self.pressure] = nested_start(bodies, whole.size, &scene, conditions)?;
        match Window::around(grid, |i| self.pressure[i] > 0.0) {
            Some(contact) => Engine::new(bodies, contact.widened(grid)),
            None => Engine::new(bodies, whole),
        }
    }

    /// Solves on the window and looks at the whole grid; where bodies overlap beyond the window it
    /// was too small, and the work continues in a larger one.
    fn solve_on_window(
        &mut self,
        engine: &mut Engine,
        load: Load,
        mut known: Known<1>,
        conditions: &mut Conditions<'_, '_>,
    ) -> Result<()> {
        let NormalProblem { bodies, gap, .. } = &self.problem;
        let Conditions {
            settings,
            start,
            observer,
        } = conditions;
        let gap = gap.as_slice();
        let mut aim = settings.tolerance;
        self.report.clone_from(&Report::unsolved());
        loop {
            let left = with_limits_left(settings, *start, &self.report).tolerance(aim);
            let mut observer = with_counts_of(&self.report, &mut **observer);
            let from = (&mut self.pressure[..], known);
            let outcome = engine.solve(gap, load, from, &left, &mut observer);
            if !matches!(outcome, Ok(()) | Err(Error::NotConverged(_))) {
                return outcome;
            }
            drop(observer);
            self.report.add_pass(engine.solver.report());
            let Some(findings) = engine.examine(gap, load, &self.pressure) else {
                return outcome;
            };
            self.report.double_precision_products += 1;
            findings.write_to(&mut self.report);
            // What has stalled may have done so because the contact is elsewhere.
            if !matches!(self.report.status, Status::Converged | Status::Stalled) {
                return outcome;
            }
            let missed = engine.missed(gap, load, ROUND_OFF * findings.displacement, bodies);
            if missed.is_none() && (outcome.is_err() || self.report.is_within(settings.tolerance)) {
                return outcome;
            }
            known = Known::Answer(engine.solver.multiplier());
            // While the engine can still show what the iterate does.
            check_iterations_left(settings, &mut self.report)?;
            if let Some(missed) = missed {
                let wider = engine.window.union(missed).widened(bodies.grid());
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
