//! What a cell does, along which axis, and which tractions a model has.

/// The state of a cell under a tangential load.
///
/// As a number for a file (`zone as u8`), and as a byte in memory: 0 separated, 1 stick, 2 slip.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[repr(u8)]
pub enum Zone {
    /// No pressure: out of contact.
    Separated,
    /// In contact, below the friction limit, without slip.
    Stick,
    /// In contact, at the friction limit.
    Slip,
}

/// The axis of a tangential load in the scalar model.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Axis {
    /// Along x.
    X,
    /// Along y.
    Y,
}

impl Axis {
    pub(crate) const BOTH: &'static [Self] = &[Self::X, Self::Y];

    /// Its place in a pair `[x, y]`.
    #[must_use]
    pub const fn index(self) -> usize {
        match self {
            Self::X => 0,
            Self::Y => 1,
        }
    }

    /// The axes of tractions along this one alone.
    pub(crate) const fn alone(self) -> &'static [Self] {
        match self {
            Self::X => &[Self::X],
            Self::Y => &[Self::Y],
        }
    }

    /// The one axis of the tractions, if there is one.
    pub(crate) fn only(axes: &[Self]) -> Option<Self> {
        match axes {
            [axis] => Some(*axis),
            _ => None,
        }
    }
}

/// Which tractions are found under a tangential load.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub enum TangentialModel {
    /// The traction along the load alone, as in the paper (default); the traction across it is neglected.
    #[default]
    Scalar,
    /// Both components, within `hypot(q_x, q_y) <= m`: slip opposes traction in direction, and loads may have any.
    /// It takes about three times the time. The coupling of pressure and traction that dissimilar bodies have is another
    /// matter, see [`coupled`](crate::coupled).
    Vector,
}

impl TangentialModel {
    /// What to do about a load that only the vector model has.
    pub(crate) const VECTOR_REMEDY: &str = "build it with the vector model";

    /// The model of tractions along these axes.
    pub(crate) fn of(axes: &[Axis]) -> Self {
        match axes {
            [_] => Self::Scalar,
            _ => Self::Vector,
        }
    }
}
