//! The side of a contact at which particles enter.

use crate::tangential::Axis;

/// Side at which particles enter the contact.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum LeadingEdge {
    /// The side of the largest x (default): particles move along -x.
    #[default]
    PlusX,
    /// The side of the smallest x.
    MinusX,
    /// The side of the largest y.
    PlusY,
    /// The side of the smallest y.
    MinusY,
}

impl LeadingEdge {
    /// Returns the axis along which particles move.
    #[must_use]
    pub fn axis(self) -> Axis {
        match self {
            Self::PlusX | Self::MinusX => Axis::X,
            Self::PlusY | Self::MinusY => Axis::Y,
        }
    }

    /// Returns whether the edge is at the positive end of the axis.
    pub(crate) fn is_positive(self) -> bool {
        matches!(self, Self::PlusX | Self::PlusY)
    }
}
