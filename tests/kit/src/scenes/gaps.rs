//! Gaps that are hard to close.

use stickslip::{Field, Grid};

use crate::Random;

/// Flat at a height, but for cells that stick out to zero, one height a cell further each.
pub(crate) fn nails(grid: Grid, height: f64, cells: &[[usize; 2]]) -> Field {
    let mut gap = Field::constant(grid, height);
    for [ix, iy] in cells {
        gap.as_mut_slice()[iy * grid.nx() + ix] = 0.0;
    }
    gap
}

/// A bowl of this radius of curvature.
pub(crate) fn bowl(grid: Grid, radius: f64) -> Field {
    Field::from_fn(grid, |x, y| (x * x + y * y) / (2.0 * radius))
}

/// Independent heights between zero and `height`.
pub(crate) fn white_noise(grid: Grid, height: f64, random: &mut Random) -> Field {
    Field::from_fn(grid, |_, _| random.uniform(0.0, height))
}

/// Flat within a radius, deep outside.
pub(crate) fn punch(grid: Grid, radius: f64, recess: f64) -> Field {
    Field::from_fn(grid, |x, y| if x.hypot(y) <= radius { 0.0 } else { recess })
}

/// The lower of two bowls, one apex a tenth of the other's size and beside it.
pub(crate) fn two_bowls(grid: Grid, radii: [f64; 2], apart: f64) -> Field {
    Field::from_fn(grid, |x, y| {
        let large = ((x + 0.5 * apart).powi(2) + y * y) / (2.0 * radii[0]);
        let small = ((x - 0.5 * apart).powi(2) + y * y) / (2.0 * radii[1]);
        large.min(small)
    })
}

/// A wave along each axis with one period on the grid.
pub(crate) fn waves(grid: Grid, amplitudes: [f64; 2]) -> Field {
    let sides = [grid.dx() * grid.nx() as f64, grid.dy() * grid.ny() as f64];
    let wave = |x: f64, side: f64| 1.0 - (std::f64::consts::TAU * x / side).cos();
    Field::from_fn(grid, |x, y| {
        amplitudes[0] * wave(x, sides[0]) + amplitudes[1] * wave(y, sides[1])
    })
}
