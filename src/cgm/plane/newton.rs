//! Semi-smooth Newton outside, preconditioned conjugate gradients inside.
//!
//! Each outer step measures the slip, linearises it (a sticking cell has two unknowns, a slipping one the
//! angle of its traction), solves to a moderate accuracy and then puts tractions back on their circles and
//! moves cells between stick and slip, all at once at that equilibrated state. Prescribed totals are carried
//! by the bordered system, as for one unknown a cell.

use std::ops::ControlFlow;

use crate::cgm::plane::border::{Border, precondition};
use crate::cgm::plane::disc::{at, dot, norm, sweep_cells};
use crate::cgm::plane::run::Run;
use crate::cgm::plane::{Cell, Workspace, update_cells};
use crate::cgm::progress::Progress;
use crate::cgm::reduce;
use crate::cgm::run::{FLAT, FLATTEST};
use crate::operator::Operator;
use crate::parallel;
use crate::report::Status;

/// Steps before the sets are looked at again.
const INNER_LIMIT: usize = 60;
/// Outer steps without progress that are a cycle.
const CYCLE: usize = 5;

/// Ends with the status of the run; `None` if the sets cycle.
pub(super) fn iterate<C: Operator, P: Operator>(run: &mut Run<'_, '_, C, P>) -> Option<Status> {
    mark_start(run);
    let mut progress = Progress::new(CYCLE);
    let mut is_first = true;
    loop {
        if let ControlFlow::Break(status) = run.ask() {
            return Some(status);
        }
        let mut border = Border::new(run);
        border.spread_missing(run);
        if !run.is_fresh {
            run.refresh(progress.is_early());
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
        if progress.is_stuck_at(merit) {
            return run.watch.stuck();
        }
        let reduction = progress.reduction(merit, run.watch.settings.tolerance);
        stiffen(run);
        if std::mem::take(&mut is_first) {
            // The first preconditioner did not know how stiff the slipping cells are.
            weigh(run);
            border = Border::new(run);
        }
        if let ControlFlow::Break(status) = solve(run, &border, reduction) {
            return Some(status);
        }
        progress.changes = reclassify(run, findings.displacement);
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
        spread,
        multiplier,
        ..
    } = &mut *run.workspace;
    let (cells, gradient, spread, [x, y]) = (&*cells, &*gradient, &*spread, *multiplier);
    let mut weighted = sweep_cells([residual], |i, _| {
        let [gx, gy] = at(gradient, i);
        let r = cells[i].project([x - gx, y - gy]);
        ([r], border.products(spread, i, r))
    });
    run.workspace.direction.fill(0.0);
    let (mut first, mut previous) = (0.0, 0.0);
    for step in 0..=INNER_LIMIT {
        let square = centre(run, border.solve(weighted).map(|x| -x));
        if step == 0 {
            first = square;
        } else if square <= reduction * reduction * first || step == INNER_LIMIT {
            break;
        }
        let [product, overlap] = precondition(run);
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
        match advance(run, border) {
            Some(products) => weighted = products,
            None => break,
        }
    }
    ControlFlow::Continue(())
}

/// Changes the multipliers, and the residual with them, so that it keeps no weighted mean: its correction will
/// then have no total. Returns its square, and leaves it weighted for the preconditioner.
fn centre<C: Operator, P: Operator>(run: &mut Run<'_, '_, C, P>, change: [f64; 2]) -> f64 {
    let Workspace {
        cells,
        residual,
        weighted,
        multiplier,
        ..
    } = &mut *run.workspace;
    let cells = &*cells;
    *multiplier = [multiplier[0] + change[0], multiplier[1] + change[1]];
    let [square] = sweep_cells([residual, weighted], |i, [[x, y], _]| {
        let [dx, dy] = cells[i].project(change);
        let r = [x + dx, y + dy];
        ([r, r.map(|r| r * cells[i].weight())], [dot(r, r)])
    });
    square
}

/// Goes along the direction to the minimum on it, with the product in `image`. Returns the weighted sums of the
/// residual there, `None` if there is no minimum to go on from.
fn advance<C: Operator, P: Operator>(
    run: &mut Run<'_, '_, C, P>,
    border: &Border,
) -> Option<[f64; 2]> {
    let Workspace {
        cells,
        direction,
        image,
        residual,
        last_residual,
        gradient,
        spread,
        ..
    } = &mut *run.workspace;
    let (cells, direction, image, spread) = (&*cells, &*direction, &*image, &*spread);
    let [mut curvature, along, square] = reduce::sums(cells.len(), |i| {
        let d = at(direction, i);
        let bend = cells[i].stiffness() * dot(d, d);
        [
            dot(d, at(image, i)) + bend,
            dot(d, at(residual, i)),
            dot(d, d),
        ]
    });
    // An operator that maps constants to zero lets all cells together slide to their limits.
    let stiffness = run.lower_bound * square;
    let may_slide = run.problem.totals.contains(&None) && curvature < FLAT * stiffness;
    let slides = may_slide && cells.iter().all(|cell| *cell == Cell::Stick);
    if slides {
        curvature = FLATTEST * stiffness;
    }
    if !(curvature > 0.0 && along.is_finite()) {
        return None;
    }
    let length = along / curvature;
    std::mem::swap(residual, last_residual);
    let last = &*last_residual;
    let weighted = sweep_cells([residual], |i, _| {
        let (r, d) = (at(last, i), at(direction, i));
        let v = cells[i].project(at(image, i));
        let stiffness = cells[i].stiffness();
        let r = [0, 1].map(|b| r[b] - length * (v[b] + stiffness * d[b]));
        ([r], border.products(spread, i, r))
    });
    let [] = sweep_cells([gradient, run.q], |i, [g, q]| {
        let (u, d) = (at(image, i), at(direction, i));
        let moved = |v: [f64; 2], by: [f64; 2]| [0, 1].map(|b| v[b] + length * by[b]);
        ([moved(g, u), moved(q, d)], [])
    });
    run.is_fresh = false;
    (!slides).then_some(weighted)
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
    let moved = reduce::count(before.len(), |i| {
        kind(&before[i]) != kind(&next(i, before[i]))
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
    moved
}
