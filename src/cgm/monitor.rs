//! Monitor of an iteration of any method: observer, report, step counts and stopping rules.

use std::ops::ControlFlow;

use crate::cgm::Settings;
use crate::error::{Error, Result};
use crate::observer::Observer;
use crate::parallel::layout::Layout;
use crate::report::{Iteration, Report, Status};
use crate::support::clock::Instant;

/// Residual at which only round-off changes the sets.
const ROUND_OFF: f64 = 1e-12;

/// Settings, observer, report and clock of one solve.
pub(super) struct Monitor<'a> {
    pub(super) settings: &'a Settings,
    layout: &'a Layout,
    observer: Observer<'a>,
    /// Report of the solve, which [`Self::finish`] returns to its workspace.
    pub(super) report: Report,
    start: Instant,
    /// Least merit so far of the current stage or problem.
    pub(super) best: f64,
    /// Residual at which the current proximal-point stage ends, or `None` outside a stage.
    stage: Option<f64>,
    /// Number of free cells at the last examination.
    pub(super) free: usize,
    /// Error of a failed allocation during the solve, if any. The solve ends with this error.
    pub(super) allocation_error: Option<Error>,
}

impl<'a> Monitor<'a> {
    /// Creates a monitor, takes and resets the report of a workspace and starts the clock.
    pub(super) fn new(
        settings: &'a Settings,
        layout: &'a Layout,
        observer: Observer<'a>,
        report: &mut Report,
    ) -> Self {
        let mut report = std::mem::replace(report, Report::unsolved());
        report.iterations = 0;
        report.double_precision_products = 0;
        report.single_precision_products = 0;
        report.residual = f64::INFINITY;
        report.history.clear();
        Self {
            settings,
            layout,
            observer,
            report,
            start: Instant::now(),
            best: f64::INFINITY,
            stage: None,
            free: 0,
            allocation_error: None,
        }
    }

    /// Starts a proximal-point stage with this tolerance, or the original problem for `None`.
    pub(super) fn begin(&mut self, stage: Option<f64>) {
        self.stage = stage;
        self.best = f64::INFINITY;
    }

    /// Returns whether the original problem is being solved, not a stage.
    pub(super) fn is_last(&self) -> bool {
        self.stage.is_none()
    }

    /// Returns the residual at which the current stage or problem ends.
    pub(super) fn tolerance(&self) -> f64 {
        self.stage.unwrap_or(self.settings.tolerance)
    }

    /// Records an examined step. Breaks if it is the last step, because the iteration has converged or must stop.
    pub(super) fn check_termination(&mut self, merit: f64) -> ControlFlow<Status> {
        if self.stage.is_none() {
            let entry = self.entry();
            self.report.history.push(entry);
        }
        if merit.is_nan() {
            return ControlFlow::Break(Status::Stalled);
        }
        self.best = self.best.min(merit);
        if merit <= self.tolerance() {
            return ControlFlow::Break(Status::Converged);
        }
        self.proceed()
    }

    /// Returns the final status if the residual is round-off and no longer falls. Otherwise returns `None`.
    pub(super) fn stuck(&self) -> Option<Status> {
        (self.best <= ROUND_OFF).then_some(Status::Stalled)
    }

    /// Counts a step.
    pub(super) fn count_step(&mut self) {
        self.report.iterations += 1;
    }

    /// Checks observer, clock and step limit. Breaks if no further step may be taken.
    pub(super) fn proceed(&mut self) -> ControlFlow<Status> {
        self.notify_observer()?;
        if self.report.iterations >= self.settings.max_iterations {
            return ControlFlow::Break(Status::IterationLimit);
        }
        ControlFlow::Continue(())
    }

    /// Checks observer and clock. This function or [`Self::proceed`] is called before every step and before every product that
    /// moves the iterate. A product that only measures the iterate is computed without a check.
    pub(super) fn notify_observer(&mut self) -> ControlFlow<Status> {
        let entry = self.entry();
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

    /// Breaks if an allocation has failed.
    pub(super) fn record_allocation_failure(&mut self, room: Result<()>) -> ControlFlow<Status> {
        match room {
            Ok(()) => ControlFlow::Continue(()),
            Err(allocation_error) => {
                self.allocation_error = Some(allocation_error);
                ControlFlow::Break(Status::Stalled)
            }
        }
    }

    /// Sets the final status and returns the report to its workspace. A solve counts as converged only if the merit of the
    /// examined iterate proves it.
    pub(super) fn finish(&mut self, status: Status, merit: f64, report: &mut Report) -> Status {
        std::mem::swap(report, &mut self.report);
        let is_proven = merit <= self.settings.tolerance;
        report.status = if status == Status::Converged && !is_proven {
            Status::Stalled
        } else {
            status
        };
        report.time = self.start.elapsed();
        report.status
    }

    fn entry(&self) -> Iteration {
        let report = &self.report;
        Iteration {
            iteration: report.iterations,
            double_precision_products: report.double_precision_products,
            single_precision_products: report.single_precision_products,
            residual: report.residual,
            free: self.free,
        }
    }
}

/// Reduction of the inner residual per outer step while the sets make progress.
pub(super) const INNER_REDUCTION: f64 = 0.1;
/// Lower limit of the reduction of the inner residual. With long cells, the sets may depend on gradients as small as this
/// fraction of the largest residual.
const LEAST_REDUCTION: f64 = 1e-6;
/// Number of outer steps without progress after which the inner solution counts as too coarse to update the sets.
const DOUBT: usize = 2;

/// Best residual above which single precision identifies the sets as well as double precision.
const EARLY: f64 = 5e-4;

/// Fraction of the tolerance to which the last inner iteration reduces the residual.
const LAST: f64 = 0.6;
/// Remaining reduction above which the linear problem is solved to the tolerance in one step. The sets may still change after
/// this step.
const IN_SIGHT: f64 = 0.02;

/// Number of outer steps without progress after which the method counts as stuck if the sets no longer change. A step makes
/// progress if the residual halves, if fewer entries than ever before change sets, or if the slip grows by [`SLIP_GROWTH`].
const PATIENCE: usize = 4;

/// Growth of the mean slip that counts as progress while all cells slip. Near the sliding force, the angles between tractions and
/// force are small. The deficit from the sliding force is quadratic in the angles, so a step halves angles that are too large.
/// The slip then doubles, whereas the residual hardly changes.
const SLIP_GROWTH: f64 = 1.5;

/// Progress of the outer iterations.
#[derive(Debug)]
pub(super) struct Progress {
    /// Number of steps without progress that count as a cycle while the sets change.
    cycle: usize,
    /// Number of entries that changed sets in the last step, or `usize::MAX` before the first step.
    pub(super) changes: usize,
    fewest: usize,
    best: f64,
    /// Largest slip so far while all cells slip; zero before such a step.
    largest_slip: f64,
    without: usize,
    /// Reduction of the inner residual while sets change. The value may decrease but never increases.
    pub(super) inner_reduction: f64,
}

impl Progress {
    /// Creates the state before the first step. `cycle` steps without progress count as a cycle.
    pub(super) fn new(cycle: usize, inner_reduction: f64) -> Self {
        Self {
            cycle,
            changes: usize::MAX,
            fewest: usize::MAX,
            best: f64::INFINITY,
            largest_slip: 0.0,
            without: 0,
            inner_reduction,
        }
    }

    /// Returns whether a residual in single precision suffices to continue.
    pub(super) fn single_precision_suffices(&self) -> bool {
        self.best > EARLY && self.without == 0
    }

    /// Records a step. Returns whether the method is stuck. `slip` is the mean slip if all cells slip under a prescribed sum,
    /// else zero.
    pub(super) fn has_stalled(&mut self, merit: f64, slip: f64) -> bool {
        let slips_more = self.largest_slip > 0.0 && slip > SLIP_GROWTH * self.largest_slip;
        self.largest_slip = self.largest_slip.max(slip);
        // An infinite residual does not count as halved.
        if merit < 0.5 * self.best || self.changes < self.fewest || slips_more {
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

    /// Returns the reduction of the residual for the next inner iteration.
    pub(super) fn reduction(&self, merit: f64, tolerance: f64) -> f64 {
        let last = (LAST * tolerance / merit).clamp(1e-4, INNER_REDUCTION);
        if self.changes == 0 || last > IN_SIGHT {
            last.min(self.inner_reduction)
        } else {
            self.inner_reduction
        }
    }
}
