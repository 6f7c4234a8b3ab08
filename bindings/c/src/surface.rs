//! Gaps of smooth shapes.

use stickslip_rs::{Field, Grid, Result, surface};

use crate::call::{Outcome, call};
use crate::inputs::stickslip_grid;
use crate::pointer::{cells_mut, input};
use crate::status::stickslip_status;
use crate::threads::enter;

/// Writes a shape into an array of the caller.
///
/// # Safety
/// The caller must follow the rule for pointers in [`crate::pointer`].
pub(crate) unsafe fn shape(
    grid: *const stickslip_grid,
    make: impl FnOnce(Grid) -> Result<Field> + Send,
    (name, heights, count): (&str, *mut f64, usize),
) -> Outcome {
    // SAFETY: the caller follows the safety contract of this function.
    let grid = unsafe { input("grid", grid)? }.checked()?;
    // SAFETY: the caller follows the safety contract of this function.
    let heights = unsafe { cells_mut(name, grid, heights, count)? };
    heights.copy_from_slice(enter(grid.cells(), || make(grid))?.as_slice());
    Ok(())
}

/// Writes the gap between a sphere and a plane that touch at the origin (lengths) to gap, which has count entries.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_surface_sphere(
    grid: *const stickslip_grid,
    radius: f64,
    gap: *mut f64,
    count: usize,
) -> stickslip_status {
    // SAFETY: the caller follows the rule for pointers.
    call(|| unsafe {
        shape(
            grid,
            |grid| surface::sphere(grid, radius),
            ("gap", gap, count),
        )
    })
}

/// Writes the gap between an ellipsoid with the radii of curvature radius_x and radius_y at the origin, and a plane.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_surface_ellipsoid(
    grid: *const stickslip_grid,
    radius_x: f64,
    radius_y: f64,
    gap: *mut f64,
    count: usize,
) -> stickslip_status {
    let make = |grid| surface::ellipsoid(grid, radius_x, radius_y);
    // SAFETY: the caller follows the rule for pointers.
    call(|| unsafe { shape(grid, make, ("gap", gap, count)) })
}

/// Writes the gap between a cylinder along y and a plane.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_surface_cylinder(
    grid: *const stickslip_grid,
    radius: f64,
    gap: *mut f64,
    count: usize,
) -> stickslip_status {
    // SAFETY: the caller follows the rule for pointers.
    call(|| unsafe {
        shape(
            grid,
            |grid| surface::cylinder(grid, radius),
            ("gap", gap, count),
        )
    })
}
