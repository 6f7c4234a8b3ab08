//! Objects that C refers to by pointer, with a count of their users.

use std::cell::UnsafeCell;
use std::ops::{Deref, DerefMut};
use std::sync::atomic::{AtomicIsize, Ordering};

use stickslip_rs::Error;

use crate::call::Outcome;
use crate::error::Failure;
use crate::pointer::{Place, input};
use crate::scratch::Spare;

/// Value with many simultaneous readers or one writer.
#[derive(Debug)]
pub(crate) struct Handle<T> {
    /// Number of current readers; -1 during a change.
    users: AtomicIsize,
    /// Number of cells of the grid.
    cells: usize,
    /// Memory for calls on the object.
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
        // The guard is created only after the count was raised, because dropping it lowers the count.
        outcome.is_ok().then(|| Reading(self))
    }

    fn change(&self) -> Option<Changing<'_, T>> {
        let outcome =
            self.users
                .compare_exchange(0, CHANGING, Ordering::Acquire, Ordering::Relaxed);
        outcome.is_ok().then(|| Changing(self))
    }
}

/// Shared access to a value.
#[derive(Debug)]
pub(crate) struct Reading<'a, T>(&'a Handle<T>);

impl<'a, T> Reading<'a, T> {
    /// Returns the memory for this call.
    pub(crate) fn spare(&self) -> &'a Spare {
        &self.0.spare
    }
}

impl<T> Deref for Reading<'_, T> {
    type Target = T;

    fn deref(&self) -> &T {
        // SAFETY: the value does not change while this reader is counted.
        unsafe { &*self.0.value.get() }
    }
}

impl<T> Drop for Reading<'_, T> {
    fn drop(&mut self) {
        self.0.users.fetch_sub(1, Ordering::Release);
    }
}

/// Exclusive access to a value.
#[derive(Debug)]
pub(crate) struct Changing<'a, T>(&'a Handle<T>);

// SAFETY: the guard is the only access to the value during its lifetime, like a mutable reference.
unsafe impl<T: Send> Send for Changing<'_, T> {}

impl<'a, T> Changing<'a, T> {
    /// Returns the memory for this call.
    pub(crate) fn spare(&self) -> &'a Spare {
        &self.0.spare
    }
}

impl<T> Deref for Changing<'_, T> {
    type Target = T;

    fn deref(&self) -> &T {
        // SAFETY: the guard has exclusive access to the value.
        unsafe { &*self.0.value.get() }
    }
}

impl<T> DerefMut for Changing<'_, T> {
    fn deref_mut(&mut self) -> &mut T {
        // SAFETY: the guard has exclusive access to the value.
        unsafe { &mut *self.0.value.get() }
    }
}

impl<T> Drop for Changing<'_, T> {
    fn drop(&mut self) {
        self.0.users.store(0, Ordering::Release);
    }
}

/// Opaque type of the C interface.
pub(crate) trait Opaque: From<Handle<Self::Value>> {
    /// Value behind the handle. Threads may share the value, because any thread may use a handle.
    type Value: Send + Sync;
    /// Name of the object in messages.
    const NAME: &'static str;

    fn handle(&self) -> &Handle<Self::Value>;
}

/// Implements [`Opaque`] for a struct with one handle.
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

/// Passes a new object to C, with the number of cells of its grid.
pub(crate) fn give<T: Opaque>(place: Place<*mut T>, value: T::Value, cells: usize) -> Outcome {
    let object = T::from(Handle {
        users: AtomicIsize::new(0),
        cells,
        spare: Spare::default(),
        value: UnsafeCell::new(value),
    });
    // A vector of one element reports a failed allocation, whereas a box aborts. The object is freed as a box, which has
    // the same layout.
    let mut one = Vec::new();
    one.try_reserve_exact(1).map_err(|_| Error::Memory {
        quantity: T::NAME,
        bytes: size_of::<T>() as u128,
    })?;
    one.push(object);
    place.put(Box::into_raw(one.into_boxed_slice()).cast());
    Ok(())
}

/// Returns an object.
///
/// # Safety
/// The caller must follow the rule for pointers in [`crate::pointer`].
unsafe fn object<'a, T: Opaque>(pointer: *const T) -> Outcome<&'a T> {
    // SAFETY: the caller follows the safety contract of this function.
    unsafe { input(T::NAME, pointer) }.map_err(|_| Failure::object(T::NAME))
}

/// Returns the number of cells of the grid of an object, or zero for an invalid pointer. Other threads may use the object
/// at the same time.
///
/// # Safety
/// The caller must follow the rule for pointers in [`crate::pointer`].
pub(crate) unsafe fn cells_of<T: Opaque>(pointer: *const T) -> usize {
    // SAFETY: the safety contract of this function; the number of cells never changes.
    let object = unsafe { object(pointer) };
    object.map_or(0, |object| object.handle().cells)
}

/// Returns shared access to an object.
///
/// # Safety
/// The caller must follow the rule for pointers in [`crate::pointer`].
pub(crate) unsafe fn reading<'a, T: Opaque + 'a>(
    pointer: *const T,
) -> Outcome<Reading<'a, T::Value>> {
    // SAFETY: the caller follows the safety contract of this function.
    let object = unsafe { object(pointer)? };
    object.handle().read().ok_or_else(|| Failure::busy(T::NAME))
}

/// Returns exclusive access to an object.
///
/// # Safety
/// The caller must follow the rule for pointers in [`crate::pointer`].
pub(crate) unsafe fn changing<'a, T: Opaque + 'a>(
    pointer: *const T,
) -> Outcome<Changing<'a, T::Value>> {
    // SAFETY: the safety contract of this function; the count of users protects the value.
    let object = unsafe { object(pointer)? };
    object
        .handle()
        .change()
        .ok_or_else(|| Failure::busy(T::NAME))
}

/// Frees an object; does nothing for NULL. An object in use is not freed.
///
/// # Safety
/// The caller must follow the rule for pointers in [`crate::pointer`]. The pointer must come from [`give`] and must not
/// be used again if this function succeeds.
pub(crate) unsafe fn free<T: Opaque>(pointer: *mut T) -> Outcome {
    if pointer.is_null() {
        return Ok(());
    }
    // SAFETY: the caller follows the safety contract of this function. The count of users is not restored, because no object
    // remains.
    std::mem::forget(unsafe { changing(pointer.cast_const())? });
    // SAFETY: the box comes from `give`, and the caller no longer uses it.
    drop(unsafe { Box::from_raw(pointer) });
    Ok(())
}
