//! The reusable solver of a normal contact.

use std::ops::ControlFlow;
use std::sync::Arc;
use std::time::Instant;

use crate::cgm::{self, Iteration, Method, NonNegative};
use crate::error::{Error, Result};
use crate::fft::{Convolution, ConvolutionWorkspace};
use crate::field::Field;
use crate::influence::Component;
use crate::normal::nested::PressureScene;
use crate::normal::problem::check_gap;
use crate::normal::{NormalLoad, NormalProblem, NormalSolution};
use crate::operator::Operator;
use crate::parallel;
use crate::report::Report;
use crate::stage::{Nested, Observer, Stage, nested_start, with_memory, with_time_left};
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
#[derive(Debug)]
pub struct NormalSolver {
    problem: NormalProblem,
    /// Where the engine works: around the contact, if that is much smaller than the grid.
    window: Window,
    stage: Stage,
    whole: Option<Whole>,
    /// The last pressure on the whole grid, the start of the next solve.
    pressure: Vec<f64>,
    is_warm: bool,
    /// The gap from its least value, or from the approach where that is prescribed.
    linear: Vec<f64>,
    report: Report,
}

/// What it takes to see the whole grid when the engine works on a part of it.
#[derive(Debug)]
struct Whole {
    operator: Arc<Convolution>,
    workspace: ConvolutionWorkspace,
    displacement: Vec<f64>,
}

impl NormalSolver {
    pub(super) fn new(problem: NormalProblem) -> Result<Self> {
        let grid = problem.gap.grid();
        let window = Window::whole(grid);
        Ok(Self {
            stage: Stage::new(&problem.bodies, Component::ZZ, window.size)?,
            problem,
            window,
            whole: None,
            pressure: vec![0.0; grid.cells()],
            is_warm: false,
            linear: vec![0.0; grid.cells()],
            report: Report::unsolved(),
        })
    }

    /// Changes the load of the next solve.
    ///
    /// # Errors
    /// [`Error::Negative`] or [`Error::NotFinite`]; the load is then as it was.
    pub fn set_load(&mut self, load: NormalLoad) -> Result<()> {
        load.check(self.problem.gap.grid())?;
        self.problem.load = load;
        Ok(())
    }

    /// Changes the gap of the next solve, as wear does; copies it without allocating.
    ///
    /// # Errors
    /// [`Error::GridMismatch`] or [`Error::Sample`]; the gap is then as it was.
    pub fn set_gap(&mut self, gap: &Field) -> Result<()> {
        check_gap(&self.problem.bodies, gap)?;
        self.problem
            .gap
            .as_mut_slice()
            .copy_from_slice(gap.as_slice());
        Ok(())
    }

    /// Forgets the last answer: the next solve starts as the first did.
    pub fn reset(&mut self) {
        self.is_warm = false;
    }

    /// An empty solution of the right size for [`NormalSolver::solve_into`].
    #[must_use]
    pub fn new_solution(&self) -> NormalSolution {
        NormalSolution::empty(&self.problem.gap)
    }

    /// Solves into `solution`, whose last content does not matter.
    ///
    /// # Errors
    /// [`Error::GridMismatch`] if the solution is of another grid, nothing changed;
    /// [`Error::NotConverged`] with the last feasible iterate in `solution`.
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
        if solution.grid() != gap.grid() {
            return Err(Error::GridMismatch {
                quantity: "solution",
            });
        }
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
        if !self.is_warm {
            self.start_cold(total, start, &mut observer)?;
        }
        let outcome = self.solve_on_window(total, start, &mut observer);
        self.is_warm = matches!(outcome, Ok(()) | Err(Error::NotConverged(_)));
        if self.is_warm {
            self.report.time = start.elapsed();
            let displacement = match &self.whole {
                Some(whole) => &whole.displacement,
                None => self.stage.product(),
            };
            let approach = datum + self.stage.multiplier();
            solution.fill(
                &self.problem.gap,
                &self.pressure,
                displacement,
                approach,
                &self.report,
            );
        }
        match outcome {
            Err(Error::NotConverged(_)) => Err(Error::NotConverged(Box::new(self.report.clone()))),
            other => other,
        }
    }

    /// From nothing: the answer on coarser cells, and the engine set up around its contact.
    fn start_cold(
        &mut self,
        total: Option<f64>,
        start: Instant,
        observer: Observer<'_>,
    ) -> Result<()> {
        let whole = Window::whole(self.problem.gap.grid());
        let scene = PressureScene {
            linear: self.linear.clone(),
        };
        if self.problem.settings.method == Method::PolonskyKeer {
            self.pressure = scene.plain_start(total);
            return self.work_on(whole);
        }
        let settings = with_time_left(&self.problem.settings, start);
        let bodies = &self.problem.bodies;
        self.pressure = nested_start(
            bodies,
            Component::ZZ,
            whole.size,
            &scene,
            total,
            &settings,
            observer,
        )?;
        let touches = |i: usize| self.pressure[i] > 0.0;
        match Window::around(bodies.grid(), touches) {
            Ok(contact) => self.work_on(contact.widened(bodies.grid())),
            Err(_) => self.work_on(whole),
        }
    }

    /// Sets the engine up on a window, or on the whole grid if the window saves too little.
    fn work_on(&mut self, window: Window) -> Result<()> {
        let bodies = &self.problem.bodies;
        let whole = Window::whole(bodies.grid());
        let window = if 5 * window.cells() > 4 * whole.cells() {
            whole
        } else {
            window
        };
        if window != self.window {
            if window.size != self.stage.size {
                self.stage = Stage::new(bodies, Component::ZZ, window.size)?;
            }
            self.window = window;
        }
        if window == whole {
            self.whole = None;
        } else if self.whole.is_none() {
            let operator = bodies.operator(Component::ZZ)?;
            self.whole = Some(Whole {
                workspace: operator.workspace(),
                displacement: vec![0.0; operator.len()],
                operator,
            });
        }
        Ok(())
    }

    /// Solves on the window and looks at the whole grid; where bodies overlap beyond the window it
    /// was too small, and the work goes on in a larger one.
    fn solve_on_window(
        &mut self,
        total: Option<f64>,
        start: Instant,
        observer: Observer<'_>,
    ) -> Result<()> {
        let mut earlier = [0; 3];
        loop {
            self.window.gather(&self.linear, &mut self.stage.linear);
            self.window.gather(&self.pressure, &mut self.stage.x);
            let settings = with_time_left(&self.problem.settings, start);
            let outcome = self.stage.minimise(NonNegative, total, &settings, observer);
            if !matches!(outcome, Ok(()) | Err(Error::NotConverged(_))) {
                return outcome;
            }
            self.pressure.fill(0.0);
            self.window.scatter(&self.stage.x, &mut self.pressure);
            self.report.clone_from(self.stage.report());
            self.report.iterations += earlier[0];
            self.report.convolutions += earlier[1];
            self.report.rough_convolutions += earlier[2];
            let Some(whole) = &mut self.whole else {
                return outcome;
            };
            let Whole {
                operator,
                workspace,
                displacement,
            } = whole;
            operator.apply(&self.pressure, displacement, workspace);
            self.report.convolutions += 1;
            let multiplier = self.stage.multiplier();
            cgm::examine(
                &self.pressure,
                displacement,
                &self.linear,
                &NonNegative,
                total,
                multiplier,
                operator.lower_bound(),
            )
            .write_to(&mut self.report);
            outcome?;

            let largest = displacement.iter().fold(0.0, |a: f64, u| a.max(u.abs()));
            let depth = 0.01 * self.problem.settings.tolerance * largest;
            let grid = self.problem.gap.grid();
            let overlaps = |i: usize| {
                displacement[i] + self.linear[i] - multiplier < -depth && !self.window.contains(i)
            };
            match Window::around(grid, overlaps) {
                Err(_) => return Ok(()),
                Ok(missed) => {
                    earlier = [
                        self.report.iterations,
                        self.report.convolutions,
                        self.report.rough_convolutions,
                    ];
                    self.work_on(self.window.union(missed).widened(grid))?;
                }
            }
        }
    }
}
