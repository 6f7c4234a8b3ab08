//! Smooth shapes, each as half-space theory sees it.

use crate::error::{Result, positive};
use crate::field::Field;
use crate::grid::Grid;

/// A sphere (or two, of relative radius `1/R = 1/R_1 + 1/R_2`) on a plane, touching at the origin:
/// `h = (x^2 + y^2) / (2 R)`.
///
/// This is the osculating paraboloid, the gap of Hertz's theory: a half-space knows slopes to first
/// order only. `radius` and `h` are lengths.
///
/// # Errors
/// [`Error::NotPositive`](crate::Error::NotPositive) for the radius.
///
/// ```
/// use stickslip::{Grid, surface};
/// let ball = surface::sphere(Grid::new(3, 1, 0.1, 0.1)?, 5.0)?;
/// assert!((ball.as_slice()[0] - 0.001).abs() < 1e-16);
/// # Ok::<(), stickslip::Error>(())
/// ```
pub fn sphere(grid: Grid, radius: f64) -> Result<Field> {
    ellipsoid(grid, radius, radius)
}

/// A body of principal radii of curvature `radius_x` and `radius_y` along the axes, touching a
/// plane at the origin: `h = x^2 / (2 R_x) + y^2 / (2 R_y)`, lengths.
///
/// # Errors
/// [`Error::NotPositive`](crate::Error::NotPositive) for a radius.
pub fn ellipsoid(grid: Grid, radius_x: f64, radius_y: f64) -> Result<Field> {
    positive("radius along x", radius_x)?;
    positive("radius along y", radius_y)?;
    Ok(Field::from_fn(grid, |x, y| {
        0.5 * (x * x / radius_x + y * y / radius_y)
    }))
}
