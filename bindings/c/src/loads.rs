//! Loads: plain structs of which zero holds everything.

use stickslip_rs::history::Rolling;
use stickslip_rs::{Axis, LoadStep, NormalControl, TangentialControl, TangentialLoad};

use crate::call::Outcome;
use crate::error::Failure;
use crate::reserved::known;
use crate::rolling::{STICKSLIP_PLUS_X, leading_edge};

/// Hold: the pressure, the shift as it is.
pub const STICKSLIP_HOLD: i32 = 0;
/// A force.
pub const STICKSLIP_FORCE: i32 = 1;
/// The approach of the bodies (a length), from the datum of the gap.
pub const STICKSLIP_APPROACH: i32 = 2;
/// The shift, the rigid motion of body 2 relative to body 1 (a length), since the unloaded state.
pub const STICKSLIP_SHIFT: i32 = 3;
/// A spring that drags body 2: the force is stiffness * (value - shift).
pub const STICKSLIP_SPRING: i32 = 4;

/// A normal load.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct stickslip_normal_load {
    /// STICKSLIP_HOLD, STICKSLIP_FORCE or STICKSLIP_APPROACH.
    pub kind: i32,
    /// The force (zero or positive) or the approach (a length, positive when the bodies come together).
    pub value: f64,
}

impl stickslip_normal_load {
    pub(crate) fn checked(&self) -> Outcome<NormalControl> {
        match self.kind {
            STICKSLIP_HOLD => Ok(NormalControl::Hold),
            STICKSLIP_FORCE => Ok(NormalControl::Force(self.value)),
            STICKSLIP_APPROACH => Ok(NormalControl::Approach(self.value)),
            other => Err(Failure::option("normal load", other)),
        }
    }
}

/// What is prescribed along one axis.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct stickslip_control {
    /// STICKSLIP_HOLD, STICKSLIP_FORCE, STICKSLIP_SHIFT or STICKSLIP_SPRING.
    pub kind: i32,
    /// The force that body 2 exerts on body 1, the shift, or the position of the far end of the spring.
    pub value: f64,
    /// Stiffness of the spring (a force over a length).
    pub stiffness: f64,
}

impl stickslip_control {
    fn checked(&self) -> Outcome<TangentialControl> {
        match self.kind {
            STICKSLIP_HOLD => Ok(TangentialControl::Hold),
            STICKSLIP_FORCE => Ok(TangentialControl::Force(self.value)),
            STICKSLIP_SHIFT => Ok(TangentialControl::Shift(self.value)),
            STICKSLIP_SPRING => Ok(TangentialControl::Spring {
                position: self.value,
                stiffness: self.stiffness,
            }),
            other => Err(Failure::option("tangential load", other)),
        }
    }
}

/// A tangential load from rest.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct stickslip_tangential_load {
    /// Along x.
    pub x: stickslip_control,
    /// Along y.
    pub y: stickslip_control,
    /// Rotation of body 2 relative to body 1 about the origin of the grid (radians, from x to y); the vector model only.
    pub twist: f64,
    /// Room for members to come: zero.
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

/// How the bodies roll in a step of a history: the memory of the particles moves through the contact, and body 2 creeps over
/// body 1 on the way. All zero: they do not roll. A step that rolls names no shift, no spring and no twist; along an axis on
/// which it names a force the creepage follows, and is zero here.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct stickslip_roll {
    /// Cells by which the particles of both surfaces move through the contact, one or more.
    pub cells: u32,
    /// Where particles enter the contact: STICKSLIP_PLUS_X, STICKSLIP_MINUS_X, STICKSLIP_PLUS_Y or STICKSLIP_MINUS_Y.
    pub leading_edge: i32,
    /// The creepages along x and y, what body 2 moves over body 1 for each length rolled (dimensionless).
    pub creepage: [f64; 2],
    /// The spin, the rotation of body 2 relative to body 1 about the origin of the grid for each length rolled (one over a
    /// length, positive from x to y); the vector model only.
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
        // Numbers beside no cells are refused with them, not left out.
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

/// A step of a history: what it prescribes at its end. All zero holds everything.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct stickslip_load_step {
    /// Normal load.
    pub normal: stickslip_normal_load,
    /// Tangential load along x.
    pub x: stickslip_control,
    /// Tangential load along y.
    pub y: stickslip_control,
    /// Not zero: to this twist; else the twist is held.
    pub has_twist: i32,
    /// Rotation of body 2 relative to body 1 since the start (radians, from x to y).
    pub twist: f64,
    /// Not zero: to this amount of the relative displacement; else it is held.
    pub has_relative_displacement: i32,
    /// Amount of the relative displacement, as a multiple of the pattern of the history.
    pub relative_displacement: f64,
    /// How the bodies roll; all zero: they do not.
    pub roll: stickslip_roll,
    /// Room for members to come: zero.
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
        }
        if self.has_relative_displacement != 0 {
            load = load.relative_displacement(self.relative_displacement);
        }
        if let Some(rolling) = self.roll.checked()? {
            load = load.roll(rolling);
        }
        Ok(load)
    }
}
