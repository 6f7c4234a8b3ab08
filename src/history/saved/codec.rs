//! Primitives of the format. Each primitive writes a value and reads it back.

use std::fmt::Debug;
use std::ops::RangeBounds;

use super::FORMAT;
use crate::error::{Error, Result, samples_obey};
use crate::files::Cursor;
use crate::memory::fallible::out_of_memory;

/// Rule for numbers: its text and its test.
pub(super) type NumberRule = (&'static str, fn(f64) -> bool);

pub(super) const FINITE: NumberRule = ("must be finite", f64::is_finite);
pub(super) const NOT_NEGATIVE: NumberRule = ("must be non-negative and finite", |value| {
    value >= 0.0 && value.is_finite()
});
pub(super) const POSITIVE: NumberRule = ("must be positive and finite", |value| {
    value > 0.0 && value.is_finite()
});
/// Rule for an error, which is infinite if it was not measured.
pub(super) const NOT_NEGATIVE_OR_INFINITE: NumberRule =
    ("must be non-negative", |value| value >= 0.0);
/// Rule for a modulus, which is infinite for a rigid body.
pub(super) const POSITIVE_OR_INFINITE: NumberRule = ("must be positive", |value| value > 0.0);
pub(super) const TOLERANCE: NumberRule = ("must lie strictly between 0 and 1", |value| {
    value > 0.0 && value < 1.0
});

/// Writer or reader of consecutive values. Numbers are little-endian. A reader checks rules and ranges. A writer
/// requires values that satisfy them.
pub(super) trait Codec {
    /// Writes the next `N` bytes from the value, or reads them into it. `from` may return the description of a problem
    /// instead.
    fn value<T, const N: usize>(
        &mut self,
        what: &str,
        value: &mut T,
        to: impl FnOnce(&T) -> [u8; N],
        from: impl FnOnce([u8; N]) -> Result<T, String>,
    ) -> Result<()>;

    /// Visits the next numbers, one for each value.
    fn numbers(&mut self, what: &'static str, values: &mut [f64], rule: NumberRule) -> Result<()>;

    fn number(&mut self, what: &str, value: &mut f64, rule: NumberRule) -> Result<()> {
        let to = |value: &f64| value.to_le_bytes();
        self.value(what, value, to, |bytes| {
            let (found, (words, obeys)) = (f64::from_le_bytes(bytes), rule);
            if obeys(found) {
                Ok(found)
            } else {
                Err(format!("{what} is {found}, but {words}"))
            }
        })
    }

    fn integer(
        &mut self,
        what: &str,
        value: &mut u64,
        range: impl RangeBounds<u64> + Debug,
    ) -> Result<()> {
        let to = |value: &u64| value.to_le_bytes();
        self.value(what, value, to, |bytes| {
            let found = u64::from_le_bytes(bytes);
            if range.contains(&found) {
                Ok(found)
            } else {
                Err(format!(
                    "{what} is {found}, but must lie in the range {range:?}"
                ))
            }
        })
    }

    /// Visits an integer that counts items in memory.
    fn count(
        &mut self,
        what: &str,
        value: &mut usize,
        range: impl RangeBounds<u64> + Debug,
    ) -> Result<()> {
        let mut integer = *value as u64;
        self.integer(what, &mut integer, range)?;
        *value = usize::try_from(integer).unwrap_or(usize::MAX);
        Ok(())
    }

    /// Visits a value as its index in a table. The index is stored in one byte.
    fn kind<T: Copy + PartialEq>(&mut self, what: &str, value: &mut T, table: &[T]) -> Result<()> {
        let to = |value: &T| {
            let place = table.iter().position(|kind| kind == value);
            [place.map_or(0, |place| u8::try_from(place).unwrap_or(0))]
        };
        self.value(what, value, to, |[place]| {
            let kind = table.get(usize::from(place));
            kind.copied()
                .ok_or_else(|| format!("code {place} of {what} is unknown"))
        })
    }

    /// Visits the presence of an optional value. If only the bytes contain a value, `make` creates the value to read
    /// into.
    fn option<T>(
        &mut self,
        what: &str,
        value: &mut Option<T>,
        make: impl FnOnce() -> Result<T>,
    ) -> Result<()> {
        let mut is_there = value.is_some();
        self.kind(what, &mut is_there, &[false, true])?;
        if is_there && value.is_none() {
            *value = Some(make()?);
        }
        Ok(())
    }
}

/// Writer into a growing vector of bytes.
#[derive(Default)]
pub(super) struct Writer(pub(super) Vec<u8>);

impl Writer {
    pub(super) fn extend(
        &mut self,
        count: usize,
        bytes: impl IntoIterator<Item = u8>,
    ) -> Result<()> {
        let room = self.0.try_reserve(count);
        room.map_err(|_| out_of_memory(self.0.len() + count))?;
        self.0.extend(bytes);
        Ok(())
    }

    pub(super) fn samples(&mut self, values: &[f64]) -> Result<()> {
        let bytes = values.iter().flat_map(|value| value.to_le_bytes());
        self.extend(size_of_val(values), bytes)
    }

    /// Reserves the memory for exactly `count` more bytes.
    pub(super) fn make_room(&mut self, count: usize) -> Result<()> {
        let room = self.0.try_reserve_exact(count);
        room.map_err(|_| out_of_memory(self.0.len().saturating_add(count)))
    }
}

impl Codec for Writer {
    fn value<T, const N: usize>(
        &mut self,
        _: &str,
        value: &mut T,
        to: impl FnOnce(&T) -> [u8; N],
        _: impl FnOnce([u8; N]) -> Result<T, String>,
    ) -> Result<()> {
        self.extend(N, to(value))
    }

    fn numbers(&mut self, _: &str, values: &mut [f64], _: NumberRule) -> Result<()> {
        self.samples(values)
    }
}

/// Reader of bytes in order.
pub(super) struct Reader<'a>(pub(super) Cursor<'a>);

impl Reader<'_> {
    /// Returns an error for a truncated file if fewer than `count` bytes are left.
    pub(super) fn require(&self, what: &str, count: usize) -> Result<()> {
        let found = self.0.rest().len();
        if found >= count {
            return Ok(());
        }
        let problem = format!("the file ends within {what}: expected {count} bytes, found {found}");
        Err(FORMAT.at_byte(self.0.position(), problem))
    }

    /// Returns an error if any bytes are left.
    pub(super) fn end(&self) -> Result<()> {
        if self.0.rest().is_empty() {
            return Ok(());
        }
        let problem = "the data continue beyond the end of the history";
        Err(FORMAT.at_byte(self.0.position(), problem))
    }
}

impl Codec for Reader<'_> {
    fn value<T, const N: usize>(
        &mut self,
        what: &str,
        value: &mut T,
        _: impl FnOnce(&T) -> [u8; N],
        from: impl FnOnce([u8; N]) -> Result<T, String>,
    ) -> Result<()> {
        let start = self.0.position();
        let found = from(self.0.array(what)?);
        *value = found.map_err(|problem| FORMAT.at_byte(start, problem))?;
        Ok(())
    }

    fn numbers(&mut self, what: &'static str, values: &mut [f64], rule: NumberRule) -> Result<()> {
        let start = self.0.position();
        let stored = self.0.take(what, size_of_val(values))?;
        for (value, stored) in values.iter_mut().zip(stored.chunks_exact(8)) {
            let mut bytes = [0; 8];
            bytes.copy_from_slice(stored);
            *value = f64::from_le_bytes(bytes);
        }
        samples_obey(what, values, rule.0, rule.1).map_err(|error| {
            let index = match error {
                Error::Sample { index, .. } => index,
                _ => 0,
            };
            FORMAT.at_byte(start + 8 * index, error.to_string())
        })
    }
}
