//! Degenerate problems of the semismooth Newton method. Either all cells are at their bounds, or the preconditioner is not
//! positive definite.

use crate::cgm::active_set_solve::ActiveSetSolve;
use crate::cgm::law::interval::EDGE;
use crate::cgm::law::state::{LinearisedSet, Row};
use crate::cgm::start::ROUND_OFF;
use crate::cgm::totals::{TotalsSystem, can_turn, sums_of};
use crate::cgm::{Constraint, reduce};
use crate::error::{Error, Result};
use crate::numerics::cell_vector::{
    at, dot, minus, norm, plus, slices, slices_mut, update_cells, within,
};

/// State of cells that are all at their bounds.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum BoundState {
    /// No cell is pushed from its bound.
    Rests,
    /// Some cells are pushed away, in pairs that keep the sum.
    Released,
    /// The sum has this deficit.
    Deficit(f64),
}

impl<K: Constraint<N>, const N: usize> ActiveSetSolve<'_, '_, K, N> {
    /// Returns the unit direction along which slipping cells cannot change the sums if no cell is free. Returns `None` if there
    /// is no such direction. All tractions are parallel to this direction, or nearly so. In the second case a rotation by one
    /// radian would change the sum by less than its deficit.
    pub(super) fn uncontrollable_direction(&self, system: &TotalsSystem<N>) -> Option<[f64; N]> {
        let (has_sum, mobility) = (system.has_sum(), system.mobility);
        if has_sum == [false; N] {
            return None;
        }
        let normal = mobility.weakest(has_sum);
        let reaches = || {
            let missing = self.missing_along(normal);
            missing.is_none_or(|[missing, _]| missing.abs() <= self.tangent_change(normal))
        };
        (!can_turn(&mobility, has_sum) || !reaches()).then_some(normal)
    }

    /// Returns the first-order change of the sum along a direction if the traction of each cell rotates by one radian.
    fn tangent_change(&self, normal: [f64; N]) -> f64 {
        let x = slices(&self.x);
        let (moving, motions) = (&self.workspace.linear.moving, &self.workspace.linear.rows);
        moving.sweep((), |entries, ()| {
            let x = within(&x, &entries.chunk);
            entries.sums(|k, place| {
                let turn = entries.row(motions, k, place).restrict(normal);
                norm(turn) * norm(at(&x, place))
            })
        })
    }

    /// Returns the deficit of the sum along a direction and the sum of magnitudes, or `None` if no sum is prescribed.
    fn missing_along(&self, normal: [f64; N]) -> Option<[f64; 2]> {
        let sums = sums_of(self.layout(), &slices(&self.x));
        let (mut missing, mut magnitude) = (0.0, 0.0);
        for c in (0..N).filter(|&c| normal[c] != 0.0) {
            missing += normal[c] * (self.sums()[c]? - sums[c][0]);
            magnitude += normal[c].abs() * sums[c][1];
        }
        Some([missing, magnitude])
    }

    /// Releases slipping cells if no rotation of their tractions can change the total along the unit vector `normal`. If the
    /// total has a deficit, releases the cells that would stick first under a motion that reduces the deficit. These cells must
    /// be able to carry the deficit. If the total is met and no cell is pushed, releases the cells that would stick first in
    /// either direction. Otherwise releases all cells.
    pub(super) fn release_bound_cells(&mut self, system: &mut TotalsSystem<N>, normal: [f64; N]) {
        let opposite = normal.map(|n| -n);
        let is_settled = match self.multiplier_at_bounds(normal) {
            Some(BoundState::Deficit(missing)) => {
                let way = if missing > 0.0 { normal } else { opposite };
                self.release_nearest_to_bound(way, missing.abs())
            }
            Some(BoundState::Rests) => {
                self.release_nearest_to_bound(normal, 0.0)
                    || self.release_nearest_to_bound(opposite, 0.0)
            }
            Some(BoundState::Released) | None => false,
        };
        if !is_settled {
            self.free(|_, _| true);
        }
        system.mobility = self.workspace.linear.mobility();
    }

    /// Releases the cells that would stick first under a motion along `way`, towards the deficit. Returns whether one of these
    /// cells can carry the deficit.
    fn release_nearest_to_bound(&mut self, way: [f64; N], missing: f64) -> bool {
        if !self.is_fresh() {
            self.refresh();
        }
        let (x, gradient) = (slices(&self.x), slices(&self.workspace.gradient));
        let first = reduce::least(self.layout(), |i| {
            let points_away = dot(at(&x, i), way) < 0.0;
            points_away.then(|| (dot(at(&gradient, i), way), norm(at(&x, i))))
        });
        let Some((least, _)) = first.filter(|(_, size)| 2.0 * size >= missing) else {
            return false;
        };
        self.free(|x, gradient| dot(x, way) < 0.0 && dot(gradient, way) <= least);
        true
    }

    /// Releases the moving cells for which `is_selected` returns true. Its arguments are the unknowns and the gradient of a cell.
    fn free(&mut self, is_selected: impl Fn([f64; N], [f64; N]) -> bool + Sync) {
        let x = slices(&self.x);
        let w = &mut *self.workspace;
        let gradient = slices(&w.gradient);
        w.linear.update_rows(|i, motion| {
            if motion.moves() && is_selected(at(&x, i), at(&gradient, i)) {
                *motion = Row::FREE;
            }
        });
    }

    /// Sets the multiplier if all cells are at their bounds along a unit vector and have the prescribed sum. Any multiplier
    /// between the gradients of the cells at the upper and at the lower bound is valid. The function selects the middle of this
    /// interval. Returns `None` if no sum is prescribed or no cell can move.
    pub(super) fn multiplier_at_bounds(&mut self, normal: [f64; N]) -> Option<BoundState> {
        let [missing, magnitude] = self.missing_along(normal)?;
        if missing.abs() > ROUND_OFF * magnitude {
            return Some(BoundState::Deficit(missing));
        }
        if !self.is_fresh() {
            self.refresh();
        }
        let (x, gradient) = (slices(&self.x), slices(&self.workspace.gradient));
        let slope = |i: usize| dot(at(&gradient, i), normal);
        let stands_at = |i: usize, direction: f64| {
            let set = self.problem.constraint.of(i);
            let along = normal.map(|n| direction * n);
            let bound = dot(set.extreme(along), along);
            set.can_move() && (bound - dot(at(&x, i), along)).abs() <= EDGE * bound.abs()
        };
        let layout = self.layout();
        let above = reduce::least(layout, |i| stands_at(i, 1.0).then(|| (-slope(i), ())));
        let below = reduce::least(layout, |i| stands_at(i, -1.0).then(|| (slope(i), ())));
        let (above, below) = (above.map(|(g, ())| -g), below.map(|(g, ())| g));
        let (low, high) = (above.or(below)?, below.or(above)?);
        let multiplier = &mut self.workspace.multiplier;
        let change = 0.5 * (low + high) - dot(*multiplier, normal);
        *multiplier = plus(*multiplier, change, normal);
        Some(if low <= high {
            BoundState::Rests
        } else {
            BoundState::Released
        })
    }
}

impl<K: Constraint<N>, const N: usize> ActiveSetSolve<'_, '_, K, N> {
    /// Returns `Ok` if `v' M v` is positive and finite for three vectors on the cells that can move. The vectors are a uniform
    /// vector, the final residual and the largest entries of this residual.
    pub(super) fn check_preconditioner(&mut self) -> Result<()> {
        let (problem, multiplier) = (self.problem, self.workspace.multiplier);
        let forbidden = |i: usize, x, gradient| {
            let set = problem.constraint.of(i);
            set.forbidden(x, minus(gradient, multiplier))
        };
        let (x, gradient) = (slices(&self.x), slices(&self.workspace.gradient));
        let size = |i: usize| norm(forbidden(i, at(&x, i), at(&gradient, i)));
        let largest = reduce::max(self.layout(), size);
        let mut flaw = self.negative_curvature_along(|_, _, _| [1.0; N]);
        for least in [0.0, 0.5 * largest] {
            flaw = flaw.or_else(|| {
                self.negative_curvature_along(|i, x, gradient| {
                    let residual = forbidden(i, x, gradient);
                    if norm(residual) >= least {
                        residual
                    } else {
                        [0.0; N]
                    }
                })
            });
        }
        flaw.map_or(Ok(()), |value| {
            let quantity = "v'Mv with the preconditioner M of the failed iteration";
            Err(Error::NotPositive { quantity, value })
        })
    }

    /// Returns `v' M v` if this product should be positive and finite but is not. `v` computes the vector from the unknowns and
    /// the gradient of each cell.
    fn negative_curvature_along(
        &mut self,
        v: impl Fn(usize, [f64; N], [f64; N]) -> [f64; N] + Sync,
    ) -> Option<f64> {
        let x = slices(&self.x);
        let (problem, w) = (self.problem, &mut *self.workspace);
        let gradient = slices(&w.gradient);
        update_cells(&mut w.linear.direction, |i, _| {
            if problem.constraint.of(i).can_move() {
                v(i, at(&x, i), at(&gradient, i))
            } else {
                [0.0; N]
            }
        });
        let (direction, image) = (slices(&w.linear.direction), slices_mut(&mut w.linear.image));
        (problem.preconditioner).apply(direction, image, &mut w.linear.preconditioner);
        let image = slices(&w.linear.image);
        let [square, product] = reduce::sum(problem.layout, |i| {
            let v = at(&direction, i);
            [dot(v, v), dot(v, at(&image, i))]
        });
        let is_fine = product > 0.0 && product.is_finite();
        (square > 0.0 && square.is_finite() && !is_fine).then_some(product)
    }
}
