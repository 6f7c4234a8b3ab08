//! Preconditioned conjugate gradients on the moving cells, without clipping: the inner solver of the semismooth Newton method.

#![expect(
    clippy::inline_always,
    reason = "a call per group of cells takes as many instructions as the group"
)]

use std::array::from_fn;
use std::ops::ControlFlow;

use crate::cgm::active_set_solve::{ActiveSetSolve, Precision};
use crate::cgm::free_cells::{ChunkCells, GroupWork};
use crate::cgm::law::state::Row;
use crate::cgm::totals::TotalsSystem;
use crate::cgm::{Constraint, MotionOf};
use crate::numerics::cell_vector::{
    Places, at_places, chunks, dot, minus, norm, plus, put_at_places, put_run, run, slices, within,
};
use crate::report::Status;

/// Maximum number of steps before the sets are updated again.
const INNER_LIMIT: usize = 60;

/// Returns the values of the components selected by `kind`, and zero for the other components.
fn only<const N: usize>(kind: [bool; N], values: [f64; N]) -> [f64; N] {
    from_fn(|c| if kind[c] { values[c] } else { 0.0 })
}

/// A step along the direction, and the change of the multipliers after the last residual.
struct DirectionStep<const N: usize> {
    length: f64,
    change: [f64; N],
}

/// Residual, measured without the preconditioner.
struct Residual<const N: usize> {
    /// Change of the multipliers of the prescribed sums that removes the weighted mean: `w_a' (r + change) = 0`.
    change: [f64; N],
    /// `|r + change|^2`.
    square: f64,
    /// `w_a' r`.
    products: [f64; N],
}

/// Preconditioned residual `z = M r + change w`, where `M r` follows from the image.
struct Correction<const N: usize> {
    /// Change of the multipliers that keeps the totals.
    change: [f64; N],
    /// `z' (r + change)`.
    product: f64,
    /// `z' r_last`.
    overlap: f64,
}

impl<K: Constraint<N>, const N: usize> ActiveSetSolve<'_, '_, K, N> {
    /// Runs conjugate gradients from the residual `delta - (C x + b)` with single-precision products. The next outer step
    /// measures the error of these products.
    ///
    /// The multipliers of prescribed sums are eliminated: each preconditioned residual immediately includes the change that keeps
    /// the sums. The multipliers of springs are unknowns that move along the direction with its step length.
    pub(in crate::cgm) fn conjugate_gradients(&mut self, reduction: f64) -> ControlFlow<Status> {
        let totals = self.totals;
        let first = self.step_and_residual(&totals, None);
        let (mut products, mut last_products) = (first.products, [0.0; N]);
        let (mut previous, mut turning) = (0.0, [0.0; N]);
        for step in 0..INNER_LIMIT {
            self.linear().precondition();
            let Correction {
                change,
                product,
                overlap,
            } = self.correct(&totals, products, last_products);
            let at_once = only(totals.has_sum(), change);
            self.add_to_multiplier(at_once);
            if product.is_nan() || product <= 0.0 {
                break;
            }
            // The Polak-Ribiere formula tolerates the noise of single precision.
            let conjugation = (step > 0).then(|| ((product - overlap) / previous).max(0.0));
            previous = product;
            let along = self.turn(change, at_once, conjugation);
            let with_springs = only(totals.has_spring(), change);
            turning = plus(with_springs, conjugation.unwrap_or(0.0), turning);

            self.monitor.proceed()?;
            self.linear().apply(Precision::Single);
            self.monitor.count_step();
            let (curvature, square) = self.curvature();
            let curvature = curvature + totals.curvature(turning);
            let (length, is_last) = match self.slide(curvature, square) {
                Some(flattest) => (along / flattest, true),
                None => (along / curvature, step + 1 == INNER_LIMIT),
            };
            if !(length.is_finite() && (is_last || curvature > 0.0)) {
                break;
            }
            let moved = turning.map(|change| length * change);
            self.add_to_multiplier(moved);
            let change = plus(at_once, 1.0, moved);
            let residual = self.step_and_residual(&totals, Some(&DirectionStep { length, change }));
            (last_products, products) = (products, residual.products);
            if is_last || residual.square <= reduction * reduction * first.square {
                self.add_to_multiplier(residual.change);
                break;
            }
        }
        ControlFlow::Continue(())
    }

    fn add_to_multiplier(&mut self, change: [f64; N]) {
        self.workspace.multiplier = plus(self.workspace.multiplier, 1.0, change);
    }

    /// Takes the given step, if any, and computes the compressed residual. Also writes the weighted residual to `direction` as
    /// input of the preconditioner. The residual includes the stiffness of curved bounds, whereas the gradient does not.
    fn step_and_residual(
        &mut self,
        totals: &TotalsSystem<N>,
        step: Option<&DirectionStep<N>>,
    ) -> Residual<N> {
        if step.is_some() {
            self.product_error = f64::INFINITY;
        }
        let w = &mut *self.workspace;
        std::mem::swap(&mut w.linear.residual, &mut w.conjugate.last_residual);
        let (image, multiplier) = (slices(&w.linear.image), w.multiplier);
        let (directions, last, spread) = (
            &w.conjugate.direction,
            &w.conjugate.last_residual,
            &w.linear.spread,
        );
        let motions = &w.linear.rows;
        let data = (
            (
                chunks(self.problem.layout, &mut self.x),
                chunks(self.problem.layout, &mut w.gradient),
            ),
            (
                chunks(self.problem.layout, &mut w.linear.direction),
                w.linear.moving.compressed(&mut w.linear.residual),
            ),
        );
        let (sum, square, products) = w.linear.moving.sweep(
            data,
            |entries, ((mut x, mut gradient), (mut full, residual))| {
                let images = within(&image, &entries.chunk);
                if let (Some(step), false) = (step, MotionOf::<K, N>::IS_STEADY) {
                    // The gradient of the other cells determines which cells will move.
                    for (gradient, images) in gradient.iter_mut().zip(images) {
                        for (g, u) in gradient.items.iter_mut().zip(images) {
                            *g += step.length * u;
                        }
                    }
                }
                let range = entries.range.clone();
                entries.sums_of_groups(&mut StepWork {
                    entries: &entries,
                    motions,
                    step,
                    multiplier,
                    images,
                    directions: &directions[range.clone()],
                    spread: &spread[range.clone()],
                    last: &last[range],
                    x: x.each_mut().map(|part| &mut *part.items),
                    gradient: gradient.each_mut().map(|part| &mut *part.items),
                    full: full.each_mut().map(|part| &mut *part.items),
                    residual: residual.items,
                })
            },
        );
        let change = totals.remove_mean(products);
        Residual {
            change,
            products,
            square: square + 2.0 * dot(change, sum) + totals.square(change),
        }
    }

    /// Measures `M r`, which follows from `image` and the residual, given `w_a' r` and `w_a' r_last`.
    fn correct(
        &mut self,
        totals: &TotalsSystem<N>,
        products: [f64; N],
        last_products: [f64; N],
    ) -> Correction<N> {
        let w = &*self.workspace;
        let image = slices(&w.linear.image);
        let (residual, last) = (&w.linear.residual, &w.conjugate.last_residual);
        let motions = &w.linear.rows;
        let (sum, product, overlap): ([f64; N], f64, f64) =
            w.linear.moving.sweep((), |entries, ()| {
                let image = within(&image, &entries.chunk);
                entries.sums_of_groups(&mut CorrectionWork {
                    entries: &entries,
                    motions,
                    image,
                    residual: &residual[entries.range.clone()],
                    last: &last[entries.range.clone()],
                })
            });
        let change = totals.balance(sum);
        Correction {
            change,
            // For a prescribed sum, z has zero sum, so the product of z and the change of the multiplier vanishes.
            product: product + dot(change, products),
            overlap: overlap + dot(change, last_products),
        }
    }

    /// Computes the next direction `d = z + conjugation d`, as a compressed and as a full vector. Returns `d' (r + at_once)`.
    /// `image` must not have changed after [`Self::correct`]. The function recomputes `M r` from `image`, which costs less than
    /// storing `M r`.
    fn turn(&mut self, change: [f64; N], at_once: [f64; N], conjugation: Option<f64>) -> f64 {
        let w = &mut *self.workspace;
        let (residual, spread) = (&w.linear.residual, &w.linear.spread);
        let (motions, image) = (&w.linear.rows, slices(&w.linear.image));
        let has_change = norm(change) != 0.0;
        let compressed = w.linear.moving.compressed(&mut w.conjugate.direction);
        let data = (
            chunks(self.problem.layout, &mut w.linear.direction),
            compressed,
        );
        w.linear
            .moving
            .sweep(data, |entries, (mut full, compressed)| {
                entries.sums_of_groups(&mut DirectionWork {
                    entries: &entries,
                    motions,
                    change: has_change.then_some(change),
                    at_once,
                    conjugation,
                    image: within(&image, &entries.chunk),
                    residual: &residual[entries.range.clone()],
                    spread: &spread[entries.range.clone()],
                    direction: compressed.items,
                    full: full.each_mut().map(|part| &mut *part.items),
                })
            })
    }

    /// Returns `d' (C + K) d` and `d' d`, where `K` is the stiffness of curved bounds. The product `C d` is read from `image`.
    fn curvature(&self) -> (f64, f64) {
        let w = &*self.workspace;
        let (motions, direction, image) = (
            &w.linear.rows,
            &w.conjugate.direction,
            slices(&w.linear.image),
        );
        w.linear.moving.sweep((), |entries, ()| {
            entries.sums_of_groups(&mut CurvatureWork {
                entries: &entries,
                motions,
                image: within(&image, &entries.chunk),
                direction: &direction[entries.range.clone()],
            })
        })
    }
}

/// Step along the direction, and the residual after the step.
struct StepWork<'a, R, const N: usize> {
    entries: &'a ChunkCells<'a>,
    motions: &'a [R],
    step: Option<&'a DirectionStep<N>>,
    multiplier: [f64; N],
    images: [&'a [f64]; N],
    directions: &'a [[f64; N]],
    spread: &'a [[[f64; N]; N]],
    last: &'a [[f64; N]],
    x: [&'a mut [f64]; N],
    gradient: [&'a mut [f64]; N],
    full: [&'a mut [f64]; N],
    residual: &'a mut [[f64; N]],
}

impl<R: Row<N>, const N: usize> GroupWork for StepWork<'_, R, N> {
    /// `r`, `r' r` and `w_a' r`.
    type Sum = ([f64; N], f64, [f64; N]);

    #[inline(always)]
    fn group<P: Places<W>, const W: usize>(&mut self, k: usize, places: P) -> [Self::Sum; W] {
        let motions: [R; W] = self.entries.rows(self.motions, k, places);
        let u: [[f64; N]; W] = at_places(&self.images, places);
        let directions: [[f64; N]; W] = run(self.directions, k);
        let mut g: [[f64; N]; W] = at_places(&self.gradient, places);
        if let Some(&DirectionStep { length, .. }) = self.step {
            let held: [[f64; N]; W] = at_places(&self.x, places);
            let moved: [_; W] = from_fn(|k| plus(held[k], length, directions[k]));
            put_at_places(&mut self.x, places, moved);
            if R::IS_STEADY {
                g = from_fn(|k| plus(g[k], length, u[k]));
                put_at_places(&mut self.gradient, places, g);
            }
        }
        let r: [[f64; N]; W] = match self.step {
            // With a curved bound the residual is not the negative gradient. Therefore each step updates the residual.
            Some(&DirectionStep { length, change }) if R::IS_CURVED => {
                let last: [[f64; N]; W] = run(self.last, k);
                from_fn(|k| {
                    let moved = motions[k].restrict(plus(change, -length, u[k]));
                    let bend = motions[k].bend(directions[k]);
                    from_fn(|c| last[k][c] + moved[c] - length * bend[c])
                })
            }
            _ => from_fn(|k| motions[k].restrict(minus(self.multiplier, g[k]))),
        };
        put_run(self.residual, k, r);
        let weighted: [_; W] = from_fn(|k| motions[k].weighted(r[k]));
        put_at_places(&mut self.full, places, weighted);
        let spread: [_; W] = run(self.spread, k);
        from_fn(|k| (r[k], dot(r[k], r[k]), spread[k].map(|w| dot(w, r[k]))))
    }
}

/// Sums of the preconditioned residual.
struct CorrectionWork<'a, R, const N: usize> {
    entries: &'a ChunkCells<'a>,
    motions: &'a [R],
    image: [&'a [f64]; N],
    residual: &'a [[f64; N]],
    last: &'a [[f64; N]],
}

impl<R: Row<N>, const N: usize> GroupWork for CorrectionWork<'_, R, N> {
    /// `z`, `z' r` and `z' r_last`.
    type Sum = ([f64; N], f64, f64);

    #[inline(always)]
    fn group<P: Places<W>, const W: usize>(&mut self, k: usize, places: P) -> [Self::Sum; W] {
        let motions: [R; W] = self.entries.rows(self.motions, k, places);
        let images: [[f64; N]; W] = at_places(&self.image, places);
        let [residual, last]: [[_; W]; 2] = [self.residual, self.last].map(|part| run(part, k));
        from_fn(|k| {
            let z = motions[k].preconditioned(images[k], residual[k]);
            (z, dot(z, residual[k]), dot(z, last[k]))
        })
    }
}

/// Next direction, as a compressed and as a full vector.
struct DirectionWork<'a, R, const N: usize> {
    entries: &'a ChunkCells<'a>,
    motions: &'a [R],
    change: Option<[f64; N]>,
    at_once: [f64; N],
    conjugation: Option<f64>,
    image: [&'a [f64]; N],
    residual: &'a [[f64; N]],
    spread: &'a [[[f64; N]; N]],
    direction: &'a mut [[f64; N]],
    full: [&'a mut [f64]; N],
}

impl<R: Row<N>, const N: usize> GroupWork for DirectionWork<'_, R, N> {
    /// `d' (r + at_once)`.
    type Sum = f64;

    #[inline(always)]
    fn group<P: Places<W>, const W: usize>(&mut self, k: usize, places: P) -> [f64; W] {
        let motions: [R; W] = self.entries.rows(self.motions, k, places);
        let images: [[f64; N]; W] = at_places(&self.image, places);
        let residual: [[f64; N]; W] = run(self.residual, k);
        let mut d: [[f64; N]; W] = from_fn(|k| motions[k].preconditioned(images[k], residual[k]));
        if let Some(change) = self.change {
            let spread: [_; W] = run(self.spread, k);
            for (a, change) in change.into_iter().enumerate() {
                d = from_fn(|k| plus(d[k], change, spread[k][a]));
            }
        }
        if let Some(conjugation) = self.conjugation {
            let previous: [_; W] = run(self.direction, k);
            d = from_fn(|k| plus(d[k], conjugation, previous[k]));
        }
        put_run(self.direction, k, d);
        put_at_places(&mut self.full, places, d);
        from_fn(|k| dot(d[k], plus(residual[k], 1.0, self.at_once)))
    }
}

/// Curvature along the direction.
struct CurvatureWork<'a, R, const N: usize> {
    entries: &'a ChunkCells<'a>,
    motions: &'a [R],
    image: [&'a [f64]; N],
    direction: &'a [[f64; N]],
}

impl<R: Row<N>, const N: usize> GroupWork for CurvatureWork<'_, R, N> {
    /// `d' (C + K) d` and `d' d`.
    type Sum = (f64, f64);

    #[inline(always)]
    fn group<P: Places<W>, const W: usize>(&mut self, k: usize, places: P) -> [Self::Sum; W] {
        let motions: [R; W] = self.entries.rows(self.motions, k, places);
        let images: [[f64; N]; W] = at_places(&self.image, places);
        let directions: [[f64; N]; W] = run(self.direction, k);
        from_fn(|k| {
            let (d, u) = (directions[k], images[k]);
            (dot(d, plus(u, 1.0, motions[k].bend(d))), dot(d, d))
        })
    }
}
