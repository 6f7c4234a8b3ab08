//! The last way out when sets cycle: proximal points, each found by Newton's method.
//!
//! The minimum of $`f(x) + \tfrac{s}{2} |x - \hat x|^2`$ moves the centre $`\hat x`$ towards the minimum of $`f`$ for
//! every $`s > 0`$, from any start, whatever the sets do (Rockafellar, SIAM J. Control Optim. 14 (1976) 877,
//! <https://doi.org/10.1137/0314056>). The larger the stiffness $`s`$, the better is $`C + s`$ conditioned and the
//! sooner do the sets stand; the smaller, the further the centre moves. So $`s`$ begins at the largest eigenvalue of
//! $`C`$, falls after every stage that is solved, to zero in the end, and rises where the sets cycle again.
//!
//! It is for cells much longer than wide that repeat, where the eigenvalues of $`C`$ span as many decades as the
//! sides, with bounds in the plane: of 10 000 grids of white noise, sheared obliquely, with cells of 1 : 1 to 1 : 1e6
//! and 2 to 15 of them along each side, none is left unsolved; projected gradients alone left 3 in 100. Alone, without the
//! projected gradients before them, they are dearer: of 80 000 solves of random scenes 16 more stalled, and those whose
//! pressure the hardness bounds took half as many products more.

use std::ops::ControlFlow;

use crate::cgm::active_set_solve::{ActiveSetSolve, Precision};
use crate::cgm::law::state::LinearisedSet;
use crate::cgm::newton::newton;
use crate::cgm::{Constraint, reduce};
use crate::memory::fallible;
use crate::numerics::cell_vector::{at, dot, slices, update_cells};
use crate::operator::{Operator, SELF_COMPLIANCE};
use crate::report::Status;

/// Ratio of the stiffnesses of two stages, at most.
const RATIO: f64 = 10.0;
/// A ratio so small that the next stage is stiffer than the last one solved.
const LEAST_RATIO: f64 = 1.3;
/// How much stiffer it is.
const RETREAT: f64 = 3.0;
/// Residual at which a stage is solved: the centre need not be exact.
const SOLVED: f64 = 1e-2;
/// Reduction of the inner residual: sets decided by less exact solutions cycle sooner.
const REDUCTION: f64 = 1e-4;
/// Products that find the largest eigenvalue, of which the order of magnitude is enough.
const POWERS: usize = 8;
/// Attempts without a stiffness after which the residual was not halved before the iteration counts as stalled.
const STALLS: usize = 6;

impl<K: Constraint<N>, const N: usize> ActiveSetSolve<'_, '_, K, N> {
    /// From where the sets have cycled to the end.
    pub(in crate::cgm) fn by_proximal_points(&mut self) -> Status {
        let ended = self.approach();
        self.set_proximal_weight(0.0);
        ended.break_value().unwrap_or(Status::Stalled)
    }

    /// Breaks with a status; continues where the residual no longer falls.
    fn approach(&mut self) -> ControlFlow<Status> {
        let largest = self.largest_eigenvalue()?;
        let least = self.lower_bound.value.max(f64::EPSILON * largest);
        // At their geometric mean the inverse of C is worth as much as no preconditioner.
        self.stiff = (largest * least).sqrt();
        let (mut stiffness, mut ratio) = (largest, RATIO);
        let (mut best, mut stalls) = (f64::INFINITY, 0);
        self.set_centre()?;
        while stalls < STALLS {
            // A stage may end without a step.
            self.count_step();
            self.proceed()?;
            let is_last = stiffness < least;
            self.set_proximal_weight(if is_last { 0.0 } else { stiffness });
            self.inner_reduction = REDUCTION;
            match newton(self) {
                Some(Status::Converged) if !is_last => {
                    self.set_centre()?;
                    ratio = (ratio * ratio).min(RATIO);
                    stiffness /= ratio;
                    continue;
                }
                Some(status) => return ControlFlow::Break(status),
                None => {}
            }
            if is_last {
                let is_halved = self.monitor.best < 0.5 * best;
                best = best.min(self.monitor.best);
                stalls = if is_halved { 0 } else { stalls + 1 };
            }
            self.restore_proximal_centre();
            if ratio > LEAST_RATIO {
                stiffness *= ratio - ratio.sqrt();
                ratio = ratio.sqrt();
            } else {
                stiffness *= RETREAT;
            }
        }
        ControlFlow::Continue(())
    }

    /// By the power method, from the gradient. Where the operator is not symmetric, by the lengths of what it makes of the
    /// cells that can move, beside which alone it is positive.
    fn largest_eigenvalue(&mut self) -> ControlFlow<Status, f64> {
        let is_symmetric = self.problem.operator.is_symmetric();
        let constraint = self.problem.constraint;
        let counts = |i: usize| is_symmetric || constraint.of(i).can_move();
        let w = &mut *self.workspace;
        let gradient = slices(&w.gradient);
        update_cells(&mut w.linear.direction, |i, _| {
            if counts(i) {
                at(&gradient, i)
            } else {
                [0.0; N]
            }
        });
        let mut largest = 0.0;
        for _ in 0..POWERS {
            self.notify_observer()?;
            self.linear().apply(Precision::Single);
            let w = &mut *self.workspace;
            let (direction, image) = (slices(&w.linear.direction), slices(&w.linear.image));
            let [square, along, length] = reduce::sum(self.problem.layout, |i| {
                let (d, u) = (at(&direction, i), at(&image, i));
                let length = if counts(i) { dot(u, u) } else { 0.0 };
                [dot(d, d), dot(d, u), length]
            });
            largest = if is_symmetric {
                along / square
            } else {
                (length / square).sqrt()
            };
            if !(largest.is_finite() && largest > 0.0) {
                return ControlFlow::Break(Status::Stalled);
            }
            update_cells(&mut w.linear.direction, |i, _| {
                at(&image, i).map(|u| if counts(i) { u / largest } else { 0.0 })
            });
        }
        ControlFlow::Continue(largest)
    }

    /// The centre of the stages to come is the present iterate.
    fn set_centre(&mut self) -> ControlFlow<Status> {
        for (centre, x) in self.workspace.centre.iter_mut().zip(&self.x) {
            let room = fallible::resize(centre, x.len(), 0.0);
            self.monitor.record_allocation_failure(room)?;
            centre.copy_from_slice(x);
        }
        ControlFlow::Continue(())
    }

    fn restore_proximal_centre(&mut self) {
        for (x, centre) in self.x.iter_mut().zip(&self.workspace.centre) {
            x.copy_from_slice(centre);
        }
    }

    /// What is solved from now on has this stiffness about the centre, and a residual to match.
    fn set_proximal_weight(&mut self, stiffness: f64) {
        if stiffness.max(self.restraint) > 0.0 {
            self.product_error = f64::INFINITY;
        }
        self.restraint = stiffness;
        let operator = &self.problem.operator;
        self.lower_bound.value = self.problem.lower_bound.value + stiffness;
        self.self_compliance = operator.self_compliance().max(0.0) + SELF_COMPLIANCE * stiffness;
        self.monitor.begin((stiffness > 0.0).then_some(SOLVED));
    }
}
