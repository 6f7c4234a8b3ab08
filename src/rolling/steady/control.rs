//! Prescribed motions and loads of rolling bodies.

use crate::error::{Result, finite};

/// Prescribed quantity along an axis: the creepage or the force.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub enum RollingControl {
    /// Creepage: motion of body 2 over body 1 per length rolled (dimensionless), with the sign opposite to Kalker's.
    Creepage(f64),
    /// Tangential force on body 1 (a force), from which the creepage follows. The resultant of the forces along both axes must be
    /// less than the friction capacity. Without friction no force is allowed.
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

/// Prescribed rotation about the normal: the spin or the moment.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub enum SpinControl {
    /// Spin $`\varphi`$ about the origin of the grid (one over a length, positive from x to y). It is the rotation of body 2
    /// relative to body 1 per length rolled.
    Spin(f64),
    /// Moment on body 1 about the origin of the grid (a force times a length, positive from x to y). The spin follows.
    ///
    /// The moment must be between the moments that large spins of both signs cause under the prescribed creepages and
    /// forces. [`Error::BeyondFrictionMoment`](crate::Error::BeyondFrictionMoment) reports both limits. If no forces
    /// are prescribed, the largest moment is approximately the integral of $`\mu p`$ times the distance from the
    /// origin.
    ///
    /// If no force is prescribed across the rolling direction, the moment does not always increase with the spin. The moment is
    /// taken about the cell centres, whereas the spin moves the midpoints of the particle paths. Some spins then cause a moment
    /// outside the range. For contacts of five cells or more, the excess is less than a tenth of the range. Such moments are
    /// rejected because their spin is not unique. A contact of one or two cells can have the same moment at every large spin.
    Moment(f64),
}

impl From<f64> for SpinControl {
    /// Prescribes a spin.
    fn from(spin: f64) -> Self {
        Self::Spin(spin)
    }
}
