//! The monitor of an iteration: observer, counts of steps, and the rules that end it.

use std::ops::ControlFlow;

use crate::cgm::Settings;
use crate::error::{Error, Result};
use crate::observer::Observer;
use crate::parallel::layout::Layout;
use crate::report::{Iteration, Report, Status};
use crate::support::clock::Instant;

/// A residual at which sets change by round-off alone.
const ROUND_OFF: f64 = 1e-12;

/// Settings, observer and clock of one solve.
pub(super) struct Monitor<'a> {
    pub(super) settings: &'a Settings,
    layout: &'a Layout,
    observer: Observer<'a>,
    start: Instant,
    /// Conjugate-gradient steps so far.
    steps: usize,
    /// Least merit so far of what is solved.
    pub(super) best: f64,
    /// Residual at which a stage ends that is solved on the way; none is under way else.
    stage: Option<f64>,
    /// Free cells, as last examined.
    pub(super) free: usize,
    /// The memory that could not be had on the way, if any: what the solve ends with then.
    pub(super) allocation_error: Option<Error>,
}

impl<'a> Monitor<'a> {
    /// A clean report, and the clock set.
    pub(super) fn new(
        settings: &'a Settings,
        layout: &'a Layout,
        observer: Observer<'a>,
        report: &mut Report,
    ) -> Self {
        report.iterations = 0;
        report.double_precision_products = 0;
        report.single_precision_products = 0;
        report.residual = f64::INFINITY;
        report.history.clear();
        Self {
            settings,
            layout,
            observer,
            start: Instant::now(),
            steps: 0,
            best: f64::INFINITY,
            stage: None,
            free: 0,
            allocation_error: None,
        }
    }

    /// A stage to be solved to this residual begins, or the problem itself.
    pub(super) fn begin(&mut self, stage: Option<f64>) {
        self.stage = stage;
        self.best = f64::INFINITY;
    }

    /// Whether what is solved at present is the problem itself.
    pub(super) fn is_last(&self) -> bool {
        self.stage.is_none()
    }

    /// Residual at which what is solved at present ends.
    pub(super) fn tolerance(&self) -> f64 {
        self.stage.unwrap_or(self.settings.tolerance)
    }

    /// Records an examined step, and says if it is the last: converged or stopped.
    pub(super) fn check_termination(
        &mut self,
        merit: f64,
        report: &mut Report,
    ) -> ControlFlow<Status> {
        if self.stage.is_none() {
            let entry = self.entry(report);
            report.history.push(entry);
        }
        if merit.is_nan() {
            return ControlFlow::Break(Status::Stalled);
        }
        self.best = self.best.min(merit);
        if merit <= self.tolerance() {
            return ControlFlow::Break(Status::Converged);
        }
        self.proceed(report)
    }

    /// What to do when the residual no longer falls: stop if it is round-off, else `None`.
    pub(super) fn stuck(&self) -> Option<Status> {
        (self.best <= ROUND_OFF).then_some(Status::Stalled)
    }

    /// Counts a step.
    pub(super) fn count_step(&mut self, report: &mut Report) {
        self.steps += 1;
        report.iterations = self.steps;
    }

    /// Asks observer, clock and limit whether to take another step.
    pub(super) fn proceed(&mut self, report: &Report) -> ControlFlow<Status> {
        self.notify_observer(report)?;
        if self.steps >= self.settings.max_iterations {
            return ControlFlow::Break(Status::IterationLimit);
        }
        ControlFlow::Continue(())
    }

    /// Asks observer and clock whether to go on. So, or by [`Self::proceed`], they are asked before every product
    /// that moves the iterate or a step; one that only shows what the iterate is worth is due anyway.
    pub(super) fn notify_observer(&mut self, report: &Report) -> ControlFlow<Status> {
        let entry = self.entry(report);
        let limit = self.settings.time_limit;
        let own = if (self.observer)(&entry).is_break() {
            ControlFlow::Break(Status::Cancelled)
        } else if limit.is_some_and(|limit| self.start.elapsed() >= limit) {
            ControlFlow::Break(Status::TimeLimit)
        } else {
            ControlFlow::Continue(())
        };
        self.layout.decided(own)
    }

    /// Ends where memory could not be had.
    pub(super) fn record_allocation_failure(&mut self, room: Result<()>) -> ControlFlow<Status> {
        match room {
            Ok(()) => ControlFlow::Continue(()),
            Err(allocation_error) => {
                self.allocation_error = Some(allocation_error);
                ControlFlow::Break(Status::Stalled)
            }
        }
    }

    /// The last word: what the examined iterate shows, whatever the iteration thought of it.
    pub(super) fn finish(&self, status: Status, merit: f64, report: &mut Report) -> Status {
        let is_proven = merit <= self.settings.tolerance;
        report.status = if status == Status::Converged && !is_proven {
            Status::Stalled
        } else {
            status
        };
        report.time = self.start.elapsed();
        report.status
    }

    fn entry(&self, report: &Report) -> Iteration {
        Iteration {
            iteration: self.steps,
            double_precision_products: report.double_precision_products,
            single_precision_products: report.single_precision_products,
            residual: report.residual,
            free: self.free,
        }
    }
}

/// Reduction of the inner residual per outer step, while the sets make progress.
pub(super) const INNER_REDUCTION: f64 = 0.1;
/// The same at the least: what the sets are decided by may be this part of the largest residual, where cells are long.
const LEAST_REDUCTION: f64 = 1e-6;
/// Outer steps without progress after which the inner solution is taken for too coarse to decide by.
const DOUBT: usize = 2;

/// Residual of the step before, above which single precision tells the sets as well as double does.
const EARLY: f64 = 5e-4;

/// Part of the tolerance to which the last inner iteration reduces the residual.
const LAST: f64 = 0.6;
/// Least reduction still to go to the tolerance at which the linear problem is solved to it at once, though the sets may
/// still change.
const IN_SIGHT: f64 = 0.02;

/// Outer steps in which neither the residual halves nor fewer entries change sets than ever before after which the
/// method is stuck, once the sets stand.
const PATIENCE: usize = 4;

/// What the outer steps have come to.
#[derive(Debug)]
pub(super) struct Progress {
    /// The same while the sets change.
    cycle: usize,
    /// Entries that changed sets in the last step; as many as can be before the first.
    pub(super) changes: usize,
    fewest: usize,
    best: f64,
    without: usize,
    /// Reduction of the inner residual while sets change: once tightened it stays so.
    pub(super) inner_reduction: f64,
}

impl Progress {
    /// Before the first step; `cycle` steps without progress are a cycle.
    pub(super) fn new(cycle: usize, inner_reduction: f64) -> Self {
        Self {
            cycle,
            changes: usize::MAX,
            fewest: usize::MAX,
            best: f64::INFINITY,
            without: 0,
            inner_reduction,
        }
    }

    /// Whether a residual to single precision is enough to go on by.
    pub(super) fn single_precision_suffices(&self) -> bool {
        self.best > EARLY && self.without == 0
    }

    /// Takes note of a step; says if the method is stuck.
    pub(super) fn has_stalled(&mut self, merit: f64) -> bool {
        // Infinite ones do not count as halved.
        if merit < 0.5 * self.best || self.changes < self.fewest {
            self.best = self.best.min(merit);
            self.fewest = self.fewest.min(self.changes);
            self.without = 0;
            return false;
        }
        self.without += 1;
        if self.without >= DOUBT {
            self.inner_reduction = (0.1 * self.inner_reduction).max(LEAST_REDUCTION);
        }
        let patience = if self.changes == 0 {
            PATIENCE
        } else {
            self.cycle
        };
        self.without >= patience
    }

    /// How far the next inner iteration should reduce its residual.
    pub(super) fn reduction(&self, merit: f64, tolerance: f64) -> f64 {
        let last = (LAST * tolerance / merit).clamp(1e-4, INNER_REDUCTION);
        if self.changes == 0 || last > IN_SIGHT {
            last.min(self.inner_reduction)
        } else {
            self.inner_reduction
        }
    }
}
