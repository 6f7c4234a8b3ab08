//! Settings, clock and observer shared by the passes of one solve, and the limits and counts that apply to all passes together.

use std::ops::ControlFlow;
use std::sync::atomic::{AtomicBool, Ordering};

use crate::cgm::Settings;
use crate::error::{Error, Result};
use crate::half_space::HalfSpace;
use crate::observer::Observer;
use crate::report::Iteration;
use crate::report::{Report, Status};
use crate::support::clock::Instant;

/// Maximum relative tolerance of a coarse solution. A larger tolerance would shift the contact edges by more cells.
const COARSE_TOLERANCE: f64 = 3e-3;
/// Tolerance of a coarse solution as a fraction of the initial residual of the next coarser solve. The start prolongated from the
/// solution has an error of about this size. A stricter tolerance costs more than it saves on the finer grid.
const COARSE_PART: f64 = 0.5;
/// Minimum relative tolerance of a coarse solution.
const LEAST_COARSE_TOLERANCE: f64 = 1e-5;
/// Maximum number of steps of a coarse solve. A coarse solution that needs more steps costs more than it saves.
const COARSE_STEPS: usize = 100;

/// Settings, clock and observer of a solve.
pub(crate) struct SolveContext<'a, 'b> {
    pub(crate) settings: &'a Settings,
    pub(crate) start: Instant,
    pub(crate) observer: Observer<'b>,
}

impl<'a, 'b> SolveContext<'a, 'b> {
    /// Creates the context and starts the clock.
    pub(crate) fn new(settings: &'a Settings, observer: Observer<'b>) -> Self {
        Self {
            settings,
            start: Instant::now(),
            observer,
        }
    }

    /// Returns the same clock and observer with other settings.
    pub(crate) fn under<'c>(&'c mut self, settings: &'c Settings) -> SolveContext<'c, 'c> {
        SolveContext {
            settings,
            start: self.start,
            observer: &mut *self.observer,
        }
    }

    /// Returns the settings with the remaining time limit.
    pub(crate) fn with_remaining_time(&self) -> Settings {
        Settings {
            time_limit: self
                .settings
                .time_limit
                .map(|limit| limit.saturating_sub(self.start.elapsed())),
            ..*self.settings
        }
    }

    /// Returns the settings with the limits that remain after earlier passes, and with at least one step.
    pub(crate) fn with_remaining_limits(&self, earlier: &Report) -> Settings {
        let steps = self.settings.max_iterations;
        let left = steps.saturating_sub(earlier.iterations).max(1);
        self.with_remaining_time().max_iterations(left)
    }

    /// Returns an error with the report of the solve if the iteration limit leaves no step for a further pass.
    pub(crate) fn check_iterations_left(&self, report: &mut Report) -> Result<()> {
        if report.iterations < self.settings.max_iterations {
            return Ok(());
        }
        report.status = Status::IterationLimit;
        Err(Error::NotConverged(Box::new(report.clone())))
    }

    /// Returns the settings of a coarse solve: a loose tolerance and the remaining time. `residual` is the initial residual of
    /// the next coarser solve, from which the start was prolongated.
    pub(crate) fn coarse_settings(&self, residual: f64) -> Settings {
        // In this order of operations, a NaN residual gives the largest tolerance.
        let loose = (COARSE_PART * residual).min(COARSE_TOLERANCE);
        let least = self.settings.tolerance.max(LEAST_COARSE_TOLERANCE);
        self.with_remaining_time()
            .tolerance(loose.max(least))
            .max_iterations(self.settings.max_iterations.min(COARSE_STEPS))
    }
}

/// Record of whether the observer of a solve has cancelled it.
///
/// A cancelled pass of a solve may still provide a result, and the following pass may end without another product. The solve
/// still reports [`Status::Cancelled`].
#[derive(Debug, Default)]
pub(crate) struct Cancellation(AtomicBool);

impl Cancellation {
    /// Returns an observer that records the first cancellation and cancels at every later call.
    pub(crate) fn record<'a>(
        &'a self,
        mut observer: impl FnMut(&Iteration) -> ControlFlow<()> + Send + 'a,
    ) -> impl FnMut(&Iteration) -> ControlFlow<()> + Send + 'a {
        move |iteration| {
            if self.is_recorded() || observer(iteration).is_break() {
                self.0.store(true, Ordering::Relaxed);
                return ControlFlow::Break(());
            }
            ControlFlow::Continue(())
        }
    }

    /// Returns an observer that [records](Self::record) a cancellation and is not called after the time limit.
    pub(crate) fn watch<'a>(
        &'a self,
        settings: &Settings,
        observer: Observer<'a>,
    ) -> impl FnMut(&Iteration) -> ControlFlow<()> + Send + 'a {
        self.record(within_time(settings, observer))
    }

    fn is_recorded(&self) -> bool {
        self.0.load(Ordering::Relaxed)
    }

    /// Returns the outcome, or the error of a cancelled solve. `report` marks the report of the solve as cancelled and returns
    /// it. The first rank of the team decides for all its ranks.
    ///
    /// # Errors
    /// - [`Error::NotConverged`] if the solve was cancelled.
    /// - The errors of the outcome.
    pub(crate) fn applied<T>(
        &self,
        bodies: &HalfSpace,
        outcome: Result<T>,
        report: impl FnOnce() -> Report,
    ) -> Result<T> {
        let own = self.is_recorded();
        let is_cancelled = match bodies.team() {
            Some(team) => team.decided(own.into()) == Some(1),
            None => own,
        };
        match outcome {
            outcome if !is_cancelled => outcome,
            Err(Error::NotConverged(found)) if found.status == Status::Cancelled => {
                Err(Error::NotConverged(found))
            }
            Ok(_) | Err(Error::NotConverged(_) | Error::BeyondFrictionCapacity { .. }) => {
                let report = report();
                Err(Error::NotConverged(Box::new(report)))
            }
            outcome => outcome,
        }
    }
}

/// Returns an observer that is not called after the time limit. A solve of several passes or grids ends each of them separately,
/// and each checks the observer before the clock.
pub(crate) fn within_time<'a>(
    settings: &Settings,
    observer: Observer<'a>,
) -> impl FnMut(&Iteration) -> ControlFlow<()> + Send + use<'a> {
    let (start, limit) = (Instant::now(), settings.time_limit);
    move |iteration| {
        if limit.is_some_and(|limit| start.elapsed() >= limit) {
            ControlFlow::Continue(())
        } else {
            observer(iteration)
        }
    }
}

/// Returns an observer for a further pass that adds the counts of the earlier passes.
pub(crate) fn with_counts_of<'a>(
    earlier: &Report,
    observer: Observer<'a>,
) -> impl FnMut(&Iteration) -> ControlFlow<()> + Send + use<'a> {
    let before = earlier.counts();
    move |step| observer(&step.after(before))
}

/// Returns whether a solve has left an iterate, which need not have converged.
pub(crate) fn has_iterate(outcome: &Result<()>) -> bool {
    matches!(outcome, Ok(()) | Err(Error::NotConverged(_)))
}

/// Returns the status of a pass that the observer or the clock ended. The next pass uses the result of any other pass, whether or
/// not this pass converged.
pub(crate) fn interrupted_status(outcome: Result<()>) -> Result<Option<Status>> {
    match outcome {
        Ok(()) => Ok(None),
        Err(Error::NotConverged(report)) => {
            let is_outside = matches!(report.status, Status::Cancelled | Status::TimeLimit);
            Ok(is_outside.then_some(report.status))
        }
        Err(error) => Err(error),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn coarse_answers_are_as_good_as_their_starts_within_limits() {
        for (asked, residual, tolerance) in [
            (1e-6, 1e-3, 5e-4),
            (1e-6, f64::INFINITY, 3e-3),
            (1e-6, f64::NAN, 3e-3),
            (1e-6, 1e-9, 1e-5),
            (1e-6, 0.0, 1e-5),
            (1e-3, 1e-4, 1e-3),
            (1e-2, f64::INFINITY, 1e-2),
        ] {
            let settings = Settings::default().tolerance(asked);
            let mut observer = |_: &Iteration| ControlFlow::Continue(());
            let conditions = SolveContext::new(&settings, &mut observer);
            let found = conditions.coarse_settings(residual).tolerance;
            assert!(
                (found - tolerance).abs() <= 1e-15,
                "of {residual} at {asked}: {found}"
            );
        }
    }
}
