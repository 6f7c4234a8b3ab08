//! Gaps that are difficult to close.

use stickslip::{Field, Grid};

use crate::Random;

/// Returns a gap of constant `height`, except for single cells that protrude to zero.
pub(crate) fn nails(grid: Grid, height: f64, cells: &[[usize; 2]]) -> Field {
    let mut gap = Field::constant(grid, height);
    for [ix, iy] in cells {
        gap.as_mut_slice()[iy * grid.nx() + ix] = 0.0;
    }
    gap
}

/// Returns a bowl with this radius of curvature.
pub(crate) fn bowl(grid: Grid, radius: f64) -> Field {
    Field::from_fn(grid, |x, y| (x * x + y * y) / (2.0 * radius))
}

/// Returns independent heights between zero and `height`.
pub(crate) fn white_noise(grid: Grid, height: f64, random: &mut Random) -> Field {
    Field::from_fn(grid, |_, _| random.uniform(0.0, height))
}

/// Returns a gap that is flat within a radius and deep outside.
pub(crate) fn punch(grid: Grid, radius: f64, recess: f64) -> Field {
    Field::from_fn(grid, |x, y| if x.hypot(y) <= radius { 0.0 } else { recess })
}

/// Returns the lower of two bowls with these radii of curvature, whose apexes are a distance `apart` along x.
pub(crate) fn two_bowls(grid: Grid, radii: [f64; 2], apart: f64) -> Field {
    Field::from_fn(grid, |x, y| {
        let large = ((x + 0.5 * apart).powi(2) + y * y) / (2.0 * radii[0]);
        let small = ((x - 0.5 * apart).powi(2) + y * y) / (2.0 * radii[1]);
        large.min(small)
    })
}

/// Returns a wave along each axis with one period on the grid.
pub(crate) fn waves(grid: Grid, amplitudes: [f64; 2]) -> Field {
    let sides = [grid.dx() * grid.nx() as f64, grid.dy() * grid.ny() as f64];
    let wave = |x: f64, side: f64| 1.0 - (std::f64::consts::TAU * x / side).cos();
    Field::from_fn(grid, |x, y| {
        amplitudes[0] * wave(x, sides[0]) + amplitudes[1] * wave(y, sides[1])
    })
}

/// Returns the sum of waves with random directions and phases. Their lengths are between 6 and 20 cells, and the
/// root-mean-square slope is about `slope`.
pub(crate) fn asperities(grid: Grid, slope: f64, random: &mut Random) -> Field {
    const WAVES: usize = 12;
    let waves: Vec<_> = (0..WAVES)
        .map(|_| {
            let length = grid.dx().min(grid.dy()) * random.uniform(6.0, 20.0);
            let number = std::f64::consts::TAU / length;
            let angle = random.uniform(0.0, std::f64::consts::TAU);
            let phase = random.uniform(0.0, std::f64::consts::TAU);
            (number, angle.sin_cos(), phase)
        })
        .collect();
    let height = slope * (2.0 / WAVES as f64).sqrt();
    Field::from_fn(grid, |x, y| {
        let wave = |&(number, (sin, cos), phase): &(f64, (f64, f64), f64)| {
            height / number * (number * (cos * x + sin * y) + phase).sin()
        };
        waves.iter().map(wave).sum()
    })
}
