//! Solver of a sequence of normal contacts of the same bodies. Each solve starts from the last solution.

use std::borrow::Cow;
use std::ops::ControlFlow;

use crate::cgm::{InitialGuess, Method, Settings, UNLIMITED, reduce};
use crate::contact::{Cancellation, has_iterate, known_of_start, nested_start, with_counts_of};
use crate::contact::{
    LoadIncrement, LoadPoint, LoadTrend, MultilevelProblem, PassOutcome, SolveContext,
    WindowEngine, Windows, multipliers,
};
use crate::error::{Error, Result};
use crate::grid::field::Field;
use crate::grid::per_cell::PerCell;
use crate::grid::window::Window;
use crate::half_space::HalfSpace;
use crate::normal::pressure_problem::PressureProblem;
use crate::normal::window_solver::NormalEngine;
use crate::normal::{Hardness, NormalLoad, NormalSolution};
use crate::observer::Observer;
use crate::parallel;
use crate::report::Iteration;
use crate::report::{Report, Status};

/// Smallest fraction of the tolerance to which a window is solved. If the solution still misses the tolerance on the whole grid,
/// the solver considers the tolerance unreachable.
const STRICTEST: f64 = 0.1;

/// Margin in cells on each side of the first window, into which the contact of later loads can grow.
const ROOM: [usize; 2] = [2; 2];

/// Least number of cells of a large window. A solve on such a window that unloads the contact far takes less time if it starts on
/// coarser cells. On smaller windows these starts take longer than the products that they save.
const LARGE: usize = 128 * 128;
/// Depth of penetration relative to the previous depth below which the start on coarser cells takes less time. Under a sphere the
/// force is then 0.6 of the previous force.
const FAR_BELOW: f64 = 0.7;

/// Input of a normal contact: bodies, gap, hardness, load and settings.
#[derive(Debug, Clone, Copy)]
pub(crate) struct NormalInput<'a> {
    pub(crate) bodies: &'a HalfSpace,
    pub(crate) gap: &'a Field,
    pub(crate) hardness: Option<&'a Hardness>,
    pub(crate) load: NormalLoad,
    pub(crate) settings: &'a Settings,
}

impl<'a> NormalInput<'a> {
    /// Returns the number of cells at their hardness.
    fn yielded(&self, pressure: &[f64]) -> usize {
        self.hardness
            .map_or(0, |hardness| hardness.reached_cells(self.bodies, pressure))
    }

    /// Returns whether the pressure of any cell exceeds the hardness.
    fn exceeds(&self, pressure: &[f64]) -> bool {
        self.hardness
            .is_some_and(|hardness| hardness.is_exceeded(self.bodies, pressure))
    }

    /// Estimates the depth of penetration under the load, relative to the depth at an earlier load. The function is collective.
    fn depth_growth(&self, reached: LoadPoint) -> f64 {
        match self.scene().remaining_load(reached) {
            // Under a sphere the force grows with the depth to the power 3/2.
            LoadIncrement::Total(change) => (1.0 + change / reached[0]).cbrt().powi(2),
            LoadIncrement::Motion(change) => {
                let depth = reached[1] - self.bodies.least(self.gap);
                if depth > 0.0 {
                    1.0 + change / depth
                } else {
                    f64::INFINITY
                }
            }
            LoadIncrement::Nothing | LoadIncrement::Spring { .. } => 1.0,
        }
    }

    /// Converts the input to the form that the window solver takes.
    fn scene(&self) -> PressureProblem<&'a [f64]> {
        let (datum, total) = self.load.to_datum_and_total(self.bodies, self.gap);
        PressureProblem {
            gap: self.gap.as_slice(),
            datum,
            limits: self.limits(),
            total,
        }
    }

    fn limits(&self) -> PerCell<&'a [f64]> {
        self.hardness.map_or(UNLIMITED, Hardness::limits)
    }
}

/// State that is kept between solves, except for the pressure. The caller stores the pressure, which must be zero
/// before the first solve.
#[derive(Debug, Clone)]
pub(crate) struct PressureSolver {
    /// Window solver of the last solve.
    windows: Windows<NormalEngine>,
    /// Whether the last solution is a valid start for the next solve.
    is_start: bool,
    /// Approach that belongs to the pressure.
    approach: f64,
    /// Largest sum of the pressures and largest approach that [`Self::discard_costly_start`] has recorded for
    /// these windows.
    held: LoadPoint,
    report: Report,
}

impl PressureSolver {
    pub(crate) fn new() -> Self {
        Self {
            windows: Windows::default(),
            is_start: false,
            approach: 0.0,
            held: [f64::NEG_INFINITY; 2],
            report: Report::with_room(),
        }
    }

    /// Returns the window of the solver, or `None` before the first solve.
    pub(crate) fn window(&self) -> Option<Window> {
        self.windows.window()
    }

    /// Returns the approach of the last solve.
    pub(super) fn approach(&self) -> f64 {
        self.approach
    }

    /// Returns the report of the last solve.
    pub(crate) fn report(&self) -> &Report {
        &self.report
    }

    /// Writes the change of the pressure with the load on the window, for the local cells.
    pub(crate) fn write_trend(&self, trend: &mut LoadTrend<1>) {
        if let Some(engine) = &self.windows.present {
            engine.write_trend(trend);
        }
    }

    /// Returns the number of local cells of the trend.
    pub(crate) fn trend_cells(&self) -> usize {
        self.windows
            .present
            .as_ref()
            .map_or(0, NormalEngine::trend_cells)
    }

    /// Counts a step, whether or not it requires a solve.
    pub(crate) fn tick(&mut self) {
        self.windows.tick();
    }

    /// Restores the state after a solve that reached this approach and ended on this window. The buffers of a failed
    /// solve are released.
    pub(crate) fn resume(
        &mut self,
        bodies: &HalfSpace,
        approach: f64,
        window: Option<Window>,
        trend: &LoadTrend<1>,
    ) -> Result<()> {
        (self.approach, self.is_start) = (approach, true);
        if let Some(engine) = &mut self.windows.present {
            engine.rest();
        }
        self.windows.resume(bodies, window)?;
        let Some(engine) = &mut self.windows.present else {
            return Ok(());
        };
        let outcome = engine.set_trend(trend);
        if outcome.is_err() {
            // Without the trend, a resumed history would deviate from the original one.
            self.windows.present = None;
        }
        outcome
    }

    /// Discards the last solution. The next solve starts in the same way as the first.
    pub(crate) fn reset(&mut self) {
        self.windows.present = None;
        self.held = [f64::NEG_INFINITY; 2];
    }

    /// Discards the last solution if a start on coarser cells is cheaper: if a large contact is unloaded far, or if the contact
    /// will grow beyond its window. In the second case, such a start takes a quarter of the products.
    ///
    /// The widest closed gap is assumed to grow in proportion to the depth of penetration. The window is too small if a gap
    /// outside the window would close. Loads up to the largest load that the window has contained are accepted without this
    /// test.
    pub(super) fn discard_costly_start(&mut self, of: &NormalInput<'_>, pressure: &[f64]) {
        let (bodies, layout) = (of.bodies, of.bodies.grid_layout());
        let Some(window) = self.window().filter(|_| self.is_start) else {
            return;
        };
        let sum = reduce::total(&layout, pressure);
        let reached = [sum, self.approach];
        let is_large = window.cells() >= LARGE && of.settings.method != Method::PolonskyKeer;
        if is_large && of.depth_growth(reached) < FAR_BELOW {
            self.reset();
            return;
        }
        if window == Window::whole(bodies.grid()) {
            return;
        }
        self.held = [self.held[0].max(sum), self.held[1].max(self.approach)];
        let scene = of.scene();
        let (LoadIncrement::Total(beyond) | LoadIncrement::Motion(beyond)) =
            scene.remaining_load(self.held)
        else {
            return;
        };
        if beyond <= 0.0 {
            return;
        }
        let least = bodies.least(of.gap);
        let (depth, growth) = (self.approach - least, of.depth_growth(reached));
        if depth > 0.0 && growth > 1.0 {
            let (gap, first) = (of.gap.as_slice(), bodies.first_cell());
            let gap = |i: usize| gap[i] - least;
            let closed = reduce::max(&layout, |i| if pressure[i] > 0.0 { gap(i) } else { 0.0 });
            let beyond = |i: usize| (!window.contains(first + i)).then(|| (gap(i), ()));
            let next = reduce::least(&layout, beyond).map_or(f64::INFINITY, |(gap, ())| gap);
            if (closed..closed * growth).contains(&next) {
                self.reset();
            }
        }
    }

    /// Writes the result to a solution that already contains the pressure, and releases the buffers.
    pub(crate) fn finish(&mut self, of: &NormalInput<'_>, solution: &mut NormalSolution) {
        let engine = &mut self.windows.present;
        let displacement = engine.as_ref().map_or(&[][..], NormalEngine::displacement);
        let NormalInput { bodies, gap, .. } = of;
        solution.fill(bodies, gap, displacement, self.approach, &self.report);
        solution.compare_with(bodies, of.hardness);
        match engine {
            Some(engine) if self.is_start => engine.rest(),
            engine => *engine = None,
        }
    }

    /// Creates the solution from this pressure and drops all other state.
    pub(super) fn into_solution(
        self,
        of: &NormalInput<'_>,
        pressure: Vec<f64>,
    ) -> Result<NormalSolution> {
        let displacement = self.windows.present.map(NormalEngine::into_displacement);
        let fields = [pressure, displacement.unwrap_or_default()];
        let mut solution =
            NormalSolution::of(of.bodies, of.gap, fields, self.approach, self.report)?;
        solution.compare_with(of.bodies, of.hardness);
        Ok(solution)
    }

    /// Computes the pressure of the whole grid in place, starting from the last pressure. The other fields of the
    /// solution come from [`Self::finish`] or [`Self::into_solution`], whether or not the solve has converged.
    ///
    /// # Errors
    /// - [`Error::NotConverged`] if a limit is reached. `pressure` then contains the last feasible iterate.
    /// - Other errors of the solve, after which the next solve starts from scratch.
    pub(crate) fn solve(
        &mut self,
        of: &NormalInput<'_>,
        pressure: &mut [f64],
        observer: Observer<'_>,
    ) -> Result<()> {
        let cancellation = Cancellation::default();
        let mut observer = cancellation.watch(of.settings, observer);
        let mut conditions = SolveContext::new(of.settings, &mut observer);
        let outcome = self.find(of, pressure, &mut conditions);
        let outcome = cancellation.applied(of.bodies, outcome, || self.report.cancelled());
        if !has_iterate(&outcome) {
            self.windows.present = None;
        }
        outcome
    }

    fn find(
        &mut self,
        of: &NormalInput<'_>,
        pressure: &mut [f64],
        conditions: &mut SolveContext<'_, '_>,
    ) -> Result<()> {
        let mut scene = of.scene();
        let layout = of.bodies.grid_layout();
        let from = [reduce::total(&layout, pressure), self.approach];
        // The solve cannot start on a window that cannot carry the load.
        let holds = |window: Window| {
            of.hardness
                .is_none_or(|hardness| hardness.holds(of.bodies, window, scene.total))
        };
        let has_start = std::mem::take(&mut self.is_start) && self.window().is_some_and(holds);
        // If no cell is at its limit, the solve starts without limits. A limit that no cell reaches then does not
        // change any iterate.
        if !has_start || of.yielded(pressure) == 0 {
            scene.limits = UNLIMITED;
        }
        let known = match &mut self.windows.present {
            Some(engine) if has_start => set_out(engine, scene, from, self.approach, pressure)?,
            engine => {
                *engine = None;
                let (cold, known) = start_cold(of.bodies, scene, pressure, conditions)?;
                *engine = Some(cold);
                known
            }
        };
        self.report.clear();
        let mut outcome = self.solve_on_window(of.bodies, scene, (pressure, known), conditions);
        if has_iterate(&outcome) && of.exceeds(pressure) {
            scene.limits = of.limits();
            outcome = self.bring_within_limits(of.bodies, scene, pressure, conditions);
        }
        let engine = self.windows.present.as_mut();
        let Some(engine) = engine.filter(|_| has_iterate(&outcome)) else {
            return outcome;
        };
        self.report.time = conditions.start.elapsed();
        let [multiplier] = engine.solver.multiplier();
        self.approach = scene.datum + multiplier;
        if outcome.is_ok() && has_start && known == InitialGuess::Interpolated {
            let to = [reduce::total(&layout, pressure), self.approach];
            engine.note(pressure, from, to)?;
        }
        // The next solve must not start from NaN. A first solve without contact has not found a window either.
        let touches = reduce::any(&layout, |i| pressure[i] > 0.0);
        self.is_start = self.report.duality_gap.is_finite() && (touches || has_start);
        outcome.map_err(|_| Error::NotConverged(Box::new(self.report.clone())))
    }

    /// Solves again from scratch if a pressure computed without the hardness limit exceeds it, because the limit widens the
    /// contact. If the solve has reached its iteration or time limit or was cancelled, the function takes no step. It then only
    /// projects the pressure onto the hardness limits.
    fn bring_within_limits(
        &mut self,
        bodies: &HalfSpace,
        scene: PressureProblem<&[f64]>,
        pressure: &mut [f64],
        conditions: &mut SolveContext<'_, '_>,
    ) -> Result<()> {
        let may_go_on = matches!(self.report.status, Status::Converged | Status::Stalled)
            && conditions.check_iterations_left(&mut self.report).is_ok();
        if may_go_on {
            let (engine, known) = start_cold(bodies, scene, pressure, conditions)?;
            self.windows.present = Some(engine);
            let from = (pressure, known);
            return self.solve_on_window(bodies, scene, from, conditions);
        }
        let engine = NormalEngine::new(bodies, Window::whole(bodies.grid()))?;
        self.windows.present = Some(engine);
        let status = self.report.status;
        let mut refuse = |_: &Iteration| ControlFlow::Break(());
        let steps = self.report.iterations + 1;
        let mut no_step = SolveContext {
            settings: &conditions.settings.max_iterations(steps),
            start: conditions.start,
            observer: &mut refuse,
        };
        let from = (pressure, InitialGuess::Nothing);
        let outcome = self.solve_on_window(bodies, scene, from, &mut no_step);
        if matches!(outcome, Err(Error::NotConverged(_))) {
            self.report.status = status;
        }
        outcome
    }

    /// Solves on the window of the contact, and on wider windows if the first window was too small.
    fn solve_on_window(
        &mut self,
        bodies: &HalfSpace,
        scene: PressureProblem<&[f64]>,
        (pressure, mut known): (&mut [f64], InitialGuess<1>),
        conditions: &mut SolveContext<'_, '_>,
    ) -> Result<()> {
        let (windows, report) = (&mut self.windows, &mut self.report);
        let tolerance = conditions.settings.tolerance;
        windows.solve(bodies, |engine, part| {
            let left = conditions
                .with_remaining_limits(report)
                .tolerance(part * tolerance);
            let mut observer = with_counts_of(report, &mut *conditions.observer);
            let outcome = engine.solve(scene, (pressure, known), &left, &mut observer);
            if !has_iterate(&outcome) {
                return outcome.map(|()| PassOutcome::Accepted);
            }
            drop(observer);
            report.add_pass(engine.solver.report());
            let Some((findings, bound)) = engine.examine(scene, pressure)? else {
                return outcome.map(|()| PassOutcome::Accepted);
            };
            report.double_precision_products += 1;
            findings.write_to(report);
            report.eigenvalue_bound = bound;
            let missed = engine.overlap_outside(scene, findings.displacement, bodies);
            // A solve may have stalled because the contact lies outside the window.
            let may_go_on = matches!(report.status, Status::Converged | Status::Stalled);
            let is_wide_enough = missed.is_none();
            if !may_go_on || is_wide_enough && (outcome.is_err() || report.is_within(tolerance)) {
                return outcome.map(|()| PassOutcome::Accepted);
            }
            known = InitialGuess::PreviousSolution(engine.solver.multiplier());
            // The check comes before the window changes, while the solver can still report the iterate.
            conditions.check_iterations_left(report)?;
            match missed {
                Some(missed) => Ok(PassOutcome::OverlapOutside(missed)),
                None if part < STRICTEST => {
                    report.status = Status::Stalled;
                    Err(Error::NotConverged(Box::new(report.clone())))
                }
                None => Ok(PassOutcome::BoundTooWide),
            }
        })
    }
}

/// Starts from the last solution, which is extrapolated if the load has changed.
fn set_out(
    engine: &mut NormalEngine,
    scene: PressureProblem<&[f64]>,
    from: LoadPoint,
    approach: f64,
    pressure: &mut [f64],
) -> Result<InitialGuess<1>> {
    Ok(match scene.remaining_load(from) {
        LoadIncrement::Nothing => {
            InitialGuess::PreviousSolution(multipliers([scene.total], [approach - scene.datum]))
        }
        ahead => {
            let parts = engine.parts(ahead).unwrap_or(0.0);
            engine.extrapolate(parts, pressure)?;
            InitialGuess::Interpolated
        }
    })
}

/// Starts from scratch. The function solves on coarser cells and sets up the window solver around the contact of this solution.
/// It returns the window solver and the quality of the start.
fn start_cold(
    bodies: &HalfSpace,
    scene: PressureProblem<&[f64]>,
    pressure: &mut [f64],
    conditions: &mut SolveContext<'_, '_>,
) -> Result<(NormalEngine, InitialGuess<1>)> {
    let (grid, whole) = (bodies.grid(), Window::whole(bodies.grid()));
    let own = PressureProblem {
        gap: Cow::Borrowed(scene.gap),
        datum: scene.datum,
        limits: scene.limits.map(|limits| Cow::Borrowed(*limits)),
        total: scene.total,
    };
    let is_plain = conditions.settings.method == Method::PolonskyKeer;
    let ([start], known) = if is_plain {
        (
            own.plain_start(&bodies.grid_layout())?,
            InitialGuess::Nothing,
        )
    } else {
        let start = nested_start(bodies, whole.size, &own, conditions)?;
        (start, known_of_start(bodies, whole.size))
    };
    parallel::copy(&start, pressure);
    let window = match bodies.around(|i| pressure[i] > 0.0) {
        Some(contact) if !is_plain => contact.widened(grid).with_margins(grid, ROOM),
        _ => whole,
    };
    Ok((NormalEngine::new(bodies, window)?, known))
}
