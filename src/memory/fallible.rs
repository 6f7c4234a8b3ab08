//! Buffers whose size depends on the number of cells. If memory runs out, these functions return an error, whereas
//! `vec!` aborts the program.

use bytemuck::Zeroable;

use crate::error::{Error, Result};

/// Creates a vector of `len` copies of a value.
pub(crate) fn filled<T: Clone>(value: T, len: usize) -> Result<Vec<T>> {
    let mut buffer = with_room(len)?;
    buffer.resize(len, value);
    Ok(buffer)
}

/// Creates a vector of zeros in pages that the operating system provides at the first write, near the thread that
/// writes.
pub(crate) fn zeros<T: Zeroable>(len: usize) -> Result<Vec<T>> {
    let zeros = bytemuck::allocation::try_zeroed_vec(len);
    zeros.map_err(|()| out_of_memory(len.saturating_mul(size_of::<T>())))
}

/// Creates zeros for each of N components.
pub(crate) fn vector<const N: usize>(len: usize) -> Result<[Vec<f64>; N]> {
    try_each(|_| zeros(len))
}

pub(crate) fn copied<T: Clone>(items: &[T]) -> Result<Vec<T>> {
    collected(items.len(), items.iter().cloned())
}

/// Collects at most `most` items of an iterator.
pub(crate) fn collected<T>(most: usize, items: impl IntoIterator<Item = T>) -> Result<Vec<T>> {
    let mut buffer = with_room(most)?;
    buffer.extend(items.into_iter().take(most));
    Ok(buffer)
}

/// Creates an empty vector with capacity for the given number of items.
pub(crate) fn with_room<T>(items: usize) -> Result<Vec<T>> {
    let mut buffer = Vec::new();
    make_room(&mut buffer, items)?;
    Ok(buffer)
}

/// Reserves capacity for the given total number of items. Existing items are kept.
pub(crate) fn make_room<T>(buffer: &mut Vec<T>, items: usize) -> Result<()> {
    let more = items.saturating_sub(buffer.len());
    let outcome = buffer.try_reserve_exact(more);
    outcome.map_err(|_| out_of_memory(items.saturating_mul(size_of::<T>())))
}

/// Returns the error for a buffer of the given number of bytes that cannot be allocated.
pub(crate) fn out_of_memory(bytes: usize) -> Error {
    Error::Memory {
        quantity: "a buffer of all cells",
        bytes: bytes as u128,
    }
}

/// Appends an item like `Vec::push`, but returns an error if memory runs out. The buffer is then unchanged.
pub(crate) fn push<T>(buffer: &mut Vec<T>, item: T) -> Result<()> {
    let outcome = buffer.try_reserve(1);
    outcome.map_err(|_| out_of_memory((buffer.len() + 1).saturating_mul(size_of::<T>())))?;
    buffer.push(item);
    Ok(())
}

/// Resizes a buffer like `Vec::resize`, but returns an error if memory runs out. The buffer is then unchanged.
pub(crate) fn resize<T: Clone>(buffer: &mut Vec<T>, len: usize, value: T) -> Result<()> {
    make_room(buffer, len)?;
    buffer.resize(len, value);
    Ok(())
}

/// Resizes a buffer with zeros like [`resize`]. An empty buffer is allocated as by [`zeros`].
pub(crate) fn resize_with_zeros<T: Zeroable + Clone>(
    buffer: &mut Vec<T>,
    len: usize,
) -> Result<()> {
    if buffer.capacity() > 0 {
        return resize(buffer, len, T::zeroed());
    }
    *buffer = zeros(len)?;
    Ok(())
}

/// Creates an array with a function that may fail.
pub(crate) fn try_each<T, const N: usize>(
    mut make: impl FnMut(usize) -> Result<T>,
) -> Result<[T; N]> {
    let mut failure = None;
    let made = std::array::from_fn(|n| match make(n) {
        Ok(value) => Some(value),
        Err(error) => {
            failure = Some(error);
            None
        }
    });
    match failure {
        Some(error) => Err(error),
        // Every value was created, because no call failed.
        None => Ok(made.map(|value| value.expect("each was made"))),
    }
}

/// Returns the value, or aborts the program if memory ran out, as `Vec` does. Functions without an error in their
/// signature call this function.
pub(crate) fn unwrap_or_abort<T>(outcome: Result<T>) -> T {
    outcome.unwrap_or_else(|error| {
        let bytes = match error {
            Error::Memory { bytes, .. } => usize::try_from(bytes).unwrap_or(0),
            _ => 0,
        };
        let layout = std::alloc::Layout::array::<u8>(bytes);
        std::alloc::handle_alloc_error(layout.unwrap_or(std::alloc::Layout::new::<u8>()))
    })
}

/// Copies a value into an optional value, and reuses the memory of the old value.
pub(crate) fn replace<T: TryClone>(target: &mut Option<T>, source: &T) -> Result<()> {
    match target {
        Some(own) => own.try_clone_from(source),
        none => {
            *none = Some(source.try_clone()?);
            Ok(())
        }
    }
}

/// Cloning that returns an error if memory runs out, whereas `Clone` aborts the program.
///
/// ```
/// use stickslip::{Field, Grid, TryClone};
/// let field = Field::constant(Grid::square(8, 1.0)?, 2.0);
/// let mut copy = field.try_clone()?;
/// copy.try_clone_from(&field.scaled(2.0))?;
/// assert_eq!(copy.max(), 4.0);
/// # Ok::<(), stickslip::Error>(())
/// ```
pub trait TryClone: Clone {
    /// Returns a copy.
    ///
    /// # Errors
    /// - [`Error::Memory`] if memory runs out.
    fn try_clone(&self) -> Result<Self>;

    /// Returns whether `clone_from` can reuse the existing allocations.
    fn has_room_for(&self, source: &Self) -> bool;

    /// Copies `source` into the value like `clone_from`, but returns an error if memory runs out.
    ///
    /// # Errors
    /// - [`Error::Memory`] if memory runs out. The value is then unchanged.
    fn try_clone_from(&mut self, source: &Self) -> Result<()> {
        if self.has_room_for(source) {
            self.clone_from(source);
        } else {
            *self = source.try_clone()?;
        }
        Ok(())
    }
}

/// Implements [`TryClone`] for a struct with the given fields: first the fields with buffers, then the fields without.
macro_rules! try_clone {
    ($type:ident $(<const $n:ident: usize>)? { $($part:ident),* $(,)? } $({ $($plain:ident),* $(,)? })?) => {
        impl$(<const $n: usize>)? $crate::memory::fallible::TryClone for $type$(<$n>)? {
            fn try_clone(&self) -> $crate::error::Result<Self> {
                Ok(Self {
                    $($part: self.$part.try_clone()?,)*
                    $($($plain: self.$plain.clone(),)*)?
                })
            }

            fn has_room_for(&self, source: &Self) -> bool {
                true $(&& self.$part.has_room_for(&source.$part))*
            }

            fn try_clone_from(&mut self, source: &Self) -> $crate::error::Result<()> {
                if self.has_room_for(source) {
                    $(self.$part.try_clone_from(&source.$part)?;)*
                    $($(self.$plain.clone_from(&source.$plain);)*)?
                } else {
                    *self = source.try_clone()?;
                }
                Ok(())
            }
        }
    };
}

pub(crate) use try_clone;

impl<T: Clone> TryClone for Vec<T> {
    fn try_clone(&self) -> Result<Self> {
        copied(self)
    }

    fn has_room_for(&self, source: &Self) -> bool {
        self.capacity() >= source.len()
    }
}

impl<T: TryClone> TryClone for Option<T> {
    fn try_clone(&self) -> Result<Self> {
        self.as_ref().map(T::try_clone).transpose()
    }

    fn has_room_for(&self, source: &Self) -> bool {
        match (self, source) {
            (Some(own), Some(source)) => own.has_room_for(source),
            (None, Some(_)) => false,
            (_, None) => true,
        }
    }
}

impl<T: TryClone, const N: usize> TryClone for [T; N] {
    fn try_clone(&self) -> Result<Self> {
        try_each(|n| self[n].try_clone())
    }

    fn has_room_for(&self, source: &Self) -> bool {
        let mut pairs = self.iter().zip(source);
        pairs.all(|(own, source)| own.has_room_for(source))
    }
}
