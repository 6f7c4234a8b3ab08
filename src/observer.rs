//! Observer of long-running work other than a solve. The observer may cancel that work.

use std::ops::ControlFlow;
use std::sync::Arc;

use crate::error::{Error, Result};
use crate::parallel::ranks::RankGroup;
use crate::report::{Iteration, Report, Status};

/// Callback that receives every step of an iteration and may cancel the iteration.
pub(crate) type Observer<'a> = &'a mut (dyn FnMut(&Iteration) -> ControlFlow<()> + Send);

/// Observer of work other than a solve, together with the progress that it receives.
pub(crate) struct WorkObserver<'a> {
    observer: Observer<'a>,
    shown: Iteration,
    team: Option<Arc<RankGroup>>,
}

impl<'a> WorkObserver<'a> {
    pub(crate) fn new(observer: Observer<'a>) -> Self {
        Self {
            observer,
            team: None,
            shown: Iteration {
                iteration: 0,
                double_precision_products: 0,
                single_precision_products: 0,
                residual: f64::INFINITY,
                free: 0,
            },
        }
    }

    /// Makes the observation collective: the observer is called on all ranks, and the decision of the first rank
    /// applies to all.
    pub(crate) fn shared(self, team: Option<&Arc<RankGroup>>) -> Self {
        let team = team.cloned();
        Self { team, ..self }
    }

    /// Returns the progress for changes by the caller. The observer receives it at its next call.
    pub(crate) fn shown(&mut self) -> &mut Iteration {
        &mut self.shown
    }

    /// Calls the observer before the next product or the next unit of other work, and counts this product or unit.
    ///
    /// # Errors
    /// - [`Error::NotConverged`] with the status [`Status::Cancelled`] if the observer cancels.
    pub(crate) fn notify_observer(&mut self) -> Result<()> {
        let is_over = (self.observer)(&self.shown).is_break();
        let is_over = match &self.team {
            Some(team) => team.decided(is_over.into()) != Some(0),
            None => is_over,
        };
        if is_over {
            return Err(Error::NotConverged(Box::new(Report {
                status: Status::Cancelled,
                iterations: self.shown.iteration,
                double_precision_products: self.shown.double_precision_products,
                residual: self.shown.residual,
                ..Report::unsolved()
            })));
        }
        self.shown.double_precision_products += 1;
        Ok(())
    }
}

/// Observer that never cancels.
pub(crate) fn unwatched(_: &Iteration) -> ControlFlow<()> {
    ControlFlow::Continue(())
}
