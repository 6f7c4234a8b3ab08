//! How cells stand that are all at their bounds.

use crate::cgm::interval::EDGE;
use crate::cgm::look::ROUND_OFF;
use crate::cgm::motion::{Linearised, Motion};
use crate::cgm::reduce;
use crate::cgm::run::Run;
use crate::cgm::totals::{TotalsSystem, sums_of};
use crate::cgm::vector::{at, dot, norm, slices};
use crate::cgm::{Constraint, MotionOf};
use crate::operator::Operator;

/// How cells stand that are all at their bounds.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Standing {
    /// Nothing pushes any from its bound.
    Rests,
    /// Some are pushed away, in pairs that keep the sum.
    Pushed,
    /// This is missing of their sum.
    Misses(f64),
}

impl<C: Operator<N>, K: Constraint<N>, P: Operator<N>, const N: usize> Run<'_, '_, C, K, P, N> {
    /// Sees to sums along which cells that are all at their bounds cannot turn. Those that they have, pointing to both
    /// sides, rest. Of what is missing of a sum the cells are freed that would stick first, if they can carry it; else all.
    pub(super) fn settle(&mut self, system: &mut TotalsSystem<N>) {
        let standing = std::array::from_fn::<_, N, _>(|a| {
            let is_fixed = system.is_fixed(a);
            is_fixed.then(|| self.stand_at_bounds(a)).flatten()
        });
        system.rests = standing.map(|standing| standing == Some(Standing::Rests));
        let missing = standing.map(|standing| match standing {
            Some(Standing::Misses(part)) => part,
            Some(Standing::Rests | Standing::Pushed) | None => 0.0,
        });
        if system.can_turn() {
            return;
        }
        if !self.free_first(missing) {
            self.free(|_, _| true);
        }
        system.mobility = self.mobility();
    }

    /// Frees the cells that a motion towards what is missing would let stick first; says if one of them can carry it.
    fn free_first(&mut self, missing: [f64; N]) -> bool {
        if !self.is_fresh {
            self.refresh();
        }
        let (x, gradient) = (slices(&self.x), slices(&self.workspace.gradient));
        let first = reduce::least(self.layout(), |i| {
            let points_away = dot(at(&x, i), missing) < 0.0;
            points_away.then(|| (dot(at(&gradient, i), missing), norm(at(&x, i))))
        });
        let Some((least, _)) = first.filter(|(_, size)| 2.0 * size >= norm(missing)) else {
            return false;
        };
        self.free(|x, gradient| dot(x, missing) < 0.0 && dot(gradient, missing) <= least);
        true
    }

    /// Frees the cells that move already and are selected by their unknowns and gradient.
    fn free(&mut self, is_selected: impl Fn([f64; N], [f64; N]) -> bool + Sync) {
        let x = slices(&self.x);
        let w = &mut *self.workspace;
        let gradient = slices(&w.gradient);
        let data = w.moving.motions(&mut w.motions);
        w.moving.sweep(data, |entries, motions| {
            entries.visit::<MotionOf<K, N>, N>(|kept, place| {
                let (motion, i) = (&mut motions.items[kept], entries.chunk.start + place);
                if motion.moves() && is_selected(at(&x, i), at(&gradient, i)) {
                    *motion = Motion::FREE;
                }
            });
        });
    }

    /// Where all cells stand at their bounds along a component and have the sum, the multiplier is any between the
    /// gradients of those at the upper bound and those at the lower: takes the middle. `None` where no sum is prescribed or
    /// none can move.
    pub(super) fn stand_at_bounds(&mut self, a: usize) -> Option<Standing> {
        let total = self.sums()[a]?;
        let [sum, magnitude] = sums_of(&self.problem.layout, &slices(&self.x))[a];
        if (total - sum).abs() > ROUND_OFF * magnitude {
            return Some(Standing::Misses(total - sum));
        }
        if !self.is_fresh {
            self.refresh();
        }
        let (x, gradient) = (&self.x[a], &self.workspace.gradient[a]);
        let stands_at = |i: usize, direction: f64| {
            let set = self.problem.constraint.of(i);
            let mut along = [0.0; N];
            along[a] = direction;
            let bound = set.extreme(along)[a];
            set.can_move() && (bound - x[i]).abs() <= EDGE * bound.abs()
        };
        let layout = self.layout();
        let above = reduce::least(layout, |i| stands_at(i, 1.0).then(|| (-gradient[i], ())));
        let below = reduce::least(layout, |i| stands_at(i, -1.0).then(|| (gradient[i], ())));
        let (above, below) = (above.map(|(g, ())| -g), below.map(|(g, ())| g));
        let (low, high) = (above.or(below)?, below.or(above)?);
        self.workspace.multiplier[a] = 0.5 * (low + high);
        Some(if low <= high {
            Standing::Rests
        } else {
            Standing::Pushed
        })
    }
}
