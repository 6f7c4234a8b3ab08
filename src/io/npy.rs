//! NPY, the array file of NumPy.
//!
//! The arrays have two axes and the shape `(ny, nx)`. The first index counts rows towards larger y. The file contains
//! neither cell sides nor a unit.
//!
//! Layout: <https://numpy.org/doc/stable/reference/generated/numpy.lib.format.html>.

use std::fs::File;
use std::io::{BufWriter, Read, Result as IoResult, Seek, SeekFrom, Write};
use std::ops::Range;
use std::path::Path;

use super::text::excerpt;
use super::{Place, Sides, missing, parse_file, write_bytes};
use crate::error::Result;
use crate::files::replace;
use crate::files::{ByteOrder, Cursor, NumberFormat};
use crate::files::{Format, in_file, refused};
use crate::grid::Grid;
use crate::grid::field::Field;
use crate::parallel::ranks::RankGroup;

const FORMAT: Format = Format("NPY");
const MAGIC: &[u8; 6] = b"\x93NUMPY";
/// Length of a written header, enough for two integers. Samples then begin at byte 128, because the format requires a
/// multiple of 64.
const HEADER_LENGTH: u16 = 118;
/// First byte of the samples in a written file.
const FIRST_SAMPLE: u64 = 128;

/// Options for reading an array.
///
/// ```
/// use stickslip::{Field, Grid, io::npy};
/// let grid = Grid::new(2, 2, 1.0, 1.0)?;
/// let file = npy::to_bytes(&Field::from_vec(grid, vec![1.5, 2.5, -9999.0, 4.0])?);
/// assert!(npy::parse(&file, [1.0, 1.0]).is_err());
/// let heights = npy::Options::default().missing(-9999.0).parse(&file, [1.0, 1.0])?;
/// assert!(heights.as_slice()[2].is_nan());
/// # Ok::<(), stickslip::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[must_use = "options do nothing until read() or parse() is called"]
pub struct Options {
    missing: Option<f64>,
}

impl Options {
    /// Sets the value that marks a missing point (default: none), as [`csv::Options::missing`](super::csv::Options::missing). NaN
    /// states that all numbers are heights.
    pub fn missing(mut self, value: f64) -> Self {
        self.missing = Some(value);
        self
    }

    /// Reads the field in a file. The [`Sides`] (lengths) are the sides of a cell, `[dx, dy]`, or the sides of the
    /// whole grid. See [`parse`].
    ///
    /// # Errors
    /// - [`Error::File`](crate::Error::File) if the file cannot be read.
    /// - The errors of [`parse`].
    pub fn read(self, path: impl AsRef<Path>, sides: impl Into<Sides>) -> Result<Field> {
        let sides = sides.into().checked()?;
        parse_file(path.as_ref(), |bytes| self.parse(bytes, sides))
    }

    /// Reads the field in the bytes of a file. The [`Sides`] (lengths) are the sides of a cell, `[dx, dy]`, or the
    /// sides of the whole grid. See [`parse`].
    ///
    /// # Errors
    /// See [`parse`].
    pub fn parse(self, bytes: &[u8], sides: impl Into<Sides>) -> Result<Field> {
        let sides = sides.into().checked()?;
        let array = ArrayHeader::parse(bytes, bytes.len() as u64)?;
        let mut samples = array.samples(array.shape[0], &bytes[array.start..]);
        if let Some(problem) = missing::problem(self.missing, &samples.iter().copied())? {
            return Err(FORMAT.at_byte(array.start, problem));
        }
        if let Some(mark) = self.missing {
            missing::remove(mark, samples.iter_mut());
        }
        Field::from_vec(array.grid(sides)?, samples)
    }
}

/// Reads the field in a file. The [`Sides`] (lengths) are the sides of a cell, `[dx, dy]`, or the sides of the whole
/// grid. See [`parse`].
///
/// # Errors
/// - [`Error::File`](crate::Error::File) if the file cannot be read.
/// - The errors of [`parse`].
pub fn read(path: impl AsRef<Path>, sides: impl Into<Sides>) -> Result<Field> {
    Options::default().read(path, sides)
}

/// Reads the field in the bytes of a file. The [`Sides`] (lengths) are the sides of a cell, `[dx, dy]`, or the sides of
/// the whole grid.
///
/// The function supports versions 1 to 3 of the format, and C and Fortran order of the axes. Samples are floats of 32
/// or 64 bits or integers of 8 to 64 bits, in either byte order. Integers of 64 bits are rounded to the nearest double.
///
/// # Errors
/// - [`Error::NotPositive`](crate::Error::NotPositive) if a cell side is not positive and finite.
/// - [`Error::Format`](crate::Error::Format) if the bytes are not an NPY file, or if their number does not match the
///   shape.
/// - [`Error::Format`](crate::Error::Format) if a number may mark missing points, as in [`csv`](super::csv::parse), unless
///   [`Options::missing`] states the mark.
///
/// ```
/// use stickslip::{Field, Grid, io::npy};
/// let field = Field::from_fn(Grid::new(3, 2, 0.5, 0.25)?, |x, y| x + y);
/// assert_eq!(npy::parse(&npy::to_bytes(&field), [0.5, 0.25])?, field);
/// # Ok::<(), stickslip::Error>(())
/// ```
pub fn parse(bytes: &[u8], sides: impl Into<Sides>) -> Result<Field> {
    Options::default().parse(bytes, sides)
}

/// Reads the grid of the array in a file without reading the samples. The [`Sides`] (lengths) are the sides of a cell,
/// `[dx, dy]`, or the sides of the whole grid.
///
/// # Errors
/// See [`read`].
///
/// ```
/// use stickslip::{Field, Grid, io::npy};
/// # let path = std::env::temp_dir().join(format!("stickslip_grid_{}.npy", std::process::id()));
/// let grid = Grid::new(3, 2, 0.5, 0.25)?;
/// npy::write(&path, &Field::zeros(grid))?;
/// assert_eq!(npy::grid(&path, [0.5, 0.25])?, grid);
/// # std::fs::remove_file(path).ok();
/// # Ok::<(), stickslip::Error>(())
/// ```
pub fn grid(path: impl AsRef<Path>, sides: impl Into<Sides>) -> Result<Grid> {
    let sides = sides.into().checked()?;
    let path = path.as_ref();
    let (_, array) = open(path)?;
    array.grid(sides).map_err(|error| in_file(path, error))
}

/// Reads the rows of the array that belong to a slab.
pub(crate) fn read_slab(path: &Path, slab: Grid) -> Result<Field> {
    let (mut file, array) = open(path)?;
    let ([ny, nx], whole) = (array.shape, slab.whole());
    if [nx, ny] != whole.size() {
        let [columns, rows] = whole.size();
        let problem = format!(
            "the array has the shape ({ny}, {nx}), but the grid has the shape ({rows}, {columns})"
        );
        return Err(in_file(path, FORMAT.at_byte(array.start, problem)));
    }
    let bytes = array.rows(&mut file, slab.rows());
    let bytes = bytes.map_err(|error| refused(path, error))?;
    Field::from_vec(slab, array.samples(slab.ny(), &bytes))
}

/// Opens a file and parses its header.
fn open(path: &Path) -> Result<(File, ArrayHeader)> {
    let refuse = |error: std::io::Error| refused(path, error);
    let file = File::open(path).map_err(refuse)?;
    let length = file.metadata().map_err(refuse)?.len();
    let head = head(&file).map_err(refuse)?;
    let array = ArrayHeader::parse(&head, length).map_err(|error| in_file(path, error))?;
    Ok((file, array))
}

/// Returns the bytes of a file before the samples, or fewer if the file is truncated.
fn head(file: &File) -> IoResult<Vec<u8>> {
    let mut head = Vec::new();
    file.take(12).read_to_end(&mut head)?;
    let left = match *head {
        [_, _, _, _, _, _, 1, _, low, high, _, _] => {
            u64::from(u16::from_le_bytes([low, high])).saturating_sub(2)
        }
        [_, _, _, _, _, _, 2 | 3, _, a, b, c, d] => u64::from(u32::from_le_bytes([a, b, c, d])),
        _ => 0,
    };
    file.take(left).read_to_end(&mut head)?;
    Ok(head)
}

/// Writes a field to a file in the form of [`to_bytes`].
///
/// # Errors
/// - [`Error::File`](crate::Error::File) if the file cannot be written.
pub fn write(path: impl AsRef<Path>, field: &Field) -> Result<()> {
    write_bytes(path.as_ref(), &to_bytes(field))
}

/// Writes a distributed field to a single file in the form of [`to_bytes`]. Either the whole file is written or no file
/// at all.
pub(crate) fn write_slab(path: &Path, field: &Field, team: Option<&RankGroup>) -> Result<()> {
    let grid = field.grid();
    let is_first = team.is_none_or(|team| team.rank() == 0);
    let first_cell = grid.rows().start * grid.nx();
    replace(path, team, |file| {
        if is_first {
            file.write_all(&header(grid.whole()))?;
        }
        file.seek(SeekFrom::Start(FIRST_SAMPLE + 8 * first_cell as u64))?;
        let mut file = BufWriter::new(file);
        let mut samples = field.as_slice().iter();
        samples.try_for_each(|z| file.write_all(&z.to_le_bytes()))?;
        file.flush()
    })
}

/// Returns the bytes of a file with a field: version 1.0, little-endian doubles in C order, shape `(ny, nx)`. Samples
/// are stored exactly. The cell sides are not stored.
#[must_use]
pub fn to_bytes(field: &Field) -> Vec<u8> {
    let mut bytes = header(field.grid());
    bytes.reserve_exact(8 * field.as_slice().len());
    bytes.extend(field.as_slice().iter().flat_map(|z| z.to_le_bytes()));
    bytes
}

/// Returns the bytes before the samples of a field.
fn header(grid: Grid) -> Vec<u8> {
    let (nx, ny) = (grid.nx(), grid.ny());
    let header = format!("{{'descr': '<f8', 'fortran_order': False, 'shape': ({ny}, {nx}), }}");
    let mut bytes = MAGIC.to_vec();
    bytes.extend_from_slice(&[1, 0]);
    bytes.extend_from_slice(&HEADER_LENGTH.to_le_bytes());
    let width = usize::from(HEADER_LENGTH) - 1;
    bytes.extend_from_slice(format!("{header:<width$}\n").as_bytes());
    bytes
}

/// Storage format and position of the array in a file.
#[derive(Debug)]
struct ArrayHeader {
    number: NumberFormat,
    order: ByteOrder,
    is_fortran: bool,
    /// Numbers of rows and columns.
    shape: [usize; 2],
    /// Position of the header in the file.
    header: usize,
    /// Position of the samples in the file.
    start: usize,
}

impl ArrayHeader {
    /// Parses the bytes before the samples. `length` is the number of bytes of the whole file.
    fn parse(bytes: &[u8], length: u64) -> Result<Self> {
        if bytes.starts_with(b"PK\x03\x04") {
            let problem = "the file is a zip archive, as an NPZ file: save one array by numpy.save";
            return Err(FORMAT.at_byte(0, problem));
        }
        FORMAT.check_compression(bytes)?;
        let mut bytes = Cursor::new(FORMAT, bytes);
        if bytes.take("the magic string", MAGIC.len())? != MAGIC {
            return Err(FORMAT.at_byte(0, "the file does not start with \\x93NUMPY"));
        }
        let [major, minor] = bytes.array("the version")?;
        let header = match major {
            1 => usize::from(bytes.u16("the length of the header")?),
            2 | 3 => bytes.u32("the length of the header")? as usize,
            _ => {
                return Err(FORMAT.at_byte(
                    6,
                    format!("version {major}.{minor} is not supported, expected version 1, 2 or 3"),
                ));
            }
        };
        let start = bytes.position();
        let array = Self::described(start, bytes.take("the header", header)?)?;

        let [ny, nx] = array.shape;
        let place = Place::Byte(start as u64);
        let cells = FORMAT.grid(place, [nx, ny], [1.0; 2])?.cells();
        let (expected, found) = (
            (cells * array.number.size()) as u64,
            length.saturating_sub(array.start as u64),
        );
        if found != expected {
            let problem = format!(
                "an array of shape ({ny}, {nx}) requires {expected} bytes, but the file has {found}"
            );
            return Err(FORMAT.at_byte(array.start, problem));
        }
        Ok(array)
    }

    /// Returns the grid of the array.
    fn grid(&self, sides: Sides) -> Result<Grid> {
        let [ny, nx] = self.shape;
        FORMAT.grid(
            Place::Byte(self.header as u64),
            [nx, ny],
            sides.of_cell([nx, ny]),
        )
    }

    /// Reads the bytes of a range of rows, row by row in C order and column by column in Fortran order.
    fn rows(&self, file: &mut File, rows: Range<usize>) -> IoResult<Vec<u8>> {
        let ([ny, nx], size) = (self.shape, self.number.size());
        let (run, first, step) = if self.is_fortran {
            (rows.len(), rows.start, ny)
        } else {
            (rows.len() * nx, rows.start * nx, 0)
        };
        let mut bytes = vec![0; rows.len() * nx * size];
        for (index, run) in bytes.chunks_mut((run * size).max(1)).enumerate() {
            let place = self.start + (first + index * step) * size;
            file.seek(SeekFrom::Start(place as u64))?;
            file.read_exact(run)?;
        }
        Ok(bytes)
    }

    /// Decodes the samples of `rows` rows from their bytes.
    fn samples(&self, rows: usize, bytes: &[u8]) -> Vec<f64> {
        let samples = self.number.decode(self.order, bytes);
        if !self.is_fortran {
            return samples;
        }
        let columns = self.shape[1];
        let transposed = |cell: usize| samples[cell % columns * rows + cell / columns];
        (0..samples.len()).map(transposed).collect()
    }

    /// Parses the header, a Python dictionary of three entries that begins at the byte `start`.
    fn described(start: usize, text: &[u8]) -> Result<Self> {
        let header = String::from_utf8_lossy(text);
        let value = |key: &str| {
            let after = header.split_once(key).map(|(_, after)| after.trim_start());
            let value = after.and_then(|after| after.strip_prefix(':'));
            let problem = || FORMAT.at_byte(start, format!("the header has no {key}"));
            value.map(str::trim_start).ok_or_else(problem)
        };
        let refused = |key: &str, value: &str| {
            FORMAT.at_byte(start, format!("{key} {} is not supported", excerpt(value)))
        };
        let descr = value("'descr'")?;
        let (number, order) = number(descr).ok_or_else(|| {
            let problem = format!(
                "the dtype {} is not supported: save the array as floats by astype('<f8')",
                dtype(descr)
            );
            FORMAT.at_byte(start, problem)
        })?;
        let fortran = value("'fortran_order'")?;
        let is_fortran = fortran.starts_with("True");
        if !is_fortran && !fortran.starts_with("False") {
            return Err(refused("'fortran_order'", fortran));
        }
        let shape = value("'shape'")?;
        Ok(Self {
            number,
            order,
            is_fortran,
            shape: pair(shape).ok_or_else(|| match axes(shape) {
                Some((0 | 1, shape)) => FORMAT.at_byte(
                    start,
                    format!("the array has the shape {shape}, expected (ny, nx): reshape it to two axes before saving it"),
                ),
                Some((count, shape)) if count > 2 => FORMAT.at_byte(
                    start,
                    format!(
                        "the array has the shape {shape}, expected (ny, nx): save one plane, such as array[0] or array[..., 0]"
                    ),
                ),
                _ => refused("'shape'", shape),
            })?,
            header: start,
            start: start + text.len(),
        })
    }
}

/// Returns the number type and byte order of a quoted code such as `'<f8'`.
fn number(descr: &str) -> Option<(NumberFormat, ByteOrder)> {
    let (code, _) = descr.strip_prefix('\'')?.split_once('\'')?;
    let (order, kind) = match code.strip_prefix('>') {
        Some(kind) => (ByteOrder::GreatestFirst, kind),
        None => (ByteOrder::LeastFirst, code.strip_prefix(['<', '|'])?),
    };
    let number = match kind {
        "i1" => NumberFormat::I8,
        "i2" => NumberFormat::I16,
        "i4" => NumberFormat::I32,
        "i8" => NumberFormat::I64,
        "u1" => NumberFormat::U8,
        "u2" => NumberFormat::U16,
        "u4" => NumberFormat::U32,
        "u8" => NumberFormat::U64,
        "f4" => NumberFormat::F32,
        "f8" => NumberFormat::F64,
        _ => return None,
    };
    Some((number, order))
}

/// Returns the name of an unsupported dtype from its code.
fn dtype(descr: &str) -> String {
    if descr.starts_with('[') {
        return "of records (a structured dtype)".into();
    }
    let quoted = |text: &str| {
        let (code, _) = text.strip_prefix('\'')?.split_once('\'')?;
        Some(code.to_owned())
    };
    let Some(code) = quoted(descr) else {
        return excerpt(descr);
    };
    let kind = code.trim_start_matches(['<', '>', '|', '=']);
    let bits = |size: &str| size.parse::<u32>().ok()?.checked_mul(8);
    let sized = |name: &str, size: &str| bits(size).map(|bits| format!("{name}{bits}"));
    let name = match kind.split_at_checked(1) {
        Some(("b", "1")) => Some("bool".into()),
        Some(("O", _)) => Some("object".into()),
        Some(("f", size)) => sized("float", size),
        Some(("c", size)) => sized("complex", size),
        Some(("i", size)) => sized("int", size),
        Some(("u", size)) => sized("uint", size),
        Some(("U" | "S", _)) => Some("of text".into()),
        Some(("M", _)) => Some("datetime64".into()),
        Some(("m", _)) => Some("timedelta64".into()),
        _ => None,
    };
    let code = excerpt(&code);
    name.map_or_else(|| code.clone(), |name| format!("{name} ({code})"))
}

/// Parses the two lengths of a tuple such as `(3, 4)`.
fn pair(shape: &str) -> Option<[usize; 2]> {
    let (inner, _) = shape.strip_prefix('(')?.split_once(')')?;
    let (first, second) = inner.split_once(',')?;
    let second = second.trim();
    let second = second.strip_suffix(',').unwrap_or(second);
    Some([first.trim().parse().ok()?, second.parse().ok()?])
}

/// Returns the number of lengths in a tuple of any number of whole numbers, and its text.
fn axes(shape: &str) -> Option<(usize, &str)> {
    let end = shape.find(')')?;
    let inner = shape[..end].strip_prefix('(')?.trim();
    let lengths = inner.strip_suffix(',').unwrap_or(inner).split(',');
    let mut lengths = lengths.map(str::trim).filter(|length| !length.is_empty());
    let count = lengths.clone().count();
    let is_whole = |length: &str| length.parse::<usize>().is_ok();
    lengths.all(is_whole).then(|| (count, &shape[..=end]))
}
