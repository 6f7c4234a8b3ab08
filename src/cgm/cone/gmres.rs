//! The linear system of a step: right-preconditioned GMRES, restarted, on the cells in contact.

use std::ops::ControlFlow;

use crate::buffer;
use crate::cgm::cone::border::Border;
use crate::cgm::cone::krylov::{Hessenberg, RESTART};
use crate::cgm::cone::workspace::gradient;
use crate::cgm::cone::{Cone, ConeRun, N};
use crate::cgm::run::Precision;
use crate::cgm::turn::Weight;
use crate::cgm::vector::{at, chunks, dot, norm, put, slices, slices_mut, within};
use crate::operator::Operator;
use crate::parallel;
use crate::report::Status;

/// Bases begun before the sets are looked at again.
const BASES: usize = 2;

impl<C: Operator<N>, P: Operator<N>, F: Cone> ConeRun<'_, '_, C, P, F> {
    /// Solves for the cells as they may move, letting them leave their sets; tractions, multipliers and product follow.
    pub(super) fn solve_linear(&mut self, border: &Border, reduction: f64) -> ControlFlow<Status> {
        let missing = self.missing();
        if norm(missing) != 0.0 {
            let change = border.balance(missing, [0.0; N]);
            self.workspace.correction.fill([0.0; N]);
            self.add_spread(change);
            self.advance(change)?;
        }
        self.set_residual();
        let start = self.residual_size();
        let mut left = start;
        for _ in 0..BASES {
            if left.is_nan() || left <= reduction * start {
                break;
            }
            let parts = self.arnoldi(border, left, reduction * start)?;
            self.combine(&parts);
            let change = self.invert(border);
            self.advance(change)?;
            self.set_residual();
            left = self.residual_size();
        }
        ControlFlow::Continue(())
    }

    /// A basis of what the preconditioned system makes of the residual, of this size, until `aim` can be reached.
    pub(super) fn arnoldi(
        &mut self,
        border: &Border,
        size: f64,
        aim: f64,
    ) -> ControlFlow<Status, [f64; RESTART]> {
        self.make_room(0)?;
        let w = &mut *self.workspace;
        for (first, r) in w.basis[0].iter_mut().zip(&w.residual) {
            *first = r.map(|r| r / size);
        }
        let mut hessenberg = Hessenberg::new(size);
        for j in 0..RESTART {
            let w = &mut *self.workspace;
            w.residual.copy_from_slice(&w.basis[j]);
            let change = self.invert(border);
            self.proceed()?;
            self.apply_to_correction(Precision::Single);
            self.count_step();
            self.make_room(j + 1)?;
            self.set_next(j + 1, change);
            let (products, rest) = self.orthogonalise(j);
            if !(hessenberg.push(&products, rest) > aim && rest > 0.0) {
                break;
            }
        }
        ControlFlow::Continue(hessenberg.solve())
    }

    /// `correction = M r` with the changes of the multipliers that keep the totals, which it returns.
    pub(super) fn invert(&mut self, border: &Border) -> [f64; N] {
        self.precondition();
        let change = border.balance([0.0; N], self.added());
        self.add_spread(change);
        change
    }

    /// `correction = M r`.
    pub(super) fn precondition(&mut self) {
        let w = &mut *self.workspace;
        let (laws, residual) = (&w.laws, &w.residual);
        let (own, [_, least_plane]) = (&w.own, self.problem.lower_bounds);
        let weight = |i: usize| match own.get(i) {
            Some(&own) => Weight::new(own, least_plane),
            None => Weight::PATTERN,
        };
        w.contact.sweep(
            chunks(self.problem.layout, &mut w.direction),
            |entries, mut full| {
                let residual = &residual[entries.range.clone()];
                for (k, place) in entries.places().enumerate() {
                    let cell = entries.chunk.start + place;
                    let pattern = laws[cell].weighted(residual[k], weight(cell));
                    put(&mut full, place, pattern);
                }
            },
        );
        let (direction, image) = (slices(&w.direction), slices_mut(&mut w.image));
        let preconditioner = &self.problem.preconditioner;
        preconditioner.apply_f32(direction, image, &mut w.preconditioner);
        let image = slices(&w.image);
        let correction = w.contact.compressed(&mut w.correction);
        w.contact.sweep(correction, |entries, correction| {
            let residual = &residual[entries.range.clone()];
            let image = within(&image, &entries.chunk);
            for (k, place) in entries.places().enumerate() {
                let cell = entries.chunk.start + place;
                let (answer, r) = (at(&image, place), residual[k]);
                correction.items[k] = laws[cell].preconditioned(answer, r, weight(cell));
            }
        });
    }

    /// `image = C` times the tractions that the correction makes, which are left in `direction`.
    pub(super) fn apply_to_correction(&mut self, precision: Precision) {
        let w = &mut *self.workspace;
        let (laws, correction) = (&w.laws, &w.correction);
        w.contact.sweep(
            chunks(self.problem.layout, &mut w.direction),
            |entries, mut full| {
                let correction = &correction[entries.range.clone()];
                for (k, place) in entries.places().enumerate() {
                    let law = laws[entries.chunk.start + place];
                    put(&mut full, place, law.extend(correction[k]));
                }
            },
        );
        let (direction, image) = (slices(&w.direction), slices_mut(&mut w.image));
        let (operator, report) = (&self.problem.operator, &mut w.report);
        precision.apply(operator, direction, image, &mut w.operator, report);
        self.add_change_of_lag();
    }

    /// Takes the correction, with changes of the multipliers.
    fn advance(&mut self, change: [f64; N]) -> ControlFlow<Status> {
        self.proceed()?;
        self.is_fresh = false;
        self.apply_to_correction(Precision::Single);
        self.count_step();
        let w = &mut *self.workspace;
        for (multiplier, change) in w.multiplier.iter_mut().zip(change) {
            *multiplier += change;
        }
        let (direction, image) = (slices(&w.direction), slices(&w.image));
        let add = |target: &mut [f64], source: &[f64]| {
            parallel::update(target, |first, chunk| {
                for (target, source) in chunk.iter_mut().zip(&source[first..]) {
                    *target += source;
                }
            });
        };
        for c in 0..N {
            add(&mut *self.x[c], direction[c]);
            add(&mut w.product[c], image[c]);
        }
        ControlFlow::Continue(())
    }

    /// The equations as the tractions leave them.
    fn set_residual(&mut self) {
        let w = &mut *self.workspace;
        let gradient = gradient(&w.product, self.problem.linear, w.multiplier);
        let laws = &w.laws;
        let (x, residual) = (slices(&self.x), w.contact.compressed(&mut w.residual));
        w.contact.sweep(residual, |entries, residual| {
            for (k, place) in entries.places().enumerate() {
                let cell = entries.chunk.start + place;
                let r = laws[cell].residual(at(&x, cell), gradient(cell));
                residual.items[k] = r;
            }
        });
    }

    pub(super) fn residual_size(&self) -> f64 {
        let w = &*self.workspace;
        let residual = &w.residual;
        w.contact.sum(|range| squares(&residual[range])).sqrt()
    }

    /// Makes room for vector `j` of the basis.
    fn make_room(&mut self, j: usize) -> ControlFlow<Status> {
        let w = &mut *self.workspace;
        let room = buffer::resize(&mut w.basis[j], w.residual.len(), [0.0; N]);
        self.unless_lacking(room)
    }

    /// The system's product with the correction, at changes of the multipliers, as vector `j` of the basis.
    fn set_next(&mut self, j: usize, change: [f64; N]) {
        let w = &mut *self.workspace;
        let (laws, correction, image) = (&w.laws, &w.correction, slices(&w.image));
        let next = w.contact.compressed(&mut w.basis[j]);
        w.contact.sweep(next, |entries, next| {
            let correction = &correction[entries.range.clone()];
            let image = within(&image, &entries.chunk);
            for (k, place) in entries.places().enumerate() {
                let law = laws[entries.chunk.start + place];
                let moved = std::array::from_fn(|c| image[c][place] - change[c]);
                let (row, bend) = (law.restrict(moved), law.bend(correction[k]));
                next.items[k] = std::array::from_fn(|c| row[c] + bend[c]);
            }
        });
    }

    /// Makes vector `j + 1` of the basis orthogonal to those before, twice, and of length one; returns the products and
    /// the length it had left.
    fn orthogonalise(&mut self, j: usize) -> ([f64; RESTART], f64) {
        let w = &mut *self.workspace;
        let (contact, (done, rest)) = (&w.contact, w.basis.split_at_mut(j + 1));
        let next = &mut rest[0];
        let mut products = [0.0; RESTART];
        for _ in 0..2 {
            let parts: [f64; RESTART] = contact.sum(|range| {
                let mut parts = [0.0; RESTART];
                for (part, vector) in parts.iter_mut().zip(&*done) {
                    *part = range
                        .clone()
                        .fold(0.0, |sum, k| sum + dot(next[k], vector[k]));
                }
                parts
            });
            parallel::update(next, |first, chunk| {
                for (part, vector) in parts.iter().zip(&*done) {
                    for (value, v) in chunk.iter_mut().zip(&vector[first..]) {
                        *value = std::array::from_fn(|c| value[c] - part * v[c]);
                    }
                }
            });
            for (product, part) in products.iter_mut().zip(parts) {
                *product += part;
            }
        }
        let length = contact.sum(|range| squares(&next[range])).sqrt();
        if length > 0.0 {
            parallel::update(next, |_, chunk| {
                for value in chunk {
                    *value = value.map(|v| v / length);
                }
            });
        }
        (products, length)
    }

    /// The residual becomes this combination of the basis.
    pub(super) fn combine(&mut self, parts: &[f64; RESTART]) {
        let w = &mut *self.workspace;
        let basis = &w.basis;
        parallel::update(&mut w.residual, |first, chunk| {
            chunk.fill([0.0; N]);
            for (part, vector) in parts.iter().zip(basis).filter(|(part, _)| **part != 0.0) {
                for (value, v) in chunk.iter_mut().zip(&vector[first..]) {
                    *value = std::array::from_fn(|c| value[c] + part * v[c]);
                }
            }
        });
    }
}

/// The sum of the squares of a piece of a vector.
fn squares(vector: &[[f64; N]]) -> f64 {
    vector
        .iter()
        .fold(0.0, |sum, value| sum + dot(*value, *value))
}
