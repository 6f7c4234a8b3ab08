//! Zones of the cells, axes and models of a tangential contact.

/// State of a cell under a tangential load.
///
/// The value in a file (`zone as u8`) and in memory is 0 for separated, 1 for stick and 2 for slip.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[repr(u8)]
pub enum Zone {
    /// Out of contact, without pressure.
    Separated,
    /// In contact, below the friction limit, without slip.
    Stick,
    /// In contact, at the friction limit.
    Slip,
}

/// Axis of a tangential load in the scalar model.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Axis {
    /// x axis.
    X,
    /// y axis.
    Y,
}

impl Axis {
    pub(crate) const BOTH: &'static [Self] = &[Self::X, Self::Y];

    /// Returns the index of the axis in a pair `[x, y]`.
    #[must_use]
    pub const fn index(self) -> usize {
        match self {
            Self::X => 0,
            Self::Y => 1,
        }
    }

    /// Returns the axes of tractions along this axis only.
    pub(crate) const fn alone(self) -> &'static [Self] {
        match self {
            Self::X => &[Self::X],
            Self::Y => &[Self::Y],
        }
    }

    /// Returns the single axis of the tractions, or `None` if there are two.
    pub(crate) fn only(axes: &[Self]) -> Option<Self> {
        match axes {
            [axis] => Some(*axis),
            _ => None,
        }
    }
}

/// Components of the traction that a tangential problem solves for.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub enum TangentialModel {
    /// Traction along the load (default). The traction across the load is neglected, as in Wang et al. (2021).
    #[default]
    Scalar,
    /// Both components, with `hypot(q_x, q_y) <= m`. Slip is opposite to the traction, and loads may have any
    /// direction. A solve takes about three times as long as a scalar solve. The coupling of pressure and traction of
    /// dissimilar bodies is a separate choice ([`coupled`](crate::coupled)).
    Vector,
}

impl TangentialModel {
    /// Remedy in the error for a load that only the vector model supports.
    pub(crate) const VECTOR_REMEDY: &str = "use the vector model";

    /// Returns the model of tractions along these axes.
    pub(crate) fn of(axes: &[Axis]) -> Self {
        match axes {
            [_] => Self::Scalar,
            _ => Self::Vector,
        }
    }
}
