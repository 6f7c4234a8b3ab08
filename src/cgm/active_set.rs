//! Active sets outside, unclipped preconditioned conjugate gradients inside.
//!
//! Each outer step measures the exact residual, solves the linear problem on the free entries to a
//! moderate accuracy, letting them violate their bounds, and then moves all entries between the
//! sets at once, at that equilibrated state: a primal-dual active-set method (Hintermueller, Ito &
//! Kunisch, SIAM J. Optim. 13 (2002) 865, <https://doi.org/10.1137/S1052623401383558>). A
//! prescribed total is carried by the bordered system: `w = M e` spreads a change of the total
//! over the free entries as a flat punch would, and directions keep it.

use std::ops::ControlFlow;

use crate::cgm::run::Run;
use crate::cgm::{Constraint, Inner, State, Workspace, reduce};
use crate::operator::Operator;
use crate::parallel::{self, Blocks, CHUNK, blocks};
use crate::report::Status;

/// Reduction of the inner residual per outer step.
const INNER_REDUCTION: f64 = 0.1;
/// Inner steps before the sets are looked at again.
const INNER_LIMIT: usize = 60;

/// Outer steps in which neither the residual halves nor fewer entries change sets than ever before
/// after which the method is stuck: while the sets change, and once they stand.
const CYCLE: usize = 12;
const PATIENCE: usize = 4;

/// Ends with the status of the run; `None` if the sets cycle.
pub(super) fn iterate<C: Operator, K: Constraint, P: Operator>(
    run: &mut Run<'_, '_, C, K, P>,
) -> Option<Status> {
    run.mark_start();
    let (mut changes, mut fewest) = (usize::MAX, usize::MAX);
    let (mut best, mut without_progress) = (f64::INFINITY, 0);
    loop {
        if changes > 0 {
            list_free(run);
        }
        spread_total(run);
        if !run.is_fresh {
            run.refresh();
        }
        set_multiplier(run);
        let findings = run.examine();
        let mut merit = run.merit(&findings);
        if merit <= run.settings.tolerance {
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
                return run.stuck();
            }
        }
        let reduction = if changes > 0 {
            INNER_REDUCTION
        } else {
            (0.3 * run.settings.tolerance / merit).clamp(1e-4, INNER_REDUCTION)
        };
        if let ControlFlow::Break(status) = solve_free(run, reduction) {
            return Some(status);
        }
        changes = reclassify(run);
    }
}

/// Lists the free entries, and how a change of the total spreads over them: `w = M e`.
fn list_free<C: Operator, K: Constraint, P: Operator>(run: &mut Run<'_, '_, C, K, P>) {
    run.workspace.free_set.update(&run.workspace.state);
    if run.workspace.free_set.len() == 0 {
        open_empty_set(run);
        run.workspace.free_set.update(&run.workspace.state);
    }
    run.workspace.direction.fill(0.0);
    if run.problem.total.is_some() {
        precondition(run, |_| 1.0);
        let Workspace {
            image,
            inner,
            free_set,
            ..
        } = &mut *run.workspace;
        let image = &*image;
        let [weight] = free_set.update_sums(&mut inner.spread, |_, i, _| (image[i], [image[i]]));
        inner.weight = weight;
    }
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
fn spread_total<C: Operator, K: Constraint, P: Operator>(run: &mut Run<'_, '_, C, K, P>) {
    if let Some(total) = run.problem.total {
        let Workspace {
            inner, free_set, ..
        } = &*run.workspace;
        let scale = (total - reduce::total(run.x)) / inner.weight;
        free_set.add(|k| scale * inner.spread[k], run.x);
        run.is_fresh = false;
    }
}

/// `image = M v` for a vector given on the free entries; `direction` is zero elsewhere.
fn precondition<C: Operator, K: Constraint, P: Operator>(
    run: &mut Run<'_, '_, C, K, P>,
    vector: impl Fn(usize) -> f64 + Sync,
) {
    let Workspace {
        preconditioner,
        direction,
        image,
        free_set,
        ..
    } = &mut *run.workspace;
    free_set.scatter(vector, direction);
    run.problem
        .preconditioner
        .apply_roughly(direction, image, preconditioner);
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
    let [weighted] = free_set.sums(|k, i| [inner.spread[k] * gradient[i]]);
    run.workspace.multiplier = weighted / inner.weight;
}

/// Conjugate gradients on the free entries, from `r = delta - (C x + b)`, with approximate
/// products: what they miss the next outer step sees.
fn solve_free<C: Operator, K: Constraint, P: Operator>(
    run: &mut Run<'_, '_, C, K, P>,
    reduction: f64,
) -> ControlFlow<Status> {
    let has_total = run.problem.total.is_some();
    let (mut first, mut previous) = (0.0, 0.0);
    for step in 0..INNER_LIMIT {
        let Workspace {
            inner,
            gradient,
            free_set,
            multiplier,
            ..
        } = &mut *run.workspace;
        let (gradient, current) = (&*gradient, *multiplier);
        std::mem::swap(&mut inner.residual, &mut inner.last_residual);
        free_set.update_sums(&mut inner.residual, |_, i, _| (current - gradient[i], []));
        let residual = std::mem::take(&mut inner.residual);
        precondition(run, |k| residual[k]);

        let Workspace {
            inner,
            image,
            direction,
            free_set,
            multiplier,
            ..
        } = &mut *run.workspace;
        inner.residual = residual;
        let image = &*image;
        let [sum] = free_set.update_sums(&mut inner.correction, |_, i, _| (image[i], [image[i]]));
        // The change of the multiplier that keeps the total.
        let change = if has_total { -sum / inner.weight } else { 0.0 };
        *multiplier += change;
        let Inner {
            residual,
            last_residual,
            correction,
            direction: directions,
            spread,
            ..
        } = &mut *inner;
        let [product, overlap] = free_set.update_sums(correction, |k, _, z| {
            let z = if has_total { z + change * spread[k] } else { z };
            (z, [z * (residual[k] + change), z * last_residual[k]])
        });
        if step == 0 {
            first = product;
        }
        if product <= reduction * reduction * first && step > 0 || product <= 0.0 {
            break;
        }
        // Polak-Ribiere forgives the noise of single precision.
        let conjugation = if step == 0 {
            0.0
        } else {
            ((product - overlap) / previous).max(0.0)
        };
        previous = product;
        free_set.update_sums(directions, |k, _, d| {
            (
                correction[k] + if step == 0 { 0.0 } else { conjugation * d },
                [],
            )
        });
        free_set.scatter(|k| directions[k], direction);
        let free = free_set.len();

        run.proceed(free)?;
        run.apply_roughly_to_direction();
        run.count_step();
        let Workspace {
            inner,
            image,
            gradient,
            free_set,
            ..
        } = &mut *run.workspace;
        let image = &*image;
        let [along, curvature] = free_set.sums(|k, i| {
            let d = inner.direction[k];
            [d * (inner.residual[k] + change), d * image[i]]
        });
        if !(curvature > 0.0 && along.is_finite()) {
            break;
        }
        let length = along / curvature;
        free_set.add(|k| length * inner.direction[k], run.x);
        parallel::update(gradient, |first, chunk| {
            for (g, u) in chunk.iter_mut().zip(&image[first..]) {
                *g += length * u;
            }
        });
        run.is_fresh = false;
    }
    ControlFlow::Continue(())
}

/// Moves entries between the sets at the equilibrated state, all at once, and clips. Returns
/// how many moved.
fn reclassify<C: Operator, K: Constraint, P: Operator>(run: &mut Run<'_, '_, C, K, P>) -> usize {
    let constraint = &run.problem.constraint;
    let multiplier = run.workspace.multiplier;
    let Workspace {
        state,
        gradient,
        product,
        ..
    } = &mut *run.workspace;
    let (gradient, product) = (&*gradient, &*product);
    let [largest] = reduce::max(gradient.len(), |i| [product[i].abs()]);
    // Below this a wrong sign is noise of the inner solution, and would come and go.
    let threshold = (0.01 * run.settings.tolerance).max(f64::EPSILON) * largest;

    run.is_fresh = false;
    let len = run.x.len();
    let data = (blocks(run.x), blocks(state));
    let work = |task: usize, (x, state): (Blocks<'_, f64>, Blocks<'_, State>)| {
        let mut moved = 0_usize;
        for ((i, x), state) in (task * CHUNK..).zip(x.items).zip(state.items) {
            let [lower, upper] = constraint.bounds(i);
            let g = gradient[i] - multiplier;
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
        moved
    };
    parallel::sweep(0..len.div_ceil(CHUNK), data, &work, &|a, b| a + b)
}
