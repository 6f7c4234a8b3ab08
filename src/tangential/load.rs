//! What moves the bodies tangentially, along each axis and about the normal.

use crate::cgm::Total;
use crate::contact::LoadIncrement;
use crate::error::{Error, Result, finite, positive};
use crate::grid::boundary::Boundary;
use crate::tangential::{Axis, RigidMotion, TangentialModel};

/// What is prescribed along one axis.
///
/// A problem takes it from rest; a step of a [`History`](crate::History) reaches it at its end, from the state before.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub enum TangentialControl {
    /// The tangential force that body 2 exerts on body 1 (a force, either sign); the shift follows.
    Force(f64),
    /// The shift: the rigid motion of body 2 relative to body 1, far from the contact (a length, either sign), since
    /// the unloaded state; the force follows, of the same sign when loaded from rest. On a periodic grid the shift is
    /// measured from the mean plane of the surface, and the certified error against the exact contact under the force
    /// that was found.
    Shift(f64),
    /// A machine that drags body 2 by a spring: the force is $`F = k\,(X - \delta)`$, the shift $`\delta`$ follows.
    ///
    /// A spring a million times softer than the contact prescribes the force in effect: give that instead, because slip
    /// is lost in the round-off of the stretch. Residuals are relative to the largest displacement of the bodies, or to
    /// what the stiffest spring would stretch if all tractions pulled one way, where that is more.
    Spring {
        /// Position X of the far end of the spring (a length, either sign), since the unloaded state.
        position: f64,
        /// Stiffness k (a force over a length), positive.
        stiffness: f64,
    },
    /// The shift as it is, zero from rest; the force follows what pressure and friction have become.
    Hold,
}

impl TangentialControl {
    /// What is prescribed along `axis`, in words and as a number, if it is finite.
    pub(crate) fn checked(self, axis: Axis) -> Result<(&'static str, f64)> {
        let by_axis = |names: [&'static str; 2]| names[axis.index()];
        let load = by_axis(["tangential load along x", "tangential load along y"]);
        let (quantity, value) = match self {
            Self::Force(value) | Self::Shift(value) => (load, value),
            Self::Hold => (load, 0.0),
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
        };
        Ok((quantity, finite(quantity, value)?))
    }

    /// What is prescribed, as a number; zero moves nothing from rest.
    fn value(self) -> f64 {
        match self {
            Self::Force(value)
            | Self::Shift(value)
            | Self::Spring {
                position: value, ..
            } => value,
            Self::Hold => 0.0,
        }
    }
}

/// A tangential load from rest: what is prescribed along x and along y, and the twist.
///
/// The scalar model takes a load along one axis, zero across it and without twist
/// ([`TangentialModel::Scalar`]); the vector model takes any mixture.
///
/// ```
/// use stickslip::{Axis, TangentialControl, TangentialLoad};
/// let drag = TangentialLoad::force([20.0, 0.0]);
/// let turned = drag.along(Axis::Y, TangentialControl::Shift(0.4e-6)).twist(1e-3);
/// assert_eq!(turned.control(Axis::X), TangentialControl::Force(20.0));
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(deny_unknown_fields)
)]
pub struct TangentialLoad {
    controls: [TangentialControl; 2],
    #[cfg_attr(feature = "serde", serde(default))]
    twist: f64,
}

impl TangentialLoad {
    /// The tangential force `[x, y]` that body 2 exerts on body 1 (forces).
    #[must_use]
    pub fn force(force: [f64; 2]) -> Self {
        Self::of(force.map(TangentialControl::Force))
    }

    /// The shift `[x, y]` of body 2 relative to body 1 (lengths).
    #[must_use]
    pub fn shift(shift: [f64; 2]) -> Self {
        Self::of(shift.map(TangentialControl::Shift))
    }

    /// Springs of one stiffness (a force over a length) along both axes, whose far ends are at `[x, y]` (lengths).
    #[must_use]
    pub fn spring(position: [f64; 2], stiffness: f64) -> Self {
        Self::of(position.map(|position| TangentialControl::Spring {
            position,
            stiffness,
        }))
    }

    fn of(controls: [TangentialControl; 2]) -> Self {
        Self {
            controls,
            twist: 0.0,
        }
    }

    /// With another control along an axis.
    #[must_use]
    pub fn along(mut self, axis: Axis, control: TangentialControl) -> Self {
        self.controls[axis.index()] = control;
        self
    }

    /// With the rotation $`\varphi`$ of body 2 relative to body 1 about the origin of the grid (radians, positive from
    /// x to y): beside the shift it moves body 2 by $`(-\varphi y, \varphi x)`$. Only the vector model takes other than
    /// zero, and only on a grid that does not repeat.
    #[must_use]
    pub fn twist(mut self, twist: f64) -> Self {
        self.twist = twist;
        self
    }

    /// What is prescribed along an axis.
    #[must_use]
    pub fn control(&self, axis: Axis) -> TangentialControl {
        self.controls[axis.index()]
    }

    /// As a step of a history from rest.
    pub(crate) fn demand(&self) -> TangentialTarget {
        TangentialTarget {
            controls: self.controls,
            twist: self.twist,
        }
    }

    /// The axes of the tractions that a model finds under this load.
    pub(super) fn axes(&self, model: TangentialModel) -> Result<&'static [Axis]> {
        match (model, self.controls) {
            (TangentialModel::Vector, _) => Ok(Axis::BOTH),
            (_, [_, y]) if y.value() == 0.0 => Ok(Axis::X.alone()),
            (_, [x, _]) if x.value() == 0.0 => Ok(Axis::Y.alone()),
            (_, [x, y]) => Err(Error::ObliqueLoad {
                x: x.checked(Axis::X)?.1,
                y: y.checked(Axis::Y)?.1,
            }),
        }
    }
}

/// What a step asks of the tangential contact.
#[derive(Debug, Clone, Copy)]
pub(crate) struct TangentialTarget {
    pub(crate) controls: [TangentialControl; 2],
    /// Twist at the end of the step.
    pub(crate) twist: f64,
}

impl TangentialTarget {
    pub(crate) fn control(&self, axis: Axis) -> TangentialControl {
        self.controls[axis.index()]
    }

    /// How far it lies ahead of force and shift.
    pub(crate) fn remaining_load(&self, force: [f64; 2], shift: [f64; 2]) -> [LoadIncrement; 2] {
        [0, 1].map(|axis| match self.controls[axis] {
            TangentialControl::Hold => LoadIncrement::Nothing,
            TangentialControl::Force(end) => LoadIncrement::Total(end - force[axis]),
            TangentialControl::Shift(end) => LoadIncrement::Motion(end - shift[axis]),
            TangentialControl::Spring {
                position,
                stiffness,
            } => LoadIncrement::Spring {
                far_end: position - shift[axis] - force[axis] / stiffness,
                stiffness,
            },
        })
    }

    /// `Ok` if tractions along these axes can carry it; what pressure and friction allow is checked later.
    pub(crate) fn check(&self, axes: &[Axis], boundary: Boundary) -> Result<()> {
        for &axis in Axis::BOTH {
            let (quantity, value) = self.control(axis).checked(axis)?;
            if value != 0.0 && !axes.contains(&axis) {
                let [x, y] = self.controls;
                let is_oblique = x.value() != 0.0 && y.value() != 0.0;
                let remedy = match axis {
                    _ if is_oblique => TangentialModel::VECTOR_REMEDY,
                    Axis::X => "build it with x as its axis, or with the vector model",
                    Axis::Y => "build it with y as its axis, or with the vector model",
                };
                return Err(Error::UnsupportedByModel {
                    model: "the model of this contact",
                    quantity,
                    value,
                    remedy,
                });
            }
        }
        let (quantity, value) = ("twist", finite("twist", self.twist)?);
        let remedy = match (axes.len(), boundary.may_turn()) {
            (_, false) => "a grid that repeats cannot turn, with any option",
            (1, true) => TangentialModel::VECTOR_REMEDY,
            (_, true) => return Ok(()),
        };
        if value == 0.0 {
            return Ok(());
        }
        Err(Error::UnsupportedByModel {
            model: "the model of this contact",
            quantity,
            value,
            remedy,
        })
    }

    /// What is prescribed of the sums of the tractions along these axes; the motion becomes the one that they are measured
    /// from, at `datum` where the shift follows. `sums` are those of the forces, none where nothing can be carried: the
    /// shift then is free, and stays.
    pub(crate) fn compute_totals(
        &self,
        axes: &[Axis],
        sums: Option<[f64; 2]>,
        (datum, cell_area): ([f64; 2], f64),
        motion: &mut RigidMotion,
    ) -> Result<[Total; 2]> {
        let mut totals = [Total::Free; 2];
        for &axis in axes {
            let component = axis.index();
            let (shift, total) = (&mut motion.shift[component], &mut totals[component]);
            match (self.control(axis), sums) {
                (TangentialControl::Shift(prescribed), _) => *shift = prescribed,
                (TangentialControl::Force(_), Some(sums)) => {
                    (*shift, *total) = (datum[component], Total::Sum(sums[component]));
                }
                (TangentialControl::Force(_), None) | (TangentialControl::Hold, _) => {}
                (
                    TangentialControl::Spring {
                        position,
                        stiffness,
                    },
                    _,
                ) => {
                    let quantity = "cell area over the stiffness of the spring";
                    *shift = datum[component];
                    *total = Total::Spring {
                        far_end: position - datum[component],
                        compliance: finite(quantity, cell_area / stiffness)?,
                    };
                }
            }
        }
        Ok(totals)
    }

    /// The motion of body 2 before anything has touched: no force can act, and a spring is slack.
    pub(crate) fn without_contact(
        &self,
        axes: &[Axis],
        before: RigidMotion,
    ) -> Result<RigidMotion> {
        let mut motion = RigidMotion {
            twist: self.twist,
            ..before
        };
        for &axis in axes {
            let shift = &mut motion.shift[axis.index()];
            *shift = match self.control(axis) {
                TangentialControl::Force(force) if force != 0.0 => {
                    return Err(Error::EmptyContact);
                }
                TangentialControl::Force(_) | TangentialControl::Hold => *shift,
                TangentialControl::Shift(shift) => shift,
                TangentialControl::Spring { position, .. } => position,
            };
        }
        Ok(motion)
    }

    /// The prescribed forces, zero where none is.
    pub(crate) fn force(&self) -> [f64; 2] {
        self.controls.map(|control| match control {
            TangentialControl::Force(force) => force,
            _ => 0.0,
        })
    }
}
