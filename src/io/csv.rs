//! CSV and other matrices in text: one row per line.
//!
//! Lines follow one another towards larger y. The file carries neither cell sides nor a unit. Points in
//! three columns are a different format, [`xyz`](super::xyz): here they would be read as a matrix of width three. So is a
//! matrix behind the header of SPIP, [`asc`](super::asc).

use std::fmt::Write;
use std::path::Path;

use super::asc::is_asc;
use super::text::{Separator, comments, excerpt, lines};
use super::{Format, Place, Sides, parse_file, write_bytes};
use crate::error::Result;
use crate::field::Field;

const FORMAT: Format = Format("CSV");

/// Names by which a comment tells the value of missing points, in small letters and digits.
const MISSING: [&str; 6] = [
    "missingvalue",
    "nodata",
    "nodatavalue",
    "badvalue",
    "invalidvalue",
    "voidvalue",
];

/// How a matrix in text is read.
///
/// ```
/// use stickslip::io::csv;
/// let text = b"left,middle,right\n1,2,-32768\n4,5,6\n";
/// let heights = csv::Options::default().skip_rows(1).missing(-32768.0).parse(text, [1.0, 1.0])?;
/// assert_eq!(heights.as_slice()[3..], [4.0, 5.0, 6.0]);
/// assert!(heights.as_slice()[2].is_nan());
/// # Ok::<(), stickslip::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[must_use = "options do nothing until read() or parse() is called"]
pub struct Options {
    missing: Option<f64>,
    skip_rows: usize,
}

impl Options {
    /// The value that stands for a missing point (default: what a comment of the file says, or none).
    pub fn missing(mut self, value: f64) -> Self {
        self.missing = Some(value);
        self
    }

    /// Lines to pass over at the beginning, comments and blank ones counted: for names of columns, or a header
    /// (default 0).
    pub fn skip_rows(mut self, rows: usize) -> Self {
        self.skip_rows = rows;
        self
    }

    /// The field in a file, on cells of [sides](Sides) `[dx, dy]`, or of a grid of given sides (lengths). See
    /// [`parse`].
    ///
    /// # Errors
    /// [`Error::File`](crate::Error::File) if the file cannot be read, otherwise as [`parse`].
    pub fn read(self, path: impl AsRef<Path>, sides: impl Into<Sides>) -> Result<Field> {
        let sides = sides.into().checked()?;
        parse_file(path.as_ref(), |bytes| self.parse(bytes, sides))
    }

    /// The field in the bytes of a file, on cells of [sides](Sides) `[dx, dy]`, or of a grid of given sides (lengths).
    /// See [`parse`].
    ///
    /// # Errors
    /// As [`parse`].
    pub fn parse(self, bytes: &[u8], sides: impl Into<Sides>) -> Result<Field> {
        let sides = sides.into().checked()?;
        if is_asc(bytes) && self == Self::default() {
            let problem = "the header holds sides, unit and missing points: read it as ASC";
            return Err(FORMAT.on_line(1, problem));
        }
        let missing = self
            .missing
            .or_else(|| comments(bytes).find_map(|comment| missing_value(&comment)));
        let mut samples = Vec::new();
        let (mut separator, mut width) = (None, 0);
        let mut ends_with_separator = true;
        for (number, line) in lines(bytes).filter(|(number, _)| *number > self.skip_rows) {
            let separator = *separator.get_or_insert_with(|| Separator::of(&line));
            let (start, mut last) = (samples.len(), "");
            for cell in separator.split(&line) {
                let sample = separator.number(FORMAT, number, cell);
                let sample = sample.map_err(|error| match error {
                    // Names of columns.
                    _ if start == 0 && !cell.bytes().any(|byte| byte.is_ascii_digit()) => {
                        let problem = format!(
                            "{} is not a number: skip lines of names by the option skip_rows = {number}",
                            excerpt(cell)
                        );
                        FORMAT.on_line(number, problem)
                    }
                    _ => error,
                })?;
                samples.push(if missing == Some(sample) {
                    f64::NAN
                } else {
                    sample
                });
                last = cell;
            }
            let found = samples.len() - start;
            if start == 0 {
                width = found;
            }
            if found != 0 && found != width {
                let problem = format!("{found} cells, but the lines before have {width}");
                return Err(FORMAT.on_line(number, problem));
            }
            ends_with_separator &= found == 0 || last.is_empty();
        }
        if samples.is_empty() {
            return Err(FORMAT.on_line(1, "the file has no numbers"));
        }
        let height = samples.len() / width;
        if ends_with_separator && width > 1 {
            let mut index = 0;
            samples.retain(|_| {
                index += 1;
                index % width != 0
            });
            width -= 1;
        }
        let grid = FORMAT.grid(
            Place::Line(1),
            [width, height],
            sides.of_cell([width, height]),
        )?;
        Field::from_vec(grid, samples)
    }
}

/// The value of missing points, if a comment tells it: `# missing value = -32768`, `# NODATA_value: -9999`.
pub(super) fn missing_value(comment: &str) -> Option<f64> {
    let (name, value) = comment.split_once(['=', ':'])?;
    let letters = name.chars().filter(char::is_ascii_alphanumeric);
    let name: String = letters.collect::<String>().to_ascii_lowercase();
    let value = value.trim().parse().ok()?;
    MISSING.contains(&name.as_str()).then_some(value)
}

/// The field in a file, on cells of [sides](Sides) `[dx, dy]`, or of a grid of given sides (lengths). See [`parse`].
///
/// # Errors
/// [`Error::File`](crate::Error::File) if the file cannot be read, otherwise as [`parse`].
pub fn read(path: impl AsRef<Path>, sides: impl Into<Sides>) -> Result<Field> {
    Options::default().read(path, sides)
}

/// The field in the bytes of a file, on cells of [sides](Sides) `[dx, dy]`, or of a grid of given sides (lengths).
///
/// - Cells are separated by semicolons, tabs, commas or white space: the first of these, in this order,
///   that the first line has. Commas within numbers in white space (`1,5 2,5`) are decimal commas.
/// - A decimal comma counts as a point unless commas separate the cells.
/// - Blank lines and lines that begin with `#` or `%` are skipped. A comment such as `# missing value = -32768` or
///   `# NODATA_value: -9999` names the value of missing points: by `missing value`, `no data`, `no data value`, `bad
///   value`, `invalid value` or `void value`, however written, then `=` or `:` and a number alone. Any other comment is
///   ignored, and the numbers stay heights: [`Options::missing`] names the value then.
/// - A cell that is empty, `nan` or `BAD` in either case, or all stars (`***`), is missing: NaN.
/// - A separator at the end of every line adds no cell.
/// - Names of columns are refused: [`Options::skip_rows`] passes over them.
///
/// # Errors
/// [`Error::NotPositive`](crate::Error::NotPositive) for a cell side;
/// [`Error::Format`](crate::Error::Format), with the line, for a cell that is not a number or a line
/// whose width differs from the first, and for a file that [`asc`](super::asc) reads; also if there is no line at all.
///
/// ```
/// use stickslip::io::csv;
/// let heights = csv::parse(b"# height in um\n1,5;2\n;-3e-1\n", [0.1, 0.1])?;
/// assert_eq!(heights.as_slice()[..2], [1.5, 2.0]);
/// assert!(heights.as_slice()[2].is_nan());
/// # Ok::<(), stickslip::Error>(())
/// ```
pub fn parse(bytes: &[u8], sides: impl Into<Sides>) -> Result<Field> {
    Options::default().parse(bytes, sides)
}

/// Writes a field to a file, as [`to_bytes`].
///
/// # Errors
/// [`Error::File`](crate::Error::File) if the file cannot be written.
pub fn write(path: impl AsRef<Path>, field: &Field) -> Result<()> {
    write_bytes(path.as_ref(), &to_bytes(field))
}

/// A field as a file: commas between cells, each number with enough digits to restore it to the
/// last bit, `NaN` for a missing one. The cell sides are not stored.
#[must_use]
pub fn to_bytes(field: &Field) -> Vec<u8> {
    let mut text = String::new();
    for row in field.rows() {
        for (index, value) in row.iter().enumerate() {
            let separator = if index == 0 { "" } else { "," };
            write!(text, "{separator}{value:?}").expect("writing to a string cannot fail");
        }
        text.push('\n');
    }
    text.into_bytes()
}
