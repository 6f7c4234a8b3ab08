//! Warm start from an earlier solution. If the problem has not changed, the certificate of one product shows that the earlier
//! solution is still valid.

use std::ops::ControlFlow;

use crate::cgm::active_set_solve::ActiveSetSolve;
use crate::cgm::totals::{Total, sums_of};
use crate::cgm::{Constraint, LinearisedSet, reduce};
use crate::numerics::cell_vector::{at, slices};

/// The caller's knowledge about the start of a solve.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum InitialGuess<const N: usize> {
    Nothing,
    /// The start was a solution with these multipliers. The solver examines it first.
    PreviousSolution([f64; N]),
    /// The start is near the solution because it is prolongated from a coarser grid or extrapolated. Its gradient identifies the
    /// cells that become free.
    Interpolated,
}

/// Relative deviation of a sum, measured by the sum of magnitudes, that counts as round-off.
pub(super) const ROUND_OFF: f64 = 1e-13;

impl<K: Constraint<N>, const N: usize> ActiveSetSolve<'_, '_, K, N> {
    /// Examines the start with the multipliers of its earlier solve. If the start is feasible and its merit is within the
    /// tolerance, completes the solve and returns `true`. Otherwise the product is up to date if the start is feasible.
    pub(super) fn verify_start(&mut self, known: InitialGuess<N>) -> bool {
        let InitialGuess::PreviousSolution(multiplier) = known else {
            self.start = known;
            return false;
        };
        if !self.is_feasible(multiplier) {
            return false;
        }
        self.refresh();
        self.start = known;
        self.workspace.multiplier = multiplier;
        let findings = self.certificate();
        let merit = self.merit(&findings);
        if merit > self.monitor.tolerance() || merit.is_nan() {
            return false;
        }
        let ended = self.monitor.check_termination(merit);
        if let ControlFlow::Break(status) = ended {
            let report = &mut self.workspace.linear.report;
            self.monitor.finish(status, merit, report);
        }
        ended.is_break()
    }

    /// Returns whether the unknowns are in their sets and meet their totals, up to round-off.
    fn is_feasible(&self, multiplier: [f64; N]) -> bool {
        let constraint = self.problem.constraint;
        let x = slices(&self.x);
        let sums = sums_of(self.layout(), &x);
        let has_total = |c: usize| match self.problem.totals[c] {
            Total::Free => multiplier[c] == 0.0,
            Total::Sum(sum) => (sum - sums[c][0]).abs() <= ROUND_OFF * sums[c][1],
            // The multiplier must equal the value of the spring for this sum, up to round-off.
            total @ Total::Spring { .. } => {
                total.held(multiplier[c], sums[c]) - multiplier[c] == 0.0
            }
        };
        (0..N).all(has_total)
            && !reduce::any(self.layout(), |i| constraint.of(i).excess(at(&x, i)) != 0.0)
    }
}
