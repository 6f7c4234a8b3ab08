//! Right-preconditioned, restarted GMRES on the moving cells. GMRES solves problems that are not symmetric and problems whose
//! residual must fall by many orders of magnitude.

use std::ops::{ControlFlow, Range};

use crate::cgm::active_set_solve::Precision;
use crate::cgm::law::state::Row;
use crate::cgm::linear::{Border, Linear};
use crate::memory::fallible;
use crate::numerics::cell_vector::{at, dot, minus, norm, plus, slices, within};
use crate::parallel;
use crate::report::Status;

/// Largest reduction of the residual by a basis. The products of the basis in single precision limit the reduction.
const BASIS_REDUCTION: f64 = 1e-5;

/// Number of basis vectors that are read together.
const AT_ONCE: usize = 4;

/// Equations of a linear problem: their residual, and their update by corrections.
pub(in crate::cgm) trait Equations<R, const N: usize> {
    /// Writes the residual of the equations to the workspace.
    fn set_residual(&mut self, linear: &mut Linear<'_, '_, R, N>) -> ControlFlow<Status>;

    /// Applies the correction and the changes of the multipliers.
    fn advance(
        &mut self,
        linear: &mut Linear<'_, '_, R, N>,
        change: [f64; N],
    ) -> ControlFlow<Status>;
}

impl<R: Row<N>, const N: usize> Linear<'_, '_, R, N> {
    /// Distributes the deficit of the totals, and solves until the residual has fallen by the given factor. Uses at most the
    /// given number of bases. Returns the final residual relative to the first.
    pub(in crate::cgm) fn solve(
        &mut self,
        border: &Border<N>,
        missing: [f64; N],
        (bases, reduction): (usize, f64),
        equations: &mut impl Equations<R, N>,
    ) -> ControlFlow<Status, f64> {
        if norm(missing) != 0.0 {
            let change = border.balance(missing, [0.0; N]);
            self.workspace.correction.fill([0.0; N]);
            self.add_spread(change);
            equations.advance(self, change)?;
        }
        equations.set_residual(self)?;
        let start = self.residual_size();
        let mut left = start;
        for _ in 0..bases {
            if left.is_nan() || left <= reduction * start {
                break;
            }
            let aim = (reduction * start).max(BASIS_REDUCTION * left);
            let parts = self.arnoldi(border, left, aim)?;
            self.combine(&parts);
            let change = self.invert(border);
            equations.advance(self, change)?;
            equations.set_residual(self)?;
            left = self.residual_size();
        }
        ControlFlow::Continue(if left == 0.0 { 0.0 } else { left / start })
    }

    /// Builds a Krylov basis from a residual of the given size until the least-squares residual reaches `aim`. Returns
    /// the coefficients.
    fn arnoldi(
        &mut self,
        border: &Border<N>,
        size: f64,
        aim: f64,
    ) -> ControlFlow<Status, [f64; RESTART]> {
        self.extend_basis(0)?;
        let w = &mut *self.workspace;
        for (first, r) in w.basis[0].iter_mut().zip(&w.residual) {
            *first = r.map(|r| r / size);
        }
        let mut hessenberg = Hessenberg::new(size);
        for j in 0..RESTART {
            let w = &mut *self.workspace;
            w.residual.copy_from_slice(&w.basis[j]);
            let change = self.invert(border);
            self.monitor.proceed()?;
            self.apply_to_correction(Precision::Single);
            self.monitor.count_step();
            self.extend_basis(j + 1)?;
            self.set_next(j + 1, change);
            let (products, rest) = self.orthogonalise(j);
            if !(hessenberg.push(&products, rest) > aim && rest > 0.0) {
                break;
            }
        }
        ControlFlow::Continue(hessenberg.solve())
    }

    /// Computes `correction = M r` plus the spread of the changes of the multipliers that keep the totals. Returns these changes.
    fn invert(&mut self, border: &Border<N>) -> [f64; N] {
        let added = self.correct();
        let change = border.balance([0.0; N], added);
        self.add_spread(change);
        change
    }

    /// Computes `correction = M r`. Returns the change of the sums of all components.
    fn correct(&mut self) -> [f64; N] {
        let w = &mut *self.workspace;
        let weighted = |k: usize, row: R| row.weighted(w.residual[k]);
        w.moving.set_full(&w.rows, &mut w.direction, weighted);
        self.precondition();
        let w = &mut *self.workspace;
        let (rows, residual, image) = (&w.rows, &w.residual, slices(&w.image));
        let correction = w.moving.compressed(&mut w.correction);
        w.moving.sweep(correction, |entries, correction| {
            let residual = &residual[entries.range.clone()];
            let image = within(&image, &entries.chunk);
            entries.sums(|k, place| {
                let row = entries.row(rows, k, place);
                let z = row.preconditioned(at(&image, place), residual[k]);
                correction.items[k] = z;
                row.extend(z)
            })
        })
    }

    /// Adds the spread of the given changes of the multipliers to the correction.
    fn add_spread(&mut self, change: [f64; N]) {
        if norm(change) == 0.0 {
            return;
        }
        let w = &mut *self.workspace;
        let spread = &w.spread;
        parallel::update(&mut w.correction, |first, chunk| {
            for (z, spread) in chunk.iter_mut().zip(&spread[first..]) {
                for (change, part) in change.iter().zip(spread) {
                    for (z, part) in z.iter_mut().zip(part) {
                        *z += change * part;
                    }
                }
            }
        });
    }

    /// Computes `image = C` times the tractions of the correction, which remain in `direction`.
    pub(super) fn apply_to_correction(&mut self, precision: Precision) {
        let w = &mut *self.workspace;
        let extended = |k: usize, row: R| row.extend(w.correction[k]);
        w.moving.set_full(&w.rows, &mut w.direction, extended);
        self.apply(precision);
    }

    /// Returns the norm of the residual.
    pub(super) fn residual_size(&self) -> f64 {
        let w = &*self.workspace;
        let residual = &w.residual;
        w.moving.sum(|range| squares(&residual[range])).sqrt()
    }

    /// Allocates vector `j` of the basis and the vectors that are read together with this vector. A later solve with one more
    /// step therefore rarely allocates.
    fn extend_basis(&mut self, j: usize) -> ControlFlow<Status> {
        let w = &mut *self.workspace;
        let group = w.basis.chunks_mut(AT_ONCE).nth(j / AT_ONCE);
        let room = group
            .into_iter()
            .flatten()
            .try_for_each(|vector| fallible::resize(vector, w.residual.len(), [0.0; N]));
        self.monitor.record_allocation_failure(room)
    }

    /// Stores the product of the system with the correction and the changes of the multipliers as vector `j` of the basis.
    fn set_next(&mut self, j: usize, change: [f64; N]) {
        let w = &mut *self.workspace;
        let (correction, image) = (&w.correction, slices(&w.image));
        w.moving.set(&w.rows, &mut w.basis[j], |k, cell, row: R| {
            let moved = row.restrict(minus(at(&image, cell), change));
            plus(moved, 1.0, row.bend(correction[k]))
        });
    }

    /// Orthogonalises vector `j + 1` of the basis twice against the previous vectors, and normalises it. Returns the products
    /// and the length before normalisation.
    fn orthogonalise(&mut self, j: usize) -> ([f64; RESTART], f64) {
        let w = &mut *self.workspace;
        let (moving, (done, rest)) = (&w.moving, w.basis.split_at_mut(j + 1));
        let next = &mut rest[0];
        let mut products = [0.0; RESTART];
        for _ in 0..2 {
            let parts = moving.sum(|range| products_with(&next[range.clone()], done, range));
            parallel::update(next, |first, chunk| subtract(chunk, &parts, done, first));
            for (product, part) in products.iter_mut().zip(parts) {
                *product += part;
            }
        }
        let length = moving.sum(|range| squares(&next[range])).sqrt();
        if length > 0.0 {
            parallel::update(next, |_, chunk| {
                for value in chunk {
                    *value = value.map(|v| v / length);
                }
            });
        }
        (products, length)
    }

    /// Sets the residual to this combination of the basis.
    fn combine(&mut self, parts: &[f64; RESTART]) {
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

/// Returns the products of a piece of a vector with the same range of each basis vector. Several basis vectors are read together,
/// so that the processor overlaps additions.
fn products_with<const N: usize>(
    piece: &[[f64; N]],
    basis: &[Vec<[f64; N]>],
    range: Range<usize>,
) -> [f64; RESTART] {
    let mut products = [0.0; RESTART];
    for (products, group) in products.chunks_mut(AT_ONCE).zip(basis.chunks(AT_ONCE)) {
        if let [a, b, c, d] = group {
            let vectors = [a, b, c, d].map(|vector| &vector[range.clone()]);
            let mut sums = [0.0; AT_ONCE];
            for (k, value) in piece.iter().enumerate() {
                for (sum, vector) in sums.iter_mut().zip(vectors) {
                    *sum += dot(*value, vector[k]);
                }
            }
            products.copy_from_slice(&sums);
        } else {
            for (product, vector) in products.iter_mut().zip(group) {
                let pairs = piece.iter().zip(&vector[range.clone()]);
                *product = pairs.fold(0.0, |sum, (a, b)| sum + dot(*a, *b));
            }
        }
    }
    products
}

/// Subtracts these multiples of the basis vectors from a piece of a vector that starts at `first`.
fn subtract<const N: usize>(
    piece: &mut [[f64; N]],
    parts: &[f64; RESTART],
    basis: &[Vec<[f64; N]>],
    first: usize,
) {
    let less = |value: [f64; N], part: f64, v: [f64; N]| -> [f64; N] {
        std::array::from_fn(|c| value[c] - part * v[c])
    };
    let range = first..first + piece.len();
    for (parts, group) in parts.chunks(AT_ONCE).zip(basis.chunks(AT_ONCE)) {
        if let ([p, q, r, s], [a, b, c, d]) = (parts, group) {
            let [a, b, c, d] = [a, b, c, d].map(|vector| &vector[range.clone()]);
            for (k, value) in piece.iter_mut().enumerate() {
                let two = less(less(*value, *p, a[k]), *q, b[k]);
                *value = less(less(two, *r, c[k]), *s, d[k]);
            }
        } else {
            for (part, vector) in parts.iter().zip(group) {
                for (value, v) in piece.iter_mut().zip(&vector[range.clone()]) {
                    *value = less(*value, *part, *v);
                }
            }
        }
    }
}

/// Returns the sum of the squares of a piece of a vector.
fn squares<const N: usize>(vector: &[[f64; N]]) -> f64 {
    vector
        .iter()
        .fold(0.0, |sum, value| sum + dot(*value, *value))
}

/// Number of basis vectors before a restart.
pub(super) const RESTART: usize = 30;

/// Hessenberg matrix of the current basis, made triangular by rotations.
#[derive(Debug)]
pub(super) struct Hessenberg {
    columns: [[f64; RESTART]; RESTART],
    rotations: [[f64; 2]; RESTART],
    right: [f64; RESTART + 1],
    len: usize,
}

impl Hessenberg {
    /// Creates the matrix for a residual of this size.
    pub(super) fn new(residual: f64) -> Self {
        let mut right = [0.0; RESTART + 1];
        right[0] = residual;
        Self {
            columns: [[0.0; RESTART]; RESTART],
            rotations: [[0.0; 2]; RESTART],
            right,
            len: 0,
        }
    }

    /// Appends a column. It contains the products of the next vector with the basis and the length of the remainder. Returns the
    /// least-squares residual.
    pub(super) fn push(&mut self, products: &[f64; RESTART], rest: f64) -> f64 {
        let j = self.len;
        let column = &mut self.columns[j];
        *column = *products;
        for (i, [cosine, sine]) in self.rotations[..j].iter().enumerate() {
            let (a, b) = (column[i], column[i + 1]);
            column[i] = cosine * a + sine * b;
            column[i + 1] = cosine * b - sine * a;
        }
        let size = column[j].hypot(rest);
        let [cosine, sine] = if size > 0.0 {
            [column[j] / size, rest / size]
        } else {
            [1.0, 0.0]
        };
        column[j] = size;
        self.rotations[j] = [cosine, sine];
        let right = self.right[j];
        (self.right[j], self.right[j + 1]) = (cosine * right, -sine * right);
        self.len += 1;
        self.right[j + 1].abs()
    }

    /// Returns the coefficients of the basis vectors that minimise the residual.
    pub(super) fn solve(&self) -> [f64; RESTART] {
        let mut parts = [0.0; RESTART];
        for i in (0..self.len).rev() {
            let known: f64 =
                (i + 1..self.len).fold(0.0, |sum, j| sum + self.columns[j][i] * parts[j]);
            let pivot = self.columns[i][i];
            parts[i] = if pivot == 0.0 {
                0.0
            } else {
                (self.right[i] - known) / pivot
            };
        }
        parts
    }
}
