//! Gaps under simple shapes.

use pyo3::prelude::*;
use stickslip::surface;

use crate::argument::Object;
use crate::conversion;
use crate::field::Field;
use crate::grid::Grid;
use crate::real::Real;
use crate::work::unobserved_on;

/// Declares shapes whose parameters are numbers.
macro_rules! shapes {
    ($($(#[$doc:meta])* $shape:ident($($parameter:ident $(. $part:tt)?: $type:ty),+);)+) => {$(
        $(#[$doc])*
        #[pyfunction]
        pub(crate) fn $shape(py: Python<'_>, grid: Object<Grid>, $($parameter: $type),+) -> PyResult<Field> {
            let made = unobserved_on(py, grid.0, || surface::$shape(grid.0, $($parameter $(. $part)?),+));
            made.map(Into::into)
        }
    )+};
}

shapes! {
    /// Returns the gap under a sphere of this radius (a length): the paraboloid ``(x^2 + y^2) / (2 radius)`` of Hertz's
    /// theory. Gaps are lengths and zero where the shape touches the plane.
    sphere(radius.0: Real);
    /// Returns the gap ``x^2 / (2 radius_x) + y^2 / (2 radius_y)`` under a paraboloid with these radii of curvature
    /// (lengths).
    ellipsoid(radius_x.0: Real, radius_y.0: Real);
    /// Returns the gap ``x^2 / (2 radius)`` under a cylinder of this radius (a length) whose axis is along y.
    cylinder(radius.0: Real);
    /// Returns the gap ``(k_xx x^2 + 2 k_xy x y + k_yy y^2) / 2`` under a paraboloid with the curvatures
    /// ``(k_xx, k_xy, k_yy)`` (one over lengths). No principal curvature may be negative.
    paraboloid(curvatures.0: conversion::Curvatures);
    /// Returns the gap ``slope * r`` under a cone; the slope is the tangent of the angle between cone and plane.
    cone(slope.0: Real);
    /// Returns the gap under a flat punch of this radius: zero in cells whose centre is below the punch, and the recess
    /// in all other cells (lengths). The recess only has to be deeper than the displacements.
    flat_punch(radius.0: Real, recess.0: Real);
    /// Returns the gap ``amplitude * (1 - cos(2 pi x / wavelength))`` under straight waves (lengths), zero on their
    /// crests.
    sinusoidal(amplitude.0: Real, wavelength.0: Real);
    /// Returns the gap ``amplitude * (1 - cos(2 pi x / wavelengths[0]) * cos(2 pi y / wavelengths[1]))`` under a product
    /// of waves (lengths), zero on its crests.
    bisinusoidal(amplitude.0: Real, wavelengths.0: conversion::Wavelengths);
}
