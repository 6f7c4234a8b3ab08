//! Memory that its users have only while they work.

use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

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

    /// Lends a piece for this work; makes one if all are out.
    pub(crate) fn lend<R>(&self, make: impl FnOnce() -> T, work: impl FnOnce(&mut T) -> R) -> R {
        let mut piece = self.take().unwrap_or_else(make);
        let result = work(&mut piece);
        self.give(piece);
        result
    }

    /// A piece, if one is free.
    pub(crate) fn take(&self) -> Option<T> {
        self.free().pop()
    }

    pub(crate) fn give(&self, piece: T) {
        self.free().push(piece);
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
pub(crate) struct Lease<T> {
    pool: Arc<Pool<T>>,
    piece: Option<T>,
}

impl<T> Lease<T> {
    pub(crate) fn new(pool: Arc<Pool<T>>) -> Self {
        Self { pool, piece: None }
    }

    /// The piece; one is made if all are out.
    pub(crate) fn take(&mut self, make: impl FnOnce() -> T) -> &mut T {
        let pool = &self.pool;
        self.piece
            .get_or_insert_with(|| pool.take().unwrap_or_else(make))
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
        self.pool.free().extend(self.piece.take());
    }
}

/// Another user of the same pool, without a piece.
impl<T> Clone for Lease<T> {
    fn clone(&self) -> Self {
        Self::new(Arc::clone(&self.pool))
    }
}
