//! Method of Polonsky & Keer: a single loop of conjugate gradients with clipping, for bounds on both sides.
//!
//! For the bounds `|q| <= mu p` the method is the tangential loop of Wang et al. (2021), eqs 17-26. Three errors of the paper are
//! corrected. Entries inside the bounds are clipped as well (eq 21). An entry that becomes free is clipped on both sides (eq 22).
//! The conjugation term has a positive sign (eq 24).

use std::ops::ControlFlow;

use crate::cgm::active_set_solve::{ActiveSetSolve, Precision};
use crate::cgm::law::state::{LinearisedSet, Row};
use crate::cgm::reduce::Reduction;
use crate::cgm::{Constraint, ConstraintSet, MotionOf, reduce};
use crate::numerics::cell_vector::{
    at, chunks, dot, held, minus, plus, put, slices, slices_mut, update_cells,
};
use crate::parallel::Blocks;
use crate::report::Status;

/// Number of steps between fresh products if nothing requires one earlier.
const REFRESH: usize = 25;
/// Number of steps without halving the residual after which the loop is stuck.
const PATIENCE: usize = 200;

/// Unknowns and states of the cells of a task.
type StepBlocks<'a, K, const N: usize> = ([Blocks<'a, f64>; N], Blocks<'a, MotionOf<K, N>>);

/// Sets with one unknown per cell only: [`Problem`](crate::cgm::Problem) rejects the method for other sets.
impl<K: Constraint<N>, const N: usize> ActiveSetSolve<'_, '_, K, N> {
    /// Runs the single loop. Returns the final status, or `None` if the sets cycle.
    pub(super) fn polonsky_keer(&mut self) -> Option<Status> {
        self.mark_start();
        self.restore_total();
        let (mut previous, mut conjugate) = (0.0, false);
        let (mut best, mut without_progress) = (f64::INFINITY, 0);
        let mut since_refresh = REFRESH;
        loop {
            if since_refresh >= REFRESH {
                if let ControlFlow::Break(status) = self.monitor.notify_observer() {
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
            if let ControlFlow::Break(status) = self.monitor.check_termination(merit) {
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
            self.monitor.count_step();
            let length = self.length_of_free();
            let [clipped, entered] = self.step_and_clip(length);
            conjugate = entered == 0 && squares > 0.0;
            if clipped + entered > 0 {
                self.restore_total();
                since_refresh = REFRESH;
            } else {
                self.follow(length);
                since_refresh += 1;
            }
        }
    }

    /// Returns `r_i`, the gradient minus the multiplier (eq 19), on a free entry and zero on other entries.
    fn residual_if_free(&self) -> impl Fn(usize) -> [f64; N] + Sync {
        let w = &*self.workspace;
        let (state, gradient, multiplier) = (&w.linear.rows, slices(&w.gradient), w.multiplier);
        move |i| {
            if state[i].is_free() {
                minus(at(&gradient, i), multiplier)
            } else {
                [0.0; N]
            }
        }
    }

    /// Sets the multiplier of a prescribed total to the mean gradient on the free entries (eq 18). Returns the number of free
    /// entries.
    fn set_mean_of_free(&mut self) -> usize {
        let has_total = self.sums() != [None; N];
        let w = &mut *self.workspace;
        let gradient = slices(&w.gradient);
        let (count, sum) = reduce::over_chunks(self.problem.layout, |range| {
            let free = range.filter(|&i| w.linear.rows[i].is_free());
            free.fold((0_usize, [0.0; N]), |(count, sum), i| {
                (count + 1, plus(sum, 1.0, at(&gradient, i)))
            })
        });
        if has_total && count > 0 {
            w.multiplier = sum.map(|sum| sum / count as f64);
        }
        count
    }

    /// Returns `R = sum r^2` over the free entries (eq 20).
    fn squares_of_free(&self) -> f64 {
        let r = self.residual_if_free();
        reduce::sum(self.layout(), |i| dot(r(i), r(i)))
    }

    fn set_direction_of_free(&mut self, conjugation: f64, free: usize) {
        let has_total = self.sums() != [None; N];
        let w = &mut *self.workspace;
        let (state, gradient, multiplier) = (&w.linear.rows, slices(&w.gradient), w.multiplier);
        update_cells(&mut w.linear.direction, |i, d| {
            if state[i].is_free() {
                plus(minus(at(&gradient, i), multiplier), conjugation, d)
            } else {
                [0.0; N]
            }
        });
        if has_total && free > 0 {
            let direction = slices(&w.linear.direction);
            let sum: [f64; N] = reduce::sum(self.problem.layout, |i| at(&direction, i));
            let mean = sum.map(|sum| sum / free as f64);
            update_cells(&mut w.linear.direction, |i, d| {
                if state[i].is_free() {
                    minus(d, mean)
                } else {
                    d
                }
            });
        }
    }

    /// Returns the length of a step along the direction, `tau = r'd / d'Cd` (eq 21).
    fn length_of_free(&self) -> f64 {
        let w = &*self.workspace;
        let (direction, image) = (slices(&w.linear.direction), slices(&w.linear.image));
        let r = self.residual_if_free();
        let [along, curvature, square] = reduce::sum(self.layout(), |i| {
            let d = at(&direction, i);
            [dot(r(i), d), dot(d, at(&image, i)), dot(d, d)]
        });
        let curvature = self.slide(curvature, square).unwrap_or(curvature);
        if curvature > 0.0 && along.is_finite() {
            along / curvature
        } else {
            0.0
        }
    }

    /// Computes `x -= tau d` on the free entries, clipped (eq 21'). An entry at a bound whose residual points inward moves along
    /// its residual and becomes free (eqs 22, 23). Returns the number of clipped entries and of entries that became free.
    fn step_and_clip(&mut self, length: f64) -> [usize; 2] {
        let (constraint, layout) = (self.problem.constraint, self.problem.layout);
        let w = &mut *self.workspace;
        let (gradient, direction) = (slices(&w.gradient), slices(&w.linear.direction));
        let multiplier = w.multiplier;
        let work = |task: usize, (mut x, state): StepBlocks<'_, K, N>| {
            let (mut clipped, mut entered) = (0_usize, 0_usize);
            for (place, state) in state.items.iter_mut().enumerate() {
                let i = task * layout.chunk() + place;
                let (set, value) = (constraint.of(i), held(&x, place));
                let r = minus(at(&gradient, i), multiplier);
                if state.is_free() {
                    let moved = plus(value, -length, at(&direction, i));
                    *state = set.motion(moved);
                    let is_clipped = !state.is_free();
                    let next = if is_clipped {
                        set.project(moved)
                    } else {
                        moved
                    };
                    put(&mut x, place, next);
                    clipped += usize::from(is_clipped);
                } else if state.released_from_bound(r).is_free() {
                    put(&mut x, place, set.project(plus(value, -length, r)));
                    *state = Row::FREE;
                    entered += 1;
                }
            }
            [clipped, entered]
        };
        let data = (
            chunks(layout, &mut self.x),
            layout.blocks(&mut w.linear.rows),
        );
        self.product_error = f64::INFINITY;
        layout.sweep(data, work, Reduction::plus)
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
        let (state, constraint) = (&self.workspace.linear.rows, self.problem.constraint);
        let (layout, sums) = (self.problem.layout, self.sums());
        let is_free = |i: usize| state[i].is_free();
        if !K::Set::restore(layout, slices_mut(&mut self.x), constraint, is_free, sums) {
            self.mark_start();
        }
    }
}
