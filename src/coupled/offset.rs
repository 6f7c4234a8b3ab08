//! The offsets of a step: what tangential displacement less motion is in a cell while it sticks.

use crate::coupled::CoupledIncrement;
use crate::half_space::Region;
use crate::tangential::PlaneVector;

impl CoupledIncrement {
    pub(super) fn offset(&self) -> [&[f64]; 2] {
        [&self.offset[0], &self.offset[1]]
    }

    /// Takes the offsets of the cells of a region.
    pub(crate) fn set_offset_within(&mut self, region: &Region, offset: [&[f64]; 2]) {
        for (target, offset) in self.offset.iter_mut().zip(offset) {
            region.scatter(offset, target);
        }
    }

    /// Moves the offsets back by the change of a relative displacement along each axis.
    pub(crate) fn displace(&mut self, change: impl Fn(usize, usize) -> f64) {
        for (axis, offset) in self.offset.iter_mut().enumerate() {
            for (cell, offset) in offset.iter_mut().enumerate() {
                *offset -= change(axis, cell);
            }
        }
    }

    /// Takes the offsets of a step.
    pub(crate) fn set_offset(&mut self, offset: &PlaneVector) {
        for (target, offset) in self.offset.iter_mut().zip(offset) {
            target.copy_from_slice(offset);
        }
    }
}
