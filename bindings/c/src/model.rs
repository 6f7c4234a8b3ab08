//! Which tractions are found, and how they act on the pressure.

use stickslip_rs::{Coupling, TangentialModel};

use crate::call::Outcome;
use crate::error::Failure;

/// The traction along the load alone (default).
pub const STICKSLIP_SCALAR: i32 = 0;
/// Both tractions, under loads of any direction.
pub const STICKSLIP_VECTOR: i32 = 1;

/// Pressure and traction are found together: coupled solvers and histories only.
pub const STICKSLIP_FULL: i32 = 0;
/// Shear does not change the pressure, but pressure moves the surfaces tangentially.
pub const STICKSLIP_ONE_WAY: i32 = 1;
/// Neither moves the other.
pub const STICKSLIP_NEGLECTED: i32 = 2;

pub(crate) fn model(value: i32) -> Outcome<TangentialModel> {
    match value {
        STICKSLIP_SCALAR => Ok(TangentialModel::Scalar),
        STICKSLIP_VECTOR => Ok(TangentialModel::Vector),
        other => Err(Failure::option("tangential model", other)),
    }
}

pub(crate) fn coupling(value: i32) -> Outcome<Coupling> {
    match value {
        STICKSLIP_FULL => Ok(Coupling::Full),
        STICKSLIP_ONE_WAY => Ok(Coupling::OneWay),
        STICKSLIP_NEGLECTED => Ok(Coupling::Neglected),
        other => Err(Failure::option("coupling", other)),
    }
}
