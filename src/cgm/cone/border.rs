//! Border of the linear system of a semismooth Newton step. It consists of the spread of the multipliers over the cells and of
//! the multiplier changes that keep the totals.

use crate::cgm::cone::cell_state::{CellKind, ConeCellState};
use crate::cgm::cone::workspace::gradient;
use crate::cgm::cone::{ConeRun, FrictionCone, N};
use crate::cgm::law::state::Row;
use crate::cgm::linear::Border;
use crate::cgm::totals::sums_of;
use crate::cgm::{Total, reduce};
use crate::numerics::cell_vector::{dot, norm, slices};
use crate::parallel;

/// Fraction of the mobility along an axis below which slipping cells cannot carry a change along this axis.
const LEAST_TURN: f64 = 1e-13;
/// Maximum number of times that all cells of a contact are set to stick if their tractions cannot rotate.
const TRIALS: usize = 2;

/// Selection of the cells with the least slip among the cells that could carry more of the deficit.
#[derive(Debug, Clone, Copy)]
struct NearestToStick {
    missing: [f64; 2],
    /// Maximum slip of the selected cells.
    most: f64,
}

impl NearestToStick {
    fn include(self, law: ConeCellState, gradient: [f64; N]) -> bool {
        slip_against(law, gradient, self.missing).is_some_and(|slip| slip <= self.most)
    }
}

/// Returns the slip of a cell whose traction points against the deficit, or `None` for other cells.
fn slip_against(law: ConeCellState, [_, x, y]: [f64; N], missing: [f64; 2]) -> Option<f64> {
    match law.kind {
        CellKind::Slip(slip) if dot(slip.normal, missing) < 0.0 => Some(norm([x, y])),
        _ => None,
    }
}

impl<F: FrictionCone> ConeRun<'_, '_, F> {
    /// Determines the spread of the multipliers. Totals that no cell can change are inactive.
    pub(super) fn border(&mut self) -> Border<N> {
        let (totals, mut border) = (self.problem.totals, Border::NONE);
        for a in (0..N).filter(|&a| totals[a] != Total::Free) {
            let added = self.linear().spread(a);
            for (row, added) in border.matrix.0.iter_mut().zip(added) {
                row[a] = added;
            }
            if let Some(compliance) = totals[a].compliance() {
                border.matrix.0[a][a] += 1.0 / compliance;
            }
            border.active[a] = border.matrix.0[a][a] != 0.0;
        }
        border
    }

    /// Returns the deficit of the totals.
    pub(super) fn missing(&self) -> [f64; N] {
        let sums = sums_of(self.problem.layout, &slices(&self.x));
        let multiplier = self.workspace.multiplier;
        std::array::from_fn(|c| self.problem.totals[c].missing(sums[c][0], multiplier[c]))
    }

    /// Updates the multipliers of the springs to the current tractions.
    pub(super) fn hold_springs(&mut self) {
        let sums = sums_of(self.problem.layout, &slices(&self.x));
        let multiplier = &mut self.workspace.multiplier;
        for (c, total) in self.problem.totals.iter().enumerate() {
            if total.is_spring() {
                multiplier[c] = total.held(multiplier[c], sums[c]);
            }
        }
    }

    /// Releases the pressures if all cells in contact are at their hardness and a normal force is prescribed. If these
    /// pressures stayed fixed, the approach could not change.
    pub(super) fn free_hardness_cells(&mut self) {
        if self.problem.totals[0] == Total::Free {
            return;
        }
        let w = &mut *self.workspace;
        let laws = &w.linear.rows;
        let moves = |place: usize| laws[place].moves() && !laws[place].is_held;
        if !reduce::any(self.problem.layout, moves) {
            parallel::update(&mut w.linear.rows, |_, laws| {
                for law in laws {
                    law.is_held = false;
                }
            });
        }
    }

    /// Sets slipping cells to stick if all cells slip in the same direction and tangential sums are prescribed. Rotating the
    /// tractions alone could not change the sums along that direction.
    pub(super) fn restore_stick(&mut self) {
        let totals = self.problem.totals;
        let w = &*self.workspace;
        let laws = &w.linear.rows;
        let mobility: [[f64; 2]; 2] = w.linear.moving.sweep((), |entries, ()| {
            entries.sums(|_, place| laws[entries.chunk.start + place].mobility())
        });
        let [[xx, xy], [_, yy]] = mobility;
        let (has_sum, all) = (totals.map(|total| total.sum().is_some()), xx + yy);
        // Estimate of the least part of a change along any prescribed direction, times `all`.
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
        let nearest = self.cell_with_least_slip();
        let w = &mut *self.workspace;
        let gradient = gradient(&w.product, self.problem.linear, w.multiplier);
        parallel::update(&mut w.linear.rows, |first, laws| {
            for (i, law) in (first..).zip(laws) {
                if nearest.is_none_or(|nearest| nearest.include(*law, gradient(i))) {
                    *law = law.stuck();
                }
            }
        });
    }

    /// Selects the cells with the least slip among the cells that could carry more of the deficit. Returns `None` if no cell
    /// could carry more, or if all cells have not yet been set to stick [`TRIALS`] times.
    fn cell_with_least_slip(&self) -> Option<NearestToStick> {
        if self.times_held <= TRIALS {
            return None;
        }
        let ([_, x, y], w) = (self.missing(), &*self.workspace);
        let gradient = gradient(&w.product, self.problem.linear, w.multiplier);
        let laws = &w.linear.rows;
        let slip = |i: usize| slip_against(laws[i], gradient(i), [x, y]);
        let least = reduce::least(self.problem.layout, |i| slip(i).map(|s| (s, ())));
        let (least, ()) = least?;
        Some(NearestToStick {
            missing: [x, y],
            most: least * (1.0 + 1e-9),
        })
    }
}
