//! First fallback when sets cycle: projected gradients with Barzilai-Borwein step lengths.
//!
//! Every step moves along `P(x - a g) - x` to the minimum of the objective on this segment. `P` is the exact projection on sets
//! and sums. The objective decreases at every step for any start and any behaviour of the sets (Dai & Fletcher, Mathematical
//! Programming 106 (2006) 403, <https://doi.org/10.1007/s10107-005-0595-2>). A few steps move the other methods away from most
//! cycles. Many steps would be slow, and ineffective for an ill-conditioned operator.

use std::ops::ControlFlow;

use crate::cgm::active_set_solve::{ActiveSetSolve, Precision};
use crate::cgm::law::state::LinearisedSet;
use crate::cgm::totals::{Total, sums_of};
use crate::cgm::{Constraint, ConstraintSet, reduce};
use crate::numerics::cell_vector::{at, dot, minus, plus, slices, slices_mut, update_cells};
use crate::report::Status;

/// Behaviour of the objective in the last step.
pub(in crate::cgm) enum Objective {
    Falls,
    /// The objective no longer decreases by more than round-off.
    Stands,
}

impl<K: Constraint<N>, const N: usize> ActiveSetSolve<'_, '_, K, N> {
    /// Takes at most `steps` steps from the current iterate.
    pub(in crate::cgm) fn project_gradients(
        &mut self,
        steps: usize,
    ) -> ControlFlow<Status, Objective> {
        self.mark_start();
        self.restore_totals(true);
        self.monitor.notify_observer()?;
        self.refresh();
        self.monitor.notify_observer()?;
        let Some(mut length) = self.length_without_bounds() else {
            return ControlFlow::Continue(Objective::Stands);
        };
        for _ in 0..steps {
            self.set_multiplier_of_all();
            let [descent, square] = self.set_projected_direction(length);
            if descent.is_nan() || descent >= 0.0 {
                return ControlFlow::Continue(Objective::Stands);
            }
            self.monitor.proceed()?;
            self.linear().apply(Precision::Double);
            self.monitor.count_step();
            let curvature = self.curvature_of_all();
            if curvature.is_nan() || curvature <= 0.0 {
                return ControlFlow::Continue(Objective::Stands);
            }
            self.go_along((-descent / curvature).min(1.0));
            length = square / curvature;
        }
        ControlFlow::Continue(Objective::Falls)
    }

    /// Returns an initial step length: the length of a steepest-descent step without bounds.
    fn length_without_bounds(&mut self) -> Option<f64> {
        let w = &mut *self.workspace;
        for (direction, gradient) in w.linear.direction.iter_mut().zip(&w.gradient) {
            direction.copy_from_slice(gradient);
        }
        self.linear().apply(Precision::Double);
        let direction = slices(&self.workspace.linear.direction);
        let square = reduce::sum(self.layout(), |i| dot(at(&direction, i), at(&direction, i)));
        let curvature = self.curvature_of_all();
        (curvature > 0.0).then(|| square / curvature)
    }

    /// Sets the multipliers of the springs, and the multipliers of prescribed sums to the mean gradient. The mean does not affect
    /// the steps, but round-off would dominate the products if the mean were not subtracted.
    fn set_multiplier_of_all(&mut self) {
        let totals = self.problem.totals;
        if totals == [Total::Free; N] {
            return;
        }
        let constraint = self.problem.constraint;
        let gradient = slices(&self.workspace.gradient);
        let (sum, count): ([f64; N], f64) = reduce::sum(self.layout(), |i| {
            if constraint.of(i).can_move() {
                (at(&gradient, i), 1.0)
            } else {
                ([0.0; N], 0.0)
            }
        });
        let sums = sums_of(self.layout(), &slices(&self.x));
        self.workspace.multiplier =
            std::array::from_fn(|c| totals[c].held(sum[c] / count, sums[c]));
    }

    /// Computes `d = P(x - a g) - x`. Returns `[g'd, d'd]`.
    fn set_projected_direction(&mut self, length: f64) -> [f64; 2] {
        let (constraint, sums) = (self.problem.constraint, self.sums());
        let w = &mut *self.workspace;
        let (x, gradient, multiplier) = (slices(&self.x), slices(&w.gradient), w.multiplier);
        let slope = |i: usize| minus(at(&gradient, i), multiplier);
        update_cells(&mut w.linear.direction, |i, _| {
            plus(at(&x, i), -length, slope(i))
        });
        if sums != [None; N] {
            K::Set::restore(
                self.problem.layout,
                slices_mut(&mut w.linear.direction),
                constraint,
                |_| true,
                sums,
            );
        }
        update_cells(&mut w.linear.direction, |i, d| {
            minus(constraint.of(i).project(d), at(&x, i))
        });
        let direction = slices(&w.linear.direction);
        reduce::sum(self.problem.layout, |i| {
            let d = at(&direction, i);
            [dot(slope(i), d), dot(d, d)]
        })
    }

    /// Returns `d' C d` of the direction, including the contribution of the springs.
    fn curvature_of_all(&self) -> f64 {
        let w = &*self.workspace;
        let (direction, image) = (slices(&w.linear.direction), slices(&w.linear.image));
        let (bodies, sums): (f64, [f64; N]) = reduce::sum(self.layout(), |i| {
            let d = at(&direction, i);
            (dot(d, at(&image, i)), d)
        });
        let springs = self.problem.totals.iter().zip(sums);
        springs.fold(bodies, |curvature, (total, sum)| {
            let added = |compliance| curvature + compliance * sum * sum;
            total.compliance().map_or(curvature, added)
        })
    }

    /// Moves along a fraction of the direction.
    fn go_along(&mut self, part: f64) {
        let constraint = self.problem.constraint;
        let w = &mut *self.workspace;
        let (direction, image) = (slices(&w.linear.direction), slices(&w.linear.image));
        update_cells(&mut self.x, |i, x| {
            constraint
                .of(i)
                .arrive(x, at(&direction, i).map(|d| part * d))
        });
        update_cells(&mut w.gradient, |i, g| plus(g, part, at(&image, i)));
        self.product_error = f64::INFINITY;
    }
}
