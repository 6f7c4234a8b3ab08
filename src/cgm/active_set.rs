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
use crate::cgm::{Constraint, State, Workspace, reduce};
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
        open_empty_set(run);
        spread_total(run);
        run.refresh();
        set_multiplier(run);
        let findings = run.examine();
        let merit = run.merit(&findings).max(bound_violation(run));
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
        if let ControlFlow::Break(status) = solve_free(run, reduction, findings.free) {
            return Some(status);
        }
        changes = reclassify(run);
    }
}

/// With no free entry nothing can move: frees the entries that want to, or all if the total asks
/// for a change.
fn open_empty_set<C: Operator, K: Constraint, P: Operator>(run: &mut Run<'_, '_, C, K, P>) {
    let state = &run.workspace.state;
    let [free] = reduce::sums(run.len(), |i| {
        [f64::from(u8::from(state[i] == State::Free))]
    });
    if free > 0.0 {
        return;
    }
    let has_total = run.problem.total.is_some();
    if !has_total {
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

/// `w = M e` on the free entries, and the missing total spread along it.
fn spread_total<C: Operator, K: Constraint, P: Operator>(run: &mut Run<'_, '_, C, K, P>) {
    let Some(total) = run.problem.total else {
        return;
    };
    let Workspace {
        preconditioner,
        residual,
        spread,
        state,
        ..
    } = &mut *run.workspace;
    let state = &*state;
    parallel::update(residual, |first, chunk| {
        for (i, value) in (first..).zip(chunk) {
            *value = f64::from(u8::from(state[i] == State::Free));
        }
    });
    run.problem
        .preconditioner
        .apply(residual, spread, preconditioner);
    mask(spread, state);
    let x = &*run.x;
    let [weight, sum] = reduce::sums(x.len(), |i| [spread[i], x[i]]);
    let scale = (total - sum) / weight;
    let spread = &*spread;
    parallel::update(run.x, |first, chunk| {
        for (i, value) in (first..).zip(chunk) {
            *value += scale * spread[i];
        }
    });
}

/// The multiplier that leaves the free entries no mean residual, weighted as the total spreads.
fn set_multiplier<C: Operator, K: Constraint, P: Operator>(run: &mut Run<'_, '_, C, K, P>) {
    if run.problem.total.is_none() {
        return;
    }
    let Workspace {
        spread, gradient, ..
    } = &*run.workspace;
    let [weighted, weight] = reduce::sums(spread.len(), |i| [spread[i] * gradient[i], spread[i]]);
    run.workspace.multiplier = weighted / weight;
}

/// Largest distance outside the bounds, relative to the largest entry.
fn bound_violation<C: Operator, K: Constraint, P: Operator>(run: &Run<'_, '_, C, K, P>) -> f64 {
    let (x, constraint) = (&*run.x, &run.problem.constraint);
    let [outside, largest] = reduce::max(x.len(), |i| {
        [(constraint.project(i, x[i]) - x[i]).abs(), x[i].abs()]
    });
    if outside > 0.0 {
        outside / largest
    } else {
        0.0
    }
}

/// Conjugate gradients on the free entries, from `r = delta - (C x + b)`.
fn solve_free<C: Operator, K: Constraint, P: Operator>(
    run: &mut Run<'_, '_, C, K, P>,
    reduction: f64,
    free: usize,
) -> ControlFlow<Status> {
    let has_total = run.problem.total.is_some();
    let (mut first, mut previous) = (0.0, 0.0);
    for step in 0..INNER_LIMIT {
        let Workspace {
            preconditioner,
            residual,
            correction,
            spread,
            state,
            gradient,
            direction,
            multiplier,
            ..
        } = &mut *run.workspace;
        let (state, spread) = (&*state, &*spread);

        let (gradient, current) = (&*gradient, *multiplier);
        parallel::update(residual, |first, chunk| {
            for (i, value) in (first..).zip(chunk) {
                *value = if state[i] == State::Free {
                    current - gradient[i]
                } else {
                    0.0
                };
            }
        });
        run.problem
            .preconditioner
            .apply(residual, correction, preconditioner);
        mask(correction, state);
        // The change of the multiplier that keeps the total.
        let residual = &*residual;
        let len = residual.len();
        let change = if has_total {
            let [sum, weight] = reduce::sums(len, |i| [correction[i], spread[i]]);
            -sum / weight
        } else {
            0.0
        };
        *multiplier += change;
        let correction = &*correction;
        let z = |i: usize| correction[i] + change * if has_total { spread[i] } else { 0.0 };
        let [product] = reduce::sums(len, |i| {
            [if state[i] == State::Free {
                (residual[i] + change) * z(i)
            } else {
                0.0
            }]
        });
        if step == 0 {
            first = product;
        }
        if product <= reduction * reduction * first && step > 0 || product <= 0.0 {
            break;
        }
        let conjugation = if step == 0 { 0.0 } else { product / previous };
        previous = product;
        parallel::update(direction, |first, chunk| {
            for (i, value) in (first..).zip(chunk) {
                *value = if state[i] == State::Free {
                    z(i) + conjugation * *value
                } else {
                    0.0
                };
            }
        });

        run.proceed(free)?;
        run.apply_to_direction();
        run.count_step();
        let Workspace {
            direction,
            image,
            gradient,
            ..
        } = &mut *run.workspace;
        let (direction, image) = (&*direction, &*image);
        let [curvature] = reduce::sums(len, |i| [direction[i] * image[i]]);
        if curvature <= 0.0 {
            break;
        }
        let length = product / curvature;
        let data = (blocks(run.x), blocks(gradient));
        let advance = |task: usize, (x, gradient): (Blocks<'_, f64>, Blocks<'_, f64>)| {
            let indices = task * CHUNK..;
            for ((i, x), gradient) in indices.zip(x.items).zip(gradient.items) {
                *x += length * direction[i];
                *gradient += length * image[i];
            }
        };
        parallel::sweep(0..len.div_ceil(CHUNK), data, &advance, &|(), ()| ());
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

/// Zeroes the entries that are not free.
fn mask(values: &mut [f64], state: &[State]) {
    parallel::update(values, |first, chunk| {
        for (value, state) in chunk.iter_mut().zip(&state[first..]) {
            if *state != State::Free {
                *value = 0.0;
            }
        }
    });
}
