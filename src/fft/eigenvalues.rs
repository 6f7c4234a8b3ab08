//! Eigenvalues and inverses of small real symmetric matrices.

use crate::numerics::jacobi::diagonalised;

/// Returns the smallest and the largest eigenvalue.
pub(super) fn eigenvalue_range<const N: usize>(matrix: [[f64; N]; N]) -> [f64; 2] {
    if N == 2 {
        let SymmetricPair { mean, radius, .. } = SymmetricPair::new(matrix);
        return [mean - radius, mean + radius];
    }
    let (diagonal, _) = diagonalised(matrix);
    let none = [f64::INFINITY, f64::NEG_INFINITY];
    let wider = |[low, high]: [f64; 2], &value: &f64| [low.min(value), high.max(value)];
    diagonal.iter().fold(none, wider)
}

/// Returns the inverse, with eigenvalues below `floor` raised to `floor`.
pub(super) fn inverse_above<const N: usize>(matrix: [[f64; N]; N], floor: f64) -> [[f64; N]; N] {
    if N == 2 {
        return SymmetricPair::new(matrix).inverse_above(floor);
    }
    let (values, vectors) = diagonalised(matrix);
    let weights = values.map(|value| 1.0 / value.max(floor));
    std::array::from_fn(|i| {
        std::array::from_fn(|j| {
            let terms = (0..N).map(|k| vectors[i][k] * vectors[j][k] * weights[k]);
            terms.sum()
        })
    })
}

/// Returns the strength of the coupling of the first component with the other two. For a matrix with the blocks a, b
/// and T it is $`\sqrt{b' T^{-1} b / a}`$. The value is less than one if the matrix is positive definite, and infinite
/// if a or T is not positive definite.
pub(super) fn coupling(matrix: [[f64; 3]; 3]) -> f64 {
    let [[a, x, y], [_, xx, xy], [_, _, yy]] = matrix;
    let determinant = xx * yy - xy * xy;
    if a < 0.0 || determinant < 0.0 || xx + yy < 0.0 {
        return f64::INFINITY;
    }
    let square = (x * x * yy - 2.0 * x * y * xy + y * y * xx) / determinant;
    (square / a).sqrt()
}

/// Symmetric 2 x 2 matrix, `mean + radius [[cos, sin], [sin, -cos]]` of twice the angle of its axes.
struct SymmetricPair {
    mean: f64,
    radius: f64,
    /// Half the difference of the diagonal entries, and the off-diagonal entry.
    difference: f64,
    beside: f64,
}

impl SymmetricPair {
    /// Decomposes a 2 x 2 matrix. The caller must ensure that N is 2, because the type does not.
    fn new<const N: usize>(matrix: [[f64; N]; N]) -> Self {
        let (xx, yy, xy) = (matrix[0][0], matrix[1][1], matrix[0][1]);
        let difference = 0.5 * (xx - yy);
        Self {
            mean: 0.5 * (xx + yy),
            radius: difference.hypot(xy),
            difference,
            beside: xy,
        }
    }

    fn inverse_above<const N: usize>(&self, floor: f64) -> [[f64; N]; N] {
        let &Self {
            mean,
            radius,
            difference,
            beside,
        } = self;
        let [low, high] = [mean - radius, mean + radius].map(|value| 1.0 / value.max(floor));
        let (centre, spread) = (0.5 * (low + high), 0.5 * (high - low));
        let [cosine, sine] = if radius > 0.0 {
            [difference / radius, beside / radius]
        } else {
            [0.0, 0.0]
        };
        let mut inverse = [[spread * sine; N]; N];
        inverse[0][0] = centre + spread * cosine;
        inverse[1][1] = centre - spread * cosine;
        inverse
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Checks matrices with given eigenvalues, including double and close eigenvalues.
    #[test]
    fn matrices_of_three_rows_have_their_eigenvalues_and_inverses() {
        for values in [
            [1.0, 2.0, 3.0],
            [2.0, 2.0, 5.0],
            [1.0, 1.0, 1.0],
            [1.0, 1.0 + 1e-9, 40.0],
        ] {
            for turn in 0..20 {
                let angle = 0.37 * f64::from(turn);
                let axes = orthogonal(angle, 1.3 * angle + 0.2, 0.7 * angle);
                let of = |values: [f64; 3]| -> [[f64; 3]; 3] {
                    std::array::from_fn(|i| {
                        std::array::from_fn(|j| {
                            (0..3).map(|k| axes[i][k] * axes[j][k] * values[k]).sum()
                        })
                    })
                };
                let matrix = of(values);
                let [low, high] = eigenvalue_range(matrix);
                assert!((low - values[0]).abs() <= 1e-15 * values[2]);
                assert!((high - values[2]).abs() <= 1e-15 * values[2]);
                let floor = 1.5;
                let expected = of(values.map(|value| 1.0 / value.max(floor)));
                let inverse = inverse_above(matrix, floor);
                for (a, b) in inverse.iter().flatten().zip(expected.iter().flatten()) {
                    assert!((a - b).abs() < 1e-14, "{values:?} {turn}: {a} is not {b}");
                }
            }
        }
    }

    fn orthogonal(a: f64, b: f64, c: f64) -> [[f64; 3]; 3] {
        let ((sa, ca), (sb, cb), (sc, cc)) = (a.sin_cos(), b.sin_cos(), c.sin_cos());
        [
            [ca * cb, ca * sb * sc - sa * cc, ca * sb * cc + sa * sc],
            [sa * cb, sa * sb * sc + ca * cc, sa * sb * cc - ca * sc],
            [-sb, cb * sc, cb * cc],
        ]
    }
}
