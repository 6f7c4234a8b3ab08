//! Units in the header of a text file with heights, such as ``# X[um] Y[um] Z[nm]``.

use std::fs::File;
use std::io::Read;
use std::path::Path;

use pyo3::PyResult;
use pyo3::exceptions::PyValueError;

use crate::unit::{is_same, known};

/// Number of bytes in which a header is searched.
const LONGEST_HEADER: usize = 1 << 16;

/// Units that a caller states for the lengths of a file.
#[derive(Clone, Copy)]
pub(crate) struct Stated<'a> {
    pub(crate) unit: &'a str,
    pub(crate) height_unit: Option<&'a str>,
}

impl Stated<'_> {
    /// Returns an error if the header of a file states other units. The reader of the file reports a file that cannot be read.
    pub(crate) fn check_file(self, path: &Path) -> PyResult<()> {
        let mut start = Vec::new();
        let read = File::open(path)
            .and_then(|file| file.take(LONGEST_HEADER as u64).read_to_end(&mut start));
        match read {
            Ok(_) => self.check(&start, &format!("{}, ", path.display())),
            Err(_) => Ok(()),
        }
    }

    /// Returns an error if the header states other units. The prefix precedes the line in the message.
    pub(crate) fn check(self, bytes: &[u8], prefix: &str) -> PyResult<()> {
        let start = &bytes[..bytes.len().min(LONGEST_HEADER)];
        let text = String::from_utf8_lossy(start);
        for (index, line) in text
            .lines()
            .enumerate()
            .take_while(|(_, line)| !is_point(line))
        {
            for (axis, found) in units(line) {
                let (argument, due) = match (axis, self.height_unit) {
                    ('Z', Some(height)) => ("height_unit", height),
                    _ => ("unit", self.unit),
                };
                if !is_same(found, due) {
                    let remedy = if axis == 'Z' { "height_unit" } else { "unit" };
                    return Err(PyValueError::new_err(format!(
                        "{prefix}line {}: the header states the unit {found} of {axis}, but the argument {argument} is {due}: \
                         give {remedy}=\"{found}\"",
                        index + 1
                    )));
                }
            }
        }
        Ok(())
    }
}

/// Returns whether a line starts with a number, as the line of a point.
fn is_point(line: &str) -> bool {
    let first = line
        .split([' ', '\t', ',', ';'])
        .find(|word| !word.is_empty());
    first.is_some_and(|word| word.parse::<f64>().is_ok())
}

/// Returns the axes of a header that are followed by a unit of length in brackets, with their units.
fn units(line: &str) -> impl Iterator<Item = (char, &str)> {
    line.char_indices().filter_map(|(index, letter)| {
        let axis = letter.to_ascii_uppercase();
        let before = line[..index].chars().next_back();
        if !('X'..='Z').contains(&axis) || before.is_some_and(char::is_alphanumeric) {
            return None;
        }
        let rest = line[index + letter.len_utf8()..].trim_start();
        let inner = rest.strip_prefix('[').or_else(|| rest.strip_prefix('('))?;
        let unit = inner.split([']', ')']).next()?.trim();
        known(unit).is_ok().then_some((axis, unit))
    })
}
