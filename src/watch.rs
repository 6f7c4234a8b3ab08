//! Who watches long work that is no solve, and ends it.

use std::ops::ControlFlow;

use crate::error::{Error, Result};
use crate::report::{Iteration, Report, Status};

/// Sees every step of an iteration, and may end it.
pub(crate) type Observer<'a> = &'a mut (dyn FnMut(&Iteration) -> ControlFlow<()> + Send);

/// An observer of work that is no solve, with what it is shown.
pub(crate) struct Watch<'a> {
    observer: Observer<'a>,
    shown: Iteration,
}

impl<'a> Watch<'a> {
    pub(crate) fn new(observer: Observer<'a>) -> Self {
        Self {
            observer,
            shown: Iteration {
                iteration: 0,
                double_precision_products: 0,
                single_precision_products: 0,
                residual: f64::INFINITY,
                free: 0,
            },
        }
    }

    /// What is shown from now on of the work so far.
    pub(crate) fn shown(&mut self) -> &mut Iteration {
        &mut self.shown
    }

    /// Asks whether to make another product, or what this work consists of, and counts it.
    ///
    /// # Errors
    /// [`Error::NotConverged`], cancelled.
    pub(crate) fn ask(&mut self) -> Result<()> {
        if (self.observer)(&self.shown).is_break() {
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
