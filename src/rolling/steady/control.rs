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
    /// follows.
    ///
    /// It must lie between the moments that large spins of both signs cause next to the prescribed creepages and forces.
    /// [`Error::BeyondFrictionMoment`](crate::Error::BeyondFrictionMoment) states both. Next to no forces the greatest is
    /// about the integral of $`\mu p`$ times the distance from the origin.
    ///
    /// The moment need not rise with the spin if no force is prescribed across the rolling direction: the spin moves the
    /// middles of paths, and the moment is about the centres of cells. Some spins then cause a moment outside the range,
    /// by less than a tenth of the range for contacts of five cells or more. Such moments are rejected, because they have
    /// no unique spin. A contact of one or two cells can have the same moment at every large spin.
    Moment(f64),
}

impl From<f64> for SpinControl {
    /// A prescribed spin.
    fn from(spin: f64) -> Self {
        Self::Spin(spin)
    }
}
