//! Scratch memory aligned to cache lines.

use std::ops::{Deref, DerefMut};

use crate::error::Result;
use crate::memory::fallible::{self, unwrap_or_abort};

/// Size in bytes of a cache line, and of the widest vector register.
const LINE: usize = 64;

/// Buffer whose first item is at the start of a cache line. A vector load across two lines costs as much as
/// two loads.
#[derive(Debug)]
pub(super) struct Aligned<T> {
    items: Vec<T>,
    first: usize,
    len: usize,
}

impl<T: Clone> Aligned<T> {
    pub(super) fn new(value: T, len: usize) -> Result<Self> {
        let spare = LINE.div_ceil(size_of::<T>());
        let items = fallible::filled(value, len + spare)?;
        // Without this offset the buffer is still valid, but slower.
        let first = items.as_ptr().align_offset(LINE).min(spare);
        Ok(Self { items, first, len })
    }

    fn try_clone(&self) -> Result<Self> {
        let mut copy = Self::new(self.items[0].clone(), self.len)?;
        copy.clone_from_slice(self);
        Ok(copy)
    }
}

impl<T: Clone> Clone for Aligned<T> {
    fn clone(&self) -> Self {
        unwrap_or_abort(self.try_clone())
    }
}

impl<T> Deref for Aligned<T> {
    type Target = [T];

    fn deref(&self) -> &[T] {
        &self.items[self.first..self.first + self.len]
    }
}

impl<T> DerefMut for Aligned<T> {
    fn deref_mut(&mut self) -> &mut [T] {
        &mut self.items[self.first..self.first + self.len]
    }
}
