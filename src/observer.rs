//! Who watches long work that is no solve, and ends it.

use std::ops::ControlFlow;
use std::sync::Arc;

use crate::error::{Error, Result};
use crate::parallel::ranks::RankGroup;
use crate::report::{Iteration, Report, Status};

/// Sees every step of an iteration, and may end it.
pub(crate) type Observer<'a> = &'a mut (dyn FnMut(&Iteration) -> ControlFlow<()> + Send);

/// An observer of work that is no solve, with what it is shown.
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

    /// The same of work that ranks share: the observer is asked on all, and the first decides.
    pub(crate) fn shared(self, team: Option<&Arc<RankGroup>>) -> Self {
        let team = team.cloned();
        Self { team, ..self }
    }

    /// What is shown from now on of the work so far.
    pub(crate) fn shown(&mut self) -> &mut Iteration {
        &mut self.shown
    }

    /// Asks whether to make another product, or what this work consists of, and counts it.
    ///
    /// # Errors
    /// [`Error::NotConverged`], cancelled.
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

/// The observer of work that nobody watches.
pub(crate) fn unwatched(_: &Iteration) -> ControlFlow<()> {
    ControlFlow::Continue(())
}
