//! Newton's method on the law of every cell outside, unclipped preconditioned conjugate gradients inside.
//!
//! Each outer step measures the residual (in single precision while it is large), solves the linear problem of the
//! cells that move to a moderate accuracy, letting them violate their bounds, and then decides for all cells at once,
//! at that equilibrated state, how they move next. For intervals this is the primal-dual active-set method
//! (Hintermueller, Ito & Kunisch, SIAM J. Optim. 13 (2002) 865, <https://doi.org/10.1137/S1052623401383558>); for
//! discs it is semi-smooth Newton with the curvature of the circles in the linear problem.

use std::ops::ControlFlow;

use crate::cgm::inner::solve;
use crate::cgm::motion::{Linearised, Motion};
use crate::cgm::progress::Progress;
use crate::cgm::run::Run;
use crate::cgm::totals::{Total, TotalsSystem};
use crate::cgm::vector::{at, chunks, held, minus, put, slices, within};
use crate::cgm::{Constraint, MotionOf, Workspace, reduce};
use crate::operator::Operator;
use crate::parallel::{self, Blocks, CHUNK, blocks};
use crate::report::Status;

/// Outer steps without progress that are a cycle; where bounds are curved, sets settle sooner.
const CYCLE: usize = 12;
const CYCLE_CURVED: usize = 5;

/// Ends with the status of the run; `None` if the sets cycle.
pub(super) fn iterate<C: Operator<N>, K: Constraint<N>, P: Operator<N>, const N: usize>(
    run: &mut Run<'_, '_, C, K, P, N>,
) -> Option<Status> {
    match steps(run) {
        ControlFlow::Break(status) => Some(status),
        ControlFlow::Continue(()) => run.monitor.stuck(),
    }
}

/// Breaks with a status; continues where the method is stuck.
fn steps<C: Operator<N>, K: Constraint<N>, P: Operator<N>, const N: usize>(
    run: &mut Run<'_, '_, C, K, P, N>,
) -> ControlFlow<Status> {
    let is_curved = MotionOf::<K, N>::IS_CURVED;
    let mut progress = Progress::new(if is_curved { CYCLE_CURVED } else { CYCLE });
    let mut totals = start(run)?;
    loop {
        totals.set_multiplier(run);
        let findings = run.examine();
        let mut merit = run.merit(&findings);
        if merit <= run.monitor.settings.tolerance {
            // Judge what will be returned.
            run.make_feasible();
            let feasible = run.examine();
            merit = run.merit(&feasible);
        }
        run.judge(merit, findings.free)?;
        if progress.is_stuck_at(merit) {
            return ControlFlow::Continue(());
        }
        let reduction = progress.reduction(merit, run.monitor.settings.tolerance);
        measure(run);
        solve(run, &totals, reduction)?;
        let (changes, sums) = reclassify(run, findings.displacement);
        progress.changes = changes;
        if is_curved || changes > 0 {
            totals = linearise(run);
        }
        totals.spread_missing(run, sums);
        run.ask()?;
        if !run.is_fresh {
            if progress.is_early() {
                run.refresh_f32();
            } else {
                run.refresh();
            }
        }
    }
}

/// Brings the start within its sets and near its totals, with a first gradient.
///
/// Curved bounds are measured before anything is spread: tiny cells at the rim, not stiff yet, would turn right round.
fn start<C: Operator<N>, K: Constraint<N>, P: Operator<N>, const N: usize>(
    run: &mut Run<'_, '_, C, K, P, N>,
) -> ControlFlow<Status, TotalsSystem<N>> {
    run.mark_start();
    if MotionOf::<K, N>::IS_CURVED {
        run.restore_totals(Motion::moves);
        run.ask()?;
        run.refresh_f32();
        list(run);
        set_mean_multiplier(run);
        run.hold_springs();
        measure(run);
        return ControlFlow::Continue(linearise(run));
    }
    run.hold_springs();
    let totals = linearise(run);
    let sums = std::array::from_fn(|c| reduce::total(run.x[c]));
    totals.spread_missing(run, sums);
    run.ask()?;
    if !run.is_fresh {
        run.refresh_f32();
    }
    ControlFlow::Continue(totals)
}

/// Lists the cells that move, tells the preconditioner how stiff they are, and finds how totals spread over them.
fn linearise<C: Operator<N>, K: Constraint<N>, P: Operator<N>, const N: usize>(
    run: &mut Run<'_, '_, C, K, P, N>,
) -> TotalsSystem<N> {
    list(run);
    if run.workspace.moving.len() == 0 {
        release(run);
        list(run);
    }
    if MotionOf::<K, N>::IS_CURVED {
        let lower_bound = run.lower_bound;
        parallel::update(&mut run.workspace.motions, |_, chunk| {
            for motion in chunk {
                *motion = motion.weighed(lower_bound);
            }
        });
    }
    TotalsSystem::new(run)
}

fn list<C: Operator<N>, K: Constraint<N>, P: Operator<N>, const N: usize>(
    run: &mut Run<'_, '_, C, K, P, N>,
) {
    let Workspace {
        moving,
        motions,
        direction,
        spread,
        ..
    } = &mut *run.workspace;
    moving.update(|i| motions[i].moves());
    // The inner iteration writes these on the cells that move only; what has no total spreads nothing.
    for part in direction {
        part.fill(0.0);
    }
    if N > 1 {
        spread.fill([[0.0; N]; N]);
    }
}

/// With no cell to move nothing can change: releases those that are pushed, or all if a total asks for a change.
fn release<C: Operator<N>, K: Constraint<N>, P: Operator<N>, const N: usize>(
    run: &mut Run<'_, '_, C, K, P, N>,
) {
    let has_total = run.sums() != [None; N];
    if !has_total && !run.is_fresh {
        run.refresh();
    }
    let Workspace {
        motions,
        gradient,
        multiplier,
        ..
    } = &mut *run.workspace;
    let (gradient, multiplier) = (slices(gradient), *multiplier);
    parallel::update(motions, |first, chunk| {
        for (i, motion) in (first..).zip(chunk) {
            *motion = motion.released(minus(at(&gradient, i), multiplier), has_total);
        }
    });
}

/// The mean of the gradient where cells are free, or of all that move if none is, for the totals; zero elsewhere.
fn set_mean_multiplier<C: Operator<N>, K: Constraint<N>, P: Operator<N>, const N: usize>(
    run: &mut Run<'_, '_, C, K, P, N>,
) {
    let Workspace {
        motions,
        moving,
        gradient,
        ..
    } = &*run.workspace;
    let gradient = slices(gradient);
    let means: [([f64; N], f64); 2] = moving.sweep((), |entries, ()| {
        let motions = &motions[entries.chunk.clone()];
        let gradient = within(&gradient, &entries.chunk);
        entries.sums(|_, place| {
            let (g, nothing) = ((at(&gradient, place), 1.0), ([0.0; N], 0.0));
            if motions[place].is_free() {
                [g, nothing]
            } else {
                [nothing, g]
            }
        })
    });
    let (sum, count) = if means[0].1 > 0.0 { means[0] } else { means[1] };
    let has_total = run.problem.totals.map(|total| total != Total::Free);
    run.workspace.multiplier =
        std::array::from_fn(|c| if has_total[c] { sum[c] / count } else { 0.0 });
}

/// The stiffness of every curved bound, from the gradient just measured.
fn measure<C: Operator<N>, K: Constraint<N>, P: Operator<N>, const N: usize>(
    run: &mut Run<'_, '_, C, K, P, N>,
) {
    if !MotionOf::<K, N>::IS_CURVED {
        return;
    }
    let constraint = &run.problem.constraint;
    let Workspace {
        motions,
        gradient,
        multiplier,
        ..
    } = &mut *run.workspace;
    let (gradient, multiplier) = (slices(gradient), *multiplier);
    parallel::update(motions, |first, chunk| {
        for (i, motion) in (first..).zip(chunk) {
            let g = minus(at(&gradient, i), multiplier);
            *motion = constraint.of(i).measured(*motion, g);
        }
    });
}

/// Decides at the equilibrated state how every cell moves next, all at once, and puts it into its set. Returns
/// how many changed, and the sums of all unknowns.
fn reclassify<C: Operator<N>, K: Constraint<N>, P: Operator<N>, const N: usize>(
    run: &mut Run<'_, '_, C, K, P, N>,
    largest: f64,
) -> (usize, [f64; N]) {
    let constraint = &run.problem.constraint;
    // Below this a wrong sign is noise of the inner solution, and would come and go.
    let noise = (0.01 * run.monitor.settings.tolerance).max(f64::EPSILON) * largest;
    let lower_bound = run.lower_bound;
    run.is_fresh = false;
    let Workspace {
        motions,
        gradient,
        multiplier,
        ..
    } = &mut *run.workspace;
    let (gradient, multiplier) = (slices(gradient), *multiplier);
    let tasks = motions.len().div_ceil(CHUNK);
    let data = (chunks(&mut run.x), blocks(motions));
    let work =
        |task: usize, (mut x, motions): ([Blocks<'_, f64>; N], Blocks<'_, MotionOf<K, N>>)| {
            let mut changed = 0_usize;
            for (place, motion) in motions.items.iter_mut().enumerate() {
                let cell = task * CHUNK + place;
                let g = minus(at(&gradient, cell), multiplier);
                let set = constraint.of(cell);
                let (next, value) = set.next(*motion, held(&x, place), g, noise, lower_bound);
                changed += usize::from(
                    next.moves() != motion.moves() || next.is_free() != motion.is_free(),
                );
                *motion = next;
                put(&mut x, place, value);
            }
            (changed, x.map(|x| reduce::in_lanes(x.items)))
        };
    parallel::sweep(0..tasks, data, &work, &reduce::Tally::plus)
}
