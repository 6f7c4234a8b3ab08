//! NPY, the array file of NumPy.
//!
//! For arrays of two axes, shape `(ny, nx)`: the first index counts rows towards larger y. The file
//! carries neither cell sides nor a unit.
//!
//! Layout: <https://numpy.org/doc/stable/reference/generated/numpy.lib.format.html>.

use std::path::Path;

use super::bytes::{Cursor, Number, Order};
use super::text::excerpt;
use super::{Format, Place, Sides, parse_file, write_bytes};
use crate::error::Result;
use crate::field::Field;

const FORMAT: Format = Format("NPY");
const MAGIC: &[u8; 6] = b"\x93NUMPY";
/// Enough for two integers; samples then begin at byte 128, since the format requires a multiple of 64.
const HEADER_LENGTH: u16 = 118;

/// The field in a file, on cells of [sides](Sides) `[dx, dy]`, or of a grid of given sides (lengths). See [`parse`].
///
/// # Errors
/// [`Error::File`](crate::Error::File) if the file cannot be read, otherwise as [`parse`].
pub fn read(path: impl AsRef<Path>, sides: impl Into<Sides>) -> Result<Field> {
    let sides = sides.into().checked()?;
    parse_file(path.as_ref(), |bytes| parse(bytes, sides))
}

/// The field in the bytes of a file, on cells of [sides](Sides) `[dx, dy]`, or of a grid of given sides (lengths).
///
/// Versions 1 to 3 of the format; floats of 32 and 64 bits and integers of 8 to 64 bits in either byte
/// order; C and Fortran order of axes. Integers of 64 bits are rounded to the nearest double.
///
/// # Errors
/// [`Error::NotPositive`](crate::Error::NotPositive) for a cell side;
/// [`Error::Format`](crate::Error::Format) if the bytes are not an NPY file, or their number disagrees
/// with its shape.
///
/// ```
/// use stickslip::{Field, Grid, io::npy};
/// let field = Field::from_fn(Grid::new(3, 2, 0.5, 0.25)?, |x, y| x + y);
/// assert_eq!(npy::parse(&npy::to_bytes(&field), [0.5, 0.25])?, field);
/// # Ok::<(), stickslip::Error>(())
/// ```
pub fn parse(bytes: &[u8], sides: impl Into<Sides>) -> Result<Field> {
    let sides = sides.into().checked()?;
    let mut bytes = Cursor::new(FORMAT, bytes);
    if bytes.take("the magic string", MAGIC.len())? != MAGIC {
        return Err(FORMAT.at_byte(0, "the file does not begin with \\x93NUMPY"));
    }
    let [major, minor] = bytes.array("the version")?;
    let length = match major {
        1 => usize::from(bytes.u16("the length of the header")?),
        2 | 3 => bytes.u32("the length of the header")? as usize,
        _ => return Err(FORMAT.at_byte(6, format!("version {major}.{minor} is unknown"))),
    };
    let start = bytes.position();
    let header = Header::parse(start, bytes.take("the header", length)?)?;

    let [ny, nx] = header.shape;
    let grid = FORMAT.grid(Place::Byte(start as u64), [nx, ny], sides.of_cell([nx, ny]))?;
    let (expected, found) = (grid.cells() * header.number.size(), bytes.rest().len());
    if found != expected {
        let problem = format!("shape ({ny}, {nx}) takes {expected} bytes, the file has {found}");
        return Err(FORMAT.at_byte(bytes.position(), problem));
    }
    let samples = header.number.decode(header.order, bytes.rest());
    if header.is_fortran {
        let transposed = |cell: usize| samples[cell % nx * ny + cell / nx];
        return Field::from_vec(grid, (0..samples.len()).map(transposed).collect());
    }
    Field::from_vec(grid, samples)
}

/// Writes a field to a file, as [`to_bytes`].
///
/// # Errors
/// [`Error::File`](crate::Error::File) if the file cannot be written.
pub fn write(path: impl AsRef<Path>, field: &Field) -> Result<()> {
    write_bytes(path.as_ref(), &to_bytes(field))
}

/// A field as a file: version 1.0, little-endian doubles in C order, shape `(ny, nx)`. Every bit of
/// every sample is kept; the cell sides are not stored.
#[must_use]
pub fn to_bytes(field: &Field) -> Vec<u8> {
    let (nx, ny) = (field.grid().nx(), field.grid().ny());
    let header = format!("{{'descr': '<f8', 'fortran_order': False, 'shape': ({ny}, {nx}), }}");
    let mut bytes = Vec::with_capacity(128 + 8 * field.as_slice().len());
    bytes.extend_from_slice(MAGIC);
    bytes.extend_from_slice(&[1, 0]);
    bytes.extend_from_slice(&HEADER_LENGTH.to_le_bytes());
    let width = usize::from(HEADER_LENGTH) - 1;
    bytes.extend_from_slice(format!("{header:<width$}\n").as_bytes());
    bytes.extend(field.as_slice().iter().flat_map(|z| z.to_le_bytes()));
    bytes
}

/// The contents of the header.
#[derive(Debug)]
struct Header {
    number: Number,
    order: Order,
    is_fortran: bool,
    shape: [usize; 2],
}

impl Header {
    /// The header is a Python dictionary of three entries; `start` is where it begins.
    fn parse(start: usize, header: &[u8]) -> Result<Self> {
        let header = String::from_utf8_lossy(header);
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
        let (number, order) = number(descr).ok_or_else(|| refused("'descr'", descr))?;
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
            shape: pair(shape).ok_or_else(|| refused("'shape'", shape))?,
        })
    }
}

/// The kind of number behind a quoted code such as `'<f8'`.
fn number(descr: &str) -> Option<(Number, Order)> {
    let (code, _) = descr.strip_prefix('\'')?.split_once('\'')?;
    let (order, kind) = match code.strip_prefix('>') {
        Some(kind) => (Order::GreatestFirst, kind),
        None => (Order::LeastFirst, code.strip_prefix(['<', '|'])?),
    };
    let number = match kind {
        "i1" => Number::I8,
        "i2" => Number::I16,
        "i4" => Number::I32,
        "i8" => Number::I64,
        "u1" => Number::U8,
        "u2" => Number::U16,
        "u4" => Number::U32,
        "u8" => Number::U64,
        "f4" => Number::F32,
        "f8" => Number::F64,
        _ => return None,
    };
    Some((number, order))
}

/// The two lengths of a tuple such as `(3, 4)`.
fn pair(shape: &str) -> Option<[usize; 2]> {
    let (inner, _) = shape.strip_prefix('(')?.split_once(')')?;
    let (first, second) = inner.split_once(',')?;
    let second = second.trim();
    let second = second.strip_suffix(',').unwrap_or(second);
    Some([first.trim().parse().ok()?, second.parse().ok()?])
}
