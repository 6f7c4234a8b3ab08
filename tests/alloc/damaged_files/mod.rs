//! A damaged, truncated or inconsistent file is rejected with an error that states the fault and its position. No
//! panic occurs when such a file is read. The required memory is proportional to the size of the file.

#[cfg(feature = "x3p")]
mod archive;
mod binary;
mod changes;
mod text;
#[cfg(feature = "x3p")]
mod zip;

use stickslip::{Error, Field, Result};

/// Maximum number of bytes allocated at the same time, for each byte of an uncompressed file.
const PER_BYTE: u64 = 48;
/// Additional bytes for the buffers and messages of any file.
const FIXED: u64 = 4096;

/// Parser under test.
type Parse = fn(&[u8]) -> Result<Field>;

/// Reads a file and returns the peak number of allocated bytes.
fn read(bytes: &[u8], parse: Parse) -> (Result<Field>, u64) {
    let mut result = None;
    let memory = allocation_counter::measure(|| result = Some(parse(bytes)));
    (result.unwrap(), memory.bytes_max)
}

/// Reads an uncompressed file in bounded memory.
fn read_bounded(bytes: &[u8], parse: Parse) -> Result<Field> {
    let (result, memory) = read(bytes, parse);
    let bound = PER_BYTE * bytes.len() as u64 + FIXED;
    assert!(memory <= bound, "{memory} bytes for {}", bytes.len());
    result
}

/// Asserts that a file is rejected with an error of its format whose message starts with `expected`.
fn assert_rejected(bytes: &[u8], parse: Parse, expected: &str) {
    assert_format_error(&read_bounded(bytes, parse), expected);
}

fn assert_format_error(result: &Result<Field>, expected: &str) {
    let error = result.as_ref().expect_err(expected);
    assert!(matches!(error, Error::Format { .. }), "{error}");
    let message = error.to_string();
    assert!(
        message.starts_with(expected),
        "{message:?}, expected {expected:?}"
    );
}

/// Returns a file with some of its bytes replaced.
fn patched(bytes: &[u8], start: usize, replacement: &[u8]) -> Vec<u8> {
    let mut bytes = bytes.to_vec();
    bytes[start..start + replacement.len()].copy_from_slice(replacement);
    bytes
}
