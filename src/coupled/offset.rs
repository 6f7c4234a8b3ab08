//! Offsets of a step: tangential displacement minus motion of each cell while it sticks.

use crate::coupled::CoupledIncrement;
use crate::error::Result;
use crate::memory::fallible;
use crate::tangential::{
    EntryCompliance, TangentialVector, entry_compliance, ratio_of_compliances,
};

impl CoupledIncrement {
    pub(super) fn offset(&self) -> [&[f64]; 2] {
        [&self.offset[0], &self.offset[1]]
    }

    /// Sets the gap that cells close when they come into contact. Such cells lag behind the motion. `None` disables the
    /// lag.
    pub(crate) fn enter(&mut self, gap: Option<impl Fn(usize) -> f64>) -> Result<()> {
        self.enters = gap.is_some();
        self.closing_deviator.clear();
        if let Some(gap) = gap {
            let kappa = ratio_of_compliances(&self.bodies);
            fallible::resize(&mut self.closing, self.offset[0].len(), 0.0)?;
            for (i, closing) in self.closing.iter_mut().enumerate() {
                *closing = kappa * gap(i);
            }
        }
        Ok(())
    }

    /// Sets $`\kappa g`$ of each cell of the grid for rolling. It determines the lag of cells that come into contact
    /// behind the motion. `None` disables the lag.
    pub(crate) fn set_rolling_entry_compliance(
        &mut self,
        closing: Option<impl Fn(usize) -> EntryCompliance>,
    ) -> Result<()> {
        self.enters = closing.is_some();
        self.closing_deviator.clear();
        if let Some(closing) = closing {
            let cells = self.offset[0].len();
            fallible::resize(&mut self.closing, cells, 0.0)?;
            fallible::make_room(&mut self.closing_deviator, cells)?;
            for (i, mean) in self.closing.iter_mut().enumerate() {
                let closing = closing(i);
                *mean = closing.mean();
                self.closing_deviator.push(closing.deviator());
            }
        }
        Ok(())
    }

    /// Moves the offsets with the particles of rolling bodies and adds their rotation.
    pub(crate) fn carry_offset(&mut self, carry: impl Fn(&mut [f64]), turned: [f64; 2]) {
        for (part, turned) in self.offset.iter_mut().zip(turned) {
            carry(part);
            for offset in part {
                *offset += turned;
            }
        }
    }

    /// Subtracts the lag from the offsets of the cells that came into contact. The lag is the motion that a cell has
    /// not followed.
    pub(super) fn subtract_entry_lag(&mut self) {
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
        let [offset_x, offset_y] = &mut self.offset;
        for (i, [a, b]) in self.closing_deviator.iter().enumerate() {
            if pressure[i] > 0.0 {
                let [x, y] = [0, 1].map(|axis| traction[axis][i] / pressure[i]);
                offset_x[i] -= a * x + b * y;
                offset_y[i] -= b * x - a * y;
            }
        }
    }

    /// Writes the entry compliance of the cells in the last step to `entered`. If the lag is disabled, `entered`
    /// becomes empty. Returns whether any cell may have come into contact.
    pub(crate) fn write_entered(&self, entered: &mut Vec<f64>) -> bool {
        entered.clear();
        if self.enters {
            let cells = self.closing.iter().zip(&self.tractions[0]);
            entered.extend(cells.map(|(closing, pressure)| entry_compliance(*closing, *pressure)));
        }
        self.enters
    }

    /// Sets the offsets to zero.
    pub(super) fn clear_offset(&mut self) {
        for part in &mut self.offset {
            part.fill(0.0);
        }
    }

    /// Subtracts the change of a relative displacement along each axis from the offsets.
    pub(crate) fn displace(&mut self, change: impl Fn(usize, usize) -> f64) {
        for (axis, offset) in self.offset.iter_mut().enumerate() {
            for (cell, offset) in offset.iter_mut().enumerate() {
                *offset -= change(axis, cell);
            }
        }
    }

    /// Sets the offsets of a step.
    pub(crate) fn set_offset(&mut self, offset: &TangentialVector) {
        for (target, offset) in self.offset.iter_mut().zip(offset) {
            target.copy_from_slice(offset);
        }
    }
}
