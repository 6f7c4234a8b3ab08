//! Sequential reading of numbers in binary files, with checks of the remaining length.

use crate::error::Result;
use crate::files::Format;

/// Bytes of a file and the current reading position.
#[derive(Debug)]
pub(crate) struct Cursor<'a> {
    format: Format,
    bytes: &'a [u8],
    position: usize,
}

impl<'a> Cursor<'a> {
    pub(crate) fn new(format: Format, bytes: &'a [u8]) -> Self {
        Self {
            format,
            bytes,
            position: 0,
        }
    }

    /// Returns the position of the next byte.
    pub(crate) fn position(&self) -> usize {
        self.position
    }

    /// Returns the remaining bytes.
    pub(crate) fn rest(&self) -> &'a [u8] {
        &self.bytes[self.position..]
    }

    /// Reads the next `count` bytes. `what` describes them in the error.
    pub(crate) fn take(&mut self, what: &str, count: usize) -> Result<&'a [u8]> {
        let Some((taken, _)) = self.rest().split_at_checked(count) else {
            let (start, found) = (self.position, self.rest().len());
            let problem =
                format!("the file ends within {what}: expected {count} bytes, found {found}");
            return Err(self.format.at_byte(start, problem));
        };
        self.position += count;
        Ok(taken)
    }

    /// Reads the next `N` bytes.
    pub(crate) fn array<const N: usize>(&mut self, what: &str) -> Result<[u8; N]> {
        let mut array = [0; N];
        array.copy_from_slice(self.take(what, N)?);
        Ok(array)
    }

    pub(crate) fn u16(&mut self, what: &str) -> Result<u16> {
        Ok(u16::from_le_bytes(self.array(what)?))
    }

    pub(crate) fn u32(&mut self, what: &str) -> Result<u32> {
        Ok(u32::from_le_bytes(self.array(what)?))
    }

    pub(crate) fn u64(&mut self, what: &str) -> Result<u64> {
        Ok(u64::from_le_bytes(self.array(what)?))
    }

    pub(crate) fn i32(&mut self, what: &str) -> Result<i32> {
        Ok(i32::from_le_bytes(self.array(what)?))
    }

    pub(crate) fn f32(&mut self, what: &str) -> Result<f32> {
        Ok(f32::from_le_bytes(self.array(what)?))
    }

    pub(crate) fn f64(&mut self, what: &str) -> Result<f64> {
        Ok(f64::from_le_bytes(self.array(what)?))
    }
}

/// Byte order of a number.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum ByteOrder {
    LeastFirst,
    GreatestFirst,
}

/// Storage type of a sample.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum NumberFormat {
    I8,
    I16,
    I32,
    I64,
    U8,
    U16,
    U32,
    U64,
    F32,
    F64,
}

impl NumberFormat {
    /// Returns the number of bytes per number.
    pub(crate) fn size(self) -> usize {
        match self {
            Self::I8 | Self::U8 => 1,
            Self::I16 | Self::U16 => 2,
            Self::I32 | Self::U32 | Self::F32 => 4,
            Self::I64 | Self::U64 | Self::F64 => 8,
        }
    }

    /// Decodes all numbers stored in `bytes`. 64-bit integers are rounded.
    pub(crate) fn decode(self, order: ByteOrder, bytes: &[u8]) -> Vec<f64> {
        match self {
            Self::I8 => map(order, bytes, |b| f64::from(i8::from_le_bytes(b))),
            Self::I16 => map(order, bytes, |b| f64::from(i16::from_le_bytes(b))),
            Self::I32 => map(order, bytes, |b| f64::from(i32::from_le_bytes(b))),
            Self::I64 => map(order, bytes, |b| i64::from_le_bytes(b) as f64),
            Self::U8 => map(order, bytes, |b| f64::from(u8::from_le_bytes(b))),
            Self::U16 => map(order, bytes, |b| f64::from(u16::from_le_bytes(b))),
            Self::U32 => map(order, bytes, |b| f64::from(u32::from_le_bytes(b))),
            Self::U64 => map(order, bytes, |b| u64::from_le_bytes(b) as f64),
            Self::F32 => map(order, bytes, |b| f64::from(f32::from_le_bytes(b))),
            Self::F64 => map(order, bytes, f64::from_le_bytes),
        }
    }
}

/// Decodes every `N` bytes as a number. `number` receives the bytes with the least significant byte first.
fn map<const N: usize>(
    order: ByteOrder,
    bytes: &[u8],
    number: impl Fn([u8; N]) -> f64,
) -> Vec<f64> {
    let sample = |stored: &[u8]| {
        let mut array = [0; N];
        array.copy_from_slice(stored);
        if order == ByteOrder::GreatestFirst {
            array.reverse();
        }
        number(array)
    };
    bytes.chunks_exact(N).map(sample).collect()
}
