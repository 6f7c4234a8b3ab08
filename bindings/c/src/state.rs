//! States of histories: kept in memory, or as bytes.

use stickslip_rs::history::State;
use stickslip_rs::{History, TryClone};

use crate::call::{call, call_on};
use crate::error::Failure;
use crate::half_space::stickslip_half_space;
use crate::handle::{Handle, changing, free, give, opaque, reading};
use crate::history::stickslip_history;
use crate::pointer::{Place, entries, entries_mut};
use crate::status::{STICKSLIP_BUFFER_TOO_SMALL, stickslip_status};

/// A state of a history, to which it may return: gap, friction and settings are part of it.
pub struct stickslip_state(Handle<State>);

opaque!(stickslip_state holds State, named "state");

/// Keeps a copy of the state of a history.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_state_new(
    history: *const stickslip_history,
    state: *mut *mut stickslip_state,
) -> stickslip_status {
    // SAFETY: the rule for pointers.
    call_on(history, || unsafe {
        let place = Place::new("state", state)?;
        let history = reading(history)?;
        give(place, history.state().try_clone()?, history.grid().cells())
    })
}

/// Frees a state; nothing for NULL.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_state_free(state: *mut stickslip_state) -> stickslip_status {
    // SAFETY: the rule for pointers.
    call(|| unsafe { free(state) })
}

/// Keeps the present state of a history in the place of an older one, whose memory it uses.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_state_keep(
    state: *mut stickslip_state,
    history: *const stickslip_history,
) -> stickslip_status {
    // SAFETY: the rule for pointers.
    call_on(state, || unsafe {
        let (mut state, history) = (changing(state)?, reading(history)?);
        Ok(state.try_clone_from(history.state())?)
    })
}

/// Returns a history to a state, one of its own or of another on equal bodies.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_history_set_state(
    history: *mut stickslip_history,
    state: *const stickslip_state,
) -> stickslip_status {
    // SAFETY: the rule for pointers.
    call_on(history, || unsafe {
        let (mut history, state) = (changing(history)?, reading(state)?);
        Ok(history.set_state(&state)?)
    })
}

/// The state of a history as bytes, some 60 to 130 for each cell. A history made from them by stickslip_history_from_bytes
/// takes further steps with the same results, bit for bit.
///
/// length gets how many there are. With a NULL buffer and capacity 0 only that; a buffer that is too small is
/// STICKSLIP_BUFFER_TOO_SMALL, and nothing is written to it. Each call takes about as long as a warm step.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_history_to_bytes(
    history: *const stickslip_history,
    buffer: *mut u8,
    capacity: usize,
    length: *mut usize,
) -> stickslip_status {
    // SAFETY: the rule for pointers.
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

/// Makes a history from bytes of stickslip_history_to_bytes, on the bodies it had. Damaged bytes are STICKSLIP_FORMAT.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn stickslip_history_from_bytes(
    half_space: *const stickslip_half_space,
    bytes: *const u8,
    length: usize,
    history: *mut *mut stickslip_history,
) -> stickslip_status {
    // SAFETY: the rule for pointers.
    call_on(half_space, || unsafe {
        let place = Place::new("history", history)?;
        let (bodies, bytes) = (reading(half_space)?, entries("bytes", bytes, length)?);
        let made = History::from_bytes(&bodies, bytes)?;
        give(place, made, bodies.grid().cells())
    })
}
