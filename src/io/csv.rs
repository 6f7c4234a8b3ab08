//! CSV, ASC and other matrices in text: one row per line, without a header.
//!
//! Lines follow one another towards larger y. The file carries neither cell sides nor a unit. Points in
//! three columns are a different format, [`xyz`](super::xyz): here they would be read as a matrix of width three.

use std::fmt::Write;
use std::path::Path;

use super::text::{Separator, lines};
use super::{Format, Place, check_sides, parse_file, write_bytes};
use crate::error::Result;
use crate::field::Field;

const FORMAT: Format = Format("CSV");

/// The field in a file, on cells of sides `[dx, dy]` (lengths). See [`parse`].
///
/// # Errors
/// [`Error::File`](crate::Error::File) if the file cannot be read, otherwise as [`parse`].
pub fn read(path: impl AsRef<Path>, cell_sides: [f64; 2]) -> Result<Field> {
    check_sides(cell_sides)?;
    parse_file(path.as_ref(), |bytes| parse(bytes, cell_sides))
}

/// The field in the bytes of a file, on cells of sides `[dx, dy]` (lengths).
///
/// - Cells are separated by semicolons, tabs, commas or white space: the first of these, in this order,
///   that the first line has. Commas within numbers in white space (`1,5 2,5`) are decimal commas.
/// - A decimal comma counts as a point unless commas separate the cells.
/// - Blank lines and lines that begin with `#` or `%` are skipped.
/// - A cell that is empty, `nan` or `BAD` in either case, or all stars (`***`), is missing: NaN.
/// - A separator at the end of every line adds no cell.
///
/// # Errors
/// [`Error::NotPositive`](crate::Error::NotPositive) for a cell side;
/// [`Error::Format`](crate::Error::Format), with the line, for a cell that is not a number or a line
/// whose width differs from the first; also if there is no line at all.
///
/// ```
/// use stickslip::io::csv;
/// let heights = csv::parse(b"# height in um\n1,5;2\n;-3e-1\n", [0.1, 0.1])?;
/// assert_eq!(heights.as_slice()[..2], [1.5, 2.0]);
/// assert!(heights.as_slice()[2].is_nan());
/// # Ok::<(), stickslip::Error>(())
/// ```
pub fn parse(bytes: &[u8], cell_sides: [f64; 2]) -> Result<Field> {
    check_sides(cell_sides)?;
    let mut samples = Vec::new();
    let (mut separator, mut width) = (None, 0);
    let mut ends_with_separator = true;
    for (number, line) in lines(bytes) {
        let separator = *separator.get_or_insert_with(|| Separator::of(&line));
        let (start, mut last) = (samples.len(), "");
        for cell in separator.split(&line) {
            samples.push(separator.number(FORMAT, number, cell)?);
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
    let grid = FORMAT.grid(Place::Line(1), [width, height], cell_sides)?;
    Field::from_vec(grid, samples)
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
