//! Loads: plain structs. A load whose members are all zero holds its quantities.

use stickslip_rs::history::Rolling;
use stickslip_rs::{Axis, LoadStep, NormalControl, NormalLoad, TangentialControl, TangentialLoad};

use crate::call::Outcome;
use crate::error::Failure;
use crate::reserved::known;
use crate::rolling::{STICKSLIP_PLUS_X, leading_edge};

/// Holds the pressure or the shift. A held shift does not hold the tangential force.
pub const STICKSLIP_HOLD: i32 = 0;
/// Prescribes a force.
pub const STICKSLIP_FORCE: i32 = 1;
/// Prescribes the approach of the bodies (a length), measured from the datum of the gap.
pub const STICKSLIP_APPROACH: i32 = 2;
/// Prescribes the shift, the rigid motion of body 2 relative to body 1 far from the contact since the unloaded state (a
/// length): the relative rigid tangential displacement.
pub const STICKSLIP_SHIFT: i32 = 3;
/// Prescribes a spring that drags body 2: the force is stiffness * (value - shift). The stretch, value - shift, must not exceed a
/// million sides of the grid.
pub const STICKSLIP_SPRING: i32 = 4;

/// Normal load.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct stickslip_normal_load {
    /// Kind of load: STICKSLIP_HOLD, STICKSLIP_FORCE or STICKSLIP_APPROACH.
    pub kind: i32,
    /// Force (zero or positive) or approach (a length, positive if the bodies move towards each other); zero for
    /// STICKSLIP_HOLD.
    pub value: f64,
}

impl stickslip_normal_load {
    pub(crate) fn checked(&self) -> Outcome<NormalControl> {
        match self.kind {
            STICKSLIP_HOLD => {
                Failure::if_given(
                    "the value of the normal load",
                    self.value,
                    "its kind is STICKSLIP_HOLD: set kind to STICKSLIP_FORCE or STICKSLIP_APPROACH, or value to zero",
                )?;
                Ok(NormalControl::Hold)
            }
            STICKSLIP_FORCE => Ok(NormalControl::Force(self.value)),
            STICKSLIP_APPROACH => Ok(NormalControl::Approach(self.value)),
            other => Err(Failure::option(
                "kind of normal load",
                other,
                "STICKSLIP_HOLD, STICKSLIP_FORCE or STICKSLIP_APPROACH",
            )),
        }
    }

    /// Returns the load of a problem, which cannot hold a pressure.
    pub(crate) fn of_problem(&self) -> Outcome<NormalLoad> {
        Ok(NormalLoad::try_from(self.checked()?)?)
    }
}

/// Prescribed tangential load along one axis.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct stickslip_control {
    /// Kind of load: STICKSLIP_HOLD, STICKSLIP_FORCE, STICKSLIP_SHIFT or STICKSLIP_SPRING.
    pub kind: i32,
    /// Force that body 2 exerts on body 1, shift (a length), or position of the far end of the spring (a length). In a
    /// history, shift and position are measured since its start, and a later step without a spring holds the shift. Zero
    /// for STICKSLIP_HOLD.
    pub value: f64,
    /// Stiffness of the spring (a force over a length); zero for all other kinds.
    pub stiffness: f64,
}

impl stickslip_control {
    fn checked(&self) -> Outcome<TangentialControl> {
        if matches!(
            self.kind,
            STICKSLIP_HOLD | STICKSLIP_FORCE | STICKSLIP_SHIFT
        ) {
            Failure::if_given(
                "the stiffness of a tangential load",
                self.stiffness,
                "its kind is not STICKSLIP_SPRING: set kind to STICKSLIP_SPRING, or stiffness to zero",
            )?;
        }
        match self.kind {
            STICKSLIP_HOLD => {
                Failure::if_given(
                    "the value of a tangential load",
                    self.value,
                    "its kind is STICKSLIP_HOLD: set kind to STICKSLIP_FORCE, STICKSLIP_SHIFT or STICKSLIP_SPRING, or \
                     value to zero",
                )?;
                Ok(TangentialControl::Hold)
            }
            STICKSLIP_FORCE => Ok(TangentialControl::Force(self.value)),
            STICKSLIP_SHIFT => Ok(TangentialControl::Shift(self.value)),
            STICKSLIP_SPRING => Ok(TangentialControl::Spring {
                position: self.value,
                stiffness: self.stiffness,
            }),
            other => Err(Failure::option(
                "kind of tangential load",
                other,
                "STICKSLIP_HOLD, STICKSLIP_FORCE, STICKSLIP_SHIFT or STICKSLIP_SPRING",
            )),
        }
    }
}

/// Tangential load from rest.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct stickslip_tangential_load {
    /// Load along x.
    pub x: stickslip_control,
    /// Load along y.
    pub y: stickslip_control,
    /// Rotation of body 2 relative to body 1 about the origin of the grid (radians, from x to y); only for the vector
    /// model.
    pub twist: f64,
    /// Reserved for future members: zero.
    pub reserved: [u64; 8],
}

impl stickslip_tangential_load {
    pub(crate) fn checked(&self) -> Outcome<TangentialLoad> {
        known("the tangential load", &self.reserved)?;
        Ok(TangentialLoad::shift([0.0; 2])
            .along(Axis::X, self.x.checked()?)
            .along(Axis::Y, self.y.checked()?)
            .twist(self.twist))
    }
}

/// Rolling in a step of a history: the memory of the particles moves through the contact while body 2 creeps over body 1.
/// All members are zero if the bodies do not roll. A step with rolling must not prescribe a shift, a spring or a twist.
/// Along an axis with a prescribed force, the creepage is a result and must be zero here.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct stickslip_roll {
    /// Number of cells by which the particles of both surfaces move through the contact, one or more. The grid must
    /// extend by this number of cells ahead of and behind the contact; otherwise the step returns
    /// STICKSLIP_GRID_TOO_SHORT. The entry rule needs the slope of the gap two cells further ahead. If the grid ends
    /// before, this slope is one-sided.
    pub cells: u32,
    /// Edge at which particles enter the contact: STICKSLIP_PLUS_X, STICKSLIP_MINUS_X, STICKSLIP_PLUS_Y or
    /// STICKSLIP_MINUS_Y.
    pub leading_edge: i32,
    /// Creepages along x and y: motion of body 2 over body 1 per unit length rolled (dimensionless). A positive creepage
    /// causes a positive force. Kalker and CONTACT define creepage and spin with the opposite sign.
    pub creepage: [f64; 2],
    /// Spin: rotation of body 2 relative to body 1 about the origin of the grid per unit length rolled (one over a length,
    /// positive from x to y); only for the vector model.
    pub spin: f64,
}

impl stickslip_roll {
    fn checked(&self) -> Outcome<Option<Rolling>> {
        let Self {
            cells,
            leading_edge: edge,
            creepage,
            spin,
        } = *self;
        // Creepages and spin without cells are rejected, not ignored.
        let creeps = [creepage[0], creepage[1], spin]
            .iter()
            .any(|part| part.abs() > 0.0 || part.is_nan());
        if cells == 0 && edge == STICKSLIP_PLUS_X && !creeps {
            return Ok(None);
        }
        let rolling = Rolling::new(usize::try_from(cells).unwrap_or(usize::MAX))
            .leading_edge(leading_edge(edge)?)
            .creepage(creepage)
            .spin(spin);
        Ok(Some(rolling))
    }
}

/// Step of a history: the load prescribed at its end. A step whose members are all zero holds pressure, shift, twist and
/// relative displacement. A nonzero number without effect, such as a twist without has_twist, returns
/// STICKSLIP_INVALID_ARGUMENT.
///
/// A held shift does not hold the tangential force, which decreases if a lower pressure or less friction cannot carry it.
/// To keep the force constant, prescribe it in every step. If pressure and traction are coupled, a step without a normal
/// load holds the normal force instead of the pressure. After a change of the gap, prescribe the normal load in every
/// step; otherwise the pressure of the old gap is held.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct stickslip_load_step {
    /// Normal load.
    pub normal: stickslip_normal_load,
    /// Tangential load along x.
    pub x: stickslip_control,
    /// Tangential load along y.
    pub y: stickslip_control,
    /// Nonzero to prescribe the twist; zero holds it.
    pub has_twist: i32,
    /// Rotation of body 2 relative to body 1 since the start (radians, from x to y); zero without has_twist.
    pub twist: f64,
    /// Nonzero to prescribe the amount of the relative displacement; zero holds it.
    pub has_relative_displacement: i32,
    /// Amount of the relative displacement, as a multiple of the pattern of the history; zero without
    /// has_relative_displacement.
    pub relative_displacement: f64,
    /// Rolling of the bodies; all zero if they do not roll.
    pub roll: stickslip_roll,
    /// Reserved for future members: zero.
    pub reserved: [u64; 4],
}

impl stickslip_load_step {
    pub(crate) fn checked(&self) -> Outcome<LoadStep> {
        known("the load step", &self.reserved)?;
        let mut load = LoadStep::hold()
            .normal(self.normal.checked()?)
            .tangential(Axis::X, self.x.checked()?)
            .tangential(Axis::Y, self.y.checked()?);
        if self.has_twist != 0 {
            load = load.twist(self.twist);
        } else {
            let reason = "has_twist is zero: set has_twist to 1, or twist to zero";
            Failure::if_given("twist", self.twist, reason)?;
        }
        if self.has_relative_displacement != 0 {
            load = load.relative_displacement(self.relative_displacement);
        } else {
            let reason =
                "has_relative_displacement is zero: set it to 1, or relative_displacement to zero";
            Failure::if_given("relative_displacement", self.relative_displacement, reason)?;
        }
        if let Some(rolling) = self.roll.checked()? {
            load = load.roll(rolling);
        }
        Ok(load)
    }
}
