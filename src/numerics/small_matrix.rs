//! Matrices with one row per component of a cell.

use crate::numerics::cell_vector::{dot, norm};

/// Small symmetric matrix.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Small<const N: usize>(pub(crate) [[f64; N]; N]);

impl<const N: usize> Small<N> {
    /// Returns the transposed matrix.
    pub(crate) fn transposed(&self) -> Self {
        Self(std::array::from_fn(|a| self.0.map(|row| row[a])))
    }

    /// Returns the sum of the diagonal.
    pub(crate) fn trace(&self) -> f64 {
        (0..N).map(|a| self.0[a][a]).sum()
    }

    /// Solves for the active unknowns by elimination. All other unknowns are zero.
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

    /// Returns the reciprocal trace of the inverse for the active unknowns, an approximation of the smallest
    /// eigenvalue. The result is infinite if no unknown is active.
    pub(crate) fn least(&self, active: [bool; N]) -> f64 {
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

    /// Returns a unit vector of the active unknowns that approximates the eigenvector of the smallest eigenvalue, by
    /// two steps of inverse iteration. The matrix must be positive semi-definite.
    pub(crate) fn weakest(&self, active: [bool; N]) -> [f64; N] {
        let least = (0..N).filter(|&a| active[a]);
        let least = least.min_by(|&a, &b| self.0[a][a].total_cmp(&self.0[b][b]));
        let trace = self.trace();
        // If the matrix is zero, all directions are equivalent.
        let shift = if trace > 0.0 {
            f64::EPSILON * trace
        } else {
            1.0
        };
        let mut shifted = *self;
        for a in 0..N {
            shifted.0[a][a] += shift;
        }
        let mut direction = std::array::from_fn(|a| if least == Some(a) { 1.0 } else { 0.0 });
        for _ in 0..2 {
            let found = shifted.solve(direction, active);
            direction = found.map(|part| part / norm(found));
        }
        direction
    }

    /// Returns `v' A v`.
    pub(crate) fn square(&self, v: [f64; N]) -> f64 {
        dot(v, self.0.map(|row| dot(row, v)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Returns the unit vector `(cos, sin)` and `size` times the projection onto the line perpendicular to it.
    fn across(angle: f64, size: f64) -> ([f64; 2], Small<2>) {
        let [c, s] = [angle.cos(), angle.sin()];
        let matrix = [[s * s, -c * s], [-c * s, c * c]];
        (
            [c, s],
            Small(matrix.map(|row| row.map(|value| size * value))),
        )
    }

    #[test]
    fn the_weakest_direction_is_the_null_direction_at_any_angle_and_size() {
        for step in 0..48 {
            let angle = f64::from(step) * std::f64::consts::PI / 48.0;
            for size in [1e-100, 1.0, 4096.0, 1e100] {
                let (null, matrix) = across(angle, size);
                let found = matrix.weakest([true; 2]);
                assert!((norm(found) - 1.0).abs() < 1e-15, "{angle}: {found:?}");
                let turned = found[0] * null[1] - found[1] * null[0];
                assert!(turned.abs() < 1e-14, "{angle}, {size}: {found:?}");
            }
        }
    }

    #[test]
    fn it_is_found_among_the_active_unknowns_alone() {
        let (null, Small([[a, b], [_, d]])) = across(0.7, 3.0);
        // The second unknown has the smallest diagonal entry, but it is not active.
        let matrix = Small([[a, 0.0, b], [0.0, 1e-9, 0.0], [b, 0.0, d]]);
        let [x, y, z] = matrix.weakest([true, false, true]);
        assert!(y == 0.0 && (x * null[1] - z * null[0]).abs() < 1e-14);
        let [x, y, z] = matrix.weakest([false, true, false]);
        assert!(x == 0.0 && z == 0.0 && (y - 1.0).abs() < 1e-15);
    }

    #[test]
    fn of_a_matrix_of_full_rank_it_is_the_axis_of_least_stretch() {
        // Eigenvalues 1 and 1e6, along (3, 4)/5 and (-4, 3)/5.
        let found =
            Small([[640_000.36, -479_999.52], [-479_999.52, 360_000.64]]).weakest([true; 2]);
        assert!((found[0] * 0.8 - found[1] * 0.6).abs() < 1e-10, "{found:?}");
        // Any unit vector is correct for the zero matrix.
        let found = Small([[0.0; 2]; 2]).weakest([true; 2]);
        assert!((norm(found) - 1.0).abs() < 1e-15, "{found:?}");
    }

    #[test]
    fn inactive_unknowns_are_zero_and_the_others_solve_their_equations() {
        let matrix = Small([[4.0, 1.0, 2.0], [1.0, 3.0, 0.5], [2.0, 0.5, 5.0]]);
        let [x, y, z] = matrix.solve([1.0, 2.0, 3.0], [true; 3]);
        let residual = matrix.0.map(|row| dot(row, [x, y, z]));
        assert!((0..3).all(|a| (residual[a] - [1.0, 2.0, 3.0][a]).abs() < 1e-15));
        // 4 x + 2 z = 1, 2 x + 5 z = 3.
        let [x, y, z] = matrix.solve([1.0, 2.0, 3.0], [true, false, true]);
        assert!(y == 0.0 && (x + 0.0625).abs() < 1e-15 && (z - 0.625).abs() < 1e-15);
    }

    #[test]
    fn least_is_about_the_least_eigenvalue() {
        let (_, Small([[a, b], [_, d]])) = across(0.7, 3.0);
        // With the eigenvalues 1 and 4, the reciprocal trace of the inverse is 4/5.
        let matrix = Small([[a + 1.0, b], [b, d + 1.0]]);
        assert!((matrix.least([true; 2]) - 0.8).abs() < 1e-15);
        assert!((matrix.least([true, false]) - (a + 1.0)).abs() < 1e-15);
        assert!(matrix.least([false; 2]).is_infinite());
    }
}
