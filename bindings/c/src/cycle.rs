//! Sums over a load cycle: energies, amplitudes and regime.

use stickslip_rs::Field;
use stickslip_rs::history::{Cycle, Regime};

use crate::call::{Outcome, call, call_on};
use crate::fields::*;
use crate::handle::{Handle, changing, free, give, opaque, reading};
use crate::history::stickslip_history;
use crate::history_reading::stickslip_energy;
use crate::pointer::Place;
use crate::status::stickslip_status;
use crate::text_fields::{show, tell};

/// Sums over the steps of a history since the start of the cycle.
pub struct stickslip_cycle(Handle<Cycle>);

opaque!(stickslip_cycle holds Cycle, named "cycle");

/// Regime in which no cell slipped.
pub const STICKSLIP_FULL_STICK: i32 = 0;
/// Regime in which some cells slipped, but some cells stuck at the end of each step.
pub const STICKSLIP_PARTIAL_SLIP: i32 = 1;
/// Regime in which the whole contact was at its friction limit at the end of a step.
pub const STICKSLIP_GROSS_SLIP: i32 = 2;

/// Scalar results of a cycle.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct stickslip_cycle_result {
    /// Number of steps since the start of the cycle.
    pub steps: usize,
    /// Regime: STICKSLIP_FULL_STICK, STICKSLIP_PARTIAL_SLIP or STICKSLIP_GROSS_SLIP.
    pub regime: i32,
    /// Ratio of the dissipated energy to the area of the rectangle around the loop of force and shift.
    pub energy_ratio: f64,
    /// Difference between the tractions at the end and at the start of the cycle, relative to the largest traction; zero if
    /// the loop closes.
    pub cyclic_residual: f64,
    /// Amplitude of the tangential force.
    pub force_amplitude: [f64; 2],
    /// Amplitude of the shift (lengths).
    pub shift_amplitude: [f64; 2],
    /// Smallest and largest stick ratio at the end of a step.
    pub stick_ratios: [f64; 2],
    /// Energies of all steps of the cycle.
    pub energy: stickslip_energy,
    /// Reserved for future members: zero.
    pub reserved: [u64; 8],
}

impl stickslip_cycle_result {
    fn of(cycle: &Cycle) -> stickslip_rs::Result<Self> {
        Ok(Self {
            steps: cycle.steps(),
            regime: match cycle.regime()? {
                Regime::FullStick => STICKSLIP_FULL_STICK,
                Regime::PartialSlip => STICKSLIP_PARTIAL_SLIP,
                _ => STICKSLIP_GROSS_SLIP,
            },
            energy_ratio: cycle.energy_ratio()?,
            cyclic_residual: cycle.cyclic_residual()?,
            force_amplitude: cycle.force_amplitude(),
            shift_amplitude: cycle.shift_amplitude(),
            stick_ratios: cycle.stick_ratios()?,
            energy: cycle.energy().into(),
            reserved: [0; 8],
        })
    }
}

/// Starts a cycle at the current state of a history.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_cycle_new(
    history: *const stickslip_history,
    cycle: *mut *mut stickslip_cycle,
) -> stickslip_status {
    // SAFETY: the caller follows the rule for pointers.
    call_on(history, || unsafe {
        let place = Place::of_object("cycle", cycle)?;
        let history = reading(history)?;
        give(place, Cycle::try_new(&history)?, history.grid().cells())
    })
}

/// Frees a cycle; does nothing if it is NULL.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_cycle_free(cycle: *mut stickslip_cycle) -> stickslip_status {
    // SAFETY: the caller follows the rule for pointers.
    call(|| unsafe { free(cycle) })
}

/// Restarts the cycle at the current state of a history.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_cycle_begin(
    cycle: *mut stickslip_cycle,
    history: *const stickslip_history,
) -> stickslip_status {
    // SAFETY: the caller follows the rule for pointers.
    call_on(cycle, || unsafe {
        let (mut cycle, history) = (changing(cycle)?, reading(history)?);
        Ok(cycle.begin(&history)?)
    })
}

/// Adds the last step of the history. Returns STICKSLIP_STEP_OUT_OF_ORDER unless this step is the step after the
/// last added one, or after the start of the cycle. Returns STICKSLIP_NO_LAST_STEP if the state of the history was
/// set since its last step.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_cycle_add(
    cycle: *mut stickslip_cycle,
    history: *const stickslip_history,
) -> stickslip_status {
    // SAFETY: the caller follows the rule for pointers.
    call_on(cycle, || unsafe {
        let (mut cycle, history) = (changing(cycle)?, reading(history)?);
        Ok(cycle.add(&history)?)
    })
}

/// Writes the scalar results of the cycle.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_cycle_result_of(
    cycle: *const stickslip_cycle,
    result: *mut stickslip_cycle_result,
) -> stickslip_status {
    // SAFETY: the caller follows the rule for pointers.
    unsafe {
        tell(cycle, ("result", result), |of| {
            Ok(stickslip_cycle_result::of(of)?)
        })
    }
}

/// Returns a field of the cycle: STICKSLIP_SLIP_DISTANCE, STICKSLIP_DISSIPATED_ENERGY, STICKSLIP_SLIP_PRESSURE,
/// STICKSLIP_SLIP_AMPLITUDE_X or _Y; returns NULL on failure. The field is valid until the next call that changes the
/// cycle.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_cycle_field(
    cycle: *const stickslip_cycle,
    which: i32,
    count: *mut usize,
) -> *const f64 {
    // SAFETY: the caller follows the rule for pointers.
    unsafe { show(cycle, count, |of| Ok(field(of, which)?.as_slice())) }
}

fn field(cycle: &Cycle, which: i32) -> Outcome<&Field> {
    Ok(match which {
        STICKSLIP_SLIP_DISTANCE => cycle.slip_distance(),
        STICKSLIP_DISSIPATED_ENERGY => cycle.dissipation(),
        STICKSLIP_SLIP_PRESSURE => cycle.slip_pressure(),
        STICKSLIP_SLIP_AMPLITUDE_X => cycle.slip_amplitude()[0],
        STICKSLIP_SLIP_AMPLITUDE_Y => cycle.slip_amplitude()[1],
        other => {
            return Err(none(
                "a cycle",
                other,
                "STICKSLIP_SLIP_DISTANCE, STICKSLIP_DISSIPATED_ENERGY, STICKSLIP_SLIP_PRESSURE, STICKSLIP_SLIP_AMPLITUDE_X or STICKSLIP_SLIP_AMPLITUDE_Y",
            ));
        }
    })
}
