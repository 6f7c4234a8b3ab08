//! The way out when sets cycle: projected gradients with Barzilai-Borwein lengths, as for one unknown a cell
//! (Dai & Fletcher, Mathematical Programming 106 (2006) 403, <https://doi.org/10.1007/s10107-005-0595-2>).

use std::ops::ControlFlow;

use crate::cgm::plane::Workspace;
use crate::cgm::plane::disc::restore;
use crate::cgm::plane::run::Run;
use crate::cgm::reduce;
use crate::operator::Operator;
use crate::parallel;
use crate::report::Status;

/// At most `steps` steps from the present iterate; says whether they ended at a point where the objective no
/// longer falls.
pub(super) fn iterate<C: Operator<2>, P: Operator<2>>(
    run: &mut Run<'_, '_, C, P>,
    steps: usize,
) -> ControlFlow<Status, bool> {
    restore(run.q, run.problem.limits, run.problem.totals);
    run.is_fresh = false;
    run.ask()?;
    run.refresh(false);
    run.ask()?;
    let Workspace {
        direction,
        gradient,
        ..
    } = &mut *run.workspace;
    direction.copy_from_slice(gradient);
    run.apply_to_direction(false);
    let [square, curvature] = squares(run);
    if curvature.is_nan() || curvature <= 0.0 {
        return ControlFlow::Continue(true);
    }
    let mut length = square / curvature;
    for _ in 0..steps {
        // d = P(q - a g) - q
        let Workspace {
            direction,
            gradient,
            ..
        } = &mut *run.workspace;
        let (q, slope) = (&*run.q, &*gradient);
        parallel::update(direction, |first, chunk| {
            for (i, d) in (first..).zip(chunk) {
                *d = q[i] - length * slope[i];
            }
        });
        restore(direction, run.problem.limits, run.problem.totals);
        parallel::update(direction, |first, chunk| {
            for (d, q) in chunk.iter_mut().zip(&q[first..]) {
                *d -= q;
            }
        });
        let direction = &*direction;
        let [descent] = reduce::sums(q.len(), |i| [slope[i] * direction[i]]);
        if descent.is_nan() || descent >= 0.0 {
            return ControlFlow::Continue(true);
        }
        run.proceed()?;
        run.apply_to_direction(false);
        run.count_step();
        let [square, curvature] = squares(run);
        if curvature.is_nan() || curvature <= 0.0 {
            return ControlFlow::Continue(true);
        }
        length = square / curvature;
        let step = (-descent / curvature).min(1.0);
        let Workspace {
            direction,
            gradient,
            image,
            ..
        } = &mut *run.workspace;
        for (target, change) in [(&mut *run.q, &*direction), (gradient, &*image)] {
            parallel::update(target, |first, chunk| {
                for (value, change) in chunk.iter_mut().zip(&change[first..]) {
                    *value += step * change;
                }
            });
        }
        run.is_fresh = false;
    }
    ControlFlow::Continue(false)
}

/// `[d'd, d'Cd]` of the direction.
fn squares<C: Operator<2>, P: Operator<2>>(run: &Run<'_, '_, C, P>) -> [f64; 2] {
    let Workspace {
        direction, image, ..
    } = &*run.workspace;
    reduce::sums(direction.len(), |i| {
        [direction[i] * direction[i], direction[i] * image[i]]
    })
}
