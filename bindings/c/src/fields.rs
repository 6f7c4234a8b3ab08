//! Constants for the fields of solutions and histories.

use stickslip_rs::{Field, NormalSolution, TangentialSolution};

use crate::call::Outcome;
use crate::error::Failure;

/// Pressure, zero outside the contact.
pub const STICKSLIP_PRESSURE: i32 = 0;
/// Gap under load (lengths).
pub const STICKSLIP_GAP: i32 = 1;
/// Shear traction along x that body 2 exerts on body 1 (pressures).
pub const STICKSLIP_TRACTION_X: i32 = 2;
/// Shear traction along y.
pub const STICKSLIP_TRACTION_Y: i32 = 3;
/// Slip along x (lengths): the motion of the surface of body 1 relative to body 2. The slip of a history is the sum over
/// all steps.
pub const STICKSLIP_SLIP_X: i32 = 4;
/// Slip along y.
pub const STICKSLIP_SLIP_Y: i32 = 5;
/// Displacement along x due to pressure and tractions (lengths). For coupled solutions it is the displacement of body 1
/// relative to body 2, and for planes below the surface the displacement of the body.
pub const STICKSLIP_DISPLACEMENT_X: i32 = 6;
/// Displacement along y due to pressure and tractions (lengths).
pub const STICKSLIP_DISPLACEMENT_Y: i32 = 7;
/// Displacement along z due to pressure and tractions (lengths); for coupled solutions the sum over both bodies.
pub const STICKSLIP_DISPLACEMENT_Z: i32 = 8;
/// Length of the slip path over all steps of a history or of a cycle (lengths).
pub const STICKSLIP_SLIP_DISTANCE: i32 = 9;
/// Energy dissipated in each cell over all steps of a history or of a cycle.
pub const STICKSLIP_DISSIPATED_ENERGY: i32 = 10;
/// Gap of a history before loading: the last gap that was set, plus STICKSLIP_YIELDED_DEPTH (lengths). Subtract this depth before
/// the gap is set again, because the history adds it.
pub const STICKSLIP_INITIAL_GAP: i32 = 11;
/// Slip along x of the last step of a history (lengths).
pub const STICKSLIP_STEP_SLIP_X: i32 = 12;
/// Slip along y of the last step.
pub const STICKSLIP_STEP_SLIP_Y: i32 = 13;
/// Length of the slip of the last step.
pub const STICKSLIP_STEP_SLIP_DISTANCE: i32 = 14;
/// Energy dissipated in each cell in the last step, computed with the traction at the end of the step.
pub const STICKSLIP_STEP_DISSIPATED_ENERGY: i32 = 15;
/// Energy dissipated in each cell in the last step, computed with the mean traction of the step; this value closes the
/// energy balance.
pub const STICKSLIP_STEP_MID_DISSIPATED_ENERGY: i32 = 16;
/// Permanent set added to the gap (lengths); only for histories with a permanent set.
pub const STICKSLIP_YIELDED_DEPTH: i32 = 17;
/// Mean pressure during slip, weighted by the slip; only for cycles.
pub const STICKSLIP_SLIP_PRESSURE: i32 = 18;
/// Amplitude of the slip along x (lengths); only for cycles.
pub const STICKSLIP_SLIP_AMPLITUDE_X: i32 = 19;
/// Amplitude of the slip along y (lengths); only for cycles.
pub const STICKSLIP_SLIP_AMPLITUDE_Y: i32 = 20;
/// Stress xx on a plane below the surface (pressures, positive in tension).
pub const STICKSLIP_STRESS_XX: i32 = 21;
/// Stress yy on a plane.
pub const STICKSLIP_STRESS_YY: i32 = 22;
/// Stress zz on a plane.
pub const STICKSLIP_STRESS_ZZ: i32 = 23;
/// Stress xy on a plane.
pub const STICKSLIP_STRESS_XY: i32 = 24;
/// Stress xz on a plane.
pub const STICKSLIP_STRESS_XZ: i32 = 25;
/// Stress yz on a plane.
pub const STICKSLIP_STRESS_YZ: i32 = 26;
/// Von Mises equivalent stress (pressures), for stickslip_planes_measure.
pub const STICKSLIP_VON_MISES: i32 = 27;
/// Largest shear stress (pressures), for stickslip_planes_measure: half the difference between the largest and the smallest
/// principal stress.
pub const STICKSLIP_MAX_SHEAR: i32 = 28;
/// Mean of the normal stresses (pressures, positive in tension), for stickslip_planes_measure.
pub const STICKSLIP_HYDROSTATIC: i32 = 29;

/// Zone of a cell out of contact.
pub const STICKSLIP_SEPARATED: u8 = 0;
/// Zone of a cell in contact, below the friction limit.
pub const STICKSLIP_STICK: u8 = 1;
/// Zone of a cell in contact, at the friction limit.
pub const STICKSLIP_SLIP: u8 = 2;

/// Fields of tangential and rolling solutions.
pub(crate) const TRACTION_AND_SLIP: &str =
    "STICKSLIP_TRACTION_X, STICKSLIP_TRACTION_Y, STICKSLIP_SLIP_X or STICKSLIP_SLIP_Y";

/// Creates the failure for a number that is not a field of the object. The remedy names the fields of the object.
pub(crate) fn none(object: &str, field: i32, fields: &str) -> Failure {
    Failure::option(&format!("field of {object}"), field, fields)
}

pub(crate) fn of_normal(solution: &NormalSolution, field: i32) -> Outcome<&Field> {
    match field {
        STICKSLIP_PRESSURE => Ok(solution.pressure()),
        STICKSLIP_GAP => Ok(solution.gap()),
        other => Err(none(
            "a normal solution",
            other,
            "STICKSLIP_PRESSURE or STICKSLIP_GAP",
        )),
    }
}

pub(crate) fn of_tangential(solution: &TangentialSolution, field: i32) -> Outcome<&Field> {
    match field {
        STICKSLIP_TRACTION_X => Ok(solution.traction()[0]),
        STICKSLIP_TRACTION_Y => Ok(solution.traction()[1]),
        STICKSLIP_SLIP_X => Ok(solution.slip()[0]),
        STICKSLIP_SLIP_Y => Ok(solution.slip()[1]),
        other => Err(none("a tangential solution", other, TRACTION_AND_SLIP)),
    }
}
