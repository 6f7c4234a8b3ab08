//! The way out when sets cycle: projected gradients with Barzilai-Borwein lengths.
//!
//! Every step goes along `P(x - a g) - x`, with the exact projection on bounds and total, to the
//! minimum of the objective on it: the objective falls at every step, from any start, whatever the
//! sets do (Dai & Fletcher, Mathematical Programming 106 (2006) 403,
//! <https://doi.org/10.1007/s10107-005-0595-2>). Slow, so it only leads the other methods past the
//! place where they went in circles.

use std::ops::ControlFlow;

use crate::cgm::run::Run;
use crate::cgm::{Constraint, Workspace, balance, reduce};
use crate::operator::Operator;
use crate::parallel::{self, Blocks, CHUNK, blocks};
use crate::report::Status;

/// At most `steps` steps from the present iterate; says whether they ended at a point where the
/// objective no longer falls.
pub(super) fn iterate<C: Operator, K: Constraint, P: Operator>(
    run: &mut Run<'_, '_, C, K, P>,
    steps: usize,
) -> ControlFlow<Status, bool> {
    run.mark_start();
    let constraint = &run.problem.constraint;
    if let Some(total) = run.problem.total {
        balance::restore(run.x, constraint, |_| true, total);
    }
    run.ask()?;
    run.refresh();
    run.ask()?;
    let Some(mut length) = first_length(run) else {
        return ControlFlow::Continue(true);
    };
    for _ in 0..steps {
        let [descent, square] = set_direction(run, length);
        if descent.is_nan() || descent >= 0.0 {
            return ControlFlow::Continue(true);
        }
        run.proceed()?;
        run.apply_to_direction();
        run.count_step();
        let Workspace {
            direction,
            image,
            gradient,
            ..
        } = &mut *run.workspace;
        let (direction, image) = (&*direction, &*image);
        let [curvature] = reduce::sums(direction.len(), |i| [direction[i] * image[i]]);
        if curvature.is_nan() || curvature <= 0.0 {
            return ControlFlow::Continue(true);
        }
        let step = (-descent / curvature).min(1.0);
        length = square / curvature;
        let work = |task: usize, (x, gradient): (Blocks<'_, f64>, Blocks<'_, f64>)| {
            for ((i, x), gradient) in (task * CHUNK..).zip(x.items).zip(gradient.items) {
                *x = arrive(*x, step * direction[i], constraint.bounds(i));
                *gradient += step * image[i];
            }
        };
        let tasks = direction.len().div_ceil(CHUNK);
        parallel::sweep(
            0..tasks,
            (blocks(run.x), blocks(gradient)),
            &work,
            &|(), ()| (),
        );
        run.is_fresh = false;
    }
    ControlFlow::Continue(false)
}

/// `x + d`, exactly at a bound that it reaches up to round-off.
fn arrive(x: f64, d: f64, [lower, upper]: [f64; 2]) -> f64 {
    let (next, noise) = (x + d, 2.0 * f64::EPSILON * (x.abs() + d.abs()));
    if next <= lower + noise {
        lower
    } else if next >= upper - noise {
        upper
    } else {
        next
    }
}

/// A step length of the right size: that of the steepest descent without bounds.
fn first_length<C: Operator, K: Constraint, P: Operator>(
    run: &mut Run<'_, '_, C, K, P>,
) -> Option<f64> {
    let Workspace {
        gradient,
        direction,
        ..
    } = &mut *run.workspace;
    direction.copy_from_slice(gradient);
    run.apply_to_direction();
    let Workspace {
        direction, image, ..
    } = &*run.workspace;
    let [square, curvature] = reduce::sums(direction.len(), |i| {
        [direction[i].powi(2), direction[i] * image[i]]
    });
    (curvature > 0.0).then(|| square / curvature)
}

/// `d = P(x - a g) - x`; returns `[g'd, d'd]`. With a total the mean of `g` changes nothing, and goes:
/// beside it the products would drown in round-off.
fn set_direction<C: Operator, K: Constraint, P: Operator>(
    run: &mut Run<'_, '_, C, K, P>,
    length: f64,
) -> [f64; 2] {
    let constraint = &run.problem.constraint;
    let Workspace {
        gradient,
        direction,
        ..
    } = &mut *run.workspace;
    let (x, gradient) = (&*run.x, &*gradient);
    let mean = match run.problem.total {
        Some(_) => {
            let [sum, count] = reduce::sums(x.len(), |i| {
                let [lower, upper] = constraint.bounds(i);
                if lower < upper {
                    [gradient[i], 1.0]
                } else {
                    [0.0, 0.0]
                }
            });
            sum / count
        }
        None => 0.0,
    };
    parallel::update(direction, |first, chunk| {
        for (i, d) in (first..).zip(chunk) {
            *d = x[i] - length * (gradient[i] - mean);
        }
    });
    if let Some(total) = run.problem.total {
        balance::restore(direction, constraint, |_| true, total);
    }
    parallel::update(direction, |first, chunk| {
        for (i, d) in (first..).zip(chunk) {
            *d = constraint.project(i, *d) - x[i];
        }
    });
    let direction = &*direction;
    reduce::sums(x.len(), |i| {
        [(gradient[i] - mean) * direction[i], direction[i].powi(2)]
    })
}
