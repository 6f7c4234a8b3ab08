//! The single loop of Polonsky & Keer, for bounds on both sides.
//!
//! With bounds `|q| <= mu p` it is the tangential loop of Wang et al. (2021), eqs 17-26, with the
//! slips of the paper mended: entries inside the bounds are clipped too (eq 21), a re-entering
//! entry is clipped on either side (eq 22), and conjugation adds (eq 24).

use std::ops::ControlFlow;

use crate::cgm::interval::{Side, shift_to_total};
use crate::cgm::run::Run;
use crate::cgm::{Admissible, Constraint, Interval, Workspace, reduce};
use crate::operator::Operator;
use crate::parallel::{self, Blocks, CHUNK, blocks};
use crate::report::Status;

/// Steps between fresh products when nothing forces one.
const REFRESH: usize = 25;
/// Steps without halving the residual after which the loop is stuck.
const PATIENCE: usize = 200;

/// Ends with the status of the run; `None` if the sets cycle.
pub(super) fn iterate<C: Operator, K: Constraint<1, Set = Interval>, P: Operator>(
    run: &mut Run<'_, '_, C, K, P, 1>,
) -> Option<Status> {
    run.mark_start();
    restore_total(run);
    let (mut previous, mut conjugate) = (0.0, false);
    let (mut best, mut without_progress) = (f64::INFINITY, 0);
    let mut since_refresh = REFRESH;
    loop {
        if since_refresh >= REFRESH {
            if let ControlFlow::Break(status) = run.ask() {
                return Some(status);
            }
            run.refresh();
            since_refresh = 0;
        }
        let free = set_multiplier(run);
        let findings = run.examine();
        let merit = run.merit(&findings);
        if merit <= run.monitor.settings.tolerance && !run.is_fresh {
            since_refresh = REFRESH;
            continue;
        }
        if let ControlFlow::Break(status) = run.judge(merit, free) {
            return Some(status);
        }
        if merit < 0.5 * best {
            (best, without_progress) = (merit, 0);
        } else {
            without_progress += 1;
            if without_progress >= PATIENCE {
                return run.monitor.stuck();
            }
        }

        // d = r + theta (R / R_old) d (eq 24), without a mean so that it keeps the total.
        let squares = residual_squares(run);
        let conjugation = if conjugate { squares / previous } else { 0.0 };
        previous = squares;
        set_direction(run, conjugation, free);
        run.apply_to_direction();
        run.count_step();
        let Workspace {
            motions: state,
            gradient: [gradient],
            direction: [direction],
            image: [image],
            multiplier: [multiplier],
            ..
        } = &*run.workspace;
        let [along, curvature, square] = reduce::sums(run.cells(), |i| {
            let r = if state[i] == Side::Free {
                gradient[i] - *multiplier
            } else {
                0.0
            };
            let d = direction[i];
            [r * d, d * image[i], d * d]
        });
        let curvature = run.slide(curvature, square).unwrap_or(curvature);
        let length = if curvature > 0.0 && along.is_finite() {
            along / curvature
        } else {
            0.0
        };

        let moves = step(run, length);
        conjugate = moves.entered == 0 && squares > 0.0;
        if moves.clipped + moves.entered > 0 {
            restore_total(run);
            since_refresh = REFRESH;
        } else {
            follow(run, length);
            since_refresh += 1;
        }
    }
}

/// The mean gradient on the free entries (eq 18), which a prescribed total makes the multiplier.
/// Returns the number of free entries.
fn set_multiplier<C: Operator, K: Constraint<1, Set = Interval>, P: Operator>(
    run: &mut Run<'_, '_, C, K, P, 1>,
) -> usize {
    let Workspace {
        motions: state,
        gradient: [gradient],
        ..
    } = &*run.workspace;
    let (count, sum) = reduce::over_chunks(run.cells(), |range| {
        let free = range.filter(|&i| state[i] == Side::Free);
        free.fold((0_usize, 0.0), |(count, sum), i| {
            (count + 1, sum + gradient[i])
        })
    });
    if run.sums() != [None] && count > 0 {
        run.workspace.multiplier = [sum / count as f64];
    }
    count
}

/// `R = sum r^2` on the free entries (eq 20).
fn residual_squares<C: Operator, K: Constraint<1, Set = Interval>, P: Operator>(
    run: &Run<'_, '_, C, K, P, 1>,
) -> f64 {
    let Workspace {
        motions: state,
        gradient: [gradient],
        multiplier: [multiplier],
        ..
    } = &*run.workspace;
    reduce::sum(run.cells(), |i| {
        if state[i] == Side::Free {
            (gradient[i] - multiplier).powi(2)
        } else {
            0.0
        }
    })
}

fn set_direction<C: Operator, K: Constraint<1, Set = Interval>, P: Operator>(
    run: &mut Run<'_, '_, C, K, P, 1>,
    conjugation: f64,
    free: usize,
) {
    let has_total = run.sums() != [None];
    let Workspace {
        motions: state,
        gradient: [gradient],
        direction: [direction],
        multiplier: [multiplier],
        ..
    } = &mut *run.workspace;
    let (state, gradient, multiplier) = (&*state, &*gradient, *multiplier);
    parallel::update(direction, |first, chunk| {
        for (i, d) in (first..).zip(chunk) {
            *d = if state[i] == Side::Free {
                gradient[i] - multiplier + conjugation * *d
            } else {
                0.0
            };
        }
    });
    if has_total && free > 0 {
        let mean = reduce::sum(state.len(), |i| direction[i]) / free as f64;
        parallel::update(direction, |first, chunk| {
            for (i, d) in (first..).zip(chunk) {
                if state[i] == Side::Free {
                    *d -= mean;
                }
            }
        });
    }
}

/// Entries that changed sets in a step.
struct Moves {
    clipped: usize,
    entered: usize,
}

/// `x -= tau d` on the free entries, clipped (eq 21'); entries at a bound whose residual points
/// inward follow theirs and become free (eqs 22, 23).
fn step<C: Operator, K: Constraint<1, Set = Interval>, P: Operator>(
    run: &mut Run<'_, '_, C, K, P, 1>,
    length: f64,
) -> Moves {
    let len = run.cells();
    let constraint = &run.problem.constraint;
    let Workspace {
        motions: state,
        gradient: [gradient],
        direction: [direction],
        multiplier: [multiplier],
        ..
    } = &mut *run.workspace;
    let (gradient, direction, multiplier) = (&*gradient, &*direction, *multiplier);
    let work = |task: usize, (x, state): (Blocks<'_, f64>, Blocks<'_, Side>)| {
        let mut moves = Moves {
            clipped: 0,
            entered: 0,
        };
        for ((i, x), state) in (task * CHUNK..).zip(x.items).zip(state.items) {
            let r = gradient[i] - multiplier;
            let interval = constraint.of(i);
            let Interval { lower, upper } = interval;
            match *state {
                Side::Free => {
                    *x -= length * direction[i];
                    if *x <= lower || *x >= upper {
                        *state = if *x <= lower {
                            Side::Lower
                        } else {
                            Side::Upper
                        };
                        [*x] = interval.project([*x]);
                        moves.clipped += 1;
                    }
                }
                Side::Lower if r < 0.0 => {
                    [*x] = interval.project([*x - length * r]);
                    *state = Side::Free;
                    moves.entered += 1;
                }
                Side::Upper if r > 0.0 => {
                    [*x] = interval.project([*x - length * r]);
                    *state = Side::Free;
                    moves.entered += 1;
                }
                _ => {}
            }
        }
        moves
    };
    let [x] = &mut run.x;
    let data = (blocks(x), blocks(state));
    run.is_fresh = false;
    parallel::sweep(0..len.div_ceil(CHUNK), data, &work, &|a, b| Moves {
        clipped: a.clipped + b.clipped,
        entered: a.entered + b.entered,
    })
}

/// The product after a step that clipped nothing, without a new one.
fn follow<C: Operator, K: Constraint<1, Set = Interval>, P: Operator>(
    run: &mut Run<'_, '_, C, K, P, 1>,
    length: f64,
) {
    let Workspace {
        product: [product],
        gradient: [gradient],
        image: [image],
        ..
    } = &mut *run.workspace;
    let (len, image) = (product.len(), &*image);
    let work = |task: usize, (product, gradient): (Blocks<'_, f64>, Blocks<'_, f64>)| {
        let images = &image[task * CHUNK..];
        for ((u, g), z) in product.items.iter_mut().zip(gradient.items).zip(images) {
            *u -= length * z;
            *g -= length * z;
        }
    };
    let data = (blocks(product), blocks(gradient));
    parallel::sweep(0..len.div_ceil(CHUNK), data, &work, &|(), ()| ());
}

/// Moves the free entries to the total (eqs 25, 26) without leaving the bounds; all entries if
/// the free ones cannot reach it.
fn restore_total<C: Operator, K: Constraint<1, Set = Interval>, P: Operator>(
    run: &mut Run<'_, '_, C, K, P, 1>,
) {
    let [Some(total)] = run.sums() else {
        return;
    };
    let state = &run.workspace.motions;
    let constraint = &run.problem.constraint;
    let [x] = &mut run.x;
    if !shift_to_total(x, constraint, |i| state[i] == Side::Free, total) {
        shift_to_total(x, constraint, |_| true, total);
        run.mark_start();
    }
}
