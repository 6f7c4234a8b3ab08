//! The prescribed totals, and the preconditioner that spreads them.

use crate::cgm::plane::disc::{at, dot, sweep_cells};
use crate::cgm::plane::run::Run;
use crate::cgm::plane::{Cell, Workspace, update_cells};
use crate::cgm::reduce;
use crate::operator::Operator;
use crate::parallel;

/// How the prescribed totals are kept: a change of total `a` spreads as `w_a = M e_a` within what the cells
/// can do, as a flat punch would.
pub(super) struct Border {
    has_total: [bool; 2],
    /// `e_b' w_a`, one on the diagonal where no total is prescribed.
    matrix: [[f64; 2]; 2],
}

impl Border {
    pub(super) fn new<C: Operator, P: Operator>(run: &mut Run<'_, '_, C, P>) -> Self {
        let has_total = run.problem.totals.map(|total| total.is_some());
        let mut border = Self {
            has_total,
            matrix: [[1.0, 0.0], [0.0, 1.0]],
        };
        if has_total == [false, false] {
            return border;
        }
        let cells = &run.workspace.cells;
        if !cells.contains(&Cell::Stick) && !can_turn(cells, has_total) {
            parallel::update(&mut run.workspace.cells, |_, chunk| {
                for cell in chunk {
                    if *cell != Cell::Fixed {
                        *cell = Cell::Stick;
                    }
                }
            });
        }
        for axis in (0..2).filter(|&axis| has_total[axis]) {
            let mut unit = [0.0; 2];
            unit[axis] = 1.0;
            let Workspace {
                cells, weighted, ..
            } = &mut *run.workspace;
            let cells = &*cells;
            update_cells(weighted, |i, _| {
                cells[i].project(unit).map(|e| e * cells[i].weight())
            });
            precondition(run);
            let Workspace {
                correction, spread, ..
            } = &mut *run.workspace;
            std::mem::swap(correction, &mut spread[axis]);
            let spread = &spread[axis];
            let sums: [f64; 2] = reduce::sums(cells_of(spread), |i| at(spread, i));
            border.matrix[axis] = [0, 1].map(|b| match (has_total[b], axis == b) {
                (true, _) => sums[b],
                (false, _) => 0.0,
            });
        }
        border
    }

    /// Solves `sum over b of matrix[a][b] x_b = right_a`, zero where no total is prescribed.
    pub(super) fn solve(&self, right: [f64; 2]) -> [f64; 2] {
        let [[xx, xy], [yx, yy]] = self.matrix;
        let right = [0, 1].map(|a| if self.has_total[a] { right[a] } else { 0.0 });
        let determinant = xx * yy - xy * yx;
        [
            (yy * right[0] - xy * right[1]) / determinant,
            (xx * right[1] - yx * right[0]) / determinant,
        ]
    }

    /// What a cell of a vector adds to `w_a' v`.
    pub(super) fn products(&self, spread: &[Vec<f64>; 2], i: usize, v: [f64; 2]) -> [f64; 2] {
        match self.has_total {
            [false, false] => [0.0; 2],
            _ => [dot(at(&spread[0], i), v), dot(at(&spread[1], i), v)],
        }
    }

    /// Spreads what is missing of the totals.
    pub(super) fn spread_missing<C: Operator, P: Operator>(&self, run: &mut Run<'_, '_, C, P>) {
        if self.has_total == [false, false] {
            return;
        }
        let q = &*run.q;
        let sums: [f64; 2] = reduce::sums(cells_of(q), |i| at(q, i));
        let missing = [0, 1].map(|a| run.problem.totals[a].map_or(0.0, |total| total - sums[a]));
        let [x, y] = self.solve(missing);
        if x != 0.0 || y != 0.0 {
            let [wx, wy] = &run.workspace.spread;
            update_cells(run.q, |i, q| {
                let (wx, wy) = (at(wx, i), at(wy, i));
                [0, 1].map(|b| q[b] + x * wx[b] + y * wy[b])
            });
            run.is_fresh = false;
        }
    }

    /// The multipliers that leave no mean slip, weighted as the totals spread.
    pub(super) fn set_multiplier<C: Operator, P: Operator>(&self, run: &mut Run<'_, '_, C, P>) {
        let Workspace {
            spread, gradient, ..
        } = &*run.workspace;
        let products = reduce::sums(cells_of(gradient), |i| {
            self.products(spread, i, at(gradient, i))
        });
        run.workspace.multiplier = self.solve(products);
    }
}

/// Part of what turning changes along a total below which it hardly changes that.
const LEAST_TURN: f64 = 1e-2;

/// Whether cells that can only turn can take up a change of the totals: not if they all point along it.
fn can_turn(cells: &[Cell], has_total: [bool; 2]) -> bool {
    let [xx, yy, xy] = reduce::sums(cells.len(), |i| match cells[i] {
        Cell::Slip {
            tangent: [x, y], ..
        } => [x * x, y * y, x * y],
        _ => [0.0; 3],
    });
    let all = xx + yy;
    let least = match has_total {
        [true, true] => (xx * yy - xy * xy) / all,
        [true, false] => xx,
        _ => yy,
    };
    least > LEAST_TURN * all
}

fn cells_of(vector: &[f64]) -> usize {
    vector.len() / 2
}

/// `correction = M residual`, of the weighted residual, within what the cells can do; returns its products with
/// the residual and with the last one.
pub(super) fn precondition<C: Operator, P: Operator>(run: &mut Run<'_, '_, C, P>) -> [f64; 2] {
    let Workspace {
        preconditioner,
        cells,
        residual,
        last_residual,
        correction,
        weighted,
        ..
    } = &mut *run.workspace;
    let (cells, residual, last) = (&*cells, &*residual, &*last_residual);
    run.problem
        .preconditioner
        .apply_roughly(weighted, correction, preconditioner);
    sweep_cells([correction], |i, [z]| {
        let z = cells[i].project(z).map(|z| z * cells[i].weight());
        ([z], [dot(z, at(residual, i)), dot(z, at(last, i))])
    })
}
