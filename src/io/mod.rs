//! Files of surfaces and fields.
//!
//! | format | module | reads | writes | contains cell sides | unit |
//! |---|---|---|---|---|---|
//! | NPY, the array file of NumPy | [`npy`] | yes | yes | no | the file's |
//! | CSV and other matrices in text | [`csv`] | yes | yes | no | the file's |
//! | ASC with the header of SPIP or of the text export of Gwyddion | [`asc`] | yes | | yes | metre |
//! | XYZ, three columns in text | [`xyz`] | yes | | yes | the file's |
//! | SDF of ISO 25178-71 | [`sdf`] | yes | yes | yes | metre |
//! | SUR of Digital Surf, not compressed | [`sur`] | yes | | yes | metre |
//! | X3P of ISO 25178-72 | `x3p`, with the feature `x3p` | yes | | yes | metre |
//! | VTI, the image data of VTK and ParaView | [`vti`], volumes by [`Planes::write_vti`](crate::subsurface::Planes::write_vti) | | yes | yes | the field's |
//! | PVD, a series of VTI files in time | [`pvd`] | | yes | | |
//! | PVTI, one VTI file per rank of a distributed grid | [`HalfSpace::write_pvti`](crate::HalfSpace::write_pvti) | | yes | yes | the field's |
//!
//! The argument of `read` is a path, and the argument of `parse` contains the bytes of a file. The functions `write`
//! and `to_bytes` are the inverses of `read` and `parse`. [`read`](fn@read) of this module identifies the format of a
//! file among the formats with cell sides. On a distributed grid, all ranks read and write a single NPY file with
//! [`HalfSpace::read_npy`](crate::HalfSpace::read_npy) and [`HalfSpace::write_npy`](crate::HalfSpace::write_npy). Each rank reads
//! and writes its own rows.
//!
//! # Conventions
//! - A height is returned as stored in the file. A surface that points up has large values at its peaks. The gap of a contact has
//!   the opposite sign.
//! - Samples keep the order of the file. The first sample belongs to cell `(0, 0)`, at the smallest x and y. The next sample
//!   belongs to the neighbour of this cell along x. Rows are ordered towards larger y. A file whose rows are counted from the top
//!   is therefore read mirrored. XYZ files give the position of each point.
//! - A point that was not measured is NaN. Solvers do not accept NaN, so fill such points first.
//! - CSV, XYZ and NPY files may mark such a point by a number, as -9999. The option `missing` states this number. Other numbers
//!   that may be marks are rejected.
//! - A [`Grid`](crate::Grid) is centred on the origin. The origin given in the file is ignored.
//! - A row of n points with the spacing d covers n cells of side d, not n - 1 cells.
//!
//! # Damaged files
//! Files that are compressed by gzip or another program are rejected. Decompress them first.
//!
//! A truncated, damaged or inconsistent file causes an [`Error::Format`](crate::Error::Format) with the problem and its
//! [place](Place). Sizes are checked against the number of bytes before memory is allocated. The memory for reading a file is
//! therefore less than fifty times its size. X3P files are compressed. The memory for reading such a file is less than eight
//! times the largest permitted size of an expanded entry.

mod missing;
mod slabs;

pub mod asc;
pub mod csv;
pub mod npy;
pub mod pvd;
pub(crate) mod pvti;
pub mod sdf;
pub mod sur;
mod text;
pub(crate) mod volume;
pub mod vti;
#[cfg(feature = "x3p")]
#[cfg_attr(docsrs, doc(cfg(feature = "x3p")))]
pub mod x3p;
pub mod xyz;

use std::path::Path;

pub use crate::error::Place;
use crate::error::{Result, positive};
use crate::files::{Format, in_file, refused};
use crate::grid::field::Field;

/// Reads a surface from a file that contains its cell sides. SDF, SUR, ASC and X3P are recognised by their first bytes, and XYZ
/// is recognised by the extension `.xyz`.
///
/// The unit is documented in the module of the format.
///
/// # Errors
/// - [`Error::File`](crate::Error::File) if the file cannot be read.
/// - [`Error::Format`](crate::Error::Format) if the file has a different format, or for the reasons given at the
///   `parse` of its format. For a text of three columns, the error suggests reading the points as XYZ.
///
/// ```
/// use stickslip::{Error, io};
/// let error = io::read("no_such_file.sdf").unwrap_err();
/// assert!(matches!(error, Error::File { .. }));
/// ```
pub fn read(path: impl AsRef<Path>) -> Result<Field> {
    let path = path.as_ref();
    let extension = path.extension().unwrap_or_default();
    parse_file(path, |bytes| {
        if sdf::is_sdf(bytes) {
            return sdf::parse(bytes);
        }
        if sur::is_sur(bytes) {
            return sur::parse(bytes);
        }
        if asc::is_asc(bytes) || asc::is_gwyddion(bytes) {
            return asc::parse(bytes);
        }
        if bytes.starts_with(b"PK\x03\x04") {
            return parse_x3p(bytes);
        }
        text::check_encoding(Format("surface"), bytes)?;
        asc::check_esri(Format("surface"), bytes, 0)?;
        if extension.eq_ignore_ascii_case("xyz") {
            return xyz::parse(bytes);
        }
        let is = |known: &str| extension.eq_ignore_ascii_case(known);
        Err(Format("surface").at_byte(
            0,
            if bytes.starts_with(b"\x93NUMPY") || is("npy") {
                "an NPY file does not contain the cell sides: read it as NPY, and give the sides"
            } else if (is("csv") || is("txt") || is("dat") || is("asc")) && xyz::is_like_points(bytes) {
                "the lines have three numbers: read the file as XYZ if these are x, y and z, otherwise read it as CSV, and give the sides"
            } else if is("csv") || is("asc") || is("txt") {
                "a text file does not contain the cell sides: read it as CSV, and give the sides"
            } else {
                "the file is not an SDF, SUR, ASC, X3P or XYZ file: read NPY and CSV files by their own functions, and give the cell sides"
            },
        ))
    })
}

#[cfg(feature = "x3p")]
fn parse_x3p(bytes: &[u8]) -> Result<Field> {
    x3p::parse(bytes)
}

#[cfg(not(feature = "x3p"))]
fn parse_x3p(_: &[u8]) -> Result<Field> {
    Err(Format("X3P").at_byte(0, "reading X3P files requires the cargo feature `x3p`"))
}

/// Cell or grid sides (lengths) for a file that does not contain them. An array `[dx, dy]` converts to the sides of a
/// cell.
///
/// ```
/// use stickslip::{Field, Grid, io};
/// let field = Field::zeros(Grid::new(4, 2, 0.5, 0.25)?);
/// let file = io::npy::to_bytes(&field);
/// assert_eq!(io::npy::parse(&file, [0.5, 0.25])?, field);
/// assert_eq!(io::npy::parse(&file, io::Sides::OfGrid([2.0, 0.5]))?, field);
/// # Ok::<(), stickslip::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum Sides {
    /// Sides of a cell along x and y.
    OfCell([f64; 2]),
    /// Sides of the whole grid along x and y.
    OfGrid([f64; 2]),
}

impl From<[f64; 2]> for Sides {
    fn from(sides: [f64; 2]) -> Self {
        Self::OfCell(sides)
    }
}

impl Sides {
    /// Returns an error if a side is not positive and finite.
    fn checked(self) -> Result<Self> {
        let (names, sides) = match self {
            Self::OfCell(sides) => (["cell side dx", "cell side dy"], sides),
            Self::OfGrid(sides) => (
                ["side of the grid along x", "side of the grid along y"],
                sides,
            ),
        };
        for (name, side) in names.into_iter().zip(sides) {
            positive(name, side)?;
        }
        Ok(self)
    }

    /// Returns the sides of a cell of a grid with the given numbers of cells.
    fn of_cell(self, [nx, ny]: [usize; 2]) -> [f64; 2] {
        match self {
            Self::OfCell(sides) => sides,
            Self::OfGrid([x, y]) => [x / nx as f64, y / ny as f64],
        }
    }
}

/// Reads and parses a file, and adds its path to an error in its contents.
fn parse_file<T>(path: &Path, parse: impl FnOnce(&[u8]) -> Result<T>) -> Result<T> {
    let bytes = std::fs::read(path).map_err(|error| refused(path, error))?;
    parse(&bytes).map_err(|error| in_file(path, error))
}

/// Creates or replaces a file.
fn write_bytes(path: &Path, bytes: &[u8]) -> Result<()> {
    std::fs::write(path, bytes).map_err(|error| refused(path, error))
}
