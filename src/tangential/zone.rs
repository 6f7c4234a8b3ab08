//! What a cell does, along which axis, and what is modelled across it.

/// The state of a cell under a tangential load.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Zone {
    /// No pressure: out of contact.
    Separate,
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
    /// Its place in a pair `[x, y]`.
    #[must_use]
    pub const fn index(self) -> usize {
        match self {
            Self::X => 0,
            Self::Y => 1,
        }
    }
}

/// What becomes of the traction across a tangential load.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Lateral {
    /// Neglected, as in the paper (default): one traction, along the axis of the load.
    #[default]
    Neglected,
    /// Found with the other: slip opposes traction in direction, and loads may have any. Each product costs
    /// twice as much, and it takes two to three times as many.
    Coupled,
}
