//! Quantities that are uniform or vary from cell to cell.

use crate::error::Result;
use crate::memory::fallible::TryClone;

/// Quantity with one number for all cells, or one number for each cell.
#[derive(Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub(crate) enum PerCell<C> {
    Uniform(f64),
    #[cfg_attr(feature = "serde", serde(rename = "PerCell"))]
    Cells(C),
}

impl<C> PerCell<C> {
    /// Maps the values of the cells to a different type. A uniform value is unchanged.
    pub(crate) fn map<'a, D>(&'a self, of: impl FnOnce(&'a C) -> D) -> PerCell<D> {
        match self {
            Self::Uniform(value) => PerCell::Uniform(*value),
            Self::Cells(cells) => PerCell::Cells(of(cells)),
        }
    }

    /// Maps the values of the cells like [`Self::map`], with a function that may fail.
    pub(crate) fn try_map<D>(&self, of: impl FnOnce(&C) -> Result<D>) -> Result<PerCell<D>> {
        Ok(match self {
            Self::Uniform(value) => PerCell::Uniform(*value),
            Self::Cells(cells) => PerCell::Cells(of(cells)?),
        })
    }
}

impl PerCell<&[f64]> {
    /// Returns the value of a cell, or NaN if the cell is out of range.
    #[inline]
    pub(crate) fn of(&self, cell: usize) -> f64 {
        match self {
            Self::Uniform(value) => *value,
            Self::Cells(cells) => cells.get(cell).copied().unwrap_or(f64::NAN),
        }
    }

    /// Returns whether the pressure of a cell is positive and has reached its upper limit.
    #[inline]
    pub(crate) fn are_reached(&self, cell: usize, pressure: f64) -> bool {
        pressure > 0.0 && pressure >= self.of(cell)
    }
}

/// Clones into the existing allocation.
#[expect(
    clippy::expl_impl_clone_on_copy,
    reason = "that of fields is theirs to keep, slices are copied"
)]
impl<C: Clone> Clone for PerCell<C> {
    fn clone(&self) -> Self {
        self.map(C::clone)
    }

    fn clone_from(&mut self, source: &Self) {
        match (self, source) {
            (Self::Cells(own), Self::Cells(cells)) => own.clone_from(cells),
            (own, source) => *own = source.clone(),
        }
    }
}

impl<C: Copy> Copy for PerCell<C> {}

impl<C: TryClone> TryClone for PerCell<C> {
    fn try_clone(&self) -> Result<Self> {
        self.try_map(C::try_clone)
    }

    fn has_room_for(&self, source: &Self) -> bool {
        match (self, source) {
            (Self::Cells(own), Self::Cells(cells)) => own.has_room_for(cells),
            (_, source) => matches!(source, Self::Uniform(_)),
        }
    }
}
