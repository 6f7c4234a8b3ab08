//! What a step of a history does to the bodies.

use crate::history::{Rolling, State};
use crate::normal::NormalControl;
use crate::tangential::{Axis, TangentialControl, TangentialLoad, TangentialTarget};

/// What a step does: normal load, tangential load along each axis, twist, relative displacement, rolling. Whatever is not
/// named is held.
///
/// ```
/// use stickslip::{Axis, LoadStep, NormalControl, TangentialControl};
/// let press = LoadStep::hold().normal(NormalControl::Force(100.0));
/// let drag = LoadStep::hold().tangential(Axis::X, TangentialControl::Shift(1e-6));
/// assert_ne!(press, drag);
/// // Both components by one name, as a load path has them.
/// assert_eq!(LoadStep::shift([1e-6, 0.0]), drag.tangential(Axis::Y, TangentialControl::Shift(0.0)));
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(default, deny_unknown_fields)
)]
#[must_use = "a load does nothing until a history takes the step"]
pub struct LoadStep {
    normal: NormalControl,
    tangential: [TangentialControl; 2],
    /// `None` leaves it as it is.
    twist: Option<f64>,
    /// `None` leaves it as it is.
    relative_displacement: Option<f64>,
    /// `None` stays where it is.
    rolling: Option<Rolling>,
}

impl LoadStep {
    /// Everything held: pressure, shift and twist. The shift is held, not the tangential force: that falls where a lighter
    /// pressure or less friction cannot carry it ([`Warning::HeldShiftLostForce`](crate::Warning::HeldShiftLostForce)).
    pub fn hold() -> Self {
        Self {
            normal: NormalControl::Hold,
            tangential: [TangentialControl::Hold; 2],
            twist: None,
            relative_displacement: None,
            rolling: None,
        }
    }

    /// The tangential force `[x, y]` at the end of the step, all else held. Along an axis the force across must
    /// be zero.
    ///
    /// After the gap has changed, give the normal load again in every step,
    /// [`.normal(NormalControl::Force(w))`](Self::normal): else the pressure stays that of the old gap.
    pub fn force(force: [f64; 2]) -> Self {
        Self::both(force.map(TangentialControl::Force))
    }

    /// The shift `[x, y]` at the end of the step, since the start of the history (lengths), all else held.
    /// Along an axis the shift across must be zero.
    ///
    /// After the gap has changed, give the normal load again in every step,
    /// [`.normal(NormalControl::Force(w))`](Self::normal): else the pressure stays that of the old gap.
    pub fn shift(shift: [f64; 2]) -> Self {
        Self::both(shift.map(TangentialControl::Shift))
    }

    /// Springs of one stiffness along both axes (a force over a length), whose far ends are at `[x, y]` at the end of
    /// the step, since the start of the history (lengths), all else held: see [`TangentialControl::Spring`]. Along an
    /// axis the position across must be zero.
    ///
    /// After the gap has changed, give the normal load in every step, as with [`shift`](Self::shift).
    ///
    /// A later step must name the spring again: one that does not holds the shift, not the far end.
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
    ///     let drag = LoadStep::spring(position, stiffness).normal(NormalControl::Force(100.0));
    ///     let step = history.step(&drag)?;
    ///     let stretch = position[0] - step.shift()[0];
    ///     assert!((step.tangential_force()[0] - stiffness * stretch).abs() < 1e-6);
    /// }
    /// # Ok::<(), Error>(())
    /// ```
    pub fn spring(position: [f64; 2], stiffness: f64) -> Self {
        Self::both(position.map(|position| TangentialControl::Spring {
            position,
            stiffness,
        }))
    }

    fn both(tangential: [TangentialControl; 2]) -> Self {
        Self {
            tangential,
            ..Self::hold()
        }
    }

    /// With this normal half.
    pub fn normal(mut self, normal: NormalControl) -> Self {
        self.normal = normal;
        self
    }

    /// With this tangential half along `axis`.
    pub fn tangential(mut self, axis: Axis, tangential: TangentialControl) -> Self {
        self.tangential[axis.index()] = tangential;
        self
    }

    /// With the rotation $`\varphi`$ of body 2 relative to body 1 about the origin of the grid at the end of the
    /// step, since the start of the history (radians, positive from x to y): beside the shift it moves body 2
    /// by $`(-\varphi y, \varphi x)`$. Only the vector model takes other than zero, and only on a grid that does
    /// not repeat.
    pub fn twist(mut self, twist: f64) -> Self {
        self.twist = Some(twist);
        self
    }

    /// With this amount of the [relative displacement](crate::history::HistoryBuilder::relative_displacement) at the end of
    /// the step, as a multiple of the pattern of the history, since its start: the bulk stress of a
    /// specimen, for example, if that was built for one of 1.
    pub fn relative_displacement(mut self, amount: f64) -> Self {
        self.relative_displacement = Some(amount);
        self
    }

    /// With rolling: the memory of the particles moves through the contact, and body 2 creeps over body 1 on the way, as
    /// [`Rolling`] says. Along an axis on which the step names a force the creepage follows; it names no shift, no spring
    /// and no twist. Normal load, gap and friction may change in the same step.
    pub fn roll(mut self, rolling: Rolling) -> Self {
        self.rolling = Some(rolling);
        self
    }

    /// The step to a part of this one, in `[0, 1]`: what is prescribed has come that part of its way from the state.
    pub(super) fn part(&self, state: &State, part: f64) -> Self {
        let between = |start: f64, end: f64| {
            if part < 1.0 {
                start + part * (end - start)
            } else {
                end
            }
        };
        let along = |axis: usize| {
            let (shift, force) = (state.shift()[axis], state.tangential_force()[axis]);
            match self.tangential[axis] {
                TangentialControl::Force(end) => TangentialControl::Force(between(force, end)),
                TangentialControl::Shift(end) => TangentialControl::Shift(between(shift, end)),
                TangentialControl::Hold => TangentialControl::Hold,
                TangentialControl::Spring {
                    position,
                    stiffness,
                } => TangentialControl::Spring {
                    position: between(shift + force / stiffness, position),
                    stiffness,
                },
            }
        };
        Self {
            normal: match self.normal {
                NormalControl::Force(end) => {
                    NormalControl::Force(between(state.normal().force(), end))
                }
                NormalControl::Approach(end) => {
                    NormalControl::Approach(between(state.approach(), end))
                }
                NormalControl::Hold => NormalControl::Hold,
            },
            tangential: [along(0), along(1)],
            twist: self.twist.map(|end| between(state.twist(), end)),
            relative_displacement: self.relative_displacement.map(|end| {
                let reached = state
                    .relative
                    .as_ref()
                    .map_or(0.0, |relative| relative.amount);
                between(reached, end)
            }),
            rolling: self.rolling,
        }
    }

    /// What is prescribed in the normal direction.
    pub(super) fn normal_control(&self) -> NormalControl {
        self.normal
    }

    /// How much of the relative displacement is prescribed, if it is.
    pub(super) fn relative_amount(&self) -> Option<f64> {
        self.relative_displacement
    }

    /// How the bodies roll, if they do.
    pub(super) fn rolling(&self) -> Option<&Rolling> {
        self.rolling.as_ref()
    }

    /// Whether the shift is held along both axes, and only the normal load may change.
    pub(super) fn holds_shift(&self) -> bool {
        self.tangential == [TangentialControl::Hold; 2]
            && self.twist.is_none()
            && self.relative_displacement.is_none()
            && self.rolling.is_none()
    }

    /// Whether a twist is prescribed.
    pub(super) fn names_twist(&self) -> bool {
        self.twist.is_some()
    }

    /// What the step asks of the tangential contact, with the twist from the `last`.
    pub(super) fn demand(&self, last: f64) -> TangentialTarget {
        TangentialTarget {
            controls: self.tangential,
            twist: self.twist.unwrap_or(last),
        }
    }
}

/// The tangential half alone, with the twist of the load, zero if it has none; the pressure is held.
impl From<TangentialLoad> for LoadStep {
    fn from(load: TangentialLoad) -> Self {
        let demand = load.demand();
        Self {
            twist: Some(demand.twist),
            ..Self::both(demand.controls)
        }
    }
}

impl Default for LoadStep {
    fn default() -> Self {
        Self::hold()
    }
}
