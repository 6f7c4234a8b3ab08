//! Who watches the solves behind a stiffness, and what they have cost together.

use std::ops::ControlFlow;

use crate::cgm::{Held, LinearWorkspace, Row};
use crate::contact::with_counts_of;
use crate::error::{Error, Result};
use crate::observer::Observer;
use crate::parallel::layout::Layout;
use crate::report::{EigenvalueBound, Iteration, Report, Status};

/// What is asked of the solves, and their report.
pub(super) struct Course<'a> {
    pub(super) tolerance: f64,
    /// Whether the stiffness at reversal is asked for too.
    pub(super) has_reversal: bool,
    pub(super) report: &'a mut Report,
    pub(super) observer: Observer<'a>,
}

impl Course<'_> {
    /// Finds the unknowns that answer a right side, to the tolerance or to where round-off leaves them.
    pub(super) fn respond<R: Row<N>, const N: usize>(
        &mut self,
        held: &Held<'_, N>,
        right: &[[f64; N]],
        unknowns: &mut Vec<[f64; N]>,
        workspace: &mut LinearWorkspace<R, N>,
    ) -> Result<()> {
        let mut observer = with_counts_of(self.report, &mut *self.observer);
        let outcome = held.respond(right, unknowns, workspace, self.tolerance, &mut observer);
        drop(observer);
        let bound = self.report.eigenvalue_bound;
        self.report.add_pass(workspace.report());
        self.report.eigenvalue_bound = bound;
        outcome.map_err(|error| match error {
            Error::NotConverged(_) => Error::NotConverged(Box::new(self.report.clone())),
            other => other,
        })
    }

    /// A bound rests on an eigenvalue known so, beside those found before.
    pub(super) fn rest_on(&mut self, known: EigenvalueBound) {
        let report = &mut *self.report;
        report.eigenvalue_bound = match report.eigenvalue_bound {
            EigenvalueBound::Unknown => known,
            before => before.min(known),
        };
    }

    /// `Ok` if the last solve has come to the tolerance, and not only to where round-off leaves it.
    pub(super) fn check_solved(&self) -> Result<()> {
        if self.report.is_converged() {
            Ok(())
        } else {
            Err(Error::NotConverged(Box::new(self.report.clone())))
        }
    }

    /// Nothing is to be solved.
    pub(super) fn finish_at_once(&mut self) {
        self.report.status = Status::Converged;
        self.report.residual = 0.0;
    }

    /// Asks the observer, the same of all ranks, before a product beside the solves, and counts it.
    pub(super) fn ask(&mut self, layout: &Layout) -> Result<()> {
        let report = &mut *self.report;
        let shown = Iteration {
            iteration: report.iterations,
            double_precision_products: report.double_precision_products,
            single_precision_products: report.single_precision_products,
            residual: report.residual,
            free: 0,
        };
        let own = (self.observer)(&shown).map_break(|()| Status::Cancelled);
        if let ControlFlow::Break(status) = layout.decided(own) {
            report.status = status;
            return Err(Error::NotConverged(Box::new(report.clone())));
        }
        report.double_precision_products += 1;
        Ok(())
    }
}
