//! Preconditioned conjugate gradients on what the cells can do: sticking ones move freely, slipping ones along
//! their circles. Between two products each vector is read once, as for one unknown a cell.

use std::ops::ControlFlow;

use crate::cgm::plane::border::Border;
use crate::cgm::plane::disc::{both, both_mut, dot, halves, pair};
use crate::cgm::plane::run::Run;
use crate::cgm::plane::{Inner, Workspace};
use crate::cgm::run::{FLAT, FLATTEST};
use crate::operator::Operator;
use crate::report::Status;

/// Steps before the sets are looked at again.
const INNER_LIMIT: usize = 60;

/// From the residual `delta - (C q + b)`, with approximate products: what they miss the next outer step sees.
pub(super) fn solve<C: Operator<2>, P: Operator<2>>(
    run: &mut Run<'_, '_, C, P>,
    border: &Border,
    reduction: f64,
) -> ControlFlow<Status> {
    let first = advance(run, border, None);
    let (mut products, mut last_products) = (first.products, [0.0; 2]);
    let mut previous = 0.0;
    for step in 0..INNER_LIMIT {
        precondition(run);
        let Correction {
            change,
            product,
            overlap,
        } = correct(run, border, products, last_products);
        add_to_multiplier(run, change);
        if product.is_nan() || product <= 0.0 {
            break;
        }
        // Polak-Ribiere forgives the noise of single precision.
        let conjugation = (step > 0).then(|| ((product - overlap) / previous).max(0.0));
        previous = product;
        turn(run, change, conjugation);

        run.proceed()?;
        run.apply_to_direction(true);
        run.count_step();
        let [curvature, square] = curvature(run);
        if let Some(flattest) = slide(run, curvature, square) {
            let length = product / flattest;
            advance(run, border, Some(&Move { length, change }));
            break;
        }
        if !(curvature > 0.0 && product.is_finite()) {
            break;
        }
        let length = product / curvature;
        let residual = advance(run, border, Some(&Move { length, change }));
        (last_products, products) = (products, residual.products);
        let is_small = residual.square <= reduction * reduction * first.square;
        if is_small || step + 1 == INNER_LIMIT {
            add_to_multiplier(run, residual.change);
            break;
        }
    }
    ControlFlow::Continue(())
}

fn add_to_multiplier<C: Operator<2>, P: Operator<2>>(
    run: &mut Run<'_, '_, C, P>,
    change: [f64; 2],
) {
    for (multiplier, change) in run.workspace.multiplier.iter_mut().zip(change) {
        *multiplier += change;
    }
}

/// A step along the direction, at multipliers changed since the last residual.
struct Move {
    length: f64,
    change: [f64; 2],
}

/// What is left to solve, measured without the preconditioner.
struct Residual {
    /// The change of the multipliers that leaves no weighted mean: `w_a' (r + change) = 0`.
    change: [f64; 2],
    /// `|r + change|^2`.
    square: f64,
    /// `w_a' r`.
    products: [f64; 2],
}

/// Takes the step, if one is given, and the residual there: compressed, and weighted in `direction` to be
/// preconditioned. The circles' own stiffness is part of the residual, not of the gradient.
fn advance<C: Operator<2>, P: Operator<2>>(
    run: &mut Run<'_, '_, C, P>,
    border: &Border,
    step: Option<&Move>,
) -> Residual {
    let Workspace {
        inner,
        loaded,
        gradient,
        direction,
        image,
        multiplier,
        ..
    } = &mut *run.workspace;
    let Inner {
        cells,
        residual,
        last_residual,
        direction: directions,
        spread,
        ..
    } = inner;
    std::mem::swap(residual, last_residual);
    run.is_fresh &= step.is_none();
    let (last, multiplier) = (&*last_residual, *multiplier);
    let data = (
        (halves(run.q), halves(gradient)),
        (halves(direction), loaded.compressed(residual)),
    );
    let sums = loaded.sweep(data, |entries, ((q, gradient), (full, residual))| {
        let (cells, last) = (&cells[entries.range.clone()], &last[entries.range.clone()]);
        let directions = &directions[entries.range.clone()];
        let spread = &spread[entries.range.clone()];
        let image = pair(image, &entries.chunk);
        entries.sums(|k, place| {
            let cell = cells[k];
            let r = if let Some(&Move { length, change }) = step {
                let (u, d) = (image(place), directions[k]);
                gradient.0.items[place] += length * u[0];
                gradient.1.items[place] += length * u[1];
                q.0.items[place] += length * d[0];
                q.1.items[place] += length * d[1];
                let v = cell.project([change[0] - length * u[0], change[1] - length * u[1]]);
                let bend = length * cell.stiffness();
                [
                    last[k][0] + v[0] - bend * d[0],
                    last[k][1] + v[1] - bend * d[1],
                ]
            } else {
                cell.project([
                    multiplier[0] - gradient.0.items[place],
                    multiplier[1] - gradient.1.items[place],
                ])
            };
            residual.items[k] = r;
            [full.0.items[place], full.1.items[place]] = cell.weighted(r);
            let [wx, wy] = spread[k];
            [r[0], r[1], dot(r, r), dot(wx, r), dot(wy, r)]
        })
    });
    let [x, y, square, along_x, along_y] = sums;
    let products = [along_x, along_y];
    let change = border.solve(products.map(|product| -product));
    Residual {
        change,
        products,
        square: square + 2.0 * dot(change, [x, y]) + border.square(change),
    }
}

/// The preconditioned residual `z = M r + change w`, of which `M r` is kept.
struct Correction {
    /// The change of the multipliers that keeps the totals: `e_a' z = 0`.
    change: [f64; 2],
    /// `z' (r + change)`.
    product: f64,
    /// `z' r_last`.
    overlap: f64,
}

/// Gathers `M r` from `image`, with the `w_a' r` and `w_a' r_last`.
fn correct<C: Operator<2>, P: Operator<2>>(
    run: &mut Run<'_, '_, C, P>,
    border: &Border,
    products: [f64; 2],
    last_products: [f64; 2],
) -> Correction {
    let Workspace {
        inner,
        loaded,
        image,
        ..
    } = &mut *run.workspace;
    let Inner {
        cells,
        residual,
        last_residual,
        correction,
        ..
    } = inner;
    let image = &*image;
    let sums = loaded.sweep(loaded.compressed(correction), |entries, correction| {
        let cells = &cells[entries.range.clone()];
        let residual = &residual[entries.range.clone()];
        let last_residual = &last_residual[entries.range.clone()];
        let image = pair(image, &entries.chunk);
        entries.sums(|k, place| {
            let r = residual[k];
            let z = cells[k].preconditioned(image(place), r);
            correction.items[k] = z;
            [z[0], z[1], dot(z, r), dot(z, last_residual[k])]
        })
    });
    let [x, y, product, overlap] = sums;
    let change = border.solve([-x, -y]);
    Correction {
        change,
        // e_a' z = 0, so the change of the residual adds nothing.
        product: product + dot(change, products),
        overlap: overlap + dot(change, last_products),
    }
}

/// The next direction `d = z + conjugation d`, compressed and full.
fn turn<C: Operator<2>, P: Operator<2>>(
    run: &mut Run<'_, '_, C, P>,
    change: [f64; 2],
    conjugation: Option<f64>,
) {
    let Workspace {
        inner,
        loaded,
        direction,
        ..
    } = &mut *run.workspace;
    let Inner {
        correction,
        direction: compressed,
        spread,
        ..
    } = inner;
    let data = (halves(direction), loaded.compressed(compressed));
    loaded.sweep(data, |entries, ((x, y), compressed)| {
        let correction = &correction[entries.range.clone()];
        let spread = &spread[entries.range.clone()];
        for (k, place) in entries.places().enumerate() {
            let (z, [wx, wy]) = (correction[k], spread[k]);
            let mut d = [0, 1].map(|b| z[b] + change[0] * wx[b] + change[1] * wy[b]);
            if let Some(conjugation) = conjugation {
                let before = compressed.items[k];
                d = [0, 1].map(|b| d[b] + conjugation * before[b]);
            }
            compressed.items[k] = d;
            [x.items[place], y.items[place]] = d;
        }
        []
    });
}

/// `d' (C + circles) d`, of the product in `image`, and `d' d`.
fn curvature<C: Operator<2>, P: Operator<2>>(run: &Run<'_, '_, C, P>) -> [f64; 2] {
    let Workspace {
        inner,
        loaded,
        image,
        ..
    } = &*run.workspace;
    loaded.sweep((), |entries, ()| {
        let cells = &inner.cells[entries.range.clone()];
        let directions = &inner.direction[entries.range.clone()];
        let image = pair(image, &entries.chunk);
        entries.sums(|k, place| {
            let d = directions[k];
            let square = dot(d, d);
            [dot(d, image(place)) + cells[k].stiffness() * square, square]
        })
    })
}

/// The curvature to go on with where the direction's own is none: an operator that maps constants to zero lets
/// all cells together slide to their limits.
fn slide<C: Operator<2>, P: Operator<2>>(
    run: &Run<'_, '_, C, P>,
    curvature: f64,
    square: f64,
) -> Option<f64> {
    let stiffness = run.lower_bound * square;
    let is_flat = run.problem.totals.contains(&None) && curvature < FLAT * stiffness;
    let Workspace { inner, loaded, .. } = &*run.workspace;
    let slides = || loaded.len() == run.cells() && inner.cells.iter().all(|cell| cell.is_stick());
    (is_flat && slides()).then_some(FLATTEST * stiffness)
}

/// `image = M direction`.
pub(super) fn precondition<C: Operator<2>, P: Operator<2>>(run: &mut Run<'_, '_, C, P>) {
    let Workspace {
        preconditioner,
        direction,
        image,
        ..
    } = &mut *run.workspace;
    run.problem
        .preconditioner
        .apply_f32(both(direction), both_mut(image), preconditioner);
}
