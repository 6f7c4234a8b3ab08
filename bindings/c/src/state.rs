//! States of histories, stored in memory or as bytes.

use stickslip_rs::history::State;
use stickslip_rs::{History, TryClone};

use crate::call::{call, call_on};
use crate::error::Failure;
use crate::half_space::stickslip_half_space;
use crate::handle::{Handle, changing, free, give, opaque, reading};
use crate::history::stickslip_history;
use crate::pointer::{Place, entries, entries_mut};
use crate::status::{STICKSLIP_BUFFER_TOO_SMALL, stickslip_status};

/// Saved state of a history, including gap, friction and settings. A history can return to this state.
pub struct stickslip_state(Handle<State>);

opaque!(stickslip_state holds State, named "state");

/// Creates a copy of the state of a history. The guide page embedding states its number of bytes per cell.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_state_new(
    history: *const stickslip_history,
    state: *mut *mut stickslip_state,
) -> stickslip_status {
    // SAFETY: the caller follows the rule for pointers.
    call_on(history, || unsafe {
        let place = Place::of_object("state", state)?;
        let history = reading(history)?;
        give(place, history.state().try_clone()?, history.grid().cells())
    })
}

/// Frees a state; does nothing if it is NULL.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_state_free(state: *mut stickslip_state) -> stickslip_status {
    // SAFETY: the caller follows the rule for pointers.
    call(|| unsafe { free(state) })
}

/// Overwrites a saved state with the current state of a history; the memory is reused.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_state_keep(
    state: *mut stickslip_state,
    history: *const stickslip_history,
) -> stickslip_status {
    // SAFETY: the caller follows the rule for pointers.
    call_on(state, || unsafe {
        let (mut state, history) = (changing(state)?, reading(history)?);
        Ok(state.try_clone_from(history.state())?)
    })
}

/// Returns a history to a saved state of this history or of another history on equal bodies. The history then has no last
/// step until its next step: functions that use the last step return STICKSLIP_NO_LAST_STEP. In a retry, restore the state,
/// take a smaller step, and add this step to the cycle and to the wear.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_history_set_state(
    history: *mut stickslip_history,
    state: *const stickslip_state,
) -> stickslip_status {
    // SAFETY: the caller follows the rule for pointers.
    call_on(history, || unsafe {
        let (mut history, state) = (changing(history)?, reading(state)?);
        Ok(history.set_state(&state)?)
    })
}

/// Writes the state of a history as bytes. A history created from these bytes by stickslip_history_from_bytes takes
/// further steps with bitwise identical results. The number of bytes for each cell is 57 (small contact, scalar model) to
/// 137 (contact on the whole grid, vector model). Changes of the contact or the gap, values for each cell and a relative
/// displacement add up to 80.
///
/// length receives the number of bytes. With a NULL buffer and a capacity of 0 only the number is written. If the buffer
/// is too small, the call returns STICKSLIP_BUFFER_TOO_SMALL and writes nothing to it. A call without a buffer also
/// creates the bytes.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_history_to_bytes(
    history: *const stickslip_history,
    buffer: *mut u8,
    capacity: usize,
    length: *mut usize,
) -> stickslip_status {
    // SAFETY: the caller follows the rule for pointers.
    call_on(history, || unsafe {
        let length = Place::new("length", length)?;
        let buffer = entries_mut("buffer", buffer, capacity)?;
        let bytes = reading(history)?.state().try_to_bytes()?;
        length.put(bytes.len());
        if capacity == 0 {
            return Ok(());
        }
        let lengths = [bytes.len(), capacity];
        let place = buffer.get_mut(..bytes.len());
        let short = || Failure::length(STICKSLIP_BUFFER_TOO_SMALL, "buffer", lengths);
        place.ok_or_else(short)?.copy_from_slice(&bytes);
        Ok(())
    })
}

/// Creates a history from bytes of stickslip_history_to_bytes, on the bodies of the original history. Returns
/// STICKSLIP_FORMAT for damaged bytes.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_history_from_bytes(
    half_space: *const stickslip_half_space,
    bytes: *const u8,
    length: usize,
    history: *mut *mut stickslip_history,
) -> stickslip_status {
    // SAFETY: the caller follows the rule for pointers.
    call_on(half_space, || unsafe {
        let place = Place::of_object("history", history)?;
        let (bodies, bytes) = (reading(half_space)?, entries("bytes", bytes, length)?);
        let made = History::from_bytes(&bodies, bytes)?;
        give(place, made, bodies.grid().cells())
    })
}
