//! Load prescribed in one step of a history.

use crate::history::{Rolling, State};
use crate::normal::NormalControl;
use crate::tangential::{Axis, TangentialControl, TangentialLoad, TangentialTarget};

/// Load of a step: normal load, tangential load along each axis, twist, relative displacement and rolling. Every
/// quantity that is not prescribed is held.
///
/// ```
/// use stickslip::{Axis, LoadStep, NormalControl, TangentialControl};
/// let press = LoadStep::hold().normal(NormalControl::Force(100.0));
/// let drag = LoadStep::hold().tangential(Axis::X, TangentialControl::Shift(1e-6));
/// assert_ne!(press, drag);
/// // A load path prescribes both components in one call.
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
    /// Twist at the end of the step, or `None` if the twist is held.
    twist: Option<f64>,
    /// Amount of the relative displacement at the end of the step, or `None` if the amount is held.
    relative_displacement: Option<f64>,
    /// Rolling of the step, or `None` for a step that does not roll.
    rolling: Option<Rolling>,
}

impl LoadStep {
    /// Holds pressure, shift and twist. The tangential force is not held. Under a lower pressure or a lower coefficient,
    /// cells at the edge of the contact slip and the force decreases. A loss of more than half of the force, in one step
    /// or in several, is a warning ([`Warning::HeldShiftLostForce`](crate::Warning::HeldShiftLostForce)).
    pub fn hold() -> Self {
        Self {
            normal: NormalControl::Hold,
            tangential: [TangentialControl::Hold; 2],
            twist: None,
            relative_displacement: None,
            rolling: None,
        }
    }

    /// Prescribes the tangential force `[x, y]` at the end of the step and holds the other quantities. In the scalar
    /// model the force across the axis must be zero.
    ///
    /// After a change of the gap, prescribe the normal load again in every step with
    /// [`.normal(NormalControl::Force(w))`](Self::normal). Otherwise the pressure of the old gap is held.
    pub fn force(force: [f64; 2]) -> Self {
        Self::both(force.map(TangentialControl::Force))
    }

    /// Prescribes the shift `[x, y]` at the end of the step (lengths since the start of the history) and holds the
    /// other quantities. In the scalar model the shift across the axis must be zero.
    ///
    /// After a change of the gap, prescribe the normal load again in every step with
    /// [`.normal(NormalControl::Force(w))`](Self::normal). Otherwise the pressure of the old gap is held.
    pub fn shift(shift: [f64; 2]) -> Self {
        Self::both(shift.map(TangentialControl::Shift))
    }

    /// Prescribes springs of equal stiffness (a force over a length) along both axes and holds the other quantities. At
    /// the end of the step the far ends are at `[x, y]` (lengths since the start of the history). See
    /// [`TangentialControl::Spring`]. In the scalar model the position across the axis must be zero.
    ///
    /// After a change of the gap, prescribe the normal load in every step, as with [`shift`](Self::shift).
    ///
    /// A later step must prescribe the spring again. A step without a spring holds the shift, not the far end.
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

    /// Sets the normal load.
    pub fn normal(mut self, normal: impl Into<NormalControl>) -> Self {
        self.normal = normal.into();
        self
    }

    /// Sets the tangential load along `axis`.
    pub fn tangential(mut self, axis: Axis, tangential: TangentialControl) -> Self {
        self.tangential[axis.index()] = tangential;
        self
    }

    /// Sets the rotation $`\varphi`$ of body 2 relative to body 1 about the origin of the grid (radians, positive from
    /// x to y). The rotation at the end of the step is measured since the start of the history. In addition to the
    /// shift, the rotation moves body 2 by $`(-\varphi y, \varphi x)`$. A non-zero twist requires the vector model and
    /// a grid that is not periodic.
    pub fn twist(mut self, twist: f64) -> Self {
        self.twist = Some(twist);
        self
    }

    /// Sets the amount of the [relative displacement](crate::history::HistoryBuilder::relative_displacement) at the end
    /// of the step, as a multiple of the pattern of the history. If the pattern belongs to a unit bulk stress, for
    /// example, the amount is the bulk stress of the specimen. Later steps hold the amount. Before the first such step the amount
    /// is zero, and a step with a tangential load has the warning
    /// [`UnusedRelativeDisplacement`](crate::Warning::UnusedRelativeDisplacement).
    pub fn relative_displacement(mut self, amount: f64) -> Self {
        self.relative_displacement = Some(amount);
        self
    }

    /// Sets the rolling of the step. The memory of the particles moves through the contact, and body 2 creeps over body
    /// 1, as [`Rolling`] describes. If the step prescribes a force along an axis, the creepage along this axis follows.
    /// A rolled step cannot prescribe a shift, a spring or a twist. Normal load, gap and friction may change in the
    /// same step.
    pub fn roll(mut self, rolling: Rolling) -> Self {
        self.rolling = Some(rolling);
        self
    }

    /// Returns the step that ends at a fraction of this step, in `[0, 1]`. Each prescribed quantity is interpolated
    /// between its value in the state and its value at the end.
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

    /// Returns the prescribed normal load.
    pub(crate) fn normal_control(&self) -> NormalControl {
        self.normal
    }

    /// Returns the prescribed amount of the relative displacement, or `None` if the amount is held.
    pub(super) fn relative_amount(&self) -> Option<f64> {
        self.relative_displacement
    }

    /// Returns the rolling of the step, or `None` if the step does not roll.
    pub(crate) fn rolling(&self) -> Option<&Rolling> {
        self.rolling.as_ref()
    }

    /// Returns whether the shift is held along each axis. A twist, a relative displacement and rolling change the force
    /// along both axes, so that neither counts as held.
    pub(super) fn held_axes(&self) -> [bool; 2] {
        let is_still =
            self.twist.is_none() && self.relative_displacement.is_none() && self.rolling.is_none();
        self.tangential
            .map(|control| is_still && control == TangentialControl::Hold)
    }

    /// Returns whether a tangential load or a twist is prescribed.
    pub(super) fn prescribes_shear(&self) -> bool {
        self.twist.is_some() || self.tangential != [TangentialControl::Hold; 2]
    }

    /// Returns whether a twist is prescribed.
    pub(crate) fn names_twist(&self) -> bool {
        self.twist.is_some()
    }

    /// Returns the tangential load. If the step does not prescribe a twist, the load has the twist `last`.
    pub(crate) fn demand(&self, last: f64) -> TangentialTarget {
        TangentialTarget {
            controls: self.tangential,
            twist: self.twist.unwrap_or(last),
        }
    }
}

/// Converts a tangential load to a step that holds the pressure. The twist of the step is the twist of the load, zero
/// by default.
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
