//! What a step of a history does to the bodies.

use crate::boundary::Boundary;
use crate::error::{Error, Result, finite, positive};
use crate::normal::NormalLoad;
use crate::tangential::Axis;

/// The normal half of a step.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub enum NormalStep {
    /// The normal force W >= 0 at the end of the step; with zero the bodies just touch, or are apart.
    Force(f64),
    /// The approach of the bodies at the end of the step, from the datum of the gap (a length).
    Approach(f64),
    /// The pressure as it is, whatever the gap has become: nothing is solved.
    Hold,
}

/// The tangential half of a step, along one axis; in the plane model each axis has its own.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub enum TangentialStep {
    /// The tangential force that body 2 exerts on body 1 at the end of the step (a force, either
    /// sign).
    Force(f64),
    /// The shift of body 2 relative to body 1 at the end of the step, since the start of the history
    /// (a length, either sign).
    Shift(f64),
    /// A machine that drags body 2 by a spring: the force is $`F = k\,(X - \delta)`$. One a million times
    /// softer than the contact in effect prescribes the force: give that instead, because slip is lost in the round-off
    /// of the stretch. Residuals are measured by the displacement of the bodies, or by the stretch of the stiffest
    /// spring where that is more.
    Spring {
        /// Where the far end of the spring is at the end of the step, since the start of the history
        /// (a length, either sign).
        position: f64,
        /// Its stiffness k (a force over a length), positive.
        stiffness: f64,
    },
    /// The shift as it is; the force follows what pressure and friction have become.
    Hold,
}

impl TangentialStep {
    /// What is prescribed along `axis`, in words and as a number; zero if held.
    fn checked(self, axis: Axis) -> Result<(&'static str, f64)> {
        let by_axis = |names: [&'static str; 2]| names[axis.index()];
        let load = by_axis(["tangential load along x", "tangential load along y"]);
        let (quantity, value) = match self {
            Self::Force(value) | Self::Shift(value) => (load, value),
            Self::Spring {
                position,
                stiffness,
            } => {
                positive("stiffness of the spring", stiffness)?;
                let ends = [
                    "position of the spring along x",
                    "position of the spring along y",
                ];
                (by_axis(ends), position)
            }
            Self::Hold => (load, 0.0),
        };
        Ok((quantity, finite(quantity, value)?))
    }
}

/// What a step does: normal load, tangential load along each axis, twist. Whatever is not named is held.
///
/// ```
/// use stickslip::Axis;
/// use stickslip::history::{LoadStep, NormalStep, TangentialStep};
/// let press = LoadStep::hold().normal(NormalStep::Force(100.0));
/// let drag = LoadStep::hold().tangential(Axis::X, TangentialStep::Shift(1e-6));
/// assert_ne!(press, drag);
/// // Both components by one name, as a load path has them.
/// assert_eq!(LoadStep::shift([1e-6, 0.0]), drag.tangential(Axis::Y, TangentialStep::Shift(0.0)));
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(default, deny_unknown_fields)
)]
#[must_use = "a load does nothing until a history takes the step"]
pub struct LoadStep {
    normal: NormalStep,
    tangential: [TangentialStep; 2],
    /// `None` leaves it as it is.
    twist: Option<f64>,
}

impl LoadStep {
    /// Everything held: pressure, shift and twist.
    pub fn hold() -> Self {
        Self {
            normal: NormalStep::Hold,
            tangential: [TangentialStep::Hold; 2],
            twist: None,
        }
    }

    /// The tangential force `[x, y]` at the end of the step, all else held. Along an axis the force across must
    /// be zero.
    ///
    /// After the gap has changed, give the normal load again in every step,
    /// [`.normal(NormalStep::Force(w))`](Self::normal): else the pressure stays that of the old gap.
    pub fn force(force: [f64; 2]) -> Self {
        Self::both(force.map(TangentialStep::Force))
    }

    /// The shift `[x, y]` at the end of the step, since the start of the history (lengths), all else held.
    /// Along an axis the shift across must be zero.
    ///
    /// After the gap has changed, give the normal load again in every step,
    /// [`.normal(NormalStep::Force(w))`](Self::normal): else the pressure stays that of the old gap.
    pub fn shift(shift: [f64; 2]) -> Self {
        Self::both(shift.map(TangentialStep::Shift))
    }

    /// Springs of one stiffness along both axes (a force over a length), whose far ends are at `[x, y]` at the end of
    /// the step, since the start of the history (lengths), all else held: see [`TangentialStep::Spring`]. Along an
    /// axis the position across must be zero.
    ///
    /// After the gap has changed, give the normal load in every step, as with [`shift`](Self::shift).
    ///
    /// ```
    /// use stickslip::history::LoadPath;
    /// use stickslip::*;
    /// let grid = Grid::square(32, 0.30e-3)?;
    /// let steel = Material::new(213e9, 0.29)?;
    /// let bodies = HalfSpace::new(grid, ElasticPair::new(steel, steel)?)?;
    /// let ball = surface::sphere(grid, 3.5e-3)?;
    /// let mut history = History::builder(&bodies, &ball, Friction::coulomb(0.5)?).build()?;
    /// let stiffness = 1e7;
    /// for &position in LoadPath::sine([5e-6, 0.0], 8)?.steps() {
    ///     let drag = LoadStep::spring(position, stiffness).normal(NormalStep::Force(100.0));
    ///     let step = history.step(&drag)?;
    ///     let stretch = position[0] - step.shift()[0];
    ///     assert!((step.force()[0] - stiffness * stretch).abs() < 1e-6);
    /// }
    /// # Ok::<(), Error>(())
    /// ```
    pub fn spring(position: [f64; 2], stiffness: f64) -> Self {
        Self::both(position.map(|position| TangentialStep::Spring {
            position,
            stiffness,
        }))
    }

    fn both(tangential: [TangentialStep; 2]) -> Self {
        Self {
            tangential,
            ..Self::hold()
        }
    }

    /// With this normal half.
    pub fn normal(mut self, normal: NormalStep) -> Self {
        self.normal = normal;
        self
    }

    /// With this tangential half along `axis`.
    pub fn tangential(mut self, axis: Axis, tangential: TangentialStep) -> Self {
        self.tangential[axis.index()] = tangential;
        self
    }

    /// With the rotation $`\varphi`$ of body 2 relative to body 1 about the origin of the grid at the end of the
    /// step, since the start of the history (radians, positive from x to y): beside the shift it moves body 2
    /// by $`(-\varphi y, \varphi x)`$. Only the plane model takes other than zero, and only on a grid that does
    /// not repeat.
    pub fn twist(mut self, twist: f64) -> Self {
        self.twist = Some(twist);
        self
    }

    /// `Ok` if a history along `axis`, or in the plane, can take the step; what pressure and friction have to
    /// say comes later.
    pub(super) fn check(&self, axis: Option<Axis>, boundary: Boundary) -> Result<()> {
        for along in [Axis::X, Axis::Y] {
            let (quantity, value) = self.along(along).checked(along)?;
            if value != 0.0 && axis.is_some_and(|axis| axis != along) {
                let remedy = match along {
                    Axis::X => "build it with .axis(Axis::X) or .lateral(Lateral::Coupled)",
                    Axis::Y => "build it with .axis(Axis::Y) or .lateral(Lateral::Coupled)",
                };
                return Err(Error::NotModelled {
                    quantity,
                    value,
                    remedy,
                });
            }
        }
        let (quantity, value) = ("twist", finite("twist", self.twist_from(0.0))?);
        let remedy = match (axis, boundary) {
            (_, Boundary::Periodic) => "a grid that repeats cannot turn, with any option",
            (Some(_), Boundary::Free) => "build it with .lateral(Lateral::Coupled)",
            (None, Boundary::Free) => return Ok(()),
        };
        if value == 0.0 {
            return Ok(());
        }
        Err(Error::NotModelled {
            quantity,
            value,
            remedy,
        })
    }

    /// What is to be solved in the normal direction, if anything.
    pub(super) fn normal_load(&self) -> Option<NormalLoad> {
        match self.normal {
            NormalStep::Force(force) => Some(NormalLoad::Force(force)),
            NormalStep::Approach(approach) => Some(NormalLoad::Approach(approach)),
            NormalStep::Hold => None,
        }
    }

    /// The twist at the end of the step, which begins at `last`.
    pub(super) fn twist_from(&self, last: f64) -> f64 {
        self.twist.unwrap_or(last)
    }

    pub(super) fn along(&self, axis: Axis) -> TangentialStep {
        self.tangential[axis.index()]
    }
}

impl Default for LoadStep {
    fn default() -> Self {
        Self::hold()
    }
}
