//! Positions in files, for format errors.

use std::fmt;

/// Position in a file.
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
pub enum Place {
    /// Offset in bytes from the beginning of the file.
    Byte(u64),
    /// Line of text, counted from 1.
    Line(usize),
    /// Named part of a file: an entry of an archive, an element of a header, or a field.
    Entry(String),
}

impl fmt::Display for Place {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Byte(byte) => write!(formatter, "at byte {byte}"),
            Self::Line(line) => write!(formatter, "on line {line}"),
            Self::Entry(name) => write!(formatter, "in {name}"),
        }
    }
}
