//! Objects that several threads may share but only one may use at a time, and solutions whose memory is reused.

use std::sync::{Arc, Mutex, MutexGuard, TryLockError};

use pyo3::exceptions::PyRuntimeError;
use pyo3::prelude::*;

/// Locks a mutable object, which one thread at a time may use.
pub(crate) fn lock<'a, T>(place: &'a Mutex<T>, what: &str) -> PyResult<MutexGuard<'a, T>> {
    match place.try_lock() {
        Ok(guard) => Ok(guard),
        // The crate leaves its data consistent when it panics, so a poisoned lock can be used.
        Err(TryLockError::Poisoned(guard)) => Ok(guard.into_inner()),
        Err(TryLockError::WouldBlock) => Err(PyRuntimeError::new_err(format!(
            "the {what} is in use by another thread or by the call that made this call: wait until that call returns"
        ))),
    }
}

/// Pool of returned solutions; a solution without other owners is filled again.
pub(crate) struct Spare<T>(Vec<Arc<T>>);

/// A loop that assigns each solution to the same variable still owns one solution while the next is computed.
const KEPT: usize = 2;

impl<T> Spare<T> {
    pub(crate) const fn new() -> Self {
        Self(Vec::new())
    }

    /// Returns a solution without other owners.
    pub(crate) fn take(&mut self, new: impl FnOnce() -> T) -> Arc<T> {
        let free = self
            .0
            .iter_mut()
            .position(|kept| Arc::get_mut(kept).is_some());
        match free {
            Some(index) => self.0.swap_remove(index),
            None => Arc::new(new()),
        }
    }

    /// Stores a solution that is returned to the caller.
    pub(crate) fn keep(&mut self, solution: &Arc<T>) {
        if self.0.len() < KEPT {
            self.0.push(Arc::clone(solution));
        }
    }
}
