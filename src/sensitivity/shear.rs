//! Tangential loads of sensitivities, and fields on regions.

use crate::cgm::{Total, reduce};
use crate::error::Result;
use crate::grid::field::Field;
use crate::half_space::{HalfSpace, Region};
use crate::memory::fallible;
use crate::numerics::cell_vector::dot;
use crate::sensitivity::functional::pair_at;
use crate::tangential::{RigidMotion, TangentialControl, centre};

/// Returns the total of the tractions along an axis. Its prescribed value has no effect on the linear problem.
pub(super) fn total_of(bodies: &HalfSpace, control: TangentialControl) -> Total {
    match control {
        TangentialControl::Force(_) => Total::Sum(0.0),
        TangentialControl::Spring { stiffness, .. } => Total::Spring {
            far_end: 0.0,
            compliance: bodies.grid().cell_area() / stiffness,
        },
        TangentialControl::Shift(_) | TangentialControl::Hold => Total::Free,
    }
}

/// Returns the derivative with respect to the prescribed value of a control. `load` is the derivative with respect to the sum of
/// tractions, the motion or the far end of the spring.
pub(super) fn by_control(bodies: &HalfSpace, control: TangentialControl, load: f64) -> Option<f64> {
    match control {
        TangentialControl::Force(_) => Some(load / bodies.grid().cell_area()),
        TangentialControl::Shift(_) | TangentialControl::Spring { .. } => Some(load),
        TangentialControl::Hold => None,
    }
}

/// Returns the derivative with respect to the twist from the multipliers of the tangential displacements on the grid.
pub(super) fn by_twist(bodies: &HalfSpace, multipliers: &[Field; 2]) -> f64 {
    let turn = RigidMotion {
        twist: 1.0,
        ..RigidMotion::default()
    };
    let multipliers = multipliers.each_ref().map(Field::as_slice);
    reduce::sum(&bodies.grid_layout(), |i| {
        dot(pair_at(&multipliers, i), turn.at(centre(bodies.grid(), i)))
    })
}

/// Returns the values of a region from the local cells of the grid. An empty slice contains zeros.
pub(super) fn on_region(region: &Region, whole: &[f64]) -> Result<Vec<f64>> {
    let mut part = fallible::zeros(region.cells())?;
    if !whole.is_empty() {
        region.collect(|i| whole[i], &mut part);
    }
    Ok(part)
}

/// Returns the values of a region as a field that is zero in other cells.
pub(super) fn on_grid(bodies: &HalfSpace, region: &Region, part: &[f64]) -> Result<Field> {
    let mut whole = Field::try_zeros(bodies.grid())?;
    region.scatter(part, whole.as_mut_slice());
    Ok(whole)
}
