//! The way out when sets cycle: projected gradients with Barzilai-Borwein lengths.
//!
//! Every step goes along `P(x - a g) - x`, with the exact projection on sets and sums, to the
//! minimum of the objective on it: the objective falls at every step, from any start, whatever the
//! sets do (Dai & Fletcher, Mathematical Programming 106 (2006) 403,
//! <https://doi.org/10.1007/s10107-005-0595-2>). Slow, so it only leads the other methods past the
//! place where they went in circles.

use std::ops::ControlFlow;

use crate::cgm::motion::Linearised;
use crate::cgm::run::Run;
use crate::cgm::totals::{Total, sums_of};
use crate::cgm::vector::{
    at, chunks, dot, held, minus, plus, put, slices, slices_mut, update_cells,
};
use crate::cgm::{Admissible, Constraint, Workspace, reduce};
use crate::operator::Operator;
use crate::parallel::{self, Blocks, CHUNK};
use crate::report::Status;

/// At most `steps` steps from the present iterate; says whether they ended at a point where the
/// objective no longer falls.
pub(super) fn iterate<C: Operator<N>, K: Constraint<N>, P: Operator<N>, const N: usize>(
    run: &mut Run<'_, '_, C, K, P, N>,
    steps: usize,
) -> ControlFlow<Status, bool> {
    run.mark_start();
    run.restore_totals(|_| true);
    run.ask()?;
    run.refresh();
    run.ask()?;
    let Some(mut length) = first_length(run) else {
        return ControlFlow::Continue(true);
    };
    for _ in 0..steps {
        set_multiplier(run);
        let [descent, square] = set_direction(run, length);
        if descent.is_nan() || descent >= 0.0 {
            return ControlFlow::Continue(true);
        }
        run.proceed()?;
        run.apply_to_direction();
        run.count_step();
        let curvature = curvature(run);
        if curvature.is_nan() || curvature <= 0.0 {
            return ControlFlow::Continue(true);
        }
        advance(run, (-descent / curvature).min(1.0));
        length = square / curvature;
    }
    ControlFlow::Continue(false)
}

/// A step length of the right size: that of the steepest descent without bounds.
fn first_length<C: Operator<N>, K: Constraint<N>, P: Operator<N>, const N: usize>(
    run: &mut Run<'_, '_, C, K, P, N>,
) -> Option<f64> {
    let Workspace {
        gradient,
        direction,
        ..
    } = &mut *run.workspace;
    for (direction, gradient) in direction.iter_mut().zip(gradient) {
        direction.copy_from_slice(gradient);
    }
    run.apply_to_direction();
    let direction = slices(&run.workspace.direction);
    let square = reduce::sum(run.cells(), |i| dot(at(&direction, i), at(&direction, i)));
    let curvature = curvature(run);
    (curvature > 0.0).then(|| square / curvature)
}

/// The multipliers of springs, and the mean of the gradient for those of sums: it changes nothing, but beside it the
/// products would drown in round-off.
fn set_multiplier<C: Operator<N>, K: Constraint<N>, P: Operator<N>, const N: usize>(
    run: &mut Run<'_, '_, C, K, P, N>,
) {
    if run.problem.totals == [Total::Free; N] {
        return;
    }
    let constraint = &run.problem.constraint;
    let gradient = slices(&run.workspace.gradient);
    let (sum, count): ([f64; N], f64) = reduce::sum(run.cells(), |i| {
        if constraint.of(i).can_move() {
            (at(&gradient, i), 1.0)
        } else {
            ([0.0; N], 0.0)
        }
    });
    let sums = sums_of(&slices(&run.x));
    run.workspace.multiplier =
        std::array::from_fn(|c| run.problem.totals[c].held(sum[c] / count, sums[c]));
}

/// `d = P(x - a g) - x`; returns `[g'd, d'd]`.
fn set_direction<C: Operator<N>, K: Constraint<N>, P: Operator<N>, const N: usize>(
    run: &mut Run<'_, '_, C, K, P, N>,
    length: f64,
) -> [f64; 2] {
    let (constraint, sums) = (&run.problem.constraint, run.sums());
    let Workspace {
        gradient,
        direction,
        multiplier,
        ..
    } = &mut *run.workspace;
    let (x, gradient, multiplier) = (slices(&run.x), slices(gradient), *multiplier);
    let slope = |i: usize| minus(at(&gradient, i), multiplier);
    update_cells(direction, |i, _| plus(at(&x, i), -length, slope(i)));
    if sums != [None; N] {
        K::Set::restore(slices_mut(direction), constraint, |_| true, sums);
    }
    update_cells(direction, |i, d| {
        minus(constraint.of(i).project(d), at(&x, i))
    });
    let direction = slices(direction);
    reduce::sums(x[0].len(), |i| {
        let d = at(&direction, i);
        [dot(slope(i), d), dot(d, d)]
    })
}

/// `d' C d` of the direction, and what the springs add to it.
fn curvature<C: Operator<N>, K: Constraint<N>, P: Operator<N>, const N: usize>(
    run: &Run<'_, '_, C, K, P, N>,
) -> f64 {
    let Workspace {
        direction, image, ..
    } = &*run.workspace;
    let (direction, image) = (slices(direction), slices(image));
    let (bodies, sums): (f64, [f64; N]) = reduce::sum(run.cells(), |i| {
        let d = at(&direction, i);
        (dot(d, at(&image, i)), d)
    });
    let springs = run.problem.totals.iter().zip(sums);
    springs.fold(bodies, |curvature, (total, sum)| match total {
        Total::Spring { compliance, .. } => curvature + compliance * sum * sum,
        Total::Free | Total::Sum(_) => curvature,
    })
}

/// Takes a part of the direction.
fn advance<C: Operator<N>, K: Constraint<N>, P: Operator<N>, const N: usize>(
    run: &mut Run<'_, '_, C, K, P, N>,
    step: f64,
) {
    let constraint = &run.problem.constraint;
    let Workspace {
        direction,
        image,
        gradient,
        ..
    } = &mut *run.workspace;
    let (direction, image) = (slices(direction), slices(image));
    let tasks = direction[0].len().div_ceil(CHUNK);
    let work =
        |task: usize, (mut x, mut gradient): ([Blocks<'_, f64>; N], [Blocks<'_, f64>; N])| {
            for place in 0..x[0].items.len() {
                let cell = task * CHUNK + place;
                let moved = at(&direction, cell).map(|d| step * d);
                let arrived = constraint.of(cell).arrive(held(&x, place), moved);
                put(&mut x, place, arrived);
                let next = plus(held(&gradient, place), step, at(&image, cell));
                put(&mut gradient, place, next);
            }
        };
    let data = (chunks(&mut run.x), chunks(gradient));
    parallel::sweep(0..tasks, data, &work, &|(), ()| ());
    run.is_fresh = false;
}
