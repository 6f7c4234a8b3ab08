//! Scratch memory that the tasks of a stage borrow.

use std::sync::{Mutex, PoisonError};

use crate::parallel;

/// As many pieces as tasks have worked at once, at first one for each thread of the pool.
#[derive(Debug)]
pub(super) struct Scratch<T> {
    free: Mutex<Vec<T>>,
}

impl<T: Clone> Scratch<T> {
    /// Pieces like this one.
    pub(super) fn new(piece: T, is_short: bool) -> Self {
        let pieces = if is_short { 1 } else { parallel::threads() };
        Self {
            free: Mutex::new(vec![piece; pieces]),
        }
    }

    /// Lends a piece; makes one if all are out. What is in it does not matter to anyone.
    pub(super) fn lend<R>(&self, make: impl FnOnce() -> T, work: impl FnOnce(&mut T) -> R) -> R {
        let free = self
            .free
            .lock()
            .unwrap_or_else(PoisonError::into_inner)
            .pop();
        let mut piece = free.unwrap_or_else(make);
        let result = work(&mut piece);
        self.free
            .lock()
            .unwrap_or_else(PoisonError::into_inner)
            .push(piece);
        result
    }
}

impl<T: Clone> Clone for Scratch<T> {
    fn clone(&self) -> Self {
        let free = self.free.lock().unwrap_or_else(PoisonError::into_inner);
        Self {
            free: Mutex::new(free.clone()),
        }
    }
}
