//! Smooth shapes, in the approximation of half-space theory.

use std::f64::consts::TAU;

use crate::error::{Error, Result, all_finite, at_least, finite, non_negative, positive};
use crate::grid::Grid;
use crate::grid::field::Field;

/// Returns the gap `h = (x^2 + y^2) / (2 R)` of a sphere that touches a plane at the origin. For two spheres,
/// `1/R = 1/R_1 + 1/R_2`.
///
/// The function returns the gap of the osculating paraboloid, as in Hertz's theory. Half-space theory is of first order in the
/// slopes. `radius` and `h` are lengths.
///
/// # Errors
/// - [`Error::NotPositive`] if the radius is not positive and finite.
///
/// ```
/// use stickslip::{Grid, surface};
/// let ball = surface::sphere(Grid::new(3, 1, 0.1, 0.1)?, 5.0)?;
/// assert!((ball.as_slice()[0] - 0.001).abs() < 1e-16);
/// # Ok::<(), stickslip::Error>(())
/// ```
pub fn sphere(grid: Grid, radius: f64) -> Result<Field> {
    positive("radius", radius)?;
    ellipsoid(grid, radius, radius)
}

/// Returns the gap `h = x^2 / (2 R_x) + y^2 / (2 R_y)` of an ellipsoid that touches a plane at the origin. `radius_x` and
/// `radius_y` are its principal radii of curvature along the axes. Radii and gap are lengths.
///
/// # Errors
/// - [`Error::NotPositive`] if a radius is not positive and finite.
pub fn ellipsoid(grid: Grid, radius_x: f64, radius_y: f64) -> Result<Field> {
    positive("radius along x", radius_x)?;
    positive("radius along y", radius_y)?;
    sampled(grid, |x, y| 0.5 * (x * x / radius_x + y * y / radius_y))
}

/// Returns the gap `h = x^2 / (2 R)` of a cylinder along y. The cylinder touches a plane along the line `x = 0`. Radius and gap
/// are lengths.
///
/// For a cylinder of a different direction use [`paraboloid`]. On a grid that is not periodic, the cylinder ends at the edges of
/// the grid and the pressure has peaks at both ends ([`Warning::ContactSpansGrid`](crate::Warning::ContactSpansGrid)). For a line
/// contact in plane strain use bodies with [`Boundary::PeriodicAlongY`](crate::Boundary::PeriodicAlongY).
///
/// # Errors
/// - [`Error::NotPositive`] if the radius is not positive and finite.
pub fn cylinder(grid: Grid, radius: f64) -> Result<Field> {
    positive("radius", radius)?;
    sampled(grid, |x, _| 0.5 * x * x / radius)
}

/// Largest negative principal curvature, as a fraction of the mean curvature, that counts as the round-off of a cylinder.
const ROUND_OFF: f64 = 1e-12;

/// Returns the gap $`h = \frac12 (\kappa_{xx} x^2 + 2 \kappa_{xy} x y + \kappa_{yy} y^2)`$ of a body that touches a plane at the
/// origin. The principal directions of the body are arbitrary.
///
/// `curvatures` are $`[\kappa_{xx}, \kappa_{xy}, \kappa_{yy}]`$ (one over lengths). Let $`\kappa_1`$ be the principal curvature
/// at the angle $`\alpha`$ from x, and $`\kappa_2`$ the principal curvature perpendicular to it. Then
///
/// ```math
/// \kappa_{xx} = \kappa_1 \cos^2\alpha + \kappa_2 \sin^2\alpha , \quad
/// \kappa_{xy} = (\kappa_1 - \kappa_2) \sin\alpha \cos\alpha , \quad
/// \kappa_{yy} = \kappa_1 \sin^2\alpha + \kappa_2 \cos^2\alpha .
/// ```
///
/// The curvatures of two bodies add up. For example, two crossed cylinders of radius `R` have the same gap as a sphere of radius
/// `R`.
///
/// # Errors
/// - [`Error::NotFinite`] if a curvature is not finite.
/// - [`Error::NegativeOrNotFinite`] if a principal curvature is negative. A saddle would penetrate the plane.
///
/// ```
/// use stickslip::{Grid, surface};
/// let grid = Grid::square(8, 1.0)?;
/// // A cylinder of radius 5 whose axis lies along the diagonal x = y.
/// let diagonal = surface::paraboloid(grid, [0.1, -0.1, 0.1])?;
/// assert_eq!(diagonal.get(6, 6), Some(0.0));
/// assert!(surface::paraboloid(grid, [0.1, 0.2, 0.1]).is_err());
/// # Ok::<(), stickslip::Error>(())
/// ```
pub fn paraboloid(grid: Grid, curvatures: [f64; 3]) -> Result<Field> {
    let [xx, xy, yy] = curvatures;
    finite("curvature xx", xx)?;
    finite("curvature xy", xy)?;
    finite("curvature yy", yy)?;
    let mean = non_negative("mean curvature", 0.5 * xx + 0.5 * yy)?;
    let smaller = mean - (0.5 * xx - 0.5 * yy).hypot(xy);
    if smaller < -ROUND_OFF * mean {
        non_negative("smaller principal curvature", smaller)?;
    }
    sampled(grid, |x, y| {
        0.5 * (xx * x * x + 2.0 * xy * x * y + yy * y * y)
    })
}

/// Returns the gap `h = slope * sqrt(x^2 + y^2)` of a cone. The tip of the cone touches a plane at the origin.
///
/// `slope` is the tangent of the angle between cone and plane (dimensionless). The gap `h` is a length.
///
/// # Errors
/// - [`Error::NotPositive`] if the slope is not positive and finite.
pub fn cone(grid: Grid, slope: f64) -> Result<Field> {
    positive("slope", slope)?;
    sampled(grid, |x, y| slope * x.hypot(y))
}

/// Returns the gap of a flat-ended cylindrical punch centred on the origin. The gap is zero in the cells whose centre is within
/// `radius` of the origin, and `recess` in the other cells (lengths).
///
/// The recess must exceed the displacements. Otherwise the body would come into contact around the punch.
///
/// # Errors
/// - [`Error::NotPositive`] if the radius or the recess is not positive and finite, or if the punch does not cover any cell
///   centre.
pub fn flat_punch(grid: Grid, radius: f64, recess: f64) -> Result<Field> {
    positive("radius", radius)?;
    positive("recess", recess)?;
    let punch = sampled(grid, |x, y| if x.hypot(y) <= radius { 0.0 } else { recess })?;
    let covered = punch.as_slice().iter().filter(|&&h| h < recess).count();
    positive("number of cells that the punch covers", covered as f64)?;
    Ok(punch)
}

/// Returns the gap $`h = A (1 - \cos(2\pi x/\lambda))`$ of straight waves with crests along y and a crest at `x = 0`. The gap is
/// zero on the crests and $`2A`$ in the troughs.
///
/// `amplitude` is $`A`$ and `wavelength` is $`\lambda`$ (lengths). This is the gap of Westergaard's problem. On a periodic
/// half-space the wavelength must divide the side of the grid. A wave of exactly two cells is only sampled at its crests and
/// troughs if the number of columns is odd. Otherwise its gap is uniform.
///
/// # Errors
/// - [`Error::NotPositive`] if the amplitude or the wavelength is not positive and finite.
/// - [`Error::BelowMinimum`] if the wavelength is shorter than two cells.
pub fn sinusoidal(grid: Grid, amplitude: f64, wavelength: f64) -> Result<Field> {
    positive("amplitude", amplitude)?;
    check_wavelength(grid, 0, "wavelength", wavelength)?;
    sampled(grid, |x, _| {
        amplitude * (1.0 - (TAU * x / wavelength).cos())
    })
}

/// Returns the gap $`h = A (1 - \cos(2\pi x/\lambda_x) \cos(2\pi y/\lambda_y))`$ of waves along both axes. A crest is at the
/// origin. The gap is zero on the crests and $`2A`$ in the troughs.
///
/// `amplitude` is $`A`$ and `wavelengths` are $`[\lambda_x, \lambda_y]`$ (lengths). Source: Johnson, Greenwood and Higginson,
/// *Int. J. Mech. Sci.* 27 (1985) 383-396, [doi:10.1016/0020-7403(85)90029-3](https://doi.org/10.1016/0020-7403(85)90029-3).
///
/// # Errors
/// - [`Error::NotPositive`] if the amplitude or a wavelength is not positive and finite.
/// - [`Error::BelowMinimum`] if a wavelength is shorter than two cells, unless the grid has only one cell along its axis.
pub fn bisinusoidal(grid: Grid, amplitude: f64, wavelengths: [f64; 2]) -> Result<Field> {
    positive("amplitude", amplitude)?;
    let [along_x, along_y] = wavelengths;
    check_wavelength(grid, 0, "wavelength along x", along_x)?;
    check_wavelength(grid, 1, "wavelength along y", along_y)?;
    sampled(grid, |x, y| {
        amplitude * (1.0 - (TAU * x / along_x).cos() * (TAU * y / along_y).cos())
    })
}

/// Checks that the cells along an axis resolve a wave. Cells longer than half a wave sample a false, longer wave.
fn check_wavelength(
    grid: Grid,
    axis: usize,
    quantity: &'static str,
    wavelength: f64,
) -> Result<()> {
    positive(quantity, wavelength)?;
    if grid.whole().size()[axis] > 1 {
        let least = 2.0 * [grid.dx(), grid.dy()][axis];
        at_least("two cells", least, quantity, wavelength)?;
    }
    Ok(())
}

/// Samples a height function at the cell centres.
fn sampled(grid: Grid, height: impl FnMut(f64, f64) -> f64) -> Result<Field> {
    let heights = Field::try_from_fn(grid, height)?;
    all_finite("height of the shape", heights.as_slice())?;
    Ok(heights)
}

/// Adds fields cell by cell. For example, the gap of a rough ball is the sum of the gap of a ball and the gap of its roughness.
/// The gap between two bodies is the sum of the gaps of both shapes.
///
/// # Errors
/// - [`Error::Length`] if there is no field.
/// - [`Error::GridMismatch`] if the fields are on different grids.
///
/// ```
/// use stickslip::{Grid, surface};
/// let grid = Grid::square(32, 2.0)?;
/// let ball = surface::sphere(grid, 10.0)?;
/// let rough = surface::SelfAffine::with_rms_height(1e-3).generate(grid)?;
/// let roughness = surface::gap_from_heights(rough.heights())?;
/// let gap = surface::sum(&[&ball, &roughness])?;
/// assert_eq!(gap.as_slice()[5], ball.as_slice()[5] + roughness.as_slice()[5]);
/// # Ok::<(), stickslip::Error>(())
/// ```
pub fn sum(fields: &[&Field]) -> Result<Field> {
    let (first, others) = fields.split_first().ok_or(Error::Length {
        quantity: "list of fields",
        expected: 1,
        found: 0,
    })?;
    let mut sum = Field::clone(first);
    for other in others {
        sum.grid().check_equal("a summand", other.grid())?;
        for (sum, term) in sum.as_mut_slice().iter_mut().zip(other.as_slice()) {
            *sum += term;
        }
    }
    Ok(sum)
}
