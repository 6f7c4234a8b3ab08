//! The side of a contact on which rolling bodies meet.

use crate::tangential::Axis;

/// Where particles enter the contact.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum LeadingEdge {
    /// At the largest x: particles move along -x (the default).
    #[default]
    PlusX,
    /// At the smallest x.
    MinusX,
    /// At the largest y.
    PlusY,
    /// At the smallest y.
    MinusY,
}

impl LeadingEdge {
    /// The axis that particles move along.
    #[must_use]
    pub fn axis(self) -> Axis {
        match self {
            Self::PlusX | Self::MinusX => Axis::X,
            Self::PlusY | Self::MinusY => Axis::Y,
        }
    }

    /// Whether it lies at the positive end of the axis.
    pub(crate) fn is_positive(self) -> bool {
        matches!(self, Self::PlusX | Self::PlusY)
    }
}
