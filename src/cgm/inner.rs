//! Preconditioned conjugate gradients on the cells that move, unclipped: the inner solution of Newton's method.
//! Between two products each vector is read once.

use std::ops::ControlFlow;

use crate::cgm::motion::Motion;
use crate::cgm::run::Run;
use crate::cgm::totals::TotalsSystem;
use crate::cgm::vector::{
    at, chunks, dot, held, minus, norm, plus, put, slices, slices_mut, within,
};
use crate::cgm::{Constraint, MotionOf, Workspace};
use crate::operator::Operator;
use crate::report::Status;

/// Steps before the sets are looked at again.
const INNER_LIMIT: usize = 60;

/// From the residual `delta - (C x + b)`, with approximate products: what they miss the next outer step sees.
///
/// The multipliers of sums are eliminated: each preconditioned residual carries the change that keeps the sums, at
/// once. Those of springs are unknowns that move along the direction, as far as it goes.
pub(super) fn solve<C: Operator<N>, K: Constraint<N>, P: Operator<N>, const N: usize>(
    run: &mut Run<'_, '_, C, K, P, N>,
    totals: &TotalsSystem<N>,
    reduction: f64,
) -> ControlFlow<Status> {
    let first = advance(run, totals, None);
    let (mut products, mut last_products) = (first.products, [0.0; N]);
    let (mut previous, mut turning) = (0.0, [0.0; N]);
    for step in 0..INNER_LIMIT {
        precondition(run);
        let Correction {
            change,
            product,
            overlap,
        } = correct(run, totals, products, last_products);
        let at_once = only(totals.has_sum(), change);
        add_to_multiplier(run, at_once);
        if product.is_nan() || product <= 0.0 {
            break;
        }
        // Polak-Ribiere forgives the noise of single precision.
        let conjugation = (step > 0).then(|| ((product - overlap) / previous).max(0.0));
        previous = product;
        let along = turn(run, change, at_once, conjugation);
        turning = plus(
            only(totals.has_spring(), change),
            conjugation.unwrap_or(0.0),
            turning,
        );

        run.proceed()?;
        run.apply_f32_to_direction();
        run.count_step();
        let (curvature, square) = curvature(run);
        let curvature = curvature + totals.curvature(turning);
        let (length, is_last) = match run.slide(curvature, square) {
            Some(flattest) => (along / flattest, true),
            None => (along / curvature, step + 1 == INNER_LIMIT),
        };
        if !(length.is_finite() && (is_last || curvature > 0.0)) {
            break;
        }
        let moved = turning.map(|change| length * change);
        add_to_multiplier(run, moved);
        let change = plus(at_once, 1.0, moved);
        let residual = advance(run, totals, Some(&Move { length, change }));
        (last_products, products) = (products, residual.products);
        if is_last || residual.square <= reduction * reduction * first.square {
            add_to_multiplier(run, residual.change);
            break;
        }
    }
    ControlFlow::Continue(())
}

/// The components of a kind, zero elsewhere.
fn only<const N: usize>(kind: [bool; N], values: [f64; N]) -> [f64; N] {
    std::array::from_fn(|c| if kind[c] { values[c] } else { 0.0 })
}

fn add_to_multiplier<C: Operator<N>, K: Constraint<N>, P: Operator<N>, const N: usize>(
    run: &mut Run<'_, '_, C, K, P, N>,
    change: [f64; N],
) {
    run.workspace.multiplier = plus(run.workspace.multiplier, 1.0, change);
}

/// A step along the direction, at multipliers changed since the last residual.
struct Move<const N: usize> {
    length: f64,
    change: [f64; N],
}

/// What is left to solve, measured without the preconditioner.
struct Residual<const N: usize> {
    /// The change of the multipliers of the sums that leaves no weighted mean: `w_a' (r + change) = 0`.
    change: [f64; N],
    /// `|r + change|^2`.
    square: f64,
    /// `w_a' r`.
    products: [f64; N],
}

/// Takes the step, if one is given, and the residual there: compressed, and weighted in `direction` to be
/// preconditioned. The stiffness of curved bounds is part of the residual, not of the gradient.
fn advance<C: Operator<N>, K: Constraint<N>, P: Operator<N>, const N: usize>(
    run: &mut Run<'_, '_, C, K, P, N>,
    totals: &TotalsSystem<N>,
    step: Option<&Move<N>>,
) -> Residual<N> {
    let Workspace {
        inner,
        motions,
        moving,
        gradient,
        direction,
        image,
        spread,
        multiplier,
        ..
    } = &mut *run.workspace;
    std::mem::swap(&mut inner.residual, &mut inner.last_residual);
    run.is_fresh &= step.is_none();
    let (image, multiplier) = (slices(image), *multiplier);
    let (directions, last, spread) = (&*inner.direction, &*inner.last_residual, &*spread);
    let data = (
        (chunks(&mut run.x), chunks(gradient)),
        (chunks(direction), moving.compressed(&mut inner.residual)),
    );
    let (sum, square, products) = moving.sweep(
        data,
        |entries, ((mut x, mut gradient), (mut full, residual))| {
            let images = within(&image, &entries.chunk);
            let directions = &directions[entries.range.clone()];
            if let Some(&Move { length, .. }) = step {
                for (gradient, images) in gradient.iter_mut().zip(images) {
                    for (g, u) in gradient.items.iter_mut().zip(images) {
                        *g += length * u;
                    }
                }
                for (place, d) in entries.places().zip(directions) {
                    let moved = plus(held(&x, place), length, *d);
                    put(&mut x, place, moved);
                }
            }
            let motions = &motions[entries.chunk.clone()];
            let (spread, last) = (&spread[entries.range.clone()], &last[entries.range.clone()]);
            entries.sums(|k, place| {
                let motion = motion_at::<K, N>(motions, place);
                let r = match step {
                    // The residual of a curved bound is not the gradient's: it is followed from step to step.
                    Some(&Move { length, change }) if MotionOf::<K, N>::IS_CURVED => {
                        let moved = motion.project(plus(change, -length, at(&images, place)));
                        let bend = length * motion.stiffness();
                        std::array::from_fn(|c| last[k][c] + moved[c] - bend * directions[k][c])
                    }
                    _ => motion.project(minus(multiplier, held(&gradient, place))),
                };
                residual.items[k] = r;
                put(&mut full, place, motion.weighted(r));
                (r, dot(r, r), spread[k].map(|w| dot(w, r)))
            })
        },
    );
    let change = totals.without_mean(products);
    Residual {
        change,
        products,
        square: square + 2.0 * dot(change, sum) + totals.square(change),
    }
}

/// How a cell that moves may move.
#[inline]
fn motion_at<K: Constraint<N>, const N: usize>(
    motions: &[MotionOf<K, N>],
    place: usize,
) -> MotionOf<K, N> {
    if MotionOf::<K, N>::IS_CURVED {
        motions[place]
    } else {
        Motion::FREE
    }
}

/// The preconditioned residual `z = M r + change w`, of which `M r` is kept.
struct Correction<const N: usize> {
    /// The change of the multipliers that keeps the totals.
    change: [f64; N],
    /// `z' (r + change)`.
    product: f64,
    /// `z' r_last`.
    overlap: f64,
}

/// Gathers `M r` from `image`, with the `w_a' r` and `w_a' r_last`.
fn correct<C: Operator<N>, K: Constraint<N>, P: Operator<N>, const N: usize>(
    run: &mut Run<'_, '_, C, K, P, N>,
    totals: &TotalsSystem<N>,
    products: [f64; N],
    last_products: [f64; N],
) -> Correction<N> {
    let Workspace {
        inner,
        motions,
        moving,
        image,
        ..
    } = &mut *run.workspace;
    let image = slices(image);
    let (residual, last) = (&*inner.residual, &*inner.last_residual);
    let data = moving.compressed(&mut inner.correction);
    let (sum, product, overlap): ([f64; N], f64, f64) =
        moving.sweep(data, |entries, correction| {
            let image = within(&image, &entries.chunk);
            let motions = &motions[entries.chunk.clone()];
            let (residual, last) = (
                &residual[entries.range.clone()],
                &last[entries.range.clone()],
            );
            entries.sums(|k, place| {
                let motion = motion_at::<K, N>(motions, place);
                let z = motion.preconditioned(at(&image, place), residual[k]);
                correction.items[k] = z;
                (z, dot(z, residual[k]), dot(z, last[k]))
            })
        });
    let change = totals.balance(sum);
    Correction {
        change,
        // Without a sum, z makes nothing of the change of a sum's multiplier.
        product: product + dot(change, products),
        overlap: overlap + dot(change, last_products),
    }
}

/// The next direction `d = z + conjugation d`, compressed and full; returns `d' (r + at_once)`.
fn turn<C: Operator<N>, K: Constraint<N>, P: Operator<N>, const N: usize>(
    run: &mut Run<'_, '_, C, K, P, N>,
    change: [f64; N],
    at_once: [f64; N],
    conjugation: Option<f64>,
) -> f64 {
    let Workspace {
        inner,
        moving,
        direction,
        spread,
        ..
    } = &mut *run.workspace;
    let (residual, correction, spread) = (&*inner.residual, &*inner.correction, &*spread);
    let has_change = norm(change) != 0.0;
    let data = (chunks(direction), moving.compressed(&mut inner.direction));
    moving.sweep(data, |entries, (mut full, compressed)| {
        let residual = &residual[entries.range.clone()];
        let correction = &correction[entries.range.clone()];
        let spread = &spread[entries.range.clone()];
        entries.sums(|k, place| {
            let mut d = correction[k];
            if has_change {
                for (change, w) in change.iter().zip(spread[k]) {
                    d = plus(d, *change, w);
                }
            }
            if let Some(conjugation) = conjugation {
                d = plus(d, conjugation, compressed.items[k]);
            }
            compressed.items[k] = d;
            put(&mut full, place, d);
            dot(d, plus(residual[k], 1.0, at_once))
        })
    })
}

/// `d' (C + K) d`, of the product in `image` and the stiffness `K` of curved bounds, and `d' d`.
fn curvature<C: Operator<N>, K: Constraint<N>, P: Operator<N>, const N: usize>(
    run: &Run<'_, '_, C, K, P, N>,
) -> (f64, f64) {
    let Workspace {
        inner,
        motions,
        moving,
        image,
        ..
    } = &*run.workspace;
    let image = slices(image);
    moving.sweep((), |entries, ()| {
        let motions = &motions[entries.chunk.clone()];
        let directions = &inner.direction[entries.range.clone()];
        let image = within(&image, &entries.chunk);
        entries.sums(|k, place| {
            let d = directions[k];
            let square = dot(d, d);
            let stiffness = motion_at::<K, N>(motions, place).stiffness();
            (dot(d, at(&image, place)) + stiffness * square, square)
        })
    })
}

/// `image = M direction`.
pub(super) fn precondition<C: Operator<N>, K: Constraint<N>, P: Operator<N>, const N: usize>(
    run: &mut Run<'_, '_, C, K, P, N>,
) {
    let Workspace {
        preconditioner,
        direction,
        image,
        ..
    } = &mut *run.workspace;
    run.problem
        .preconditioner
        .apply_f32(slices(direction), slices_mut(image), preconditioner);
}
