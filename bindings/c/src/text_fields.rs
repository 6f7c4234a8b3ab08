//! Bodies of the functions that read an object. All objects are read in the same way. The exported functions differ only in
//! their names, which cbindgen must find in the source.

use stickslip_rs::{Result, Warning};

use crate::call::{Outcome, call_for, call_on};
use crate::handle::{Opaque, reading};
use crate::pointer::{answer, samples};
use crate::results::{put_warnings, stickslip_warning};
use crate::status::stickslip_status;

/// Writes a value that is computed from an object.
///
/// # Safety
/// The caller must follow the rule for pointers in [`crate::pointer`].
pub(crate) unsafe fn tell<T: Opaque, A>(
    object: *const T,
    (name, place): (&str, *mut A),
    find: impl FnOnce(&T::Value) -> Outcome<A>,
) -> stickslip_status {
    // SAFETY: the caller follows the safety contract of this function.
    call_on(object, || unsafe {
        answer(name, place, || find(&*reading(object)?))
    })
}

/// Returns a pointer to an array of an object with an entry for each cell, and writes the number of cells.
///
/// # Safety
/// The caller must follow the rule for pointers in [`crate::pointer`].
pub(crate) unsafe fn show<T: Opaque, A>(
    object: *const T,
    count: *mut usize,
    find: impl FnOnce(&T::Value) -> Outcome<&[A]>,
) -> *const A {
    // SAFETY: the caller follows the safety contract of this function.
    call_for(|| unsafe { samples(find(&*reading(object)?)?, count) })
}

/// Writes the warnings about an object.
///
/// # Safety
/// The caller must follow the rule for pointers in [`crate::pointer`].
pub(crate) unsafe fn warn<T: Opaque>(
    object: *const T,
    (buffer, capacity, count): (*mut stickslip_warning, usize, *mut usize),
    find: impl FnOnce(&T::Value) -> Result<Vec<Warning>>,
) -> stickslip_status {
    // SAFETY: the caller follows the safety contract of this function.
    call_on(object, || unsafe {
        put_warnings(buffer, capacity, count, || Ok(find(&*reading(object)?)?))
    })
}
