//! Pool of buffers that are in use only during work.

use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use crate::error::Result;

/// Pool of free buffers. The pool grows to the largest number of buffers that were in use simultaneously. Users must not rely
/// on the contents of a buffer.
#[derive(Debug)]
pub(crate) struct Pool<T> {
    free: Mutex<Vec<T>>,
}

impl<T> Pool<T> {
    pub(crate) fn new(pieces: Vec<T>) -> Self {
        Self {
            free: Mutex::new(pieces),
        }
    }

    /// Creates a pool of `pieces` buffers.
    pub(crate) fn of(pieces: usize, make: impl Fn() -> Result<T>) -> Result<Self> {
        (0..pieces)
            .map(|_| make())
            .collect::<Result<_>>()
            .map(Self::new)
    }

    /// Runs `work` with a buffer of a pool that has at least one buffer. Creates a buffer if none is free.
    pub(crate) fn lend<R>(
        &self,
        make: impl Fn() -> Result<T>,
        work: impl FnOnce(&mut T) -> R,
    ) -> R {
        let mut piece = loop {
            if let Some(piece) = self.take().or_else(|| make().ok()) {
                break piece;
            }
            // There is no memory for a new buffer. The user of a buffer never waits for a second buffer, so a buffer is soon
            // returned.
            std::thread::yield_now();
        };
        let result = work(&mut piece);
        self.give(piece);
        result
    }

    /// Returns a free buffer, or `None` if all are in use.
    pub(crate) fn take(&self) -> Option<T> {
        self.free().pop()
    }

    /// Returns a buffer to the pool, or drops it if there is no memory for a longer list.
    pub(crate) fn give(&self, piece: T) {
        let mut free = self.free();
        if free.try_reserve(1).is_ok() {
            free.push(piece);
        }
    }

    fn free(&self) -> MutexGuard<'_, Vec<T>> {
        // A panic while the lock is held leaves the list valid, so a poisoned lock can be used.
        self.free.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

impl<T: Clone> Clone for Pool<T> {
    fn clone(&self) -> Self {
        Self::new(self.free().clone())
    }
}

/// Buffer of a pool from its first use until its return.
#[derive(Debug)]
pub(crate) struct PooledBuffer<T> {
    pool: Arc<Pool<T>>,
    piece: Option<T>,
}

impl<T> PooledBuffer<T> {
    pub(crate) fn new(pool: Arc<Pool<T>>) -> Self {
        Self { pool, piece: None }
    }

    /// Returns the buffer. Creates a buffer if none is free.
    pub(crate) fn take(&mut self, make: impl FnOnce() -> Result<T>) -> Result<&mut T> {
        match &mut self.piece {
            Some(piece) => Ok(piece),
            none => {
                let piece = self.pool.take().map_or_else(make, Ok)?;
                Ok(none.insert(piece))
            }
        }
    }

    /// Returns the buffer if it is in use, that is, between its first use and its return. Otherwise returns `None`.
    pub(crate) fn held(&self) -> Option<&T> {
        self.piece.as_ref()
    }

    pub(crate) fn held_mut(&mut self) -> Option<&mut T> {
        self.piece.as_mut()
    }

    /// Returns the buffer and removes it from the pool permanently.
    pub(crate) fn into_piece(self) -> Option<T> {
        self.piece
    }

    pub(crate) fn give_back(&mut self) {
        if let Some(piece) = self.piece.take() {
            self.pool.give(piece);
        }
    }
}

/// Creates a further user of the same pool, without a buffer.
impl<T> Clone for PooledBuffer<T> {
    fn clone(&self) -> Self {
        Self::new(Arc::clone(&self.pool))
    }
}
