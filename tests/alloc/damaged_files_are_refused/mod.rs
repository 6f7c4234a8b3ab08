//! A broken, truncated or lying file is refused with an error that says what is wrong and where;
//! nothing panics, and memory stays in proportion to the file.

#[cfg(feature = "x3p")]
mod archive;
mod binary;
mod changes;
mod text;
#[cfg(feature = "x3p")]
mod zip;

use stickslip::{Error, Field, Result};

/// Bytes that reading may hold at a time, for each byte of a file that is not compressed,
const PER_BYTE: u64 = 48;
/// and for the buffers and messages of any file.
const FIXED: u64 = 4096;

/// A parser under test.
type Parse = fn(&[u8]) -> Result<Field>;

/// Reads a file and returns the most bytes it held at a time.
fn read(bytes: &[u8], parse: Parse) -> (Result<Field>, u64) {
    let mut result = None;
    let memory = allocation_counter::measure(|| result = Some(parse(bytes)));
    (result.unwrap(), memory.bytes_max)
}

/// Reads a file that is not compressed, in bounded memory.
fn read_bounded(bytes: &[u8], parse: Parse) -> Result<Field> {
    let (result, memory) = read(bytes, parse);
    let bound = PER_BYTE * bytes.len() as u64 + FIXED;
    assert!(memory <= bound, "{memory} bytes for {}", bytes.len());
    result
}

/// Checks that a file is refused with an error of its format that begins so.
fn refuse(bytes: &[u8], parse: Parse, expected: &str) {
    check(&read_bounded(bytes, parse), expected);
}

fn check(result: &Result<Field>, expected: &str) {
    let error = result.as_ref().expect_err(expected);
    assert!(matches!(error, Error::Format { .. }), "{error}");
    let message = error.to_string();
    assert!(
        message.starts_with(expected),
        "{message:?}, expected {expected:?}"
    );
}

/// A file with some of its bytes replaced.
fn patched(bytes: &[u8], start: usize, replacement: &[u8]) -> Vec<u8> {
    let mut bytes = bytes.to_vec();
    bytes[start..start + replacement.len()].copy_from_slice(replacement);
    bytes
}
