//! Active sets outside, unclipped preconditioned conjugate gradients inside.
//!
//! Each outer step measures the residual (to single precision while it is large), solves the linear
//! problem on the free entries to a moderate accuracy, letting them violate their bounds, and then
//! moves all entries between the sets at once, at that equilibrated state: a primal-dual active-set
//! method (Hintermueller, Ito & Kunisch, SIAM J. Optim. 13 (2002) 865,
//! <https://doi.org/10.1137/S1052623401383558>). A prescribed total is carried by the bordered
//! system: `w = M e` spreads a change of the total over the free entries as a flat punch would, and
//! directions keep it.

use std::ops::ControlFlow;

use crate::cgm::inner::{precondition, solve_free};
use crate::cgm::progress::Progress;
use crate::cgm::run::Run;
use crate::cgm::{Constraint, State, Workspace, reduce};
use crate::operator::Operator;
use crate::parallel::{self, Blocks, CHUNK, blocks};
use crate::report::Status;

/// Outer steps without progress that are a cycle.
const CYCLE: usize = 12;

/// Ends with the status of the run; `None` if the sets cycle.
pub(super) fn iterate<C: Operator, K: Constraint, P: Operator>(
    run: &mut Run<'_, '_, C, K, P>,
) -> Option<Status> {
    run.mark_start();
    let mut progress = Progress::new(CYCLE);
    let mut sum = reduce::total(run.x);
    loop {
        if let ControlFlow::Break(status) = run.ask() {
            return Some(status);
        }
        if progress.changes > 0 {
            list_free(run);
        }
        spread_total(run, sum);
        if !run.is_fresh {
            if progress.is_early() {
                run.refresh_roughly();
            } else {
                run.refresh();
            }
        }
        set_multiplier(run);
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
        if let ControlFlow::Break(status) = solve_free(run, reduction) {
            return Some(status);
        }
        (progress.changes, sum) = reclassify(run, findings.displacement);
    }
}

/// Lists the free entries, and how a change of the total spreads over them: `w = M e`.
fn list_free<C: Operator, K: Constraint, P: Operator>(run: &mut Run<'_, '_, C, K, P>) {
    list_entries(run.workspace);
    if run.workspace.free_set.len() == 0 {
        open_empty_set(run);
        list_entries(run.workspace);
    }
    // The engine writes `direction` on the free entries only.
    run.workspace.direction.fill(0.0);
    if run.problem.total.is_some() {
        let Workspace {
            direction,
            free_set,
            ..
        } = &mut *run.workspace;
        free_set.sweep(blocks(direction), |entries, full| {
            for place in entries.places() {
                full.items[place] = 1.0;
            }
            []
        });
        precondition(run);
        let Workspace {
            image,
            inner,
            free_set,
            ..
        } = &mut *run.workspace;
        let image = &*image;
        let spread = free_set.compressed(&mut inner.spread);
        [inner.weight] = free_set.sweep(spread, |entries, spread| {
            let image = &image[entries.chunk.clone()];
            entries.sums(|k, place| {
                spread.items[k] = image[place];
                [image[place]]
            })
        });
    }
}

fn list_entries<C: Operator, P: Operator>(workspace: &mut Workspace<C, P>) {
    let Workspace {
        free_set, state, ..
    } = workspace;
    free_set.update(|i| state[i] == State::Free);
}

/// With no free entry nothing can move: frees the entries that want to, or all if the total asks
/// for a change.
fn open_empty_set<C: Operator, K: Constraint, P: Operator>(run: &mut Run<'_, '_, C, K, P>) {
    let has_total = run.problem.total.is_some();
    if !has_total && !run.is_fresh {
        run.refresh();
    }
    let gradient = &run.workspace.gradient;
    parallel::update(&mut run.workspace.state, |first, chunk| {
        for (i, state) in (first..).zip(chunk) {
            *state = match *state {
                State::Lower if has_total || gradient[i] < 0.0 => State::Free,
                State::Upper if has_total || gradient[i] > 0.0 => State::Free,
                other => other,
            };
        }
    });
}

/// Spreads what is missing of the total over the free entries, as a flat punch would.
fn spread_total<C: Operator, K: Constraint, P: Operator>(run: &mut Run<'_, '_, C, K, P>, sum: f64) {
    if let Some(total) = run.problem.total {
        let Workspace {
            inner, free_set, ..
        } = &*run.workspace;
        let scale = (total - sum) / inner.weight;
        free_set.sweep(blocks(run.x), |entries, x| {
            let spread = &inner.spread[entries.range.clone()];
            for (place, w) in entries.places().zip(spread) {
                x.items[place] += scale * w;
            }
            []
        });
        run.is_fresh = false;
    }
}

/// The multiplier that leaves the free entries no mean residual, weighted as the total spreads.
fn set_multiplier<C: Operator, K: Constraint, P: Operator>(run: &mut Run<'_, '_, C, K, P>) {
    if run.problem.total.is_none() {
        return;
    }
    let Workspace {
        inner,
        gradient,
        free_set,
        ..
    } = &*run.workspace;
    let [weighted] = free_set.sweep((), |entries, ()| {
        let (spread, gradient) = (
            &inner.spread[entries.range.clone()],
            &gradient[entries.chunk.clone()],
        );
        entries.sums(|k, place| [spread[k] * gradient[place]])
    });
    run.workspace.multiplier = weighted / inner.weight;
}

/// Moves entries between the sets at the equilibrated state, all at once, and clips. Returns
/// how many moved, and the sum of all unknowns.
fn reclassify<C: Operator, K: Constraint, P: Operator>(
    run: &mut Run<'_, '_, C, K, P>,
    largest: f64,
) -> (usize, f64) {
    let constraint = &run.problem.constraint;
    let multiplier = run.workspace.multiplier;
    let Workspace {
        state, gradient, ..
    } = &mut *run.workspace;
    let gradient = &*gradient;
    // Below this a wrong sign is noise of the inner solution, and would come and go.
    let threshold = (0.01 * run.watch.settings.tolerance).max(f64::EPSILON) * largest;

    run.is_fresh = false;
    let len = run.x.len();
    let data = (blocks(run.x), blocks(state));
    let work = |task: usize, (x, state): (Blocks<'_, f64>, Blocks<'_, State>)| {
        let mut moved = 0_usize;
        let gradient = &gradient[task * CHUNK..];
        let cells = x.items.iter_mut().zip(state.items).zip(gradient);
        for (i, ((x, state), g)) in (task * CHUNK..).zip(cells) {
            let [lower, upper] = constraint.bounds(i);
            let g = g - multiplier;
            let next = match *state {
                State::Free if *x < lower => State::Lower,
                State::Free if *x > upper => State::Upper,
                State::Lower if g < -threshold => State::Free,
                State::Upper if g > threshold => State::Free,
                other => other,
            };
            moved += usize::from(next != *state);
            *state = next;
            *x = constraint.project(i, *x);
        }
        (moved, reduce::in_lanes(x.items))
    };
    let merge = |a: (usize, f64), b: (usize, f64)| (a.0 + b.0, a.1 + b.1);
    parallel::sweep(0..len.div_ceil(CHUNK), data, &work, &merge)
}
