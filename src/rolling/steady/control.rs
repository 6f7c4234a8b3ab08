//! Motions and loads that can be prescribed of rolling bodies.

use crate::error::{Result, finite};

/// What is prescribed along an axis.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub enum RollingControl {
    /// The creepage, what body 2 moves over body 1 for each length rolled (dimensionless).
    Creepage(f64),
    /// The tangential force on body 1 (a force); the creepage follows. The forces of both axes together must be less than
    /// friction holds: without friction none is.
    Force(f64),
}

impl RollingControl {
    pub(in crate::rolling) fn check(self) -> Result<()> {
        match self {
            Self::Creepage(creepage) => finite("creepage", creepage),
            Self::Force(force) => finite("tangential force", force),
        }
        .map(|_| ())
    }
}

/// What is prescribed of the rotation about the normal.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub enum SpinControl {
    /// The spin $`\varphi`$, the rotation of body 2 relative to body 1 for each length rolled (one over a length,
    /// positive from x to y), about the origin of the grid.
    Spin(f64),
    /// The moment on body 1 about the origin of the grid (a force times a length, positive from x to y); the spin
    /// follows. It must be less than a large spin causes beside the prescribed forces; without any that is about the
    /// integral of $`\mu p`$ times the distance from the origin.
    Moment(f64),
}

impl From<f64> for SpinControl {
    /// A prescribed spin.
    fn from(spin: f64) -> Self {
        Self::Spin(spin)
    }
}
