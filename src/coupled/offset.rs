//! The offsets of a step: what tangential displacement less motion is in a cell while it sticks.

use crate::coupled::CoupledIncrement;
use crate::error::Result;
use crate::memory::fallible;
use crate::tangential::{PlaneVector, own_compliance, ratio_of_compliances};

impl CoupledIncrement {
    pub(super) fn offset(&self) -> [&[f64]; 2] {
        [&self.offset[0], &self.offset[1]]
    }

    /// Lets the cells that would enter the contact from a gap lag behind their motion; none without one.
    pub(crate) fn enter(&mut self, gap: Option<impl Fn(usize) -> f64>) -> Result<()> {
        self.enters = gap.is_some();
        if let Some(gap) = gap {
            let kappa = ratio_of_compliances(&self.bodies);
            fallible::resize(&mut self.closing, self.offset[0].len(), 0.0)?;
            for (i, closing) in self.closing.iter_mut().enumerate() {
                *closing = kappa * gap(i);
            }
        }
        Ok(())
    }

    /// Moves the offsets of the cells that entered back by what they have not followed of the motion.
    pub(super) fn lag_behind(&mut self) {
        if !self.enters {
            return;
        }
        let [pressure, traction @ ..] = &self.tractions;
        for (offset, traction) in self.offset.iter_mut().zip(traction) {
            for (i, closing) in self.closing.iter().enumerate() {
                if pressure[i] > 0.0 {
                    offset[i] -= closing * traction[i] / pressure[i];
                }
            }
        }
    }

    /// Writes the compliance that the cells have had of their own in the last step; of no cells where none entered.
    /// Returns whether any may have.
    pub(crate) fn write_entered(&self, entered: &mut Vec<f64>) -> bool {
        entered.clear();
        if self.enters {
            let cells = self.closing.iter().zip(&self.tractions[0]);
            entered.extend(cells.map(|(closing, pressure)| own_compliance(*closing, *pressure)));
        }
        self.enters
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
