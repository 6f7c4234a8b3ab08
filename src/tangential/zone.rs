//! What a cell does, and along which axis.

/// The state of a cell under a tangential load.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
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
