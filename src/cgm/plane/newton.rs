//! Semi-smooth Newton outside, preconditioned conjugate gradients inside.
//!
//! Each outer step measures the slip, linearises it (a sticking cell has two unknowns, a slipping one the
//! angle of its traction), solves to a moderate accuracy and then puts tractions back on their circles and
//! moves cells between stick and slip, all at once at that equilibrated state. Prescribed totals are carried
//! by the bordered system, as for one unknown a cell.

use std::ops::ControlFlow;

use crate::cgm::free_set::Entries;
use crate::cgm::plane::border::Border;
use crate::cgm::plane::disc::{Halves, dot, halves, norm, pair, restore};
use crate::cgm::plane::inner::solve;
use crate::cgm::plane::run::Run;
use crate::cgm::plane::{Cell, Disc, Inner, Workspace, update_cells};
use crate::cgm::progress::Progress;
use crate::operator::Operator;
use crate::parallel::Ragged;
use crate::report::Status;

/// Outer steps without progress that are a cycle.
const CYCLE: usize = 5;

/// Ends with the status of the run; `None` if the sets cycle.
pub(super) fn iterate<C: Operator<2>, P: Operator<2>>(
    run: &mut Run<'_, '_, C, P>,
) -> Option<Status> {
    if let ControlFlow::Break(status) = start(run) {
        return Some(status);
    }
    let mut border = Border::new(run);
    let mut progress = Progress::new(CYCLE);
    loop {
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
        if let ControlFlow::Break(status) = solve(run, &border, reduction) {
            return Some(status);
        }
        progress.changes = reclassify(run, findings.displacement);
        share(run);
        border = Border::new(run);
        border.spread_missing(run);
        if let ControlFlow::Break(status) = run.ask() {
            return Some(status);
        }
        run.refresh(progress.is_early());
    }
}

/// Brings the start within its discs and near its totals, marks the cells, and measures how stiff the slipping
/// ones are.
fn start<C: Operator<2>, P: Operator<2>>(run: &mut Run<'_, '_, C, P>) -> ControlFlow<Status> {
    let limits = run.problem.limits;
    update_cells(run.q, |i, q| Disc(limits[i]).project(q));
    mark(run);
    let totals = run.problem.totals;
    restore(run.q, limits, totals);
    run.is_fresh = false;
    run.ask()?;
    run.refresh(true);
    let motion = mean_slip(run);
    run.workspace.multiplier = [0, 1].map(|axis| totals[axis].map_or(0.0, |_| motion[axis]));
    stiffen(run);
    share(run);
    ControlFlow::Continue(())
}

/// The mean of the slip where cells stick, or of all if none does.
fn mean_slip<C: Operator<2>, P: Operator<2>>(run: &Run<'_, '_, C, P>) -> [f64; 2] {
    let Workspace {
        inner,
        loaded,
        gradient,
        ..
    } = &*run.workspace;
    let sums = loaded.sweep((), |entries, ()| {
        let cells = &inner.cells[entries.range.clone()];
        let gradient = pair(gradient, &entries.chunk);
        entries.sums(|k, place| {
            let [x, y] = gradient(place);
            let [stuck, slipped] = if cells[k].is_stick() {
                [1.0, 0.0]
            } else {
                [0.0, 1.0]
            };
            [
                stuck * x,
                stuck * y,
                stuck,
                slipped * x,
                slipped * y,
                slipped,
            ]
        })
    });
    let [x, y, stuck, slipped_x, slipped_y, slipped] = sums;
    if stuck > 0.0 {
        [x / stuck, y / stuck]
    } else {
        [slipped_x / slipped, slipped_y / slipped]
    }
}

/// Lists the cells that can carry a traction, and marks those that slip.
fn mark<C: Operator<2>, P: Operator<2>>(run: &mut Run<'_, '_, C, P>) {
    let limits = run.problem.limits;
    let Workspace {
        inner,
        loaded,
        direction,
        ..
    } = &mut *run.workspace;
    loaded.update(|i| limits[i] > 0.0);
    // The inner iteration writes it on the loaded cells only; what has no total spreads nothing.
    direction.fill(0.0);
    inner.spread.fill([[0.0; 2]; 2]);
    let q = &*run.q;
    loaded.sweep(loaded.compressed(&mut inner.cells), |entries, cells| {
        let (q, limits) = (pair(q, &entries.chunk), &limits[entries.chunk.clone()]);
        for (cell, place) in cells.items.iter_mut().zip(entries.places()) {
            *cell = if Disc(limits[place]).is_at_limit(q(place)) {
                Cell::slipping(q(place))
            } else {
                Cell::Stick
            };
        }
        []
    });
}

/// The stiffness of every slipping cell, from the slip just measured.
fn stiffen<C: Operator<2>, P: Operator<2>>(run: &mut Run<'_, '_, C, P>) {
    let limits = run.problem.limits;
    let Workspace {
        inner,
        loaded,
        gradient,
        multiplier,
        ..
    } = &mut *run.workspace;
    let ([x, y], gradient) = (*multiplier, &*gradient);
    loaded.sweep(loaded.compressed(&mut inner.cells), |entries, cells| {
        let limits = &limits[entries.chunk.clone()];
        let gradient = pair(gradient, &entries.chunk);
        for (cell, place) in cells.items.iter_mut().zip(entries.places()) {
            let [gx, gy] = gradient(place);
            cell.stiffen([gx - x, gy - y], limits[place]);
        }
        []
    });
}

/// Tells the preconditioner how stiff the slipping cells are.
fn share<C: Operator<2>, P: Operator<2>>(run: &mut Run<'_, '_, C, P>) {
    let lower_bound = run.lower_bound;
    let Workspace { inner, loaded, .. } = &mut *run.workspace;
    loaded.sweep(loaded.compressed(&mut inner.cells), |_, cells| {
        for cell in cells.items {
            cell.share(lower_bound);
        }
        []
    });
}

/// Puts tractions on their circles and moves cells between stick and slip at the equilibrated state, all at
/// once. Returns how many moved.
fn reclassify<C: Operator<2>, P: Operator<2>>(run: &mut Run<'_, '_, C, P>, largest: f64) -> usize {
    let limits = run.problem.limits;
    // Below this a wrong sign is noise of the inner solution, and would come and go.
    let threshold = (0.01 * run.watch.settings.tolerance).max(f64::EPSILON) * largest;
    run.is_fresh = false;
    let lower_bound = run.lower_bound;
    let Workspace {
        inner: Inner { cells, .. },
        loaded,
        gradient,
        multiplier,
        ..
    } = &mut *run.workspace;
    let ([x, y], gradient) = (*multiplier, &*gradient);
    let data = (halves(run.q), loaded.compressed(cells));
    let work = |entries: Entries<'_>, (q, cells): (Halves<'_>, Ragged<'_, Cell>)| {
        let limits = &limits[entries.chunk.clone()];
        let gradient = pair(gradient, &entries.chunk);
        let mut moved = 0;
        for (cell, place) in cells.items.iter_mut().zip(entries.places()) {
            let limit = limits[place];
            let traction = [q.0.items[place], q.1.items[place]];
            let (size, [gx, gy]) = (norm(traction), gradient(place));
            let sticks = if cell.is_stick() {
                size <= limit
            } else {
                dot([gx - x, gy - y], traction) > threshold * size
            };
            moved += usize::from(sticks != cell.is_stick());
            [q.0.items[place], q.1.items[place]] = if sticks {
                *cell = Cell::Stick;
                Disc(limit).project(traction)
            } else {
                *cell = if cell.is_stick() {
                    Cell::let_go(traction, limit, lower_bound)
                } else {
                    cell.turned_to(traction)
                };
                traction.map(|q| q * (limit / size))
            };
        }
        moved
    };
    loaded.sweep_into(data, work, |a, b| a + b)
}
