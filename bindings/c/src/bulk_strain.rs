//! Relative displacement due to a uniform strain of the bodies.

use stickslip_rs::tangential::RelativeDisplacement;
use stickslip_rs::{Boundary, Error};

use crate::call::call_on;
use crate::error::Failure;
use crate::half_space::stickslip_half_space;
use crate::handle::reading;
use crate::pointer::cells_mut;
use crate::status::{STICKSLIP_INVALID_ARGUMENT, stickslip_status};

/// Fills along_x and along_y (lengths, count entries) with the displacement of body 1 relative to body 2 due to a uniform bulk
/// strain, a pattern for stickslip_relative_displacement. The strain is that of body 1 minus that of body 2, positive if body 1
/// is stretched; xy is half of the engineering shear strain. The displacement is zero at the origin of the grid: along_x
/// contains xx x + xy y and along_y contains xy x + yy y for a cell with the centre (x, y). Returns STICKSLIP_NOT_FINITE if a
/// component is not finite, and STICKSLIP_INVALID_ARGUMENT for a component along a periodic axis, where the displacement would
/// jump. A failure leaves both arrays unchanged.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_bulk_strain(
    half_space: *const stickslip_half_space,
    xx: f64,
    xy: f64,
    yy: f64,
    along_x: *mut f64,
    along_y: *mut f64,
    count: usize,
) -> stickslip_status {
    // SAFETY: the caller follows the rule for pointers.
    call_on(half_space, || unsafe {
        let bodies = reading(half_space)?;
        let grid = bodies.grid();
        let along_x = cells_mut("along_x", grid, along_x, count)?;
        let along_y = cells_mut("along_y", grid, along_y, count)?;
        let is_periodic_along_x = matches!(bodies.boundary(), Boundary::Periodic);
        let is_periodic_along_y = !matches!(bodies.boundary(), Boundary::NonPeriodic);
        let components = [
            ("bulk strain xx", xx, is_periodic_along_x),
            ("bulk strain xy", xy, is_periodic_along_y),
            ("bulk strain yy", yy, is_periodic_along_y),
        ];
        for (quantity, value, _) in components {
            if !value.is_finite() {
                return Err(Error::NotFinite { quantity, value }.into());
            }
        }
        for (name, value, is_periodic) in components {
            if value != 0.0 && is_periodic {
                return Err(jump(name, value));
            }
        }
        let pattern = RelativeDisplacement::bulk_strain(grid, [[xx, xy], [xy, yy]])?;
        for (out, field) in [along_x, along_y].into_iter().zip(pattern.fields()) {
            out.copy_from_slice(field.as_slice());
        }
        Ok(())
    })
}

/// Creates the failure for a component whose displacement would jump at the edge of a periodic grid.
fn jump(name: &str, value: f64) -> Failure {
    Failure::at_value(
        STICKSLIP_INVALID_ARGUMENT,
        value,
        format!(
            "{name} is {value:?}, but must be zero along a periodic axis, because its displacement would jump there: use a boundary that is not periodic along this axis, or set it to zero"
        ),
    )
}
