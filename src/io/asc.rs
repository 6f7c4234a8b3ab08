//! ASC, the text export of SPIP and Gwyddion: a header and a matrix in text. Lines of the header have the form `# key = value`
//! (SPIP) or `# Width: 10 um` (Gwyddion).
//!
//! Heights and cell sides are in metres. Rows are ordered towards larger y.

use std::path::Path;

use super::csv;
use super::missing;
use super::text::{Separator, excerpt, lines, without_mark};
use super::{Place, Sides, parse_file};
use crate::error::{Error, Result};
use crate::files::Format;
use crate::grid::field::Field;

const FORMAT: Format = Format("ASC");
const MAGIC: &[u8] = b"# File Format = ASCII";
const NANOMETRE: f64 = 1e-9;

/// Units of heights, in metres.
const UNITS: [(&str, f64); 8] = [
    ("m", 1.0),
    ("mm", 1e-3),
    ("um", 1e-6),
    ("\u{b5}m", 1e-6),
    ("\u{3bc}m", 1e-6),
    ("nm", NANOMETRE),
    ("pm", 1e-12),
    ("A", 1e-10),
];

/// Reads the surface in a file (metres). See [`parse`].
///
/// # Errors
/// - [`Error::File`] if the file cannot be read.
/// - The errors of [`parse`].
pub fn read(path: impl AsRef<Path>) -> Result<Field> {
    parse_file(path.as_ref(), parse)
}

/// Reads the surface in the bytes of a file (metres).
///
/// The first line is `# File Format = ASCII`. The keys `x-pixels` and `y-pixels` give the numbers of columns and rows.
/// The keys `x-length` and `y-length` give the sides of the whole surface in nanometres. Heights are in the unit given
/// by `z-unit`, or in multiples of `Bit2nm` nanometres. Numbers are separated as in [`csv`](super::csv::parse). Line breaks only
/// separate numbers.
///
/// Missing points become NaN. If `voidpixels` is not zero, a mask of equal size follows the heights. The mask is
/// nonzero for each missing point and zero for the other points. Some programs write the value of missing heights as
/// `voidpixels`. The key is interpreted in this way if no mask follows and if its value cannot be a number of points. A comment
/// may also give the value of missing points, as in [`csv`](super::csv::parse).
///
/// The function also reads the text export of Gwyddion. Its comments `# Width: 10.0 um` and `# Height: 4.0 um` give the sides of
/// the whole surface, and `# Value units: nm` gives the unit of the heights. The matrix follows as in
/// [`csv`](super::csv::parse).
///
/// # Errors
/// - [`Error::Format`] if the bytes are not an ASC file, a key is missing, a unit is unknown, or the number of heights is wrong.
///
/// ```
/// use stickslip::io::asc;
/// let header = "# File Format = ASCII\n# x-pixels = 2\n# y-pixels = 1\n# x-length = 400\n# y-length = 100\n";
/// let file = format!("{header}# z-unit = nm\n# voidpixels = 1\n# Start of Data:\n5 7\n0 1\n");
/// let heights = asc::parse(file.as_bytes())?;
/// assert!((heights.grid().dx() / 200e-9 - 1.0).abs() < 1e-12);
/// assert!((heights.as_slice()[0] / 5e-9 - 1.0).abs() < 1e-12 && heights.as_slice()[1].is_nan());
/// # Ok::<(), stickslip::Error>(())
/// ```
pub fn parse(bytes: &[u8]) -> Result<Field> {
    if is_gwyddion(bytes) {
        return parse_gwyddion(bytes);
    }
    FORMAT.check_compression(bytes)?;
    check_esri(FORMAT, bytes, 0)?;
    if !is_asc(bytes) {
        return Err(FORMAT.on_line(1, "the file does not start with # File Format = ASCII"));
    }
    let header = Header::of(bytes)?;
    let [nx, ny] = header.size;
    // Every number occupies at least one byte and a separator.
    let cells = nx.saturating_mul(ny);
    if cells > bytes.len() {
        let problem = format!("{nx} x {ny} heights do not fit into {} bytes", bytes.len());
        return Err(FORMAT.in_entry("x-pixels", problem));
    }
    let sides = [header.lengths[0] / nx as f64, header.lengths[1] / ny as f64];
    let grid = FORMAT.grid(Place::Entry("x-length".into()), header.size, sides)?;
    let numbers = numbers(bytes)?;
    let (heights, masks) = numbers.split_at(cells.min(numbers.len()));
    let has_mask = header.void != 0.0 && masks.len() == cells;
    if heights.len() < cells || !(masks.is_empty() || has_mask) {
        let problem = format!(
            "the file contains {} numbers, expected {nx} x {ny} heights",
            numbers.len()
        );
        return Err(FORMAT.in_entry("the heights", problem));
    }
    let may_be_count =
        header.void > 0.0 && header.void.fract() == 0.0 && header.void <= cells as f64;
    if may_be_count && !has_mask {
        let problem = format!(
            "{} points are missing, but the file has no mask that marks them",
            header.void
        );
        return Err(FORMAT.in_entry("voidpixels", problem));
    }
    let is_missing = |cell: usize| {
        if has_mask {
            masks[cell] != 0.0
        } else {
            let is_void = header.void != 0.0 && heights[cell].to_bits() == header.void.to_bits();
            is_void || header.missing == Some(heights[cell])
        }
    };
    let height = |cell: usize| {
        if is_missing(cell) {
            f64::NAN
        } else {
            header.unit * heights[cell]
        }
    };
    Field::from_vec(grid, (0..cells).map(height).collect())
}

/// Returns whether a file begins with the first line of this format.
pub(super) fn is_asc(bytes: &[u8]) -> bool {
    without_mark(bytes).starts_with(MAGIC)
}

/// Returns whether a file begins with the comments of a text export of Gwyddion.
pub(super) fn is_gwyddion(bytes: &[u8]) -> bool {
    let header = header_text(bytes);
    !is_asc(bytes)
        && entry(&header, ':', "Width").is_some()
        && entry(&header, ':', "Height").is_some()
}

/// Returns an error with the options that read a file, if it starts with the header of an ESRI ASCII grid, which is not skipped.
pub(super) fn check_esri(format: Format, bytes: &[u8], skip_rows: usize) -> Result<()> {
    const FIRST: [&str; 2] = ["ncols", "nrows"];
    const OTHERS: [&str; 8] = [
        "xllcorner",
        "xllcenter",
        "yllcorner",
        "yllcenter",
        "cellsize",
        "dx",
        "dy",
        "nodata_value",
    ];
    let lines = without_mark(bytes).split(|&byte| byte == b'\n');
    let entry = |line: &[u8]| {
        let line = String::from_utf8_lossy(line.get(..64).unwrap_or(line)).to_ascii_lowercase();
        let (key, value) = line.trim().split_once(char::is_whitespace)?;
        let is_key = FIRST.contains(&key) || OTHERS.contains(&key);
        is_key.then(|| (key.to_owned(), value.trim().to_owned()))
    };
    let header: Vec<_> = lines.map_while(entry).collect();
    let value = |key: &str| Some(&header.iter().find(|(name, _)| name == key)?.1);
    let rows = header.len();
    if skip_rows >= rows || FIRST.iter().any(|key| value(key).is_none()) {
        return Ok(());
    }
    let options = match value("nodata_value") {
        Some(mark) => format!("options skip_rows = {rows} and missing = {mark}"),
        None => format!("option skip_rows = {rows}"),
    };
    let sides =
        value("cellsize").map_or_else(|| "cell sides".into(), |side| format!("cell side {side}"));
    let problem = format!(
        "the file is an ESRI ASCII grid: read it as CSV by the {options}, and give the {sides}; its first line has the largest y"
    );
    Err(format.on_line(1, problem))
}

fn parse_gwyddion(bytes: &[u8]) -> Result<Field> {
    let header = header_text(bytes);
    let required = |key: &str| {
        let value = entry(&header, ':', key);
        value.ok_or_else(|| FORMAT.in_entry(key, "the header does not contain this entry"))
    };
    let length = |key: &str| {
        let value = required(key)?;
        let (number, unit) = value
            .split_once(char::is_whitespace)
            .unwrap_or((&value, ""));
        let parsed = number.replace(',', ".").parse::<f64>();
        let problem = |_| FORMAT.in_entry(key, format!("{} is not a number", excerpt(number)));
        let value = parsed.map_err(problem)? * unit_of(key, unit.trim())?;
        FORMAT.positive(Place::Entry(key.into()), "the value", value)
    };
    let sides = Sides::OfGrid([length("Width")?, length("Height")?]);
    let unit = unit_of("Value units", &required("Value units")?)?;
    let matrix = csv::Options::default().without_labels().parse(bytes, sides);
    let matrix = matrix.map_err(|mut error| {
        if let Error::Format { format, .. } = &mut error {
            *format = FORMAT.0;
        }
        error
    })?;
    Ok(matrix.scaled(unit))
}

/// Returns the value of a key in comments of the form `# key = value`, where `sign` replaces the equals sign.
fn entry(header: &str, sign: char, key: &str) -> Option<String> {
    let pairs = header
        .lines()
        .filter_map(|line| line.trim_start_matches('#').split_once(sign));
    let mut values = pairs.filter(|(name, _)| name.trim().eq_ignore_ascii_case(key));
    values.next().map(|(_, value)| value.trim().to_owned())
}

/// Returns the length of a unit in metres.
fn unit_of(key: &str, unit: &str) -> Result<f64> {
    let known = UNITS.iter().find(|(name, _)| *name == unit);
    let problem = || format!("{} is not a known unit of length", excerpt(unit));
    Ok(known.ok_or_else(|| FORMAT.in_entry(key, problem()))?.1)
}

/// Parsed header.
struct Header {
    size: [usize; 2],
    /// Sides of the whole surface, in metres.
    lengths: [f64; 2],
    /// Unit of the heights, in metres.
    unit: f64,
    void: f64,
    /// Value of missing points given in a comment.
    missing: Option<f64>,
}

impl Header {
    fn of(bytes: &[u8]) -> Result<Self> {
        let text = header_text(bytes);
        let entry = |key: &str| entry(&text, '=', key);
        let number = |key: &str| -> Result<Option<f64>> {
            entry(key)
                .map(|value| {
                    let parsed = value.parse::<f64>().ok().filter(|value| value.is_finite());
                    let problem = || format!("{} is not a number", excerpt(&value));
                    parsed.ok_or_else(|| FORMAT.in_entry(key, problem()))
                })
                .transpose()
        };
        let required = |key: &str| {
            let value = number(key)?
                .ok_or_else(|| FORMAT.in_entry(key, "the header does not contain this entry"))?;
            FORMAT.positive(Place::Entry(key.into()), "the value", value)
        };
        let count = |key: &str| {
            let value = required(key)?;
            #[expect(
                clippy::cast_possible_truncation,
                clippy::cast_sign_loss,
                reason = "a whole number in the range of integers"
            )]
            if value.fract() == 0.0 && value < 2.0_f64.powi(53) {
                Ok(value as usize)
            } else {
                Err(FORMAT.in_entry(
                    key,
                    format!("the number of points must be a whole number, got {value}"),
                ))
            }
        };
        let unit = match entry("z-unit") {
            Some(unit) => unit_of("z-unit", &unit)?,
            None => required("Bit2nm")? * NANOMETRE,
        };
        Ok(Self {
            size: [count("x-pixels")?, count("y-pixels")?],
            lengths: [
                required("x-length")? * NANOMETRE,
                required("y-length")? * NANOMETRE,
            ],
            unit,
            void: number("voidpixels")?.unwrap_or(0.0),
            missing: text
                .lines()
                .find_map(|line| missing::stated(line.trim_start_matches('#'))),
        })
    }
}

/// Returns the lines of the header. If they are not UTF-8, they are decoded as Latin-1, which older programs write.
fn header_text(bytes: &[u8]) -> String {
    let bytes = without_mark(bytes);
    let lines = bytes.split_inclusive(|&byte| byte == b'\n');
    let header: Vec<u8> = lines
        .take_while(|line| line.starts_with(b"#"))
        .flatten()
        .copied()
        .collect();
    String::from_utf8(header).unwrap_or_else(|error| {
        let bytes = error.into_bytes();
        bytes.into_iter().map(char::from).collect()
    })
}

/// Returns all numbers after the header.
fn numbers(bytes: &[u8]) -> Result<Vec<f64>> {
    let mut numbers = Vec::new();
    for (number, line) in lines(bytes) {
        let separator = Separator::of(&line);
        for cell in separator.split(&line).filter(|cell| !cell.is_empty()) {
            numbers.push(separator.number(FORMAT, number, cell)?);
        }
    }
    Ok(numbers)
}
