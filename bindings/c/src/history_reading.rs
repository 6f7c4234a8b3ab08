//! State and last step of a history.

use stickslip_rs::history::{EnergyBalance, StepResult};
use stickslip_rs::{Field, History};

use crate::call::{Outcome, call_on};
use crate::error::Failure;
use crate::fields::*;
use crate::handle::reading;
use crate::history::stickslip_history;
use crate::inputs::stickslip_grid;
use crate::pointer::Place;
use crate::results::{stickslip_normal_result, stickslip_report, stickslip_warning, unsolved};
use crate::status::{STICKSLIP_UNKNOWN_OPTION, stickslip_status};
use crate::text_fields::{show, tell, warn};

/// Work, elastic energy and dissipation of a step or a cycle.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct stickslip_energy {
    /// Work of the tangential load: mean force times change of the shift, plus mean moment times change of the twist.
    /// Cells that come into contact contribute only the part of the motion that they follow. The work of a changing
    /// relative displacement is included, and so is the work of the normal load if pressure and traction are coupled.
    pub work: f64,
    /// Elastic energy of shear before the step or the cycle; energy of pressure and traction if both are coupled.
    pub elastic_before: f64,
    /// Elastic energy of shear after the step or the cycle; energy of pressure and traction if both are coupled.
    pub elastic_after: f64,
    /// Dissipated energy, computed from the tractions at the ends of steps; not negative. If pressure and friction do not
    /// change and the load does not turn within a step, this value is exact for any length of the step.
    pub dissipated_energy: f64,
    /// Dissipated energy, computed from the mean of the tractions before and after each step. This value closes the
    /// energy balance. It is not negative if pressure and friction do not change.
    pub dissipated_energy_midpoint: f64,
    /// Energy released by the tractions of cells that leave the contact.
    pub released: f64,
    /// Work on the residual motion that the tolerance permits in stick cells.
    pub residual: f64,
    /// Imbalance of the energies, which is due to round-off.
    pub imbalance: f64,
    /// Reserved for future members: zero.
    pub reserved: [u64; 8],
}

impl From<&EnergyBalance> for stickslip_energy {
    fn from(energy: &EnergyBalance) -> Self {
        Self {
            work: energy.work,
            elastic_before: energy.elastic_before,
            elastic_after: energy.elastic_after,
            dissipated_energy: energy.dissipated_energy,
            dissipated_energy_midpoint: energy.dissipated_energy_midpoint,
            released: energy.released,
            residual: energy.residual,
            imbalance: energy.imbalance(),
            reserved: [0; 8],
        }
    }
}

/// Energies without a value.
const UNDEFINED: stickslip_energy = stickslip_energy {
    work: f64::NAN,
    elastic_before: f64::NAN,
    elastic_after: f64::NAN,
    dissipated_energy: f64::NAN,
    dissipated_energy_midpoint: f64::NAN,
    released: f64::NAN,
    residual: f64::NAN,
    imbalance: f64::NAN,
    reserved: [0; 8],
};

/// Scalar results of a history. The members that describe the last step are NaN if the history has none, that is, if
/// has_last_step is zero.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct stickslip_step_result {
    /// Normal force.
    pub normal_force: f64,
    /// Approach of the bodies (a length).
    pub approach: f64,
    /// Tangential force that body 2 exerts on body 1.
    pub force: [f64; 2],
    /// Shift since the start (lengths): the rigid motion of body 2 relative to body 1.
    pub shift: [f64; 2],
    /// Moment about z at the origin of the grid that the tractions exert on body 1 (a force times a length, positive from
    /// x to y).
    pub moment: f64,
    /// Rotation of body 2 relative to body 1 since the start (radians).
    pub twist: f64,
    /// Ratio of stick cells to contact cells after the last step; zero without contact, NaN without a last step.
    pub stick_ratio: f64,
    /// Nonzero if the whole contact is at its friction limit after the last step; zero without a last step.
    pub is_gross_slip: i32,
    /// Nonzero if a step led to the present state. Zero before the first step, and after stickslip_history_set_state and
    /// stickslip_history_from_bytes.
    pub has_last_step: i32,
    /// Number of steps since the start.
    pub steps: u64,
    /// Energies of the last step; NaN without a last step.
    pub energy: stickslip_energy,
    /// Creepages along x and y of the last step, prescribed or caused by the force (dimensionless); zero if the bodies did
    /// not roll, NaN without a last step.
    pub creepage: [f64; 2],
    /// Reserved for future members: zero.
    pub reserved: [u64; 6],
}

impl From<&History> for stickslip_step_result {
    fn from(history: &History) -> Self {
        let step = history.last_step().ok();
        Self {
            normal_force: history.normal().force(),
            approach: history.approach(),
            force: history.tangential_force(),
            shift: history.shift(),
            moment: history.moment(),
            twist: history.twist(),
            stick_ratio: step.map_or(f64::NAN, StepResult::stick_ratio),
            is_gross_slip: i32::from(step.is_some_and(StepResult::is_gross_slip)),
            has_last_step: i32::from(step.is_some()),
            steps: history.steps(),
            energy: step.map_or(UNDEFINED, |step| step.energy().into()),
            creepage: step.map_or([f64::NAN; 2], |step| step.creepage().unwrap_or_default()),
            reserved: [0; 6],
        }
    }
}

/// Writes the scalar results. Stick ratio, gross slip, energies and creepages describe the last step. Without a last step,
/// has_last_step is zero and these numbers are NaN.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_history_result(
    history: *const stickslip_history,
    result: *mut stickslip_step_result,
) -> stickslip_status {
    // SAFETY: the caller follows the rule for pointers.
    unsafe { tell(history, ("result", result), |of| Ok(of.into())) }
}

/// Writes the scalar results of the normal contact.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_history_normal_result(
    history: *const stickslip_history,
    result: *mut stickslip_normal_result,
) -> stickslip_status {
    // SAFETY: the caller follows the rule for pointers.
    unsafe { tell(history, ("result", result), |of| Ok(of.normal().into())) }
}

/// Writes the grid of all fields.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_history_grid(
    history: *const stickslip_history,
    grid: *mut stickslip_grid,
) -> stickslip_status {
    // SAFETY: the caller follows the rule for pointers.
    unsafe { tell(history, ("grid", grid), |of| Ok(of.grid().into())) }
}

/// Writes the largest tangential force that friction can carry at the current pressure.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_history_friction_capacity(
    history: *const stickslip_history,
    capacity: *mut f64,
) -> stickslip_status {
    // SAFETY: the caller follows the rule for pointers.
    unsafe {
        tell(history, ("capacity", capacity), |of| {
            Ok(of.friction_capacity())
        })
    }
}

/// Writes the reports of the pressure and the traction of the last step. Their status is STICKSLIP_UNSOLVED if the pressure
/// was held, or before the first contact. Returns STICKSLIP_NO_LAST_STEP without a last step.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_history_reports(
    history: *const stickslip_history,
    normal: *mut stickslip_report,
    tangential: *mut stickslip_report,
) -> stickslip_status {
    // SAFETY: the caller follows the rule for pointers.
    call_on(history, || unsafe {
        let normal = Place::new("normal", normal)?;
        let tangential = Place::new("tangential", tangential)?;
        let history = reading(history)?;
        let step = history.last_step()?;
        let report = |own: Option<_>| own.map_or_else(unsolved, stickslip_report::from);
        normal.put(report(step.normal_report()));
        tangential.put(report(step.tangential_report()));
        Ok(())
    })
}

/// Writes the warnings about the last step, like stickslip_normal_solution_warnings. Returns STICKSLIP_NO_LAST_STEP without a
/// last step.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_history_warnings(
    history: *const stickslip_history,
    buffer: *mut stickslip_warning,
    capacity: usize,
    count: *mut usize,
) -> stickslip_status {
    // SAFETY: the caller follows the rule for pointers.
    unsafe {
        warn(history, (buffer, capacity, count), |of| {
            Ok(of.last_step()?.warnings())
        })
    }
}

/// Returns a field, STICKSLIP_PRESSURE to STICKSLIP_YIELDED_DEPTH except displacements, and writes its number of cells to
/// count (may be NULL); returns NULL on failure. The fields of the last step, STICKSLIP_STEP_SLIP_X to
/// STICKSLIP_STEP_MID_DISSIPATED_ENERGY, fail with STICKSLIP_NO_LAST_STEP without a last step.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_history_field(
    history: *const stickslip_history,
    which: i32,
    count: *mut usize,
) -> *const f64 {
    // SAFETY: the caller follows the rule for pointers.
    unsafe { show(history, count, |of| Ok(field(of, which)?.as_slice())) }
}

fn field(history: &History, which: i32) -> Outcome<&Field> {
    let step = || history.last_step();
    Ok(match which {
        STICKSLIP_PRESSURE | STICKSLIP_GAP => of_normal(history.normal(), which)?,
        STICKSLIP_TRACTION_X => history.traction()[0],
        STICKSLIP_TRACTION_Y => history.traction()[1],
        STICKSLIP_SLIP_X => history.slip()[0],
        STICKSLIP_SLIP_Y => history.slip()[1],
        STICKSLIP_SLIP_DISTANCE => history.accumulated_slip(),
        STICKSLIP_DISSIPATED_ENERGY => history.accumulated_dissipation(),
        STICKSLIP_INITIAL_GAP => history.unloaded_gap(),
        STICKSLIP_STEP_SLIP_X => step()?.slip()[0],
        STICKSLIP_STEP_SLIP_Y => step()?.slip()[1],
        STICKSLIP_STEP_SLIP_DISTANCE => step()?.slip_distance(),
        STICKSLIP_STEP_DISSIPATED_ENERGY => step()?.dissipation(),
        STICKSLIP_STEP_MID_DISSIPATED_ENERGY => step()?.dissipation_midpoint(),
        STICKSLIP_YIELDED_DEPTH => history
            .state()
            .yielded()
            .ok_or_else(without_permanent_set)?,
        other => {
            return Err(none(
                "a history",
                other,
                "STICKSLIP_PRESSURE to STICKSLIP_SLIP_Y, STICKSLIP_SLIP_DISTANCE to STICKSLIP_STEP_MID_DISSIPATED_ENERGY, or STICKSLIP_YIELDED_DEPTH",
            ));
        }
    })
}

/// Creates the failure for the depth of a permanent set that the history does not have.
fn without_permanent_set() -> Failure {
    Failure::at_value(
        STICKSLIP_UNKNOWN_OPTION,
        f64::from(STICKSLIP_YIELDED_DEPTH),
        "the field STICKSLIP_YIELDED_DEPTH exists only in a history with a permanent set: create the history with the options hardness and permanent_set".into(),
    )
}

/// Returns the zone of every cell after the last step, or NULL on failure.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_history_zones(
    history: *const stickslip_history,
    count: *mut usize,
) -> *const u8 {
    // SAFETY: the caller follows the rule for pointers.
    unsafe { show(history, count, |of| Ok(of.zones())).cast() }
}
