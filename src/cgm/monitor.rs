//! Who watches an iteration, counts its steps and ends it.

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
    pub(super) lack: Option<Error>,
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
            lack: None,
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
    pub(super) fn judge(&mut self, merit: f64, report: &mut Report) -> ControlFlow<Status> {
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
        self.ask(report)?;
        if self.steps >= self.settings.max_iterations {
            return ControlFlow::Break(Status::IterationLimit);
        }
        ControlFlow::Continue(())
    }

    /// Asks observer and clock whether to go on. So, or by [`Self::proceed`], they are asked before every product
    /// that moves the iterate or a step; one that only shows what the iterate is worth is due anyway.
    pub(super) fn ask(&mut self, report: &Report) -> ControlFlow<Status> {
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
    pub(super) fn unless_lacking(&mut self, room: Result<()>) -> ControlFlow<Status> {
        match room {
            Ok(()) => ControlFlow::Continue(()),
            Err(lack) => {
                self.lack = Some(lack);
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
