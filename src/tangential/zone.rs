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
    /// Neglected, as in the paper (default): only the traction along the load is found. These pages call it the scalar
    /// model.
    #[default]
    Neglected,
    /// Both are found, within `hypot(q_x, q_y) <= m`: slip opposes traction in direction, and loads may have any. These
    /// pages call it the plane model: two components in the plane of the contact, not plane strain. It takes about three
    /// times the time. The coupling of pressure and shear that dissimilar bodies have is another matter, see
    /// [`neglect_coupling`](crate::tangential::TangentialProblemBuilder::neglect_coupling).
    Coupled,
}
