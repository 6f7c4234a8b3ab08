//! Plain data by pointer.
//!
//! The rule for pointers, on which every `unsafe` of this crate rests and which the head of the header states: a pointer
//! is NULL, or points to what its type says, for as long as the call (handles: until they are freed); an array has as many
//! entries as the number beside it says; nothing else writes to what it points to meanwhile.

use stickslip_rs::{Error, Field, Grid};

use crate::call::Outcome;
use crate::error::Failure;
use crate::status::STICKSLIP_LENGTH;

/// A struct that is needed.
///
/// # Safety
/// The rule for pointers.
pub(crate) unsafe fn input<'a, T>(name: &str, pointer: *const T) -> Outcome<&'a T> {
    // SAFETY: as of this function.
    unsafe { optional(name, pointer)? }.ok_or_else(|| Failure::pointer(name))
}

/// A struct that may be left out.
///
/// # Safety
/// The rule for pointers.
pub(crate) unsafe fn optional<'a, T>(name: &str, pointer: *const T) -> Outcome<Option<&'a T>> {
    if !pointer.is_aligned() {
        return Err(Failure::pointer(name));
    }
    // SAFETY: NULL or valid by the rule, and aligned.
    Ok(unsafe { pointer.as_ref() })
}

/// A place for an answer. It is checked when it is made, before any work, so that to write to it cannot fail: a call that
/// has changed something does not fail for want of a place.
#[derive(Debug)]
pub(crate) struct Place<T>(*mut T);

impl<T> Place<T> {
    /// A place that is needed.
    ///
    /// # Safety
    /// The rule for pointers, until the answer is put there.
    pub(crate) unsafe fn new(name: &str, pointer: *mut T) -> Outcome<Self> {
        // SAFETY: as of this function.
        unsafe { Self::if_asked(name, pointer)? }.ok_or_else(|| Failure::pointer(name))
    }

    /// A place that may be left out.
    ///
    /// # Safety
    /// The rule for pointers, until the answer is put there.
    pub(crate) unsafe fn if_asked(name: &str, pointer: *mut T) -> Outcome<Option<Self>> {
        if !pointer.is_aligned() {
            return Err(Failure::pointer(name));
        }
        Ok((!pointer.is_null()).then_some(Self(pointer)))
    }

    /// Writes the answer.
    pub(crate) fn put(self, value: T) {
        // SAFETY: neither NULL nor misaligned, so valid by the rule.
        unsafe { self.0.write(value) };
    }
}

/// Writes what is found to a place that is checked before.
///
/// # Safety
/// The rule for pointers.
pub(crate) unsafe fn answer<T>(
    name: &str,
    pointer: *mut T,
    find: impl FnOnce() -> Outcome<T>,
) -> Outcome {
    // SAFETY: as of this function.
    let place = unsafe { Place::new(name, pointer)? };
    place.put(find()?);
    Ok(())
}

/// An array of so many entries.
///
/// # Safety
/// The rule for pointers.
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
    // SAFETY: valid for so many entries by the rule, aligned, and no larger than memory.
    Ok(unsafe { std::slice::from_raw_parts(pointer, count) })
}

/// The same, to be written to.
///
/// # Safety
/// The rule for pointers.
pub(crate) unsafe fn entries_mut<'a, T>(
    name: &str,
    pointer: *mut T,
    count: usize,
) -> Outcome<&'a mut [T]> {
    // SAFETY: as of this function.
    unsafe { entries(name, pointer.cast_const(), count)? };
    if count == 0 {
        return Ok(&mut []);
    }
    // SAFETY: checked as an array just now, and nobody else has it by the rule.
    Ok(unsafe { std::slice::from_raw_parts_mut(pointer, count) })
}

/// A number for each cell of a grid.
///
/// # Safety
/// The rule for pointers.
pub(crate) unsafe fn cells<'a>(
    name: &str,
    grid: Grid,
    pointer: *const f64,
    count: usize,
) -> Outcome<&'a [f64]> {
    expect_cells(name, grid, count)?;
    // SAFETY: as of this function.
    unsafe { entries(name, pointer, count) }
}

/// The same, to be written to.
///
/// # Safety
/// The rule for pointers.
pub(crate) unsafe fn cells_mut<'a>(
    name: &str,
    grid: Grid,
    pointer: *mut f64,
    count: usize,
) -> Outcome<&'a mut [f64]> {
    expect_cells(name, grid, count)?;
    // SAFETY: as of this function.
    unsafe { entries_mut(name, pointer, count) }
}

/// The same, copied to keep.
///
/// # Safety
/// The rule for pointers.
pub(crate) unsafe fn field(
    name: &str,
    grid: Grid,
    pointer: *const f64,
    count: usize,
) -> Outcome<Field> {
    // SAFETY: as of this function.
    let samples = unsafe { cells(name, grid, pointer, count)? };
    let samples = collected(Vec::new(), samples.iter().copied())?;
    Ok(Field::from_vec(grid, samples)?)
}

/// What an iterator gives, in the place of what an array held.
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

/// `Ok` if an array has an entry for each cell.
pub(crate) fn expect_cells(name: &str, grid: Grid, found: usize) -> Outcome {
    let expected = grid.cells();
    if found != expected {
        return Err(Failure::length(STICKSLIP_LENGTH, name, [expected, found]));
    }
    Ok(())
}

/// A field without a copy: its first sample, and how many there are if that is asked for.
///
/// # Safety
/// The rule for pointers.
pub(crate) unsafe fn samples<T>(samples: &[T], count: *mut usize) -> Outcome<*const T> {
    // SAFETY: as of this function.
    if let Some(place) = unsafe { Place::if_asked("count", count)? } {
        place.put(samples.len());
    }
    Ok(samples.as_ptr())
}
