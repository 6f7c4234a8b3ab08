//! Wear in the last step of a history.

use stickslip_rs::history::wear::{self, Coefficient};
use stickslip_rs::{Field, History, Result};

use crate::call::{Outcome, call_on};
use crate::handle::reading;
use crate::history::stickslip_history;
use crate::inputs::stickslip_per_cell;
use crate::pointer::{cells_mut, input};
use crate::status::stickslip_status;

/// Adds the depth removed by a wear law to an array of the caller.
///
/// # Safety
/// The caller must follow the rule for pointers in [`crate::pointer`].
unsafe fn wear(
    history: *const stickslip_history,
    coefficient: *const stickslip_per_cell,
    (depth, count): (*mut f64, usize),
    law: impl FnOnce(Coefficient<'_>, &History, &mut Field) -> Result<()>,
) -> Outcome {
    // SAFETY: the caller follows the safety contract of this function.
    let (history, coefficient) = unsafe { (reading(history)?, input("coefficient", coefficient)?) };
    let (grid, spare) = (history.grid(), history.spare());
    // SAFETY: the caller follows the safety contract of this function.
    let (coefficients, depth) = unsafe {
        let coefficients = coefficient.cells("wear coefficient", grid)?;
        (coefficients, cells_mut("depth", grid, depth, count)?)
    };
    spare.change(grid, depth, |worn| match coefficients {
        None => Ok(law(
            Coefficient::Uniform(coefficient.value),
            &history,
            worn,
        )?),
        Some(samples) => spare.with_copy(grid, samples, |coefficients| {
            Ok(law(Coefficient::PerCell(coefficients), &history, worn)?)
        }),
    })
}

/// Adds to depth (lengths, count entries) the depth that Archard's law removes in the last step: coefficient (one over a
/// pressure) times pressure times slip. A failure leaves depth unchanged, for example STICKSLIP_NO_LAST_STEP after
/// stickslip_history_set_state.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_wear_archard(
    history: *const stickslip_history,
    coefficient: *const stickslip_per_cell,
    depth: *mut f64,
    count: usize,
) -> stickslip_status {
    let law = |coefficient: Coefficient<'_>, history: &History, depth: &mut Field| {
        let slip = history.last_step()?.slip_distance();
        wear::archard(coefficient, history.pressure(), slip, depth)
    };
    // SAFETY: the caller follows the rule for pointers.
    call_on(history, || unsafe {
        wear(history, coefficient, (depth, count), law)
    })
}

/// Adds to depth the depth that the energy law removes in the last step: coefficient (one over a pressure) times the
/// dissipated energy per area. Fails like stickslip_wear_archard.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_wear_energy(
    history: *const stickslip_history,
    coefficient: *const stickslip_per_cell,
    depth: *mut f64,
    count: usize,
) -> stickslip_status {
    let law = |coefficient: Coefficient<'_>, history: &History, depth: &mut Field| {
        wear::energy(coefficient, history.last_step()?.dissipation(), depth)
    };
    // SAFETY: the caller follows the rule for pointers.
    call_on(history, || unsafe {
        wear(history, coefficient, (depth, count), law)
    })
}

/// Adds to depth the depth that the energy law with a threshold removes in the last step. Only the part of the energy
/// dissipated per area since the start that exceeds the threshold (an energy per area) causes wear. Fails like
/// stickslip_wear_archard.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_wear_threshold_energy(
    history: *const stickslip_history,
    coefficient: *const stickslip_per_cell,
    threshold: f64,
    depth: *mut f64,
    count: usize,
) -> stickslip_status {
    let law = |coefficient: Coefficient<'_>, history: &History, depth: &mut Field| {
        let (total, step) = (
            history.accumulated_dissipation(),
            history.last_step()?.dissipation(),
        );
        wear::threshold_energy(coefficient, threshold, total, step, depth)
    };
    // SAFETY: the caller follows the rule for pointers.
    call_on(history, || unsafe {
        wear(history, coefficient, (depth, count), law)
    })
}
