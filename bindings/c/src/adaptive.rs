//! Adaptive load steps with a tolerance.

use stickslip_rs::history::AdaptiveSteps;

use crate::call::{call, call_on};
use crate::cycle::stickslip_cycle;
use crate::handle::{Handle, changing, free, give, opaque, reading};
use crate::history::stickslip_history;
use crate::loads::stickslip_load_step;
use crate::observer::{StepWatch, stickslip_step_observer};
use crate::pointer::{Place, answer, input, optional};
use crate::status::stickslip_status;

/// Adaptive load stepper, which applies loads in steps that are short enough for a tolerance on the tractions. The
/// error of a step is the difference between its result and the result of two half steps. The object can be used for
/// every history on the same grid.
pub struct stickslip_adaptive_steps(Handle<AdaptiveSteps>);

opaque!(stickslip_adaptive_steps holds AdaptiveSteps, named "adaptive steps");

/// Error of one load step: the difference between its result and the result of the same load in two half steps.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct stickslip_step_error {
    /// Relative error of the traction, to which the tolerance applies.
    pub traction: f64,
    /// Error of the tangential force.
    pub force: [f64; 2],
    /// Error of the shift (lengths).
    pub shift: [f64; 2],
    /// Error of the dissipated energy.
    pub dissipated_energy: f64,
    /// Reserved for future members: zero.
    pub reserved: [u64; 8],
}

/// Creates a load stepper for histories on the grid of the given history, with a tolerance in (0, 1) for a whole load.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_adaptive_steps_new(
    history: *const stickslip_history,
    tolerance: f64,
    steps: *mut *mut stickslip_adaptive_steps,
) -> stickslip_status {
    // SAFETY: the caller follows the rule for pointers.
    call_on(history, || unsafe {
        let place = Place::of_object("steps", steps)?;
        let history = reading(history)?;
        let made = AdaptiveSteps::new(&history, tolerance)?;
        give(place, made, history.grid().cells())
    })
}

/// Frees a load stepper; does nothing if steps is NULL.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_adaptive_steps_free(
    steps: *mut stickslip_adaptive_steps,
) -> stickslip_status {
    // SAFETY: the caller follows the rule for pointers.
    call(|| unsafe { free(steps) })
}

/// Applies a load in as many steps as the tolerance requires, and writes their number to taken (may be NULL). A
/// failure, for example STICKSLIP_STEP_TOO_LONG, leaves the state of the history unchanged. If the call has undone steps, the
/// history has no last step until its next step. After several steps, the result and the wear of the last step are those of the
/// last one alone; the field STICKSLIP_DISSIPATED_ENERGY contains the energy of all steps.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_adaptive_steps_step(
    steps: *mut stickslip_adaptive_steps,
    history: *mut stickslip_history,
    load: *const stickslip_load_step,
    taken: *mut usize,
) -> stickslip_status {
    // SAFETY: the caller follows the rule for pointers.
    call_on(steps, || unsafe {
        let place = Place::if_asked("taken", taken)?;
        let load = input("load", load)?.checked()?;
        let (mut steps, mut history) = (changing(steps)?, changing(history)?);
        let count = steps.step(&mut history, &load)?;
        if let Some(place) = place {
            place.put(count);
        }
        Ok(())
    })
}

/// Applies a load in steps like stickslip_adaptive_steps_step, and writes their number to taken (may be NULL). Every accepted
/// step is added to cycle (may be NULL), and observer (may be NULL) receives its results. Sums over all steps, such as energies
/// and the slip for wear, are then results of the cycle. The cycle must start or end at the current state. After a failure the
/// state of the history is unchanged, but the cycle may contain undone steps: begin it again. Returns STICKSLIP_NOT_CONVERGED if
/// the observer ends the call.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_adaptive_steps_stepwise(
    steps: *mut stickslip_adaptive_steps,
    history: *mut stickslip_history,
    load: *const stickslip_load_step,
    cycle: *mut stickslip_cycle,
    observer: *const stickslip_step_observer,
    taken: *mut usize,
) -> stickslip_status {
    // SAFETY: the caller follows the rule for pointers.
    call_on(steps, || unsafe {
        let place = Place::if_asked("taken", taken)?;
        let load = input("load", load)?.checked()?;
        let observer = optional("observer", observer)?;
        let (mut steps, mut history) = (changing(steps)?, changing(history)?);
        let cycle = (!cycle.is_null()).then(|| changing(cycle)).transpose()?;
        let mut watch = StepWatch::new(observer, cycle);
        let outcome = steps.step_observed(&mut history, &load, |history| watch.receive(history));
        let count = watch.outcome(outcome)?;
        if let Some(place) = place {
            place.put(count);
        }
        Ok(())
    })
}

/// Computes the error that stickslip_history_step would make with a load. The state of the history is unchanged. The history
/// then has no last step until its next step.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_adaptive_steps_error(
    steps: *mut stickslip_adaptive_steps,
    history: *mut stickslip_history,
    load: *const stickslip_load_step,
    error: *mut stickslip_step_error,
) -> stickslip_status {
    // SAFETY: the caller follows the rule for pointers.
    call_on(steps, || unsafe {
        answer("error", error, || {
            let load = input("load", load)?.checked()?;
            let (mut steps, mut history) = (changing(steps)?, changing(history)?);
            let found = steps.error(&mut history, &load)?;
            Ok(stickslip_step_error {
                traction: found.traction,
                force: found.force,
                shift: found.shift,
                dissipated_energy: found.dissipated_energy,
                reserved: [0; 8],
            })
        })
    })
}
