//! Triangular factor of a least-squares problem.

/// Smallest fraction of a column that must be linearly independent of the preceding columns.
const INDEPENDENT: f64 = 1e-5;

/// Upper triangular matrix `R`.
pub(super) struct Triangle {
    count: usize,
    /// Entries row by row, including the zeros below the diagonal.
    entries: Vec<f64>,
}

impl Triangle {
    /// Creates a triangle from the function `entry` of row and column. The function is not called below the diagonal.
    pub(super) fn from_fn(count: usize, mut entry: impl FnMut(usize, usize) -> f64) -> Self {
        let mut entries = vec![0.0; count * count];
        for row in 0..count {
            for column in row..count {
                entries[row * count + column] = entry(row, column);
            }
        }
        Self { count, entries }
    }

    /// Computes the Cholesky factor of `A'A = R'R`, given row by row. Entries are NaN if the columns of `A` are
    /// linearly dependent.
    pub(super) fn of_products(count: usize, products: &[f64]) -> Self {
        let mut factor = Self::from_fn(count, |row, column| products[row * count + column]);
        for row in 0..count {
            for column in row..count {
                let above = (0..row).map(|k| factor.at(k, row) * factor.at(k, column));
                let rest = factor.at(row, column) - above.sum::<f64>();
                factor.entries[row * count + column] = if column == row {
                    rest.sqrt()
                } else {
                    rest / factor.at(row, row)
                };
            }
        }
        factor
    }

    /// Updates `R` of `A = QR` for additional rows of `A`, which are overwritten.
    ///
    /// For each column, a Householder reflection `1 - v v'/h` with `h = v'v/2` eliminates the entries of the new rows
    /// in this column. Each reflection changes only one row of `R`, so a block of a few rows stays in the cache.
    pub(super) fn absorb(&mut self, rows: &mut [f64]) {
        let count = self.count;
        let mut sums = vec![0.0; count];
        for column in 0..count {
            let pivot = &mut self.entries[column * count..][..count];
            let entries = rows.chunks_exact(count).map(|row| row[column]);
            let squares: f64 = entries.map(|entry| entry * entry).sum();
            if squares == 0.0 {
                continue;
            }
            let reflected = -pivot[column].hypot(squares.sqrt()).copysign(pivot[column]);
            let first = pivot[column] - reflected;
            let half_square = -reflected * first;
            sums.fill(0.0);
            let rest = column + 1..count;
            add(first, &pivot[rest.clone()], &mut sums[rest.clone()]);
            for row in rows.chunks_exact(count) {
                add(row[column], &row[rest.clone()], &mut sums[rest.clone()]);
            }
            add(
                -first / half_square,
                &sums[rest.clone()],
                &mut pivot[rest.clone()],
            );
            for row in rows.chunks_exact_mut(count) {
                add(
                    -row[column] / half_square,
                    &sums[rest.clone()],
                    &mut row[rest.clone()],
                );
            }
            pivot[column] = reflected;
        }
    }

    /// Returns `R` for the rows of both triangles.
    pub(super) fn with(mut self, mut other: Self) -> Self {
        self.absorb(&mut other.entries);
        self
    }

    fn at(&self, row: usize, column: usize) -> f64 {
        self.entries[row * self.count + column]
    }

    /// Returns whether every column of `A` is sufficiently independent of the preceding columns.
    pub(super) fn is_independent(&self) -> bool {
        (0..self.count).all(|column| {
            let squares = (0..=column).map(|row| self.at(row, column).powi(2));
            self.at(column, column).abs() > INDEPENDENT * squares.sum::<f64>().sqrt()
        })
    }

    /// Solves `R'R x = b`. On entry, `x` contains `b`.
    pub(super) fn solve_squared(&self, x: &mut [f64]) {
        for row in 0..self.count {
            let known: f64 = (0..row).map(|k| self.at(k, row) * x[k]).sum();
            x[row] = (x[row] - known) / self.at(row, row);
        }
        for row in (0..self.count).rev() {
            let known: f64 = (row + 1..self.count).map(|k| self.at(row, k) * x[k]).sum();
            x[row] = (x[row] - known) / self.at(row, row);
        }
    }
}

/// Computes `y += a x`.
fn add(a: f64, x: &[f64], y: &mut [f64]) {
    for (y, x) in y.iter_mut().zip(x) {
        *y += a * x;
    }
}
