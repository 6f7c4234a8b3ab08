//! Objects that C holds by pointer, with a count of who is using them.

use std::cell::UnsafeCell;
use std::ops::{Deref, DerefMut};
use std::sync::atomic::{AtomicIsize, Ordering};

use stickslip_rs::Error;

use crate::call::Outcome;
use crate::error::Failure;
use crate::pointer::{Place, input};
use crate::scratch::Spare;

/// A value that several may read at once, or one may change.
#[derive(Debug)]
pub(crate) struct Handle<T> {
    /// Those who read it now; -1 while one changes it.
    users: AtomicIsize,
    /// Cells of its grid.
    cells: usize,
    /// Memory for its calls.
    spare: Spare,
    value: UnsafeCell<T>,
}

const CHANGING: isize = -1;

impl<T> Handle<T> {
    fn read(&self) -> Option<Reading<'_, T>> {
        let enter = |users: isize| (users != CHANGING).then_some(users + 1);
        let outcome = self
            .users
            .fetch_update(Ordering::Acquire, Ordering::Relaxed, enter);
        // Not made where it may not be: to drop it gives the value back.
        outcome.is_ok().then(|| Reading(self))
    }

    fn change(&self) -> Option<Changing<'_, T>> {
        let outcome =
            self.users
                .compare_exchange(0, CHANGING, Ordering::Acquire, Ordering::Relaxed);
        outcome.is_ok().then(|| Changing(self))
    }
}

/// The value, while it is read.
#[derive(Debug)]
pub(crate) struct Reading<'a, T>(&'a Handle<T>);

impl<'a, T> Reading<'a, T> {
    /// Memory for this call.
    pub(crate) fn spare(&self) -> &'a Spare {
        &self.0.spare
    }
}

impl<T> Deref for Reading<'_, T> {
    type Target = T;

    fn deref(&self) -> &T {
        // SAFETY: while this is counted, nobody changes the value.
        unsafe { &*self.0.value.get() }
    }
}

impl<T> Drop for Reading<'_, T> {
    fn drop(&mut self) {
        self.0.users.fetch_sub(1, Ordering::Release);
    }
}

/// The value, while one changes it.
#[derive(Debug)]
pub(crate) struct Changing<'a, T>(&'a Handle<T>);

// SAFETY: it is the only way to the value while it lives, as a mutable reference is.
unsafe impl<T: Send> Send for Changing<'_, T> {}

impl<'a, T> Changing<'a, T> {
    /// Memory for this call.
    pub(crate) fn spare(&self) -> &'a Spare {
        &self.0.spare
    }
}

impl<T> Deref for Changing<'_, T> {
    type Target = T;

    fn deref(&self) -> &T {
        // SAFETY: nobody else has the value.
        unsafe { &*self.0.value.get() }
    }
}

impl<T> DerefMut for Changing<'_, T> {
    fn deref_mut(&mut self) -> &mut T {
        // SAFETY: nobody else has the value.
        unsafe { &mut *self.0.value.get() }
    }
}

impl<T> Drop for Changing<'_, T> {
    fn drop(&mut self) {
        self.0.users.store(0, Ordering::Release);
    }
}

/// A type that C knows by name alone.
pub(crate) trait Opaque: From<Handle<Self::Value>> {
    /// What it holds. Threads may share it, since each use of a handle is of one of them.
    type Value: Send + Sync;
    /// What it is called in messages.
    const NAME: &'static str;

    fn handle(&self) -> &Handle<Self::Value>;
}

/// Makes a struct of one handle an opaque type.
macro_rules! opaque {
    ($type:ident holds $value:ty, named $name:literal) => {
        impl From<crate::handle::Handle<$value>> for $type {
            fn from(handle: crate::handle::Handle<$value>) -> Self {
                Self(handle)
            }
        }

        impl crate::handle::Opaque for $type {
            type Value = $value;
            const NAME: &'static str = $name;

            fn handle(&self) -> &crate::handle::Handle<$value> {
                &self.0
            }
        }
    };
}

pub(crate) use opaque;

/// Hands a new object over to C, with the number of cells of its grid.
pub(crate) fn give<T: Opaque>(place: Place<*mut T>, value: T::Value, cells: usize) -> Outcome {
    let object = T::from(Handle {
        users: AtomicIsize::new(0),
        cells,
        spare: Spare::default(),
        value: UnsafeCell::new(value),
    });
    // A slice of one, since a box aborts where memory runs out; it is freed as a box of the object, whose layout it has.
    let mut one = Vec::new();
    one.try_reserve_exact(1).map_err(|_| Error::Memory {
        quantity: T::NAME,
        bytes: size_of::<T>() as u128,
    })?;
    one.push(object);
    place.put(Box::into_raw(one.into_boxed_slice()).cast());
    Ok(())
}

/// Cells of the grid of an object, whoever uses it; none without one.
///
/// # Safety
/// The rule for pointers.
pub(crate) unsafe fn cells_of<T: Opaque>(pointer: *const T) -> usize {
    // SAFETY: as of this function; the number of cells never changes.
    let object = unsafe { input(T::NAME, pointer) };
    object.map_or(0, |object| object.handle().cells)
}

/// An object to be read.
///
/// # Safety
/// The rule for pointers.
pub(crate) unsafe fn reading<'a, T: Opaque + 'a>(
    pointer: *const T,
) -> Outcome<Reading<'a, T::Value>> {
    // SAFETY: as of this function.
    let object = unsafe { input(T::NAME, pointer)? };
    object.handle().read().ok_or_else(|| Failure::busy(T::NAME))
}

/// An object to be changed.
///
/// # Safety
/// The rule for pointers.
pub(crate) unsafe fn changing<'a, T: Opaque + 'a>(
    pointer: *const T,
) -> Outcome<Changing<'a, T::Value>> {
    // SAFETY: as of this function; what changes is behind the count of users.
    let object = unsafe { input(T::NAME, pointer)? };
    object
        .handle()
        .change()
        .ok_or_else(|| Failure::busy(T::NAME))
}

/// Frees an object; nothing for NULL. One in use is not freed.
///
/// # Safety
/// The rule for pointers; the pointer came from [`give`], and is not used again if this succeeds.
pub(crate) unsafe fn free<T: Opaque>(pointer: *mut T) -> Outcome {
    if pointer.is_null() {
        return Ok(());
    }
    // SAFETY: as of this function. The mark of use is not taken back: there is no object left to use.
    std::mem::forget(unsafe { changing(pointer.cast_const())? });
    // SAFETY: from the box of `give`, and given up by the caller.
    drop(unsafe { Box::from_raw(pointer) });
    Ok(())
}
