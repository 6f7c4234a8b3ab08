//! Plain data by pointer.
//!
//! Every `unsafe` of this crate relies on the rule for pointers, which the head of the header states. A pointer is NULL, or
//! points to a value of its type for the duration of the call (for handles: until they are freed). An array has as many
//! entries as the accompanying count. During this time, nothing else writes to the data behind the pointer.

use stickslip_rs::{Error, Field, Grid};

use crate::call::Outcome;
use crate::error::Failure;
use crate::status::STICKSLIP_LENGTH;

/// Returns a required struct.
///
/// # Safety
/// The caller must follow the rule for pointers in [`crate::pointer`].
pub(crate) unsafe fn input<'a, T>(name: &str, pointer: *const T) -> Outcome<&'a T> {
    // SAFETY: the caller follows the safety contract of this function.
    unsafe { optional(name, pointer)? }.ok_or_else(|| Failure::pointer(name))
}

/// Returns an optional struct; `None` for NULL.
///
/// # Safety
/// The caller must follow the rule for pointers in [`crate::pointer`].
pub(crate) unsafe fn optional<'a, T>(name: &str, pointer: *const T) -> Outcome<Option<&'a T>> {
    if !pointer.is_aligned() {
        return Err(Failure::pointer(name));
    }
    // SAFETY: the pointer is NULL or valid by the rule, and it is aligned.
    Ok(unsafe { pointer.as_ref() })
}

/// Destination of a result. The pointer is checked at construction, before any work, so that writing cannot fail. A call
/// that has changed an object therefore never fails because of its destination.
#[derive(Debug)]
pub(crate) struct Place<T>(*mut T);

impl<T> Place<T> {
    /// Creates a required destination.
    ///
    /// # Safety
    /// The caller must follow the rule for pointers in [`crate::pointer`] until the result is written.
    pub(crate) unsafe fn new(name: &str, pointer: *mut T) -> Outcome<Self> {
        // SAFETY: the caller follows the safety contract of this function.
        unsafe { Self::if_asked(name, pointer)? }.ok_or_else(|| Failure::pointer(name))
    }

    /// Creates an optional destination; `None` for NULL.
    ///
    /// # Safety
    /// The caller must follow the rule for pointers in [`crate::pointer`] until the result is written.
    pub(crate) unsafe fn if_asked(name: &str, pointer: *mut T) -> Outcome<Option<Self>> {
        if !pointer.is_aligned() {
            return Err(Failure::pointer(name));
        }
        Ok((!pointer.is_null()).then_some(Self(pointer)))
    }

    /// Writes the result.
    pub(crate) fn put(self, value: T) {
        // SAFETY: the pointer is neither NULL nor misaligned, so it is valid by the rule.
        unsafe { self.0.write(value) };
    }
}

impl<T> Place<*mut T> {
    /// Creates the required destination of a new object, and sets it to NULL. A caller can therefore free the object after a
    /// failure.
    ///
    /// # Safety
    /// The caller must follow the rule for pointers in [`crate::pointer`] until the result is written.
    pub(crate) unsafe fn of_object(name: &str, pointer: *mut *mut T) -> Outcome<Self> {
        // SAFETY: the caller follows the safety contract of this function.
        let place = unsafe { Self::new(name, pointer)? };
        // SAFETY: the pointer was checked above.
        unsafe { place.0.write(std::ptr::null_mut()) };
        Ok(place)
    }
}

/// Writes the result of a computation to a destination that is checked first.
///
/// # Safety
/// The caller must follow the rule for pointers in [`crate::pointer`].
pub(crate) unsafe fn answer<T>(
    name: &str,
    pointer: *mut T,
    find: impl FnOnce() -> Outcome<T>,
) -> Outcome {
    // SAFETY: the caller follows the safety contract of this function.
    let place = unsafe { Place::new(name, pointer)? };
    place.put(find()?);
    Ok(())
}

/// Returns an array of `count` entries.
///
/// # Safety
/// The caller must follow the rule for pointers in [`crate::pointer`].
pub(crate) unsafe fn entries<'a, T>(
    name: &str,
    pointer: *const T,
    count: usize,
) -> Outcome<&'a [T]> {
    if count == 0 {
        return Ok(&[]);
    }
    let is_possible = size_of::<T>()
        .checked_mul(count)
        .is_some_and(|bytes| isize::try_from(bytes).is_ok());
    if pointer.is_null() || !pointer.is_aligned() || !is_possible {
        return Err(Failure::pointer(name));
    }
    // SAFETY: the pointer is valid for `count` entries by the rule, aligned, and the array is no larger than memory.
    Ok(unsafe { std::slice::from_raw_parts(pointer, count) })
}

/// Returns a mutable array of `count` entries.
///
/// # Safety
/// The caller must follow the rule for pointers in [`crate::pointer`].
pub(crate) unsafe fn entries_mut<'a, T>(
    name: &str,
    pointer: *mut T,
    count: usize,
) -> Outcome<&'a mut [T]> {
    // SAFETY: the caller follows the safety contract of this function.
    unsafe { entries(name, pointer.cast_const(), count)? };
    if count == 0 {
        return Ok(&mut []);
    }
    // SAFETY: the array was checked above, and nothing else accesses it by the rule.
    Ok(unsafe { std::slice::from_raw_parts_mut(pointer, count) })
}

/// Returns an array with a number for each cell of a grid.
///
/// # Safety
/// The caller must follow the rule for pointers in [`crate::pointer`].
pub(crate) unsafe fn cells<'a>(
    name: &str,
    grid: Grid,
    pointer: *const f64,
    count: usize,
) -> Outcome<&'a [f64]> {
    expect_cells(name, grid, count)?;
    // SAFETY: the caller follows the safety contract of this function.
    unsafe { entries(name, pointer, count) }
}

/// Returns a mutable array with a number for each cell of a grid.
///
/// # Safety
/// The caller must follow the rule for pointers in [`crate::pointer`].
pub(crate) unsafe fn cells_mut<'a>(
    name: &str,
    grid: Grid,
    pointer: *mut f64,
    count: usize,
) -> Outcome<&'a mut [f64]> {
    expect_cells(name, grid, count)?;
    // SAFETY: the caller follows the safety contract of this function.
    unsafe { entries_mut(name, pointer, count) }
}

/// Returns a copy of an array with a number for each cell, as a field.
///
/// # Safety
/// The caller must follow the rule for pointers in [`crate::pointer`].
pub(crate) unsafe fn field(
    name: &str,
    grid: Grid,
    pointer: *const f64,
    count: usize,
) -> Outcome<Field> {
    // SAFETY: the caller follows the safety contract of this function.
    let samples = unsafe { cells(name, grid, pointer, count)? };
    let samples = collected(Vec::new(), samples.iter().copied())?;
    Ok(Field::from_vec(grid, samples)?)
}

/// Collects an iterator into an existing array and reports a failed allocation.
pub(crate) fn collected<T>(
    mut array: Vec<T>,
    items: impl ExactSizeIterator<Item = T>,
) -> Outcome<Vec<T>> {
    array.clear();
    let room = array.try_reserve_exact(items.len());
    room.map_err(|_| Error::Memory {
        quantity: "a copy of an array",
        bytes: items.len() as u128 * size_of::<T>() as u128,
    })?;
    array.extend(items);
    Ok(array)
}

/// Returns an error unless an array has an entry for each cell.
pub(crate) fn expect_cells(name: &str, grid: Grid, found: usize) -> Outcome {
    let expected = grid.cells();
    if found != expected {
        return Err(Failure::length(STICKSLIP_LENGTH, name, [expected, found]));
    }
    Ok(())
}

/// Returns a pointer to the first sample of a field, and writes the number of samples if `count` is not NULL.
///
/// # Safety
/// The caller must follow the rule for pointers in [`crate::pointer`].
pub(crate) unsafe fn samples<T>(samples: &[T], count: *mut usize) -> Outcome<*const T> {
    // SAFETY: the caller follows the safety contract of this function.
    if let Some(place) = unsafe { Place::if_asked("count", count)? } {
        place.put(samples.len());
    }
    Ok(samples.as_ptr())
}
