//! The triangular factor of a least-squares problem.

/// Smallest fraction of a column that must be independent of the columns before it.
const INDEPENDENT: f64 = 1e-5;

/// `R` of `A = QR`, row by row, for the rows of `A`, of `count` entries each: no more rows than columns, and zeros below the
/// diagonal. By Householder's reflections `1 - v v'/h`, `h = v'v/2`, each of which leaves the first entry of what is left of a column.
pub(super) fn reduced(count: usize, mut rows: Vec<f64>) -> Vec<f64> {
    let height = rows.len() / count;
    let mut along = vec![0.0; count];
    for column in 0..count.min(height) {
        let rest = &mut rows[column * count..];
        let squares: f64 = rest
            .chunks_exact(count)
            .map(|row| row[column].powi(2))
            .sum();
        if squares == 0.0 {
            continue;
        }
        let reflected = -squares.sqrt().copysign(rest[column]);
        rest[column] -= reflected;
        let half_square = -reflected * rest[column];
        along.fill(0.0);
        for row in rest.chunks_exact(count) {
            for (sum, entry) in along.iter_mut().zip(row).skip(column + 1) {
                *sum += row[column] * entry;
            }
        }
        for row in rest.chunks_exact_mut(count) {
            let part = std::mem::take(&mut row[column]) / half_square;
            for (entry, sum) in row.iter_mut().zip(&along).skip(column + 1) {
                *entry -= part * sum;
            }
        }
        rest[column] = reflected;
    }
    rows.truncate(count.min(height) * count);
    rows
}

/// An upper triangle `R`.
pub(super) struct Triangle {
    count: usize,
    /// Row by row, zeros below the diagonal included.
    entries: Vec<f64>,
}

impl Triangle {
    /// By row and column; `entry` is not called below the diagonal.
    pub(super) fn from_fn(count: usize, mut entry: impl FnMut(usize, usize) -> f64) -> Self {
        let mut entries = vec![0.0; count * count];
        for row in 0..count {
            for column in row..count {
                entries[row * count + column] = entry(row, column);
            }
        }
        Self { count, entries }
    }

    /// Cholesky's factor of `A'A = R'R`, given row by row; NaN where the columns of `A` depend on one
    /// another.
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

    fn at(&self, row: usize, column: usize) -> f64 {
        self.entries[row * self.count + column]
    }

    /// Whether every column of `A` is sufficiently independent of those before it.
    pub(super) fn is_independent(&self) -> bool {
        (0..self.count).all(|column| {
            let squares = (0..=column).map(|row| self.at(row, column).powi(2));
            self.at(column, column).abs() > INDEPENDENT * squares.sum::<f64>().sqrt()
        })
    }

    /// Solves `R'R x = b`; `x` holds `b` on entry.
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
