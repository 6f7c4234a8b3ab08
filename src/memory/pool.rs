//! Memory that its users have only while they work.

use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use crate::error::Result;

/// Pieces of memory that are free: as many as were in use at once. What is in a piece does not matter to who takes it.
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

    /// So many pieces.
    pub(crate) fn of(pieces: usize, make: impl Fn() -> Result<T>) -> Result<Self> {
        (0..pieces)
            .map(|_| make())
            .collect::<Result<_>>()
            .map(Self::new)
    }

    /// Lends a piece of a pool that has some for this work; makes one if all are out.
    pub(crate) fn lend<R>(
        &self,
        make: impl Fn() -> Result<T>,
        work: impl FnOnce(&mut T) -> R,
    ) -> R {
        let mut piece = loop {
            if let Some(piece) = self.take().or_else(|| make().ok()) {
                break piece;
            }
            // There is no memory for another one. Who has a piece waits for nobody, and soon gives it back.
            std::thread::yield_now();
        };
        let result = work(&mut piece);
        self.give(piece);
        result
    }

    /// A piece, if one is free.
    pub(crate) fn take(&self) -> Option<T> {
        self.free().pop()
    }

    /// Takes a piece back; gives it up if there is no memory for a longer list.
    pub(crate) fn give(&self, piece: T) {
        let mut free = self.free();
        if free.try_reserve(1).is_ok() {
            free.push(piece);
        }
    }

    fn free(&self) -> MutexGuard<'_, Vec<T>> {
        // What panics under the lock leaves a list of whole pieces.
        self.free.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

impl<T: Clone> Clone for Pool<T> {
    fn clone(&self) -> Self {
        Self::new(self.free().clone())
    }
}

/// A piece of a pool from its first use until it is given back.
#[derive(Debug)]
pub(crate) struct PooledBuffer<T> {
    pool: Arc<Pool<T>>,
    piece: Option<T>,
}

impl<T> PooledBuffer<T> {
    pub(crate) fn new(pool: Arc<Pool<T>>) -> Self {
        Self { pool, piece: None }
    }

    /// The piece; one is made if all are out.
    pub(crate) fn take(&mut self, make: impl FnOnce() -> Result<T>) -> Result<&mut T> {
        match &mut self.piece {
            Some(piece) => Ok(piece),
            none => {
                let piece = self.pool.take().map_or_else(make, Ok)?;
                Ok(none.insert(piece))
            }
        }
    }

    /// The piece, between first use and return.
    pub(crate) fn held(&self) -> Option<&T> {
        self.piece.as_ref()
    }

    pub(crate) fn held_mut(&mut self) -> Option<&mut T> {
        self.piece.as_mut()
    }

    /// The piece, for good.
    pub(crate) fn into_piece(self) -> Option<T> {
        self.piece
    }

    pub(crate) fn give_back(&mut self) {
        if let Some(piece) = self.piece.take() {
            self.pool.give(piece);
        }
    }
}

/// Another user of the same pool, without a piece.
impl<T> Clone for PooledBuffer<T> {
    fn clone(&self) -> Self {
        Self::new(Arc::clone(&self.pool))
    }
}
