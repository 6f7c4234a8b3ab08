//! Reading and writing of whole files: byte positions, errors that name the file, and atomic replacement of a file.

mod cursor;
mod whole_file;

use std::path::Path;

use crate::error::{Error, Place, Result, positive};
use crate::grid::Grid;

pub(crate) use cursor::{ByteOrder, Cursor, NumberFormat};
pub(crate) use whole_file::{PartialFile, replace, replace_bytes};

/// Name of a format, as used in its errors.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Format(pub(crate) &'static str);

impl Format {
    pub(crate) fn at(self, place: Place, problem: impl Into<String>) -> Error {
        Error::Format {
            file: None,
            format: self.0,
            place,
            problem: problem.into(),
        }
    }

    pub(crate) fn at_byte(self, byte: usize, problem: impl Into<String>) -> Error {
        self.at(Place::Byte(byte as u64), problem)
    }

    pub(crate) fn on_line(self, line: usize, problem: impl Into<String>) -> Error {
        self.at(Place::Line(line), problem)
    }

    pub(crate) fn in_entry(self, name: &str, problem: impl Into<String>) -> Error {
        self.at(Place::Entry(name.into()), problem)
    }

    /// Returns an error if bytes are compressed, which no reader expands.
    pub(crate) fn check_compression(self, bytes: &[u8]) -> Result<()> {
        let program = match bytes {
            [0x1f, 0x8b, ..] => "gzip",
            [b'P', b'K', 3, 4, ..] => "zip",
            [b'B', b'Z', b'h', _, b'1', b'A', b'Y', ..] => "bzip2",
            [0xfd, b'7', b'z', b'X', b'Z', ..] => "xz",
            [0x28, 0xb5, 0x2f, 0xfd, ..] => "zstd",
            _ => return Ok(()),
        };
        let problem = format!("the data are compressed by {program}: decompress them first");
        Err(self.at_byte(0, problem))
    }

    /// Checks that a number at a position in the file is positive and finite.
    pub(crate) fn positive(self, place: Place, quantity: &'static str, value: f64) -> Result<f64> {
        positive(quantity, value).map_err(|error| self.at(place, error.to_string()))
    }

    /// Returns the grid that a file declares at a position.
    pub(crate) fn grid(self, place: Place, size: [usize; 2], sides: [f64; 2]) -> Result<Grid> {
        let grid = Grid::new(size[0], size[1], sides[0], sides[1]);
        grid.map_err(|error| self.at(place, error.to_string()))
    }
}

/// Adds the name of the file to an error in its content.
pub(crate) fn in_file(path: &Path, mut error: Error) -> Error {
    if let Error::Format { file, .. } = &mut error {
        *file = Some(path.display().to_string());
    }
    error
}

pub(crate) fn refused(path: &Path, error: std::io::Error) -> Error {
    Error::File {
        path: path.display().to_string(),
        source: error.into(),
    }
}
