//! The insides of functions that read an object. All objects are read in the same way; the exported functions differ in their
//! names, which cbindgen needs to see in the source.

use stickslip_rs::{Result, Warning};

use crate::call::{Outcome, call_for, call_on};
use crate::handle::{Opaque, reading};
use crate::pointer::{answer, samples};
use crate::results::{put_warnings, stickslip_warning};
use crate::status::stickslip_status;

/// Writes what an object tells.
///
/// # Safety
/// The rule for pointers.
pub(crate) unsafe fn tell<T: Opaque, A>(
    object: *const T,
    (name, place): (&str, *mut A),
    find: impl FnOnce(&T::Value) -> Outcome<A>,
) -> stickslip_status {
    // SAFETY: as of this function.
    call_on(object, || unsafe {
        answer(name, place, || find(&*reading(object)?))
    })
}

/// Returns what an object holds for each cell, and how many cells there are.
///
/// # Safety
/// The rule for pointers.
pub(crate) unsafe fn show<T: Opaque, A>(
    object: *const T,
    count: *mut usize,
    find: impl FnOnce(&T::Value) -> Outcome<&[A]>,
) -> *const A {
    // SAFETY: as of this function.
    call_for(|| unsafe { samples(find(&*reading(object)?)?, count) })
}

/// Writes warnings on an object.
///
/// # Safety
/// The rule for pointers.
pub(crate) unsafe fn warn<T: Opaque>(
    object: *const T,
    (buffer, capacity, count): (*mut stickslip_warning, usize, *mut usize),
    find: impl FnOnce(&T::Value) -> Result<Vec<Warning>>,
) -> stickslip_status {
    // SAFETY: as of this function.
    call_on(object, || unsafe {
        put_warnings(buffer, capacity, count, || Ok(find(&*reading(object)?)?))
    })
}
