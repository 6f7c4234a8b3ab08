//! The small least-squares problem of GMRES (Saad & Schultz, SIAM J. Sci. Stat. Comput. 7 (1986) 856,
//! <https://doi.org/10.1137/0907058>).

/// Vectors of a basis, after which the iteration begins again.
pub(super) const RESTART: usize = 30;

/// The Hessenberg matrix of the basis so far, made triangular by rotations.
#[derive(Debug)]
pub(super) struct Hessenberg {
    columns: [[f64; RESTART]; RESTART],
    rotations: [[f64; 2]; RESTART],
    right: [f64; RESTART + 1],
    len: usize,
}

impl Hessenberg {
    /// For a residual of this size.
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

    /// Takes the products of the next vector with the basis, and the size of what is left of it; returns the residual
    /// that remains.
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

    /// The parts of the vectors that leave the least residual.
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
