//! Preconditioned conjugate gradients on the free entries, unclipped: the inner solution of the
//! active-set method. Between two products each vector is read once.

use std::ops::ControlFlow;

use crate::cgm::run::Run;
use crate::cgm::{Constraint, Inner, Workspace};
use crate::operator::Operator;
use crate::parallel::blocks;
use crate::report::Status;

/// Steps before the sets are looked at again.
const INNER_LIMIT: usize = 60;

/// Conjugate gradients on the free entries, from `r = delta - (C x + b)`, with approximate
/// products: what they miss the next outer step sees.
pub(super) fn solve_free<C: Operator, K: Constraint, P: Operator>(
    run: &mut Run<'_, '_, C, K, P>,
    reduction: f64,
) -> ControlFlow<Status> {
    let free = run.workspace.free_set.len();
    let first = advance(run, None);
    let mut previous = 0.0;
    for step in 0..INNER_LIMIT {
        precondition(run);
        let Correction {
            change,
            product,
            overlap,
        } = correct(run);
        run.workspace.multiplier += change;
        if product <= 0.0 {
            break;
        }
        // Polak-Ribiere forgives the noise of single precision.
        let conjugation = (step > 0).then(|| ((product - overlap) / previous).max(0.0));
        previous = product;
        let along = turn(run, change, conjugation);

        run.proceed()?;
        run.apply_roughly_to_direction();
        run.count_step();
        let [curvature, square] = curvature(run);
        if let Some(flattest) = run.slide(free, curvature, square) {
            advance(run, Some(along / flattest));
            break;
        }
        if !(curvature > 0.0 && along.is_finite()) {
            break;
        }
        let residual = advance(run, Some(along / curvature));
        let is_small = residual.square <= reduction * reduction * first.square;
        if is_small || step + 1 == INNER_LIMIT {
            run.workspace.multiplier += residual.change;
            break;
        }
    }
    ControlFlow::Continue(())
}

/// What is left to solve, measured without the preconditioner.
struct Residual {
    /// The change of the multiplier that leaves no weighted mean: `w' (r + change) = 0`.
    change: f64,
    /// `|r + change|^2`.
    square: f64,
}

/// Moves by a length along the direction, if one is given, and takes the residual there: compressed,
/// and in `direction` to be preconditioned.
fn advance<C: Operator, K: Constraint, P: Operator>(
    run: &mut Run<'_, '_, C, K, P>,
    length: Option<f64>,
) -> Residual {
    let has_total = run.problem.total.is_some();
    let Workspace {
        inner,
        gradient,
        direction,
        image,
        free_set,
        multiplier,
        ..
    } = &mut *run.workspace;
    std::mem::swap(&mut inner.residual, &mut inner.last_residual);
    let (image, directions, multiplier) = (&*image, &inner.direction, *multiplier);
    let residual = free_set.compressed(&mut inner.residual);
    let data = (
        (blocks(run.x), blocks(gradient)),
        (blocks(direction), residual),
    );
    let spread = &inner.spread;
    let sums = free_set.sweep(data, |entries, ((x, gradient), (full, residual))| {
        if let Some(length) = length {
            let images = &image[entries.chunk.clone()];
            for (g, u) in gradient.items.iter_mut().zip(images) {
                *g += length * u;
            }
            let directions = &directions[entries.range.clone()];
            for (place, d) in entries.places().zip(directions) {
                x.items[place] += length * d;
            }
        }
        let spread = &spread[entries.range.clone()];
        entries.sums(|k, place| {
            let r = multiplier - gradient.items[place];
            residual.items[k] = r;
            full.items[place] = r;
            [r, r * r, spread[k] * r]
        })
    });
    run.is_fresh &= length.is_none();
    let [sum, square, weighted] = sums;
    let change = if has_total {
        -weighted / inner.weight
    } else {
        0.0
    };
    let free = free_set.len() as f64;
    Residual {
        change,
        square: square + change * (2.0 * sum + change * free),
    }
}

/// The preconditioned residual `z = M r + change w`, of which `M r` is kept.
struct Correction {
    /// The change of the multiplier that keeps the total: `e' z = 0`.
    change: f64,
    /// `z' (r + change)`.
    product: f64,
    /// `z' r_last`.
    overlap: f64,
}

/// Gathers `M r` from `image`, and what it comes to with every product formed on the way.
fn correct<C: Operator, K: Constraint, P: Operator>(run: &mut Run<'_, '_, C, K, P>) -> Correction {
    let has_total = run.problem.total.is_some();
    let Workspace {
        inner,
        image,
        free_set,
        ..
    } = &mut *run.workspace;
    let Inner {
        residual,
        last_residual,
        correction,
        spread,
        weight,
        ..
    } = inner;
    let image = &*image;
    let sums = free_set.sweep(free_set.compressed(correction), |entries, correction| {
        let image = &image[entries.chunk.clone()];
        let residual = &residual[entries.range.clone()];
        let last_residual = &last_residual[entries.range.clone()];
        let spread = &spread[entries.range.clone()];
        entries.sums(|k, place| {
            let z = image[place];
            correction.items[k] = z;
            let (r, last, w) = (residual[k], last_residual[k], spread[k]);
            [z, z * r, z * last, w * r, w * last]
        })
    });
    let [sum, product, overlap, spread_product, spread_overlap] = sums;
    if has_total {
        let change = -sum / *weight;
        Correction {
            change,
            // e' z = 0, so the change of the residual adds nothing.
            product: product + change * spread_product,
            overlap: overlap + change * spread_overlap,
        }
    } else {
        Correction {
            change: 0.0,
            product,
            overlap,
        }
    }
}

/// The next direction `d = z + conjugation d`, compressed and full; returns `d' (r + change)`.
fn turn<C: Operator, K: Constraint, P: Operator>(
    run: &mut Run<'_, '_, C, K, P>,
    change: f64,
    conjugation: Option<f64>,
) -> f64 {
    let has_total = run.problem.total.is_some();
    let Workspace {
        inner,
        direction,
        free_set,
        ..
    } = &mut *run.workspace;
    let Inner {
        residual,
        correction,
        direction: compressed,
        spread,
        ..
    } = inner;
    let data = (blocks(direction), free_set.compressed(compressed));
    let [along] = free_set.sweep(data, |entries, (full, compressed)| {
        let residual = &residual[entries.range.clone()];
        let correction = &correction[entries.range.clone()];
        let spread = &spread[entries.range.clone()];
        entries.sums(|k, place| {
            let mut d = correction[k];
            if has_total {
                d += change * spread[k];
            }
            if let Some(conjugation) = conjugation {
                d += conjugation * compressed.items[k];
            }
            compressed.items[k] = d;
            full.items[place] = d;
            [d * (residual[k] + change)]
        })
    });
    along
}

/// `d' C d`, of the product in `image`, and `d' d`.
fn curvature<C: Operator, K: Constraint, P: Operator>(run: &Run<'_, '_, C, K, P>) -> [f64; 2] {
    let Workspace {
        inner,
        image,
        free_set,
        ..
    } = &*run.workspace;
    free_set.sweep((), |entries, ()| {
        let (directions, image) = (
            &inner.direction[entries.range.clone()],
            &image[entries.chunk.clone()],
        );
        entries.sums(|k, place| {
            let d = directions[k];
            [d * image[place], d * d]
        })
    })
}

/// `image = M direction`.
pub(super) fn precondition<C: Operator, K: Constraint, P: Operator>(
    run: &mut Run<'_, '_, C, K, P>,
) {
    let Workspace {
        preconditioner,
        direction,
        image,
        ..
    } = &mut *run.workspace;
    run.problem
        .preconditioner
        .apply_f32([direction], [image], preconditioner);
}
