//! Semi-smooth Newton outside, preconditioned conjugate gradients inside.
//!
//! Each outer step measures the slip, linearises it (a sticking cell has two unknowns, a slipping one the
//! angle of its traction), solves to a moderate accuracy and then puts tractions back on their circles and
//! moves cells between stick and slip, all at once at that equilibrated state. Prescribed totals are carried
//! by the bordered system, as for one unknown a cell.

use std::ops::ControlFlow;

use crate::cgm::plane::disc::{at, dot, norm};
use crate::cgm::plane::run::Run;
use crate::cgm::plane::{Cell, Workspace, update_cells};
use crate::cgm::reduce;
use crate::cgm::run::{FLAT, FLATTEST};
use crate::operator::Operator;
use crate::parallel;
use crate::report::Status;

/// Reduction of the inner residual per outer step.
const INNER_REDUCTION: f64 = 0.1;
/// Steps before the sets are looked at again.
const INNER_LIMIT: usize = 60;
/// Residual above which single precision tells the sets as well as double does.
const EARLY: f64 = 1e-3;
/// Outer steps without progress after which the method is stuck: while the sets change, and once they stand.
const CYCLE: usize = 12;
const PATIENCE: usize = 4;

impl Cell {
    /// The part of a vector along which the cell can move.
    fn project(self, v: [f64; 2]) -> [f64; 2] {
        match self {
            Self::Fixed => [0.0; 2],
            Self::Stick => v,
            Self::Slip { tangent, .. } => tangent.map(|t| t * dot(tangent, v)),
        }
    }

    fn weight(self) -> f64 {
        match self {
            Self::Slip { weight, .. } => weight,
            _ => 1.0,
        }
    }

    fn stiffness(self) -> f64 {
        match self {
            Self::Slip { stiffness, .. } => stiffness,
            _ => 0.0,
        }
    }
}

/// Ends with the status of the run; `None` if the sets cycle.
pub(super) fn iterate<C: Operator, P: Operator>(run: &mut Run<'_, '_, C, P>) -> Option<Status> {
    mark_start(run);
    let (mut changes, mut fewest) = (usize::MAX, usize::MAX);
    let (mut best, mut without_progress) = (f64::INFINITY, 0);
    loop {
        let mut border = Border::new(run);
        border.spread_missing(run);
        if !run.is_fresh {
            run.refresh(best > EARLY && without_progress == 0);
        }
        border.set_multiplier(run);
        let findings = run.examine();
        let mut merit = run.merit(&findings);
        if merit <= run.watch.settings.tolerance {
            // Judge what will be returned.
            run.make_feasible();
            let feasible = run.examine();
            merit = run.merit(&feasible);
        }
        if let ControlFlow::Break(status) = run.judge(merit, findings.free) {
            return Some(status);
        }
        if merit <= 0.5 * best || changes < fewest {
            (best, fewest) = (best.min(merit), fewest.min(changes));
            without_progress = 0;
        } else {
            without_progress += 1;
            if without_progress >= if changes == 0 { PATIENCE } else { CYCLE } {
                return run.watch.stuck();
            }
        }
        let reduction = if changes > 0 {
            INNER_REDUCTION
        } else {
            (0.3 * run.watch.settings.tolerance / merit).clamp(1e-4, INNER_REDUCTION)
        };
        stiffen(run);
        if changes == usize::MAX {
            // The first preconditioner did not know how stiff the slipping cells are.
            weigh(run);
            border = Border::new(run);
        }
        if let ControlFlow::Break(status) = solve(run, &border, reduction) {
            return Some(status);
        }
        changes = reclassify(run, findings.displacement);
        weigh(run);
    }
}

/// Brings the start within its discs and marks every cell.
fn mark_start<C: Operator, P: Operator>(run: &mut Run<'_, '_, C, P>) {
    let limits = run.problem.limits;
    update_cells(run.q, |i, q| super::Disc(limits[i]).project(q));
    run.is_fresh = false;
    let q = &*run.q;
    parallel::update(&mut run.workspace.cells, |first, chunk| {
        for (i, cell) in (first..).zip(chunk) {
            let (q, limit) = (at(q, i), limits[i]);
            *cell = if limit <= 0.0 {
                Cell::Fixed
            } else if super::Disc(limit).is_at_limit(q) {
                slipping(q)
            } else {
                Cell::Stick
            };
        }
    });
}

/// A cell at its limit, before its slip is known.
fn slipping(q: [f64; 2]) -> Cell {
    let size = norm(q);
    Cell::Slip {
        tangent: [-q[1] / size, q[0] / size],
        stiffness: 0.0,
        weight: 1.0,
    }
}

/// The stiffness of every slipping cell, from the slip just measured.
fn stiffen<C: Operator, P: Operator>(run: &mut Run<'_, '_, C, P>) {
    let (q, limits) = (&*run.q, run.problem.limits);
    let Workspace {
        cells,
        gradient,
        multiplier,
        ..
    } = &mut *run.workspace;
    let [x, y] = *multiplier;
    let gradient = &*gradient;
    parallel::update(cells, |first, chunk| {
        for (i, cell) in (first..).zip(chunk) {
            if let Cell::Slip {
                tangent, stiffness, ..
            } = cell
            {
                let [gx, gy] = at(gradient, i);
                let (q, g) = (at(q, i), [gx - x, gy - y]);
                // Across the tangent, outwards.
                let n = [tangent[1], -tangent[0]];
                debug_assert!(dot(n, q) > 0.0);
                *stiffness = (-dot(g, n)).max(0.0) / limits[i];
            }
        }
    });
}

/// How much the preconditioner is damped in every slipping cell: as its own compliance asks for beside the
/// stiffness.
fn weigh<C: Operator, P: Operator>(run: &mut Run<'_, '_, C, P>) {
    let own = 4.0 * run.lower_bound;
    parallel::update(&mut run.workspace.cells, |_, chunk| {
        for cell in chunk {
            if let Cell::Slip {
                stiffness, weight, ..
            } = cell
            {
                *weight = if own > 0.0 {
                    (own / (own + *stiffness)).sqrt()
                } else {
                    1.0
                };
            }
        }
    });
}

/// How the prescribed totals are kept: a change of total `a` spreads as `w_a = M e_a` within what the cells
/// can do, as a flat punch would.
struct Border {
    has_total: [bool; 2],
    /// `e_b' w_a`, one on the diagonal where no total is prescribed.
    matrix: [[f64; 2]; 2],
}

impl Border {
    fn new<C: Operator, P: Operator>(run: &mut Run<'_, '_, C, P>) -> Self {
        let has_total = run.problem.totals.map(|total| total.is_some());
        let mut border = Self {
            has_total,
            matrix: [[1.0, 0.0], [0.0, 1.0]],
        };
        if has_total == [false, false] {
            return border;
        }
        let cells = &run.workspace.cells;
        let [sticking] = reduce::sums(cells.len(), |i| {
            [f64::from(u8::from(cells[i] == Cell::Stick))]
        });
        if sticking == 0.0 {
            // Cells that can only turn cannot take up a change of the total.
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
                cells, residual, ..
            } = &mut *run.workspace;
            let cells = &*cells;
            update_cells(residual, |i, _| cells[i].project(unit));
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
    fn solve(&self, right: [f64; 2]) -> [f64; 2] {
        let [[xx, xy], [yx, yy]] = self.matrix;
        let right = [0, 1].map(|a| if self.has_total[a] { right[a] } else { 0.0 });
        let determinant = xx * yy - xy * yx;
        [
            (yy * right[0] - xy * right[1]) / determinant,
            (xx * right[1] - yx * right[0]) / determinant,
        ]
    }

    /// `w_a' v` of both totals.
    fn products(&self, spread: &[Vec<f64>; 2], v: &[f64]) -> [f64; 2] {
        match self.has_total {
            [false, false] => [0.0; 2],
            _ => reduce::sums(cells_of(v), |i| {
                let v = at(v, i);
                [dot(at(&spread[0], i), v), dot(at(&spread[1], i), v)]
            }),
        }
    }

    /// Spreads what is missing of the totals.
    fn spread_missing<C: Operator, P: Operator>(&self, run: &mut Run<'_, '_, C, P>) {
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
    fn set_multiplier<C: Operator, P: Operator>(&self, run: &mut Run<'_, '_, C, P>) {
        let Workspace {
            spread, gradient, ..
        } = &*run.workspace;
        let products = self.products(spread, gradient);
        run.workspace.multiplier = self.solve(products);
    }
}

fn cells_of(vector: &[f64]) -> usize {
    vector.len() / 2
}

/// Conjugate gradients on what the cells can do, with approximate products: what they miss the next outer
/// step sees.
fn solve<C: Operator, P: Operator>(
    run: &mut Run<'_, '_, C, P>,
    border: &Border,
    reduction: f64,
) -> ControlFlow<Status> {
    let Workspace {
        cells,
        gradient,
        residual,
        multiplier,
        ..
    } = &mut *run.workspace;
    let (cells, gradient, [x, y]) = (&*cells, &*gradient, *multiplier);
    update_cells(residual, |i, _| {
        let [gx, gy] = at(gradient, i);
        cells[i].project([x - gx, y - gy])
    });
    run.workspace.direction.fill(0.0);
    let (mut first, mut previous) = (0.0, 0.0);
    for step in 0..=INNER_LIMIT {
        let square = centre(run, border);
        if step == 0 {
            first = square;
        } else if square <= reduction * reduction * first || step == INNER_LIMIT {
            break;
        }
        precondition(run);
        let [product, overlap] = balance(run, border);
        if product <= 0.0 {
            break;
        }
        // Polak-Ribiere forgives the noise of single precision.
        let conjugation = if step > 0 {
            ((product - overlap) / previous).max(0.0)
        } else {
            0.0
        };
        previous = product;
        let Workspace {
            direction,
            correction,
            ..
        } = &mut *run.workspace;
        let correction = &*correction;
        parallel::update(direction, |first, chunk| {
            for (d, z) in chunk.iter_mut().zip(&correction[first..]) {
                *d = z + conjugation * *d;
            }
        });
        run.proceed(0)?;
        run.apply_to_direction(true);
        run.count_step();
        if !advance(run) {
            break;
        }
    }
    ControlFlow::Continue(())
}

/// Changes the multipliers so that the residual keeps no weighted mean; returns its square.
fn centre<C: Operator, P: Operator>(run: &mut Run<'_, '_, C, P>, border: &Border) -> f64 {
    let Workspace {
        spread, residual, ..
    } = &*run.workspace;
    let change = border.solve(border.products(spread, residual)).map(|x| -x);
    shift(run, change);
    let residual = &run.workspace.residual;
    let [square] = reduce::sums(residual.len(), |i| [residual[i] * residual[i]]);
    square
}

/// Changes the multipliers, and the residual with them.
fn shift<C: Operator, P: Operator>(run: &mut Run<'_, '_, C, P>, change: [f64; 2]) {
    if change == [0.0; 2] {
        return;
    }
    let Workspace {
        cells,
        residual,
        multiplier,
        ..
    } = &mut *run.workspace;
    let cells = &*cells;
    *multiplier = [multiplier[0] + change[0], multiplier[1] + change[1]];
    update_cells(residual, |i, [x, y]| {
        let [dx, dy] = cells[i].project(change);
        [x + dx, y + dy]
    });
}

/// `correction = M residual`, within what the cells can do.
fn precondition<C: Operator, P: Operator>(run: &mut Run<'_, '_, C, P>) {
    let Workspace {
        preconditioner,
        cells,
        residual,
        correction,
        weighted,
        ..
    } = &mut *run.workspace;
    let (cells, residual) = (&*cells, &*residual);
    update_cells(weighted, |i, _| {
        at(residual, i).map(|r| r * cells[i].weight())
    });
    run.problem
        .preconditioner
        .apply_roughly(weighted, correction, preconditioner);
    update_cells(correction, |i, z| {
        cells[i].project(z).map(|z| z * cells[i].weight())
    });
}

/// Gives the correction no total; returns its products with the residual and with the last one.
fn balance<C: Operator, P: Operator>(run: &mut Run<'_, '_, C, P>, border: &Border) -> [f64; 2] {
    if border.has_total != [false, false] {
        let correction = &run.workspace.correction;
        let sums: [f64; 2] = reduce::sums(cells_of(correction), |i| at(correction, i));
        let [x, y] = border.solve(sums).map(|x| -x);
        let Workspace {
            correction,
            spread: [wx, wy],
            ..
        } = &mut *run.workspace;
        update_cells(correction, |i, z| {
            let (wx, wy) = (at(wx, i), at(wy, i));
            [0, 1].map(|b| z[b] + x * wx[b] + y * wy[b])
        });
        shift(run, [x, y]);
    }
    let Workspace {
        correction,
        residual,
        last_residual,
        ..
    } = &*run.workspace;
    reduce::sums(correction.len(), |i| {
        [
            correction[i] * residual[i],
            correction[i] * last_residual[i],
        ]
    })
}

/// Goes along the direction to the minimum on it, with the product in `image`; says if there is one
/// from which to go on.
fn advance<C: Operator, P: Operator>(run: &mut Run<'_, '_, C, P>) -> bool {
    let Workspace {
        cells,
        direction,
        image,
        residual,
        last_residual,
        gradient,
        ..
    } = &mut *run.workspace;
    let (cells, direction, image) = (&*cells, &*direction, &*image);
    let [mut curvature, along, square, sticking] = reduce::sums(cells.len(), |i| {
        let d = at(direction, i);
        let bend = cells[i].stiffness() * dot(d, d);
        let sticks = f64::from(u8::from(cells[i] == Cell::Stick));
        [
            dot(d, at(image, i)) + bend,
            dot(d, at(residual, i)),
            dot(d, d),
            sticks,
        ]
    });
    // An operator that maps constants to zero lets all cells together slide to their limits.
    let stiffness = run.lower_bound * square;
    let may_slide = run.problem.totals.contains(&None) && sticking == cells.len() as f64;
    let slides = may_slide && curvature < FLAT * stiffness;
    if slides {
        curvature = FLATTEST * stiffness;
    }
    if !(curvature > 0.0 && along.is_finite()) {
        return false;
    }
    let length = along / curvature;
    std::mem::swap(residual, last_residual);
    let last = &*last_residual;
    update_cells(residual, |i, _| {
        let (r, d) = (at(last, i), at(direction, i));
        let v = cells[i].project(at(image, i));
        let stiffness = cells[i].stiffness();
        [0, 1].map(|b| r[b] - length * (v[b] + stiffness * d[b]))
    });
    parallel::update(gradient, |first, chunk| {
        for (g, u) in chunk.iter_mut().zip(&image[first..]) {
            *g += length * u;
        }
    });
    parallel::update(run.q, |first, chunk| {
        for (q, d) in chunk.iter_mut().zip(&direction[first..]) {
            *q += length * d;
        }
    });
    run.is_fresh = false;
    !slides
}

/// Puts tractions on their circles and moves cells between stick and slip at the equilibrated state, all at
/// once. Returns how many moved.
fn reclassify<C: Operator, P: Operator>(run: &mut Run<'_, '_, C, P>, largest: f64) -> usize {
    let limits = run.problem.limits;
    // Below this a wrong sign is noise of the inner solution, and would come and go.
    let threshold = (0.01 * run.watch.settings.tolerance).max(f64::EPSILON) * largest;
    let q = &*run.q;
    let Workspace {
        cells,
        gradient,
        multiplier,
        ..
    } = &mut *run.workspace;
    let ([x, y], gradient) = (*multiplier, &*gradient);
    let next = |i: usize, cell: Cell| {
        let (q, limit) = (at(q, i), limits[i]);
        let size = norm(q);
        match cell {
            Cell::Stick if size > limit => slipping(q),
            Cell::Slip {
                stiffness, weight, ..
            } => {
                let [gx, gy] = at(gradient, i);
                if dot([gx - x, gy - y], q) > threshold * size {
                    Cell::Stick
                } else {
                    Cell::Slip {
                        tangent: [-q[1] / size, q[0] / size],
                        stiffness,
                        weight,
                    }
                }
            }
            other => other,
        }
    };
    let before = &*cells;
    let kind = std::mem::discriminant::<Cell>;
    let [moved] = reduce::sums(before.len(), |i| {
        let moves = kind(&before[i]) != kind(&next(i, before[i]));
        [f64::from(u8::from(moves))]
    });
    parallel::update(cells, |first, chunk| {
        for (i, cell) in (first..).zip(chunk) {
            *cell = next(i, *cell);
        }
    });
    let cells = &*cells;
    update_cells(run.q, |i, q| match cells[i] {
        Cell::Slip { .. } => q.map(|q_b| q_b * (limits[i] / norm(q))),
        _ => super::Disc(limits[i]).project(q),
    });
    run.is_fresh = false;
    moved as usize
}
