//! The offsets of a step: what displacement less motion is in a cell while it sticks.

use crate::half_space::Region;
use crate::tangential::{RelativeDisplacement, TangentialIncrement, TangentialVector};

impl TangentialIncrement {
    /// Takes the offsets of a step from those of the cells held here.
    pub(crate) fn set_offset(&mut self, offset: &TangentialVector) {
        for axis in self.axes.iter().map(|axis| axis.index()) {
            let part = &mut self.offset[axis];
            self.pressed.region.take(&offset[axis], part);
        }
    }

    /// Carries the offsets to where the particles of rolling bodies are, and adds how far they have turned.
    pub(crate) fn carry_offset(&mut self, carry: impl Fn(&mut [f64]), turned: [f64; 2]) {
        for axis in self.axes.iter().map(|axis| axis.index()) {
            let part = &mut self.offset[axis];
            carry(part);
            for offset in part {
                *offset += turned[axis];
            }
        }
    }

    /// Moves the offsets back by what the growth of the pressure displaces the surfaces, where pressure moves them: a cell
    /// that sticks resists it by traction. `before` is the pressure that a cell of the grid had.
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

    /// Sets the offsets to those of bodies that were apart, and are displaced by this.
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

    /// Moves the offsets back by the change of a relative displacement along each axis, in the cells held here.
    pub(crate) fn displace(&mut self, change: impl Fn(usize, usize) -> f64) {
        self.subtract(|region, axis, buffer| region.collect(|cell| change(axis, cell), buffer));
    }

    /// Takes from the offsets along each axis what is written.
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
