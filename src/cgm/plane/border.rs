//! The prescribed totals: how they spread, and the motion that keeps them.

use crate::cgm::plane::disc::{dot, halves, norm, pair};
use crate::cgm::plane::inner::precondition;
use crate::cgm::plane::run::Run;
use crate::cgm::plane::{Cell, Inner, Workspace};
use crate::operator::Operator;

/// How the prescribed totals are kept: a change of total `a` spreads as `w_a = M e_a` within what the cells
/// can do, as a flat punch would.
pub(super) struct Border {
    has_total: [bool; 2],
    /// `e_b' w_a`, one on the diagonal where no total is prescribed.
    matrix: [[f64; 2]; 2],
    /// How a uniform motion is followed: the sum of what cells can do of it, `[xx, yy, xy]`.
    mobility: [f64; 3],
}

impl Border {
    pub(super) fn new<C: Operator<2>, P: Operator<2>>(run: &mut Run<'_, '_, C, P>) -> Self {
        let has_total = run.problem.totals.map(|total| total.is_some());
        let mut border = Self {
            has_total,
            matrix: [[1.0, 0.0], [0.0, 1.0]],
            mobility: mobility(run),
        };
        if has_total == [false, false] {
            return border;
        }
        let cells = &run.workspace.inner.cells[..run.workspace.loaded.len()];
        if !cells.iter().any(|cell| cell.is_stick()) && !border.can_turn() {
            run.workspace.inner.cells.fill(Cell::Stick);
            border.mobility = mobility(run);
        }
        for axis in 0..2 {
            border.matrix[axis] = if has_total[axis] {
                border.spread(run, axis)
            } else {
                let mut unit = [0.0; 2];
                unit[axis] = 1.0;
                unit
            };
        }
        border
    }

    /// Finds how a change of one total spreads, and what it changes of all of them.
    fn spread<C: Operator<2>, P: Operator<2>>(
        &self,
        run: &mut Run<'_, '_, C, P>,
        axis: usize,
    ) -> [f64; 2] {
        let mut unit = [0.0; 2];
        unit[axis] = 1.0;
        let Workspace {
            inner: Inner { cells, .. },
            loaded,
            direction,
            ..
        } = &mut *run.workspace;
        loaded.sweep(halves(direction), |entries, (x, y)| {
            let cells = &cells[entries.range.clone()];
            for (place, cell) in entries.places().zip(cells) {
                [x.items[place], y.items[place]] = cell.weighted(cell.project(unit));
            }
            []
        });
        precondition(run);
        let Workspace {
            inner: Inner { cells, spread, .. },
            loaded,
            image,
            ..
        } = &mut *run.workspace;
        let sums = loaded.sweep(loaded.compressed(spread), |entries, spread| {
            let cells = &cells[entries.range.clone()];
            let image = pair(image, &entries.chunk);
            entries.sums(|k, place| {
                let cell = cells[k];
                let w = cell.preconditioned(image(place), cell.project(unit));
                spread.items[k][axis] = w;
                w
            })
        });
        [0, 1].map(|b| if self.has_total[b] { sums[b] } else { 0.0 })
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

    /// The square of what all cells can do of a uniform motion.
    pub(super) fn square(&self, [x, y]: [f64; 2]) -> f64 {
        let [xx, yy, xy] = self.mobility;
        x * x * xx + y * y * yy + 2.0 * x * y * xy
    }

    /// Spreads what is missing of the totals.
    pub(super) fn spread_missing<C: Operator<2>, P: Operator<2>>(
        &self,
        run: &mut Run<'_, '_, C, P>,
    ) {
        if self.has_total == [false, false] {
            return;
        }
        let Workspace { inner, loaded, .. } = &*run.workspace;
        let q = &*run.q;
        let sums: [f64; 2] = loaded.sweep((), |entries, ()| {
            let q = pair(q, &entries.chunk);
            entries.sums(|_, place| q(place))
        });
        let missing = [0, 1].map(|a| run.problem.totals[a].map_or(0.0, |total| total - sums[a]));
        let change = self.solve(missing);
        if norm(change) > 0.0 {
            loaded.sweep(halves(run.q), |entries, (x, y)| {
                let spread = &inner.spread[entries.range.clone()];
                for (place, [wx, wy]) in entries.places().zip(spread) {
                    x.items[place] += change[0] * wx[0] + change[1] * wy[0];
                    y.items[place] += change[0] * wx[1] + change[1] * wy[1];
                }
                []
            });
            run.is_fresh = false;
        }
    }

    /// The multipliers that leave no mean slip, weighted as the totals spread.
    pub(super) fn set_multiplier<C: Operator<2>, P: Operator<2>>(
        &self,
        run: &mut Run<'_, '_, C, P>,
    ) {
        let Workspace {
            inner,
            loaded,
            gradient,
            ..
        } = &*run.workspace;
        let products = loaded.sweep((), |entries, ()| {
            let spread = &inner.spread[entries.range.clone()];
            let gradient = pair(gradient, &entries.chunk);
            entries.sums(|k, place| spread[k].map(|w| dot(w, gradient(place))))
        });
        run.workspace.multiplier = self.solve(products);
    }

    /// Whether cells that can only turn can take up a change of the totals: not if they all point along it.
    fn can_turn(&self) -> bool {
        let [xx, yy, xy] = self.mobility;
        let all = xx + yy;
        let least = match self.has_total {
            [true, true] => (xx * yy - xy * xy) / all,
            [true, false] => xx,
            _ => yy,
        };
        least > LEAST_TURN * all
    }
}

/// Part of what turning changes along a total below which it is round-off: close to the limit, cells that all slide
/// are turned away from the total by very little, and it is that which carries it.
const LEAST_TURN: f64 = 1e-13;

fn mobility<C: Operator<2>, P: Operator<2>>(run: &Run<'_, '_, C, P>) -> [f64; 3] {
    let Workspace { inner, loaded, .. } = &*run.workspace;
    loaded.sweep((), |entries, ()| {
        let cells = &inner.cells[entries.range.clone()];
        entries.sums(|k, _| {
            let ([xx, xy], [_, yy]) = (cells[k].project([1.0, 0.0]), cells[k].project([0.0, 1.0]));
            [xx, yy, xy]
        })
    })
}
