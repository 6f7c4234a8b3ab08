//! Prescribed normal loads of problems and of steps.

use crate::cgm::Total;
use crate::error::{Error, Result, finite, has_squares, non_negative};
use crate::grid::boundary::Boundary;
use crate::grid::field::Field;
use crate::half_space::HalfSpace;
use crate::normal::Hardness;

/// Prescribed normal load of a problem, which acts on unloaded bodies: a force or an approach.
///
/// A step of a [`History`](crate::History) has a [`NormalControl`], which may also hold the pressure.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub enum NormalLoad {
    /// Normal force W >= 0, from which the approach follows. The bodies just touch at zero force.
    Force(f64),
    /// Approach delta of the bodies from the datum of the gap (a length, positive for bodies that move together). The
    /// force follows from the approach. At an approach at or below the least gap, the bodies do not touch.
    ///
    /// On a periodic grid the approach must be less than the mean gap. An approach equal to the mean gap would close
    /// the gap everywhere. On such a grid the certified error is measured against the exact contact under the computed
    /// force.
    Approach(f64),
}

/// Normal load at the end of a step of a [`History`](crate::History): a force, an approach or a fixed pressure.
///
/// ```
/// use stickslip::{Error, LoadStep, NormalControl, NormalLoad};
/// let load = NormalLoad::Force(100.0);
/// assert_eq!(NormalControl::from(load), NormalControl::Force(100.0));
/// assert_eq!(LoadStep::hold().normal(load), LoadStep::hold().normal(NormalControl::Force(100.0)));
/// assert_eq!(NormalLoad::try_from(NormalControl::Hold), Err(Error::NoPressureToHold));
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub enum NormalControl {
    /// Normal force as in [`NormalLoad::Force`].
    Force(f64),
    /// Approach as in [`NormalLoad::Approach`].
    Approach(f64),
    /// Unchanged pressure for any gap. The step does not solve for the pressure.
    Hold,
}

impl From<NormalLoad> for NormalControl {
    fn from(load: NormalLoad) -> Self {
        match load {
            NormalLoad::Force(force) => Self::Force(force),
            NormalLoad::Approach(approach) => Self::Approach(approach),
        }
    }
}

/// Returns [`Error::NoPressureToHold`] for [`NormalControl::Hold`], because a problem has no earlier pressure.
impl TryFrom<NormalControl> for NormalLoad {
    type Error = Error;

    fn try_from(control: NormalControl) -> Result<Self> {
        control.load().ok_or(Error::NoPressureToHold)
    }
}

impl NormalControl {
    /// Returns the load, or `None` for a pressure that is held.
    pub(crate) fn load(self) -> Option<NormalLoad> {
        match self {
            Self::Force(force) => Some(NormalLoad::Force(force)),
            Self::Approach(approach) => Some(NormalLoad::Approach(approach)),
            Self::Hold => None,
        }
    }
}

impl NormalLoad {
    /// Returns the datum of the gap and the prescribed total of the pressures. A datum near the contact avoids
    /// cancellation in sums of gaps.
    pub(crate) fn to_datum_and_total(self, bodies: &HalfSpace, gap: &Field) -> (f64, Total) {
        match self {
            Self::Force(force) => {
                let sum = Total::Sum(force / bodies.grid().cell_area());
                (bodies.least(gap), sum)
            }
            Self::Approach(approach) => (approach, Total::Free),
        }
    }

    /// Returns an error if the load cannot act on the gap or exceeds the hardness. Gap and hardness must have been
    /// checked.
    pub(crate) fn check(
        self,
        bodies: &HalfSpace,
        gap: &Field,
        hardness: Option<&Hardness>,
    ) -> Result<()> {
        match self {
            Self::Force(force) => {
                non_negative("normal force", force)?;
                let pressure = force / gap.grid().cell_area();
                finite("normal force divided by the cell area", pressure)?;
                let mean = force / bodies.grid().whole().area();
                check_size(force, [mean, mean * bodies.cell_compliance()])?;
            }
            Self::Approach(approach) => {
                finite("approach", approach)?;
                let mean_gap = || bodies.integral(gap) / bodies.grid().whole().area();
                if bodies.boundary() == Boundary::Periodic && approach >= mean_gap() {
                    let mean_gap = mean_gap();
                    return Err(Error::ApproachBeyondMeanGap { approach, mean_gap });
                }
                let depth = (approach - bodies.least(gap)).max(0.0);
                check_size(depth, [depth / bodies.cell_compliance(), depth])?;
            }
        }
        hardness.map_or(Ok(()), |hardness| hardness.check_load(bodies, self))
    }
}

/// Returns an error if a non-zero load causes pressures or displacements whose squares overflow or underflow.
fn check_size(load: f64, [pressure, displacement]: [f64; 2]) -> Result<()> {
    if load == 0.0 {
        return Ok(());
    }
    let remedy = "choose different units of length or pressure, or a zero load";
    has_squares("the pressure due to the normal load", pressure, remedy)?;
    let quantity = "the displacement due to the normal load";
    has_squares(quantity, displacement, remedy).map(drop)
}
