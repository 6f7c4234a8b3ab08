//! Matrices of as many rows as a cell has components.

use crate::cgm::vector::{dot, norm};

/// A small symmetric matrix.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Small<const N: usize>(pub(crate) [[f64; N]; N]);

impl<const N: usize> Small<N> {
    /// Solves for the active unknowns, the others being zero, by elimination.
    pub(crate) fn solve(&self, right: [f64; N], active: [bool; N]) -> [f64; N] {
        let (mut rows, mut x) = (self.0, right);
        let is_below = |row: usize, pivot: usize| active[row] && row > pivot;
        for pivot in (0..N).filter(|&pivot| active[pivot]) {
            for row in (0..N).filter(|&row| is_below(row, pivot)) {
                let part = rows[row][pivot] / rows[pivot][pivot];
                let above = rows[pivot];
                for (value, above) in rows[row].iter_mut().zip(above).skip(pivot) {
                    *value -= part * above;
                }
                x[row] -= part * x[pivot];
            }
        }
        for row in (0..N).rev() {
            if !active[row] {
                x[row] = 0.0;
                continue;
            }
            for column in (0..N).filter(|&column| is_below(column, row)) {
                x[row] -= rows[row][column] * x[column];
            }
            x[row] /= rows[row][row];
        }
        x
    }

    /// One over the trace of the inverse among the active unknowns: about the least eigenvalue; infinite without any.
    pub(super) fn least(&self, active: [bool; N]) -> f64 {
        if active == [false; N] {
            return f64::INFINITY;
        }
        let inverse = (0..N).filter(|&a| active[a]).map(|a| {
            let mut unit = [0.0; N];
            unit[a] = 1.0;
            self.solve(unit, active)[a]
        });
        1.0 / inverse.fold(0.0, |sum, part| sum + part)
    }

    /// A vector of length one among the active unknowns that the matrix, not negative, takes to the least: by two steps
    /// of inverse iteration.
    pub(super) fn weakest(&self, active: [bool; N]) -> [f64; N] {
        let least = (0..N).filter(|&a| active[a]);
        let least = least.min_by(|&a, &b| self.0[a][a].total_cmp(&self.0[b][b]));
        let trace: f64 = (0..N).map(|a| self.0[a][a]).sum();
        let mut shifted = *self;
        for a in 0..N {
            shifted.0[a][a] += f64::EPSILON * trace + f64::MIN_POSITIVE;
        }
        let mut direction = std::array::from_fn(|a| if least == Some(a) { 1.0 } else { 0.0 });
        for _ in 0..2 {
            let found = shifted.solve(direction, active);
            direction = found.map(|part| part / norm(found));
        }
        direction
    }

    /// `v' A v`.
    pub(super) fn square(&self, v: [f64; N]) -> f64 {
        dot(v, self.0.map(|row| dot(row, v)))
    }
}
