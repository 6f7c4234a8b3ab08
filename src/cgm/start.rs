//! A look at a start that has been an answer: where nothing has changed, one product shows that it is one still.

use crate::cgm::active_set_solve::{ActiveSetSolve, IterateStart};
use crate::cgm::totals::{Total, sums_of};
use crate::cgm::{Constraint, LinearisedSet, reduce};
use crate::numerics::cell_vector::{at, slices};
use crate::report::Status;

/// What the caller knows of the start of a solve.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum InitialGuess<const N: usize> {
    Nothing,
    /// It has been an answer at these multipliers: it is looked at first.
    PreviousSolution([f64; N]),
    /// It is near the answer, from coarser cells or extrapolated: its gradient tells where cells become free.
    Interpolated,
}

/// What a sum may miss, of the sum of the magnitudes, and be met but for round-off.
pub(super) const ROUND_OFF: f64 = 1e-13;

impl<K: Constraint<N>, const N: usize> ActiveSetSolve<'_, '_, K, N> {
    /// Ends where the start, at the multipliers it had as an answer, is converged: it is feasible, and what it shows is the
    /// last word. Otherwise the product is at hand, if the start is feasible.
    pub(super) fn verify_start(&mut self, known: InitialGuess<N>) -> Option<Status> {
        let multiplier = match known {
            InitialGuess::PreviousSolution(multiplier) => multiplier,
            InitialGuess::Interpolated => {
                self.start = IterateStart::Near;
                return None;
            }
            InitialGuess::Nothing => return None,
        };
        if !self.is_feasible(multiplier) {
            return None;
        }
        self.refresh();
        self.start = IterateStart::Verified;
        self.workspace.multiplier = multiplier;
        let findings = self.certificate();
        let merit = self.merit(&findings);
        if merit > self.monitor.tolerance() || merit.is_nan() {
            return None;
        }
        let status = self.check_termination(merit).break_value()?;
        let report = &mut self.workspace.linear.report;
        Some(self.monitor.finish(status, merit, report))
    }

    /// Whether the unknowns are in their sets and have their totals, but for round-off.
    fn is_feasible(&self, multiplier: [f64; N]) -> bool {
        let constraint = self.problem.constraint;
        let x = slices(&self.x);
        let sums = sums_of(self.layout(), &x);
        let has_total = |c: usize| match self.problem.totals[c] {
            Total::Free => multiplier[c] == 0.0,
            Total::Sum(sum) => (sum - sums[c][0]).abs() <= ROUND_OFF * sums[c][1],
            // What the spring makes of the sum, but for round-off.
            total @ Total::Spring { .. } => {
                total.held(multiplier[c], sums[c]) - multiplier[c] == 0.0
            }
        };
        (0..N).all(has_total)
            && !reduce::any(self.layout(), |i| constraint.of(i).excess(at(&x, i)) != 0.0)
    }
}
