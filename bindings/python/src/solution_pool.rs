//! Objects that many threads may hold, and one may use; solutions whose memory is used again.

use std::sync::{Arc, Mutex, MutexGuard, TryLockError};

use pyo3::exceptions::PyRuntimeError;
use pyo3::prelude::*;

/// What changes, used by one thread at a time.
pub(crate) fn lock<'a, T>(place: &'a Mutex<T>, what: &str) -> PyResult<MutexGuard<'a, T>> {
    match place.try_lock() {
        Ok(guard) => Ok(guard),
        // What a panic leaves behind is as the crate leaves it: in order.
        Err(TryLockError::Poisoned(guard)) => Ok(guard.into_inner()),
        Err(TryLockError::WouldBlock) => Err(PyRuntimeError::new_err(format!(
            "the {what} is in use, by another thread or by the call that this one is made from"
        ))),
    }
}

/// Solutions that were handed out, of which those that nobody holds any more are filled again.
pub(crate) struct Spare<T>(Vec<Arc<T>>);

/// A loop that assigns each solution to the same name holds one while the next is found.
const KEPT: usize = 2;

impl<T> Spare<T> {
    pub(crate) const fn new() -> Self {
        Self(Vec::new())
    }

    /// One that nobody else holds.
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

    /// Keeps one that is handed out.
    pub(crate) fn keep(&mut self, solution: &Arc<T>) {
        if self.0.len() < KEPT {
            self.0.push(Arc::clone(solution));
        }
    }
}
