//! Offsets of a step: displacement minus motion of each cell while it sticks.

use crate::error::Result;
use crate::half_space::Region;
use crate::memory::fallible::{self, try_each};
use crate::numerics::cell_vector::slices;
use crate::tangential::{Axis, EntryCompliances, TangentialVector, zeros};

/// Offsets of the cells of a region in one step, and the entry compliances of the cells that come into contact.
#[derive(Debug, Clone)]
pub(crate) struct Offsets {
    axes: &'static [Axis],
    /// Displacement minus motion of each cell while it sticks.
    pub(crate) cells: TangentialVector,
    pub(crate) entry: EntryCompliances,
}

impl Offsets {
    /// Creates zero offsets along these axes.
    pub(crate) fn new(axes: &'static [Axis], cells: usize) -> Result<Self> {
        Ok(Self {
            axes,
            cells: zeros(axes, cells)?,
            entry: EntryCompliances::default(),
        })
    }

    /// Returns the axes of the tractions.
    pub(crate) fn axes(&self) -> &'static [Axis] {
        self.axes
    }

    /// Returns the offsets of the cells.
    pub(crate) fn slices(&self) -> [&[f64]; 2] {
        slices(&self.cells)
    }

    /// Returns the offsets on coarser cells, from a function that coarsens a field.
    pub(crate) fn coarsened(&self, coarsened: impl Fn(&[f64]) -> Result<Vec<f64>>) -> Result<Self> {
        let EntryCompliances {
            mean,
            deviator,
            is_active,
        } = &self.entry;
        let component = |part: usize| {
            let values = deviator.iter().map(|deviator| deviator[part]);
            coarsened(&fallible::collected(deviator.len(), values)?)
        };
        let mut entry = EntryCompliances::default();
        if *is_active {
            (entry.mean, entry.is_active) = (coarsened(mean)?, true);
        }
        if !deviator.is_empty() {
            let [a, b] = try_each(component)?;
            let parts = a.iter().zip(&b).map(|(a, b)| [*a, *b]);
            entry.deviator = fallible::collected(a.len(), parts)?;
        }
        Ok(Self {
            axes: self.axes,
            cells: try_each(|axis| coarsened(&self.cells[axis]))?,
            entry,
        })
    }

    /// Sets the offsets to zero.
    pub(crate) fn reset(&mut self) {
        self.cells
            .iter_mut()
            .flatten()
            .for_each(|offset| *offset = 0.0);
    }

    /// Sets the offsets of a step from the offsets of the local cells.
    pub(crate) fn set(&mut self, region: &Region, offset: &TangentialVector) {
        for axis in self.axes.iter().map(|axis| axis.index()) {
            region.take(&offset[axis], &mut self.cells[axis]);
        }
    }

    /// Subtracts the change of a relative displacement along each axis from the offsets. `change` is a function of an
    /// axis and a local cell.
    pub(crate) fn displace(&mut self, region: &Region, change: impl Fn(usize, usize) -> f64) {
        for axis in self.axes.iter().map(|axis| axis.index()) {
            let offset = &mut self.cells[axis];
            let change = region.held().indices().map(|cell| change(axis, cell));
            if region.is_moved() {
                let change: Vec<f64> = change.collect();
                subtract(offset, region.taken(&change).iter().copied());
            } else {
                subtract(offset, change);
            }
        }
    }

    /// Subtracts the lag of the cells that came into contact, the motion that they have not followed. `lag` is a function
    /// of a cell.
    pub(crate) fn subtract_lag(&mut self, lag: impl Fn(usize, &EntryCompliances) -> [f64; 2]) {
        for cell in 0..self.entry.mean.len() {
            let lag = lag(cell, &self.entry);
            for axis in self.axes.iter().map(|axis| axis.index()) {
                self.cells[axis][cell] -= lag[axis];
            }
        }
    }
}

/// Moves offsets with the particles of rolling bodies and adds their rotation.
pub(crate) fn carry_offsets(
    offsets: &mut TangentialVector,
    carry: impl Fn(&mut [f64]),
    turned: [f64; 2],
) {
    for (part, turned) in offsets.iter_mut().zip(turned) {
        carry(part);
        for offset in part {
            *offset += turned;
        }
    }
}

/// Subtracts values from the offsets of the cells along an axis.
fn subtract(offset: &mut [f64], values: impl Iterator<Item = f64>) {
    for (offset, value) in offset.iter_mut().zip(values) {
        *offset -= value;
    }
}
