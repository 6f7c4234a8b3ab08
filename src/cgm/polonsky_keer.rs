//! Method of Polonsky & Keer: a single loop of conjugate gradients with clipping, for bounds on both sides.
//!
//! For the bounds `|q| <= mu p` the method is the tangential loop of Wang et al. (2021), eqs 17-26. Three errors of the paper are
//! corrected. Entries inside the bounds are clipped as well (eq 21). An entry that becomes free is clipped on both sides (eq 22).
//! The conjugation term has a positive sign (eq 24).

use std::ops::ControlFlow;

use crate::cgm::active_set_solve::{ActiveSetSolve, Precision};
use crate::cgm::law::interval::{IntervalMotion, shift_to_total};
use crate::cgm::law::state::CellMotion;
use crate::cgm::reduce::Reduction;
use crate::cgm::{Constraint, ConstraintSet, Interval, reduce};
use crate::numerics::cell_vector::{at, plus, slices, update_cells};
use crate::parallel::Blocks;
use crate::report::Status;

/// Number of steps between fresh products if nothing requires one earlier.
const REFRESH: usize = 25;
/// Number of steps without halving the residual after which the loop is stuck.
const PATIENCE: usize = 200;

/// Number of entries that changed sets in a step.
struct SetChanges {
    clipped: usize,
    entered: usize,
}

impl<K: Constraint<1, Set = Interval>> ActiveSetSolve<'_, '_, K, 1> {
    /// Runs the single loop. Returns the final status, or `None` if the sets cycle.
    pub(super) fn polonsky_keer(&mut self) -> Option<Status> {
        self.mark_start();
        self.restore_total();
        let (mut previous, mut conjugate) = (0.0, false);
        let (mut best, mut without_progress) = (f64::INFINITY, 0);
        let mut since_refresh = REFRESH;
        loop {
            if since_refresh >= REFRESH {
                if let ControlFlow::Break(status) = self.notify_observer() {
                    return Some(status);
                }
                self.refresh();
                since_refresh = 0;
            }
            let free = self.set_mean_of_free();
            let findings = self.certificate();
            let merit = self.merit(&findings);
            if merit <= self.monitor.tolerance() && !self.is_fresh() {
                since_refresh = REFRESH;
                continue;
            }
            self.monitor.free = free;
            if let ControlFlow::Break(status) = self.check_termination(merit) {
                return Some(status);
            }
            if merit < 0.5 * best {
                (best, without_progress) = (merit, 0);
            } else {
                without_progress += 1;
                if without_progress >= PATIENCE {
                    return self.monitor.stuck();
                }
            }

            // The direction is d = r + theta (R / R_old) d (eq 24). Its mean is removed so that the step keeps the total.
            let squares = self.squares_of_free();
            let conjugation = if conjugate { squares / previous } else { 0.0 };
            previous = squares;
            self.set_direction_of_free(conjugation, free);
            self.linear().apply(Precision::Double);
            self.count_step();
            let length = self.length_of_free();
            let moves = self.step_and_clip(length);
            conjugate = moves.entered == 0 && squares > 0.0;
            if moves.clipped + moves.entered > 0 {
                self.restore_total();
                since_refresh = REFRESH;
            } else {
                self.follow(length);
                since_refresh += 1;
            }
        }
    }

    /// Returns `r_i`, the gradient minus the multiplier (eq 19), on a free entry and zero on other entries.
    fn residual_if_free(&self) -> impl Fn(usize) -> f64 + Sync {
        let w = &*self.workspace;
        let (state, [gradient], [multiplier]) = (&w.linear.rows, &w.gradient, w.multiplier);
        move |i| {
            if state[i] == IntervalMotion::Free {
                gradient[i] - multiplier
            } else {
                0.0
            }
        }
    }

    /// Sets the multiplier of a prescribed total to the mean gradient on the free entries (eq 18). Returns the number of free
    /// entries.
    fn set_mean_of_free(&mut self) -> usize {
        let w = &mut *self.workspace;
        let [gradient] = &w.gradient;
        let (count, sum) = reduce::over_chunks(self.problem.layout, |range| {
            let free = range.filter(|&i| w.linear.rows[i] == IntervalMotion::Free);
            free.fold((0_usize, 0.0), |(count, sum), i| {
                (count + 1, sum + gradient[i])
            })
        });
        if self.problem.totals[0].sum().is_some() && count > 0 {
            w.multiplier = [sum / count as f64];
        }
        count
    }

    /// Returns `R = sum r^2` over the free entries (eq 20).
    fn squares_of_free(&self) -> f64 {
        let r = self.residual_if_free();
        reduce::sum(self.layout(), |i| r(i).powi(2))
    }

    fn set_direction_of_free(&mut self, conjugation: f64, free: usize) {
        let has_total = self.sums() != [None];
        let w = &mut *self.workspace;
        let (state, [gradient], [multiplier]) = (&w.linear.rows, &w.gradient, w.multiplier);
        update_cells(&mut w.linear.direction, |i, [d]| {
            [if state[i] == IntervalMotion::Free {
                gradient[i] - multiplier + conjugation * d
            } else {
                0.0
            }]
        });
        if has_total && free > 0 {
            let [direction] = &w.linear.direction;
            let mean = reduce::sum(self.problem.layout, |i| direction[i]) / free as f64;
            update_cells(&mut w.linear.direction, |i, [d]| {
                [if state[i] == IntervalMotion::Free {
                    d - mean
                } else {
                    d
                }]
            });
        }
    }

    /// Returns the length of a step along the direction, `tau = r'd / d'Cd` (eq 21).
    fn length_of_free(&self) -> f64 {
        let w = &*self.workspace;
        let ([direction], [image], r) = (
            &w.linear.direction,
            &w.linear.image,
            self.residual_if_free(),
        );
        let [along, curvature, square] = reduce::sum(self.layout(), |i| {
            let d = direction[i];
            [r(i) * d, d * image[i], d * d]
        });
        let curvature = self.slide(curvature, square).unwrap_or(curvature);
        if curvature > 0.0 && along.is_finite() {
            along / curvature
        } else {
            0.0
        }
    }

    /// Computes `x -= tau d` on the free entries, clipped (eq 21'). An entry at a bound whose residual points inward moves along
    /// its residual and becomes free (eqs 22, 23).
    fn step_and_clip(&mut self, length: f64) -> SetChanges {
        let (constraint, layout) = (self.problem.constraint, self.problem.layout);
        let w = &mut *self.workspace;
        let ([gradient], [direction], [multiplier]) =
            (&w.gradient, &w.linear.direction, w.multiplier);
        let work = |task: usize, (x, state): (Blocks<'_, f64>, Blocks<'_, IntervalMotion>)| {
            let mut moves = SetChanges {
                clipped: 0,
                entered: 0,
            };
            for ((i, x), state) in (task * layout.chunk()..).zip(x.items).zip(state.items) {
                let r = gradient[i] - multiplier;
                let interval = constraint.of(i);
                match *state {
                    IntervalMotion::Free => {
                        *x -= length * direction[i];
                        if *x <= interval.lower || *x >= interval.upper {
                            *state = if *x <= interval.lower {
                                IntervalMotion::Lower
                            } else {
                                IntervalMotion::Upper
                            };
                            [*x] = interval.project([*x]);
                            moves.clipped += 1;
                        }
                    }
                    IntervalMotion::Lower | IntervalMotion::Upper
                        if state.released_from_bound([r]) == IntervalMotion::Free =>
                    {
                        [*x] = interval.project([*x - length * r]);
                        *state = IntervalMotion::Free;
                        moves.entered += 1;
                    }
                    _ => {}
                }
            }
            [moves.clipped, moves.entered]
        };
        let [x] = &mut self.x;
        let data = (layout.blocks(x), layout.blocks(&mut w.linear.rows));
        self.product_error = f64::INFINITY;
        let [clipped, entered] = layout.sweep(data, work, Reduction::plus);
        SetChanges { clipped, entered }
    }

    /// Updates product and gradient after a step that clipped nothing, without a new product.
    fn follow(&mut self, length: f64) {
        let w = &mut *self.workspace;
        let image = slices(&w.linear.image);
        for vector in [&mut w.product, &mut w.gradient] {
            update_cells(vector, |i, u| plus(u, -length, at(&image, i)));
        }
    }

    /// Shifts the free entries within the bounds such that the total is met (eqs 25, 26). Shifts all entries if the free entries
    /// do not suffice.
    fn restore_total(&mut self) {
        let [Some(total)] = self.sums() else {
            return;
        };
        let (state, constraint) = (&self.workspace.linear.rows, self.problem.constraint);
        let layout = self.problem.layout;
        let [x] = &mut self.x;
        if !shift_to_total(
            layout,
            x,
            constraint,
            |i| state[i] == IntervalMotion::Free,
            total,
        ) {
            shift_to_total(layout, x, constraint, |_| true, total);
            self.mark_start();
        }
    }
}
