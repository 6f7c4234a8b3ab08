//! Border of the linear system of a semismooth Newton step. It consists of the spread of the multipliers over the cells and of
//! the multiplier changes that keep the totals.

use crate::cgm::cone::cell_state::{CellKind, ConeCellState};
use crate::cgm::cone::workspace::gradient;
use crate::cgm::cone::{ConeRun, FrictionCone, N};
use crate::cgm::law::state::Row;
use crate::cgm::linear::Border;
use crate::cgm::totals::{can_turn, hold_springs, sums_of};
use crate::cgm::{Total, reduce};
use crate::numerics::cell_vector::{dot, norm, slices};

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
        let totals = self.problem.totals;
        let mut border = Border::new(&totals, self.linear().spread(&totals).transposed());
        for (a, active) in border.active.iter_mut().enumerate() {
            *active &= border.matrix.0[a][a] != 0.0;
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
        let (problem, multiplier) = (self.problem, &mut self.workspace.multiplier);
        hold_springs(
            &problem.totals,
            problem.layout,
            &slices(&self.x),
            multiplier,
        );
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
            w.linear.update_rows(|_, law| law.is_held = false);
        }
    }

    /// Sets slipping cells to stick if all cells slip in the same direction and tangential sums are prescribed. Rotating the
    /// tractions alone could not change the sums along that direction.
    pub(super) fn restore_stick(&mut self) {
        let [_, x, y] = self.problem.totals.map(|total| total.sum().is_some());
        let mut mobility = self.workspace.linear.mobility();
        // Only the mobility in the plane matters.
        mobility.0[0] = [0.0; N];
        if can_turn(&mobility, [false, x, y]) {
            return;
        }
        self.times_held += 1;
        let nearest = self.cell_with_least_slip();
        let w = &mut *self.workspace;
        let gradient = gradient(&w.product, self.problem.linear, w.multiplier);
        w.linear.update_rows(|i, law| {
            if nearest.is_none_or(|nearest| nearest.include(*law, gradient(i))) {
                *law = law.stuck();
            }
        });
    }

    /// Selects the cells with the least slip among the cells that could carry more of the deficit. Returns `None` if no cell
    /// could carry more, or until all cells have been set to stick [`TRIALS`] times.
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
