//! What the last step of a history wears.

use stickslip_rs::history::wear::{self, Coefficient};
use stickslip_rs::{Field, History, Result};

use crate::call::{Outcome, call_on};
use crate::handle::reading;
use crate::history::stickslip_history;
use crate::inputs::stickslip_per_cell;
use crate::pointer::{cells_mut, input};
use crate::status::stickslip_status;

/// Adds what a law removes to a depth of the caller.
///
/// # Safety
/// The rule for pointers.
unsafe fn wear(
    history: *const stickslip_history,
    coefficient: *const stickslip_per_cell,
    (depth, count): (*mut f64, usize),
    law: impl FnOnce(Coefficient<'_>, &History, &mut Field) -> Result<()>,
) -> Outcome {
    // SAFETY: as of this function.
    let (history, coefficient) = unsafe { (reading(history)?, input("coefficient", coefficient)?) };
    let (grid, spare) = (history.grid(), history.spare());
    // SAFETY: as of this function.
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

/// Adds to depth (lengths, count entries) what Archard's law removes in the last step: coefficient (one over a pressure)
/// times pressure times slip. After a failure depth is as it was.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_wear_archard(
    history: *const stickslip_history,
    coefficient: *const stickslip_per_cell,
    depth: *mut f64,
    count: usize,
) -> stickslip_status {
    let law = |coefficient: Coefficient<'_>, history: &History, depth: &mut Field| {
        let slip = history.last_step().slip_distance();
        wear::archard(coefficient, history.pressure(), slip, depth)
    };
    // SAFETY: the rule for pointers.
    call_on(history, || unsafe {
        wear(history, coefficient, (depth, count), law)
    })
}

/// Adds to depth what the energy law removes in the last step: coefficient (one over a pressure) times the energy dissipated
/// per area.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_wear_energy(
    history: *const stickslip_history,
    coefficient: *const stickslip_per_cell,
    depth: *mut f64,
    count: usize,
) -> stickslip_status {
    let law = |coefficient: Coefficient<'_>, history: &History, depth: &mut Field| {
        wear::energy(coefficient, history.last_step().dissipated_energy(), depth)
    };
    // SAFETY: the rule for pointers.
    call_on(history, || unsafe {
        wear(history, coefficient, (depth, count), law)
    })
}

/// The same beyond a threshold, an energy per area that wears nothing, of the energy dissipated since the start.
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
            history.dissipated_energy(),
            history.last_step().dissipated_energy(),
        );
        wear::threshold_energy(coefficient, threshold, total, step, depth)
    };
    // SAFETY: the rule for pointers.
    call_on(history, || unsafe {
        wear(history, coefficient, (depth, count), law)
    })
}
