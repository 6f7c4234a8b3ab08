//! Tangential model and coupling of pressure and traction.

use stickslip_rs::{Coupling, TangentialModel};

use crate::call::Outcome;
use crate::error::Failure;

/// Model with the traction along the load only (default).
pub const STICKSLIP_SCALAR: i32 = 0;
/// Model with both tractions, for loads in any direction.
pub const STICKSLIP_VECTOR: i32 = 1;

/// Full coupling of pressure and traction; only for coupled solvers and histories.
pub const STICKSLIP_FULL: i32 = 0;
/// One-way coupling: the pressure causes tangential displacements, but the tractions do not change the pressure.
pub const STICKSLIP_ONE_WAY: i32 = 1;
/// No coupling in either direction.
pub const STICKSLIP_NEGLECTED: i32 = 2;

pub(crate) fn model(value: i32) -> Outcome<TangentialModel> {
    match value {
        STICKSLIP_SCALAR => Ok(TangentialModel::Scalar),
        STICKSLIP_VECTOR => Ok(TangentialModel::Vector),
        other => Err(Failure::option(
            "tangential model",
            other,
            "STICKSLIP_SCALAR or STICKSLIP_VECTOR",
        )),
    }
}

pub(crate) fn coupling(value: i32) -> Outcome<Coupling> {
    match value {
        STICKSLIP_FULL => Ok(Coupling::Full),
        STICKSLIP_ONE_WAY => Ok(Coupling::OneWay),
        STICKSLIP_NEGLECTED => Ok(Coupling::Neglected),
        other => Err(Failure::option(
            "coupling",
            other,
            "STICKSLIP_FULL, STICKSLIP_ONE_WAY or STICKSLIP_NEGLECTED",
        )),
    }
}
