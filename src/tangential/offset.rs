//! Offsets of a step: displacement minus motion of each cell while it sticks.

use crate::half_space::Region;
use crate::tangential::{RelativeDisplacement, TangentialIncrement, TangentialVector};

impl TangentialIncrement {
    /// Sets the offsets of a step from the offsets of the local cells.
    pub(crate) fn set_offset(&mut self, offset: &TangentialVector) {
        for axis in self.axes.iter().map(|axis| axis.index()) {
            let part = &mut self.offset[axis];
            self.pressed.region.take(&offset[axis], part);
        }
    }

    /// Moves the offsets with the particles of rolling bodies and adds their rotation.
    pub(crate) fn carry_offset(&mut self, carry: impl Fn(&mut [f64]), turned: [f64; 2]) {
        for axis in self.axes.iter().map(|axis| axis.index()) {
            let part = &mut self.offset[axis];
            carry(part);
            for offset in part {
                *offset += turned[axis];
            }
        }
    }

    /// Subtracts the surface displacement due to the growth of the pressure from the offsets, if pressure moves the
    /// surfaces. A cell that sticks resists this displacement by traction. `before` returns the previous pressure of a
    /// cell of the grid.
    pub(crate) fn draw_from(&mut self, before: impl Fn(usize) -> f64) {
        if let Some(drawing) = &mut self.drawing {
            let present = &self.pressed.pressure;
            let buffer = &mut self.linear[self.axes[0].index()];
            self.pressed.region.collect(before, buffer);
            let grown = present
                .iter()
                .zip(buffer)
                .map(|(now, before)| now - *before);
            drawing.subtract(grown, &mut self.offset);
        }
    }

    /// Sets the offsets of bodies that were apart before the step. The offset is the negated sum of the displacement
    /// due to the pressure and the displacement `relative`.
    pub(crate) fn draw(&mut self, relative: Option<&RelativeDisplacement>) {
        for offset in self.offset.iter_mut().flatten() {
            *offset = 0.0;
        }
        if let Some(drawing) = &mut self.drawing {
            drawing.subtract(self.pressed.pressure.iter().copied(), &mut self.offset);
        }
        if let Some(relative) = relative {
            let fields = relative.fields();
            self.subtract(|region, axis, buffer| region.gather(fields[axis].as_slice(), buffer));
        }
    }

    /// Subtracts the change of a relative displacement along each axis from the offsets. `change` is a function of an
    /// axis and a local cell.
    pub(crate) fn displace(&mut self, change: impl Fn(usize, usize) -> f64) {
        self.subtract(|region, axis, buffer| region.collect(|cell| change(axis, cell), buffer));
    }

    /// Subtracts the field that `write` computes for each axis from the offsets.
    fn subtract(&mut self, write: impl Fn(&Region, usize, &mut [f64])) {
        for axis in self.axes.iter().map(|axis| axis.index()) {
            let (offset, buffer) = (&mut self.offset[axis], &mut self.linear[axis]);
            write(&self.pressed.region, axis, buffer);
            for (offset, less) in offset.iter_mut().zip(buffer) {
                *offset -= *less;
            }
        }
    }
}
