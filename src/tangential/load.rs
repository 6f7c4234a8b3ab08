//! Tangential load along each axis and about the normal.

use crate::cgm::Total;
use crate::contact::LoadIncrement;
use crate::error::{Error, Result, finite, positive};
use crate::grid::Grid;
use crate::half_space::HalfSpace;
use crate::tangential::{Axis, RigidMotion, TangentialModel};

/// Largest stretch of a spring, in sides of the grid. The force of a softer spring is lost in the round-off of the stretch, and
/// exchanged values of position and stiffness exceed this limit.
const LONGEST_SPRING: f64 = 1e6;

/// Prescribed tangential load along one axis.
///
/// A problem applies the load to bodies at rest. A step of a [`History`](crate::History) starts from the previous state
/// and reaches the load at its end.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub enum TangentialControl {
    /// Tangential force that body 2 exerts on body 1 (a force, either sign). The shift follows from the force.
    Force(f64),
    /// Shift since the unloaded state, the rigid motion of body 2 relative to body 1 far from the contact (a length,
    /// either sign). The force follows from the shift. If the bodies are loaded from rest, the force has the sign of
    /// the shift.
    ///
    /// On a periodic grid the shift is measured from the mean plane of the surface. The certified error is then
    /// measured against the exact contact under the computed force.
    Shift(f64),
    /// Spring through which a machine drags body 2. The force is $`F = k\,(X - \delta)`$, and the shift $`\delta`$
    /// follows.
    ///
    /// A spring a million times softer than the contact effectively prescribes the force. Prescribe the force directly
    /// in this case, because the slip is lost in the round-off of the stretch. Residuals are relative to the largest
    /// displacement of the bodies or to a reference stretch, whichever is larger. The reference stretch is the stretch
    /// of the stiffest spring if all tractions had the same direction.
    Spring {
        /// Position X of the far end of the spring (a length, either sign) since the unloaded state. Its distance from the shift
        /// must not exceed a million sides of the grid. Exchanged values of position and stiffness usually exceed this limit.
        position: f64,
        /// Stiffness k > 0 (a force over a length).
        stiffness: f64,
    },
    /// Unchanged shift, which is zero from rest. The force follows from the present pressure and friction.
    Hold,
}

impl TangentialControl {
    /// Returns the name and the value of the prescribed quantity along `axis`, or an error if the value is not finite.
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

    /// Returns the prescribed value. A value of zero causes no motion from rest.
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

/// Tangential load from rest: the prescribed load along x and along y, and the twist.
///
/// The scalar model ([`TangentialModel::Scalar`]) accepts a load along one axis, with zero load across it and no twist.
/// The vector model accepts any combination.
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
    /// Prescribes the tangential force `[x, y]` that body 2 exerts on body 1 (forces).
    #[must_use]
    pub fn force(force: [f64; 2]) -> Self {
        Self::of(force.map(TangentialControl::Force))
    }

    /// Prescribes the shift `[x, y]` of body 2 relative to body 1 (lengths).
    #[must_use]
    pub fn shift(shift: [f64; 2]) -> Self {
        Self::of(shift.map(TangentialControl::Shift))
    }

    /// Prescribes springs of equal stiffness (a force over a length) along both axes, with far ends at `[x, y]`
    /// (lengths).
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

    /// Sets the control along an axis.
    #[must_use]
    pub fn along(mut self, axis: Axis, control: TangentialControl) -> Self {
        self.controls[axis.index()] = control;
        self
    }

    /// Sets the rotation $`\varphi`$ of body 2 relative to body 1 about the origin of the grid (radians, positive from
    /// x to y, default 0). In addition to the shift, the rotation moves body 2 by $`(-\varphi y, \varphi x)`$. A
    /// non-zero twist needs the vector model and a grid that is not periodic.
    #[must_use]
    pub fn twist(mut self, twist: f64) -> Self {
        self.twist = twist;
        self
    }

    /// Returns the control along an axis.
    #[must_use]
    pub fn control(&self, axis: Axis) -> TangentialControl {
        self.controls[axis.index()]
    }

    /// Converts the load to the target of a history step from rest.
    pub(crate) fn demand(&self) -> TangentialTarget {
        TangentialTarget {
            controls: self.controls,
            twist: self.twist,
        }
    }

    /// Returns the axes of the tractions that a model solves for under this load.
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

/// Tangential load at the end of a step.
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

    /// Returns the change of the load from the present force and shift.
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

    /// Returns an error if a spring is stretched by more than [`LONGEST_SPRING`] at the present shift.
    fn check_springs(&self, grid: Grid, shift: [f64; 2]) -> Result<()> {
        for (control, shift) in self.controls.iter().zip(shift) {
            let TangentialControl::Spring { position, .. } = control else {
                continue;
            };
            let sides = (position - shift) / grid.whole().reference_side();
            if sides.abs() > LONGEST_SPRING {
                return Err(Error::UnsupportedByModel {
                    model: "a spring",
                    quantity: "a stretch above a million sides of the grid",
                    value: sides,
                    remedy: "check that position and stiffness are not exchanged, and check their units, or prescribe the force",
                });
            }
        }
        Ok(())
    }

    /// Returns an error if tractions along these axes cannot carry the load from a state with this shift. Pressure and friction are
    /// checked later.
    pub(crate) fn check(&self, axes: &[Axis], bodies: &HalfSpace, shift: [f64; 2]) -> Result<()> {
        for &axis in Axis::BOTH {
            let (quantity, value) = self.control(axis).checked(axis)?;
            if value != 0.0 && !axes.contains(&axis) {
                let [x, y] = self.controls;
                let is_oblique = x.value() != 0.0 && y.value() != 0.0;
                let remedy = match axis {
                    _ if is_oblique => TangentialModel::VECTOR_REMEDY,
                    Axis::X => "build the model with x as its axis, or use the vector model",
                    Axis::Y => "build the model with y as its axis, or use the vector model",
                };
                return Err(Error::UnsupportedByModel {
                    model: "the model of this contact",
                    quantity,
                    value,
                    remedy,
                });
            }
        }
        self.check_springs(bodies.grid(), shift)?;
        let (quantity, value) = ("twist", finite("twist", self.twist)?);
        let remedy = match (axes.len(), bodies.boundary().may_turn()) {
            (_, false) => "a periodic grid does not allow rotation in any model",
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

    /// Converts the load to totals of the tractions along these axes and sets the datum of the motion. `datum` is used
    /// along axes whose shift follows from a force or a spring.
    ///
    /// `sums` are the totals for the prescribed forces, or `None` if friction cannot carry any traction. The shift
    /// under a force is then undetermined and remains unchanged.
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
                    let quantity = "cell area divided by the stiffness of the spring";
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

    /// Returns the motion of body 2 before the first contact. A non-zero force causes an error, and a spring exerts no
    /// force.
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

    /// Returns the prescribed forces, zero along an axis without a prescribed force.
    pub(crate) fn force(&self) -> [f64; 2] {
        self.controls.map(|control| match control {
            TangentialControl::Force(force) => force,
            _ => 0.0,
        })
    }
}
