//! Checksums of 64 bits for comparing bytes and values: FNV-1a, <https://datatracker.ietf.org/doc/html/rfc9923>.

use std::fmt::{Debug, Result, Write};

/// Factor of each step of FNV-1a with 64 bits.
const PRIME: u64 = 0x0100_0000_01b3;

/// Checksum of a sequence of bytes.
#[derive(Debug, Clone, Copy)]
struct Digest(u64);

impl Digest {
    const START: Self = Self(0xcbf2_9ce4_8422_2325);

    fn with(self, bytes: &[u8]) -> Self {
        let step = |sum: u64, &byte: &u8| (sum ^ u64::from(byte)).wrapping_mul(PRIME);
        Self(bytes.iter().fold(self.0, step))
    }
}

impl Write for Digest {
    fn write_str(&mut self, text: &str) -> Result {
        *self = self.with(text.as_bytes());
        Ok(())
    }
}

/// Returns the checksum of bytes.
pub(crate) fn of_bytes(bytes: &[u8]) -> u64 {
    Digest::START.with(bytes).0
}

/// Returns a checksum of numbers from their bit patterns. Each operation includes the eight bytes of a number.
pub(crate) fn of_numbers(numbers: impl Iterator<Item = f64>) -> u64 {
    let step = |sum: u64, number: f64| (sum ^ number.to_bits()).wrapping_mul(PRIME);
    numbers.fold(Digest::START.0, step)
}

/// Returns the checksum of the `Debug` output of a value, which contains every bit of its numbers except the bits of
/// NaN. Parts that the `Debug` output of a type omits are not compared.
pub(crate) fn of_shown(value: &dyn Debug) -> u64 {
    let mut digest = Digest::START;
    // `Digest::write_str` returns no error, and derived `Debug` adds none.
    write!(digest, "{value:?}").expect("writing to a digest cannot fail");
    digest.0
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_bit_of_a_number_is_in_it() {
        // The expected value is a test vector of RFC 9923.
        assert_eq!(of_bytes(b"foobar"), 0x8594_4171_f739_67e8);
        let numbers = [
            0.0,
            -0.0,
            1.0,
            1.0 + f64::EPSILON,
            f64::MIN_POSITIVE,
            f64::NAN,
        ];
        for (i, one) in numbers.iter().enumerate() {
            for (j, other) in numbers.iter().enumerate() {
                assert_eq!(of_shown(one) == of_shown(other), i == j, "{one} {other}");
            }
        }
    }
}
