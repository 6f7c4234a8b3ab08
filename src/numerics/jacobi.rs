//! Eigenvalues and eigenvectors of small real symmetric matrices.

/// Number of sweeps of rotations. It is more than sufficient for a matrix of three rows because convergence is
/// quadratic.
const SWEEPS: usize = 20;

/// Returns the eigenvalues and, in columns, the eigenvectors, computed with Jacobi rotations (Golub & Van Loan, Matrix
/// Computations, 4th ed. 2013, section 8.5).
pub(crate) fn diagonalised<const N: usize>(mut a: [[f64; N]; N]) -> ([f64; N], [[f64; N]; N]) {
    let mut vectors = std::array::from_fn(|i| std::array::from_fn(|j| f64::from(u8::from(i == j))));
    let scale = a
        .as_flattened()
        .iter()
        .fold(0.0, |s: f64, x| s.max(x.abs()))
        .min(f64::MAX);
    for _ in 0..SWEEPS {
        let mut is_diagonal = true;
        for p in 0..N {
            for q in p + 1..N {
                // An entry this small changes an eigenvalue by less than the last bit of the largest eigenvalue. An
                // entry that is not finite does not count as small and propagates into the result.
                let is_small = a[p][q].abs() <= 0.25 * f64::EPSILON * scale;
                if !is_small {
                    is_diagonal = false;
                    rotate(&mut a, &mut vectors, p, q);
                }
            }
        }
        if is_diagonal {
            break;
        }
    }
    (std::array::from_fn(|i| a[i][i]), vectors)
}

/// Rotates the axes `p` and `q` so that the entry between them vanishes.
fn rotate<const N: usize>(a: &mut [[f64; N]; N], vectors: &mut [[f64; N]; N], p: usize, q: usize) {
    let slope = 0.5 * (a[q][q] - a[p][p]) / a[p][q];
    // The entry is not small compared with the matrix, so the square of the slope cannot overflow.
    let tangent = 1.0_f64.copysign(slope) / (slope.abs() + (1.0 + slope * slope).sqrt());
    let cosine = 1.0 / (1.0 + tangent * tangent).sqrt();
    let sine = tangent * cosine;
    let change = tangent * a[p][q];
    a[p][p] -= change;
    a[q][q] += change;
    a[p][q] = 0.0;
    a[q][p] = 0.0;
    for r in (0..N).filter(|&r| r != p && r != q) {
        let (x, y) = (a[r][p], a[r][q]);
        (a[r][p], a[r][q]) = (cosine * x - sine * y, sine * x + cosine * y);
        (a[p][r], a[q][r]) = (a[r][p], a[r][q]);
    }
    for row in vectors {
        let (x, y) = (row[p], row[q]);
        (row[p], row[q]) = (cosine * x - sine * y, sine * x + cosine * y);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_not_finite_passes_on() {
        for bad in [f64::NAN, f64::INFINITY] {
            let matrix = [[1.0, bad, 0.0], [bad, 2.0, 0.0], [0.0, 0.0, 3.0]];
            let (values, _) = diagonalised(matrix);
            assert!(values.iter().any(|value| !value.is_finite()));
        }
    }
}
