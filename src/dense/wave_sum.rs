//! The coefficients of a periodic grid as a sum of waves.

use std::f64::consts::TAU;

use crate::bodies::component::Component;
use crate::bodies::kernel::Kernel;
use crate::grid::Grid;
use crate::grid::field::Field;
use crate::influence::Symbols;

/// Returns the coefficient at every distance `(i dx, j dy)` of a periodic grid, `0 <= i < nx`, `0 <= j < ny`. Each
/// coefficient is the sum of all waves, each multiplied by its symbol.
pub(super) fn coefficients(grid: Grid, kernel: &Kernel, component: Component) -> Field {
    let (nx, ny) = (grid.nx(), grid.ny());
    let symbols = Symbols::new(grid, kernel, component);
    let [odd_x, odd_y] = component.is_odd();
    let along_x = |k, i| wave(nx, odd_x, k, i);
    let along_y = |l, j| wave(ny, odd_y, l, j);
    // The sign is i^2 from two odd factors, or from one odd factor and an imaginary symbol.
    let sign = if odd_x || odd_y { -1.0 } else { 1.0 };
    let scale = sign / grid.cells() as f64;

    let rows = Field::from_indices(grid, |k, j| {
        let waves = (0..=ny / 2).map(|l| symbols.at([k.min(nx - k), l]) * along_y(l, j));
        waves.sum()
    });
    Field::from_indices(grid, |i, j| {
        let row = &rows.as_slice()[j * nx..][..nx];
        scale * (0..=nx / 2).map(|k| row[k] * along_x(k, i)).sum::<f64>()
    })
}

/// Returns the sum of the waves with `k` and `-k` periods on `n` cells at cell `i`: a cosine or a sine.
fn wave(n: usize, is_odd: bool, k: usize, i: usize) -> f64 {
    // The remainder keeps the angle small and its sine accurate.
    let angle = TAU * ((k * i) % n) as f64 / n as f64;
    let copies = if k == 0 || 2 * k == n { 1.0 } else { 2.0 };
    copies * if is_odd { angle.sin() } else { angle.cos() }
}
