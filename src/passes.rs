//! Several passes of one solve: observers, limits and counts that hold for all of them together.

use std::ops::ControlFlow;

use crate::cgm::{Iteration, Settings};
use crate::clock::Instant;
use crate::elastic::Observer;
use crate::error::{Error, Result};
use crate::report::{Report, Status};

/// An observer that refuses from its first refusal on.
pub(crate) fn with_memory(
    observer: Observer<'_>,
) -> impl FnMut(&Iteration) -> ControlFlow<()> + Send {
    let mut cancelled = false;
    move |iteration| {
        if cancelled || observer(iteration).is_break() {
            cancelled = true;
            return ControlFlow::Break(());
        }
        ControlFlow::Continue(())
    }
}

/// An observer of a further pass, which counts those before it too.
pub(crate) fn with_counts_of(
    earlier: &Report,
    observer: Observer<'_>,
) -> impl FnMut(&Iteration) -> ControlFlow<()> + Send {
    let before = earlier.counts();
    move |step| observer(&step.after(before))
}

/// `Ok` if the limit of iterations leaves some for a further pass, else the report of the solve, which it ends.
pub(crate) fn check_iterations_left(settings: &Settings, report: &mut Report) -> Result<()> {
    if report.iterations < settings.max_iterations {
        return Ok(());
    }
    report.status = Status::IterationLimit;
    Err(Error::NotConverged(Box::new(report.clone())))
}

/// The settings with what earlier passes have left of their limits; [`check_iterations_left`] has found that there are
/// iterations left.
pub(crate) fn with_limits_left(settings: &Settings, start: Instant, earlier: &Report) -> Settings {
    let left = settings.max_iterations - earlier.iterations;
    with_time_left(settings, start).max_iterations(left)
}

/// The status of a pass that observer or clock ended. Any other pass serves what follows it, finished or not.
pub(crate) fn ended_from_outside(outcome: Result<()>) -> Result<Option<Status>> {
    match outcome {
        Ok(()) => Ok(None),
        Err(Error::NotConverged(report)) => {
            let is_outside = matches!(report.status, Status::Cancelled | Status::TimeLimit);
            Ok(is_outside.then_some(report.status))
        }
        Err(error) => Err(error),
    }
}

/// The settings with what is left of their time limit.
pub(crate) fn with_time_left(settings: &Settings, start: Instant) -> Settings {
    Settings {
        time_limit: settings
            .time_limit
            .map(|limit| limit.saturating_sub(start.elapsed())),
        ..*settings
    }
}
