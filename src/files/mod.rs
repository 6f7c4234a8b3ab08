//! Reading and writing whole files: positions in bytes, errors that name the file, replacement of a file as a whole.

mod cursor;
mod whole_file;

use std::path::Path;

use crate::error::{Error, Place, Result, positive};
use crate::grid::Grid;

pub(crate) use cursor::{ByteOrder, Cursor, Number};
pub(crate) use whole_file::{PartialFile, replace, replace_bytes};

/// The name of a format, used in its errors.
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

    /// `Ok` if a number at a place in the file is positive and finite.
    pub(crate) fn positive(self, place: Place, quantity: &'static str, value: f64) -> Result<f64> {
        positive(quantity, value).map_err(|error| self.at(place, error.to_string()))
    }

    /// The grid a file declares at a place.
    pub(crate) fn grid(self, place: Place, size: [usize; 2], sides: [f64; 2]) -> Result<Grid> {
        let grid = Grid::new(size[0], size[1], sides[0], sides[1]);
        grid.map_err(|error| self.at(place, error.to_string()))
    }
}

/// Returns an error in the content of a file with the name of the file.
pub(crate) fn in_file(path: &Path, mut error: Error) -> Error {
    if let Error::Format { file, .. } = &mut error {
        *file = Some(path.display().to_string());
    }
    error
}

pub(crate) fn refused(path: &Path, error: &std::io::Error) -> Error {
    Error::File {
        path: path.display().to_string(),
        problem: error.to_string(),
        code: error.raw_os_error(),
    }
}
