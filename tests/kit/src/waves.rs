//! Waves of a field, by the slow transform.

use std::f64::consts::TAU;

use stickslip::Field;

/// One wave `a exp(i (kx x + ky y))` of a field relative to the origin of the grid. The wave of the opposite wave
/// vector is also listed.
#[derive(Debug, Clone, Copy)]
pub struct Wave {
    /// Number of periods along each side, from `-n/2`.
    pub numbers: [i64; 2],
    /// Wave vector, `2 pi` divided by the wavelength along each axis.
    pub vector: [f64; 2],
    /// Real and imaginary part.
    pub amplitude: [f64; 2],
}

impl Wave {
    pub fn wave_number(&self) -> f64 {
        self.vector[0].hypot(self.vector[1])
    }

    /// Returns the squared modulus.
    pub fn power(&self) -> f64 {
        self.amplitude[0].powi(2) + self.amplitude[1].powi(2)
    }
}

/// Returns all waves of a field that is continued periodically.
pub fn waves(field: &Field) -> Vec<Wave> {
    let grid = field.grid();
    let columns = along(grid.nx(), grid.dx());
    let rows = along(grid.ny(), grid.dy());
    let mut found = Vec::with_capacity(grid.cells());
    for (i, kx, turns) in &columns {
        let part = |row: &[f64], part: usize| -> f64 {
            row.iter().zip(turns).map(|(z, turn)| z * turn[part]).sum()
        };
        let column: Vec<_> = field
            .rows()
            .map(|row| [part(row, 0), part(row, 1)])
            .collect();
        for (j, ky, turns) in &rows {
            let mut sum = [0.0; 2];
            for ([re, im], [c, s]) in column.iter().zip(turns) {
                sum[0] += re * c - im * s;
                sum[1] += re * s + im * c;
            }
            found.push(Wave {
                numbers: [*i, *j],
                vector: [*kx, *ky],
                amplitude: sum.map(|part| part / grid.cells() as f64),
            });
        }
    }
    found
}

/// Returns each number of periods along an axis, its wave vector, and `exp(-i k x)` in every cell.
fn along(n: usize, d: f64) -> Vec<(i64, f64, Vec<[f64; 2]>)> {
    let numbers = (0..n as i64).map(|i| i - (n / 2) as i64);
    let with_turns = |number: i64| {
        // Twice a position is a whole number of cells, so that the angles remain small and exact.
        let turn = |cell: i64| {
            let steps = number * (2 * cell - (n as i64 - 1));
            let (s, c) = (TAU * steps.rem_euclid(2 * n as i64) as f64 / (2 * n) as f64).sin_cos();
            [c, -s]
        };
        let wave_vector = TAU * number as f64 / (n as f64 * d);
        (number, wave_vector, (0..n as i64).map(turn).collect())
    };
    numbers.map(with_turns).collect()
}
