//! The totals beside the cells: how changes of the multipliers spread, and which of them keep the totals.

use crate::cgm::cone::law::Law;
use crate::cgm::cone::workspace::gradient;
use crate::cgm::cone::{Cone, ConeRun, N};
use crate::cgm::small::Small;
use crate::cgm::totals::sums_of;
use crate::cgm::vector::{dot, norm, slices};
use crate::cgm::{Total, reduce};
use crate::operator::Operator;
use crate::parallel;

/// Part of the mobility along an axis below which cells that all slip cannot carry a change along it.
const LEAST_TURN: f64 = 1e-13;
/// Times that all cells of a contact that cannot turn are made to stick.
const TRIALS: usize = 2;

/// The totals beside the cells as they may move at present.
#[derive(Debug, Clone, Copy)]
pub(super) struct Border {
    /// The totals that the cells can change.
    active: [bool; N],
    /// The sum of each component that the spread of each multiplier adds, plus one over the compliance of a spring.
    matrix: Small<N>,
}

impl Border {
    /// Of motions that are prescribed.
    pub(super) fn none() -> Self {
        Self {
            active: [false; N],
            matrix: Small([[0.0; N]; N]),
        }
    }

    /// Whether the cells can change the totals of which something is missing: not if none is in contact.
    pub(super) fn carries(&self, missing: [f64; N]) -> bool {
        let mut totals = self.active.iter().zip(missing);
        totals.all(|(is_active, missing)| *is_active || missing == 0.0)
    }

    /// The changes of the multipliers that leave `missing` after `added`.
    pub(super) fn balance(&self, missing: [f64; N], added: [f64; N]) -> [f64; N] {
        let right = std::array::from_fn(|c| missing[c] - added[c]);
        self.matrix.solve(right, self.active)
    }
}

/// The cells that slip least of those that could carry more of what is missing.
#[derive(Debug, Clone, Copy)]
struct Nearest {
    missing: [f64; 2],
    /// The most that they slip.
    most: f64,
}

impl Nearest {
    fn include(self, law: Law, gradient: [f64; N]) -> bool {
        slip_against(law, gradient, self.missing).is_some_and(|slip| slip <= self.most)
    }
}

/// How far a cell slips whose traction points against what is missing.
fn slip_against(law: Law, [_, x, y]: [f64; N], missing: [f64; 2]) -> Option<f64> {
    match law {
        Law::Slip(slip) if dot(slip.normal, missing) < 0.0 => Some(norm([x, y])),
        _ => None,
    }
}

impl<C: Operator<N>, P: Operator<N>, F: Cone> ConeRun<'_, '_, C, P, F> {
    /// Finds how changes of the multipliers spread.
    pub(super) fn border(&mut self) -> Border {
        let totals = self.problem.totals;
        let (mut active, mut matrix) = ([false; N], Small([[0.0; N]; N]));
        for a in (0..N).filter(|&a| totals[a] != Total::Free) {
            let mut unit = [0.0; N];
            unit[a] = 1.0;
            self.set_residual_of(unit);
            self.precondition();
            let added = self.added();
            let w = &mut *self.workspace;
            for (spread, z) in w.spread.iter_mut().zip(&w.correction) {
                spread[a] = *z;
            }
            for (row, added) in matrix.0.iter_mut().zip(added) {
                row[a] = added;
            }
            if let Total::Spring { compliance, .. } = totals[a] {
                matrix.0[a][a] += 1.0 / compliance;
            }
            active[a] = matrix.0[a][a] != 0.0;
        }
        Border { active, matrix }
    }

    /// The equations that a uniform displacement makes, as the residual.
    fn set_residual_of(&mut self, unit: [f64; N]) {
        let w = &mut *self.workspace;
        let laws = &w.laws;
        w.contact.sweep(
            w.contact.compressed(&mut w.residual),
            |entries, residual| {
                for (k, place) in entries.places().enumerate() {
                    residual.items[k] = laws[entries.chunk.start + place].restrict(unit);
                }
            },
        );
    }

    /// What the correction adds to the sums of all components.
    pub(super) fn added(&self) -> [f64; N] {
        let w = &*self.workspace;
        let (laws, correction) = (&w.laws, &w.correction);
        w.contact.sweep((), |entries, ()| {
            let correction = &correction[entries.range.clone()];
            entries.sums(|k, place| laws[entries.chunk.start + place].extend(correction[k]))
        })
    }

    /// What is missing of the totals.
    pub(super) fn missing(&self) -> [f64; N] {
        let sums = sums_of(self.problem.layout, &slices(&self.x));
        let multiplier = self.workspace.multiplier;
        std::array::from_fn(|c| match self.problem.totals[c] {
            Total::Free => 0.0,
            Total::Sum(sum) => sum - sums[c][0],
            Total::Spring {
                far_end,
                compliance,
            } => (far_end - multiplier[c]) / compliance - sums[c][0],
        })
    }

    /// The multipliers of springs follow what the tractions have become.
    pub(super) fn hold_springs(&mut self) {
        let sums = sums_of(self.problem.layout, &slices(&self.x));
        let multiplier = &mut self.workspace.multiplier;
        for (c, total) in self.problem.totals.iter().enumerate() {
            if total.is_spring() {
                multiplier[c] = total.held(multiplier[c], sums[c]);
            }
        }
    }

    /// Where all cells slip the same way and tangential sums are prescribed, they stick: turning alone could not carry
    /// a change along that way.
    pub(super) fn let_stick(&mut self) {
        let totals = self.problem.totals;
        let w = &*self.workspace;
        let laws = &w.laws;
        let mobility: [[f64; 2]; 2] = w.contact.sweep((), |entries, ()| {
            entries.sums(|_, place| laws[entries.chunk.start + place].mobility())
        });
        let [[xx, xy], [_, yy]] = mobility;
        let (has_sum, all) = (totals.map(|total| total.sum().is_some()), xx + yy);
        // About the least part of a change along any way that is prescribed, times `all`.
        let least = match has_sum {
            [_, true, true] => xx * yy - xy * xy,
            [_, true, false] => xx * all,
            [_, false, true] => yy * all,
            [_, false, false] => return,
        };
        if least > LEAST_TURN * all * all {
            return;
        }
        self.times_held += 1;
        let nearest = self.nearest_to_stick();
        let w = &mut *self.workspace;
        let gradient = gradient(&w.product, self.problem.linear, w.multiplier);
        parallel::update(&mut w.laws, |first, laws| {
            for (i, law) in (first..).zip(laws) {
                if nearest.is_none_or(|nearest| nearest.include(*law, gradient(i))) {
                    *law = law.stuck();
                }
            }
        });
    }

    /// Once it has not helped that all cells stick: the slipping cells that could carry more of what is missing, and of
    /// these those that slip least.
    fn nearest_to_stick(&self) -> Option<Nearest> {
        if self.times_held <= TRIALS {
            return None;
        }
        let ([_, x, y], w) = (self.missing(), &*self.workspace);
        let gradient = gradient(&w.product, self.problem.linear, w.multiplier);
        let laws = &w.laws;
        let slip = |i: usize| slip_against(laws[i], gradient(i), [x, y]);
        let least = reduce::least(self.problem.layout, |i| slip(i).map(|s| (s, ())));
        let (least, ()) = least?;
        Some(Nearest {
            missing: [x, y],
            most: least * (1.0 + 1e-9),
        })
    }

    /// Adds the spread of changes of the multipliers to the correction.
    pub(super) fn add_spread(&mut self, change: [f64; N]) {
        if norm(change) == 0.0 {
            return;
        }
        let w = &mut *self.workspace;
        let spread = &w.spread;
        parallel::update(&mut w.correction, |first, chunk| {
            for (z, spread) in chunk.iter_mut().zip(&spread[first..]) {
                for (change, part) in change.iter().zip(spread) {
                    for (z, part) in z.iter_mut().zip(part) {
                        *z += change * part;
                    }
                }
            }
        });
    }
}
