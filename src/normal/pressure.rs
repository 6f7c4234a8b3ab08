//! Normal contacts of the same bodies, one after the other, each from the answer of the last.

use std::ops::ControlFlow;

use crate::buffer;
use crate::cascade::{Conditions, Scene, nested_start};
use crate::cgm::{Iteration, Known, Method, Settings, Total, UNLIMITED, reduce};
use crate::clock::Instant;
use crate::elastic::Observer;
use crate::error::{Error, Result};
use crate::field::Field;
use crate::half_space::HalfSpace;
use crate::left_behind::LeftBehind;
use crate::normal::engine::{Engine, Load, Surfaces};
use crate::normal::nested::PressureScene;
use crate::normal::{Hardness, NormalControl, NormalSolution};
use crate::parallel;
use crate::passes::{check_iterations_left, with_counts_of, with_limits_left, with_memory};
use crate::report::{Report, Status};
use crate::trend::{Ahead, Reached, Trend};
use crate::window::Window;

/// What is pressed, and how.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Pressing<'a> {
    pub(crate) bodies: &'a HalfSpace,
    pub(crate) gap: &'a Field,
    /// The least of its samples.
    pub(crate) least_gap: f64,
    pub(crate) hardness: Option<&'a Hardness>,
    pub(crate) control: NormalControl,
    pub(crate) settings: &'a Settings,
}

impl<'a> Pressing<'a> {
    /// Cells at their hardness.
    fn yielded(&self, pressure: &[f64]) -> usize {
        self.hardness
            .map_or(0, |hardness| hardness.reached_cells(self.bodies, pressure))
    }

    /// Whether a pressure is beyond the hardness.
    fn exceeds(&self, pressure: &[f64]) -> bool {
        self.hardness
            .is_some_and(|hardness| hardness.is_exceeded(self.bodies, pressure))
    }

    fn surfaces(&self) -> Surfaces<'a> {
        Surfaces {
            gap: self.gap.as_slice(),
            limits: self.hardness.map_or(UNLIMITED, Hardness::limits),
        }
    }

    /// Without a hardness.
    fn elastic_surfaces(&self) -> Surfaces<'a> {
        Surfaces {
            limits: UNLIMITED,
            ..self.surfaces()
        }
    }
}

/// What one solve leaves to the next, but for the pressure, which is its caller's: zero before the first solve.
#[derive(Debug, Clone)]
pub(crate) struct PressureSolver {
    /// What the last solve worked with; `None` before the first.
    engine: Option<Engine>,
    /// Those of other windows.
    left_behind: LeftBehind<Engine>,
    /// Whether its answer is a start.
    is_start: bool,
    /// The approach that belongs to the pressure.
    approach: f64,
    report: Report,
}

impl PressureSolver {
    pub(crate) fn new() -> Self {
        Self {
            engine: None,
            left_behind: LeftBehind::default(),
            is_start: false,
            approach: 0.0,
            report: Report::with_room(),
        }
    }

    /// Where the engine works; `None` before the first solve.
    pub(crate) fn window(&self) -> Option<Window> {
        self.engine.as_ref().map(Engine::window)
    }

    /// Writes how the pressure changed with the load on that window, in the cells held here.
    pub(crate) fn write_trend(&self, trend: &mut Trend<1>) {
        if let Some(engine) = &self.engine {
            engine.write_trend(trend);
        }
    }

    /// Cells of that trend held here.
    pub(crate) fn trend_cells(&self) -> usize {
        self.engine.as_ref().map_or(0, Engine::trend_cells)
    }

    /// Counts a step, whether or not it solves.
    pub(crate) fn age(&mut self) {
        self.left_behind.age();
    }

    /// Goes on as after a solve that came to this approach, on the window it ended with; one that failed gives its buffers
    /// back.
    pub(crate) fn resume(
        &mut self,
        bodies: &HalfSpace,
        approach: f64,
        window: Option<Window>,
        trend: &Trend<1>,
    ) -> Result<()> {
        self.approach = approach;
        if let Some(engine) = &mut self.engine {
            engine.rest();
        }
        if self.window() != window {
            let present = &mut self.engine;
            match window.map(|window| bodies.place(window)) {
                Some(window) => {
                    let make = || Engine::new(bodies, window);
                    let engine = self.left_behind.provide(present, window.size, make)?;
                    engine.move_to(bodies, window);
                }
                None => *present = None,
            }
        }
        let Some(engine) = &mut self.engine else {
            return Ok(());
        };
        let outcome = engine.set_trend(trend);
        if outcome.is_err() {
            // Without the trend it would not go on as it did.
            self.engine = None;
        }
        outcome
    }

    /// Forgets the last answer: the next solve starts as the first did.
    pub(crate) fn reset(&mut self) {
        self.engine = None;
    }

    /// Writes what was found to a solution that has the pressure, and rests.
    pub(crate) fn finish(&mut self, of: &Pressing<'_>, solution: &mut NormalSolution) {
        let displacement = self.engine.as_ref().map_or(&[][..], Engine::displacement);
        let Pressing { bodies, gap, .. } = of;
        solution.fill(bodies, gap, displacement, self.approach, &self.report);
        let pressure = solution.pressure().as_slice();
        let yielded = of.yielded(pressure);
        solution.set_yielded_cells(yielded);
        match &mut self.engine {
            Some(engine) if self.is_start => engine.rest(),
            engine => *engine = None,
        }
    }

    /// The solution with this pressure; all else is given up.
    pub(super) fn into_solution(
        self,
        of: &Pressing<'_>,
        pressure: Vec<f64>,
    ) -> Result<NormalSolution> {
        let yielded = of.yielded(&pressure);
        let displacement = self.engine.map(Engine::into_displacement);
        let fields = [pressure, displacement.unwrap_or_default()];
        let mut solution =
            NormalSolution::of(of.bodies, of.gap, fields, self.approach, self.report)?;
        solution.set_yielded_cells(yielded);
        Ok(solution)
    }

    /// Finds the pressure of the whole grid from the last one, in its place. The rest of the answer is to be taken from
    /// [`Self::finish`] or [`Self::into_solution`], converged or not.
    ///
    /// # Errors
    /// [`Error::NotConverged`] with the last feasible iterate; others, after which the next solve starts from nothing.
    pub(crate) fn solve(
        &mut self,
        of: &Pressing<'_>,
        pressure: &mut [f64],
        observer: Observer<'_>,
    ) -> Result<()> {
        let mut observer = with_memory(observer);
        let mut conditions = Conditions {
            settings: of.settings,
            start: Instant::now(),
            observer: &mut observer,
        };
        // Without a datum far from the contact the sums keep their last digits.
        let load = match of.control {
            NormalControl::Force(force) => Load {
                datum: of.least_gap,
                total: Total::Sum(force / of.bodies.grid().cell_area()),
            },
            NormalControl::Approach(approach) => Load {
                datum: approach,
                total: Total::Free,
            },
            NormalControl::Hold => return Err(Error::NothingToHold),
        };
        let layout = of.bodies.grid_layout();
        let from = [reduce::total(&layout, pressure), self.approach];
        let holds = |engine: &Engine| {
            let window = engine.window();
            of.hardness
                .is_none_or(|hardness| hardness.holds(of.bodies, window, load.total))
        };
        // A window that cannot carry the load is no place to begin at.
        let last = self.engine.take().filter(holds);
        let is_cold = last.is_none();
        // What nothing reaches is not to be seen in any iterate.
        let is_elastic = is_cold || of.yielded(pressure) == 0;
        let surfaces = if is_elastic {
            of.elastic_surfaces()
        } else {
            of.surfaces()
        };
        let (mut engine, known) = if let Some(mut engine) = last {
            let known = self.set_out(&mut engine, load, from, pressure)?;
            (engine, known)
        } else {
            let engine = start_cold(of.bodies, surfaces, load, pressure, &mut conditions)?;
            (engine, Known::Nothing)
        };
        self.report.clone_from(&Report::unsolved());
        let what = (of.bodies, surfaces, load);
        let from_here = (&mut *pressure, known);
        let mut outcome = self.solve_on_window(&mut engine, what, from_here, &mut conditions);
        if matches!(outcome, Ok(()) | Err(Error::NotConverged(_))) && of.exceeds(pressure) {
            outcome = self.bring_within_limits(&mut engine, of, load, pressure, &mut conditions);
        }
        if !matches!(outcome, Ok(()) | Err(Error::NotConverged(_))) {
            return outcome;
        }
        self.report.time = conditions.start.elapsed();
        let [multiplier] = engine.solver.multiplier();
        self.approach = load.datum + multiplier;
        if outcome.is_ok() && known == Known::Extrapolated {
            let to = [reduce::total(&layout, pressure), self.approach];
            engine.note(pressure, from, to)?;
        }
        // Do not warm-start from NaN; and a first solve without contact has not found where to work.
        let touches = reduce::any(&layout, |i| pressure[i] > 0.0);
        self.is_start = self.report.duality_gap.is_finite() && (touches || !is_cold);
        self.engine = Some(engine);
        outcome.map_err(|_| Error::NotConverged(Box::new(self.report.clone())))
    }

    /// Begins anew where a pressure that was found without the hardness is beyond it: the contact is wider. Where the solve
    /// has come to its limits, or was cancelled, the pressure is brought within the hardness and no step is taken.
    fn bring_within_limits(
        &mut self,
        engine: &mut Engine,
        of: &Pressing<'_>,
        load: Load,
        pressure: &mut [f64],
        conditions: &mut Conditions<'_, '_>,
    ) -> Result<()> {
        let what = (of.bodies, of.surfaces(), load);
        let may_go_on = matches!(self.report.status, Status::Converged | Status::Stalled)
            && check_iterations_left(conditions.settings, &mut self.report).is_ok();
        if may_go_on {
            *engine = start_cold(of.bodies, of.surfaces(), load, pressure, conditions)?;
            return self.solve_on_window(engine, what, (pressure, Known::Nothing), conditions);
        }
        *engine = Engine::new(of.bodies, Window::whole(of.bodies.grid()))?;
        let status = self.report.status;
        let mut refuse = |_: &Iteration| ControlFlow::Break(());
        let mut no_step = Conditions {
            settings: &conditions
                .settings
                .max_iterations(self.report.iterations + 1),
            start: conditions.start,
            observer: &mut refuse,
        };
        let outcome = self.solve_on_window(engine, what, (pressure, Known::Nothing), &mut no_step);
        if matches!(outcome, Err(Error::NotConverged(_))) {
            self.report.status = status;
        }
        outcome
    }

    /// From the last answer: as it is under the same load, moved on where the load has changed.
    fn set_out(
        &self,
        engine: &mut Engine,
        load: Load,
        from: Reached,
        pressure: &mut [f64],
    ) -> Result<Known<1>> {
        Ok(match load.ahead(from) {
            Ahead::Nothing => Known::Answer([load.of(self.approach - load.datum)]),
            ahead => {
                let parts = engine.parts(ahead).unwrap_or(0.0);
                engine.extrapolate(parts, pressure)?;
                Known::Extrapolated
            }
        })
    }

    /// Solves on the window and looks at the whole grid; where bodies overlap beyond the window it
    /// was too small, and the work continues in a larger one.
    fn solve_on_window(
        &mut self,
        engine: &mut Engine,
        (bodies, surfaces, load): (&HalfSpace, Surfaces<'_>, Load),
        (pressure, mut known): (&mut [f64], Known<1>),
        conditions: &mut Conditions<'_, '_>,
    ) -> Result<()> {
        let Conditions {
            settings,
            start,
            observer,
        } = conditions;
        let mut aim = settings.tolerance;
        loop {
            let left = with_limits_left(settings, *start, &self.report).tolerance(aim);
            let mut observer = with_counts_of(&self.report, &mut **observer);
            let from = (&mut *pressure, known);
            let outcome = engine.solve(surfaces, load, from, &left, &mut observer);
            if !matches!(outcome, Ok(()) | Err(Error::NotConverged(_))) {
                return outcome;
            }
            drop(observer);
            self.report.add_pass(engine.solver.report());
            let Some(findings) = engine.examine(surfaces, load, pressure)? else {
                return outcome;
            };
            self.report.double_precision_products += 1;
            findings.write_to(&mut self.report);
            // What has stalled may have done so because the contact is elsewhere.
            if !matches!(self.report.status, Status::Converged | Status::Stalled) {
                return outcome;
            }
            let missed = engine.missed(
                surfaces.gap,
                load,
                ROUND_OFF * findings.displacement,
                bodies,
            );
            if missed.is_none() && (outcome.is_err() || self.report.is_within(settings.tolerance)) {
                return outcome;
            }
            known = Known::Answer(engine.solver.multiplier());
            // While the engine can still show what the iterate does.
            check_iterations_left(settings, &mut self.report)?;
            if let Some(missed) = missed {
                let wider = engine.window().union(missed).widened(bodies.grid());
                let wider = bodies.place(wider);
                engine.rest();
                let make = || Engine::new(bodies, wider);
                self.left_behind.replace(engine, wider.size, make)?;
                engine.move_to(bodies, wider);
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

/// From nothing: the answer on coarser cells, and the engine set up around its contact.
fn start_cold(
    bodies: &HalfSpace,
    Surfaces { gap, limits }: Surfaces<'_>,
    load: Load,
    pressure: &mut [f64],
    conditions: &mut Conditions<'_, '_>,
) -> Result<Engine> {
    let (grid, whole) = (bodies.grid(), Window::whole(bodies.grid()));
    let mut scene = PressureScene {
        linear: buffer::zeros(grid.cells())?,
        limits: limits.try_map(|limits| buffer::copied(limits))?,
        total: load.total,
        cells: whole.cells(),
    };
    parallel::update(&mut scene.linear, |first, chunk| {
        for (linear, gap) in chunk.iter_mut().zip(&gap[first..]) {
            *linear = gap - load.datum;
        }
    });
    let is_plain = conditions.settings.method == Method::PolonskyKeer;
    let [start] = if is_plain {
        scene.plain_start()?
    } else {
        nested_start(bodies, whole.size, &scene, conditions)?
    };
    parallel::copy(&start, pressure);
    match bodies.around(|i| pressure[i] > 0.0) {
        Some(contact) if !is_plain => Engine::new(bodies, contact.widened(grid)),
        _ => Engine::new(bodies, whole),
    }
}

/// Overlap beyond the window, relative to the largest displacement, that a product may show by itself.
const ROUND_OFF: f64 = 1e-13;
