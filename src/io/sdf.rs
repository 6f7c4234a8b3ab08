//! SDF, the surface data file of ISO 25178-71, in its binary and its text form.
//!
//! Lengths are in metres. Profiles are ordered towards larger y, and their points towards larger x.
//!
//! Source: ISO 25178-71:2012, Geometrical product specifications, Surface texture: Areal, Part 71:
//! Software measurement standards.

use std::path::Path;

use super::text::{Separator, excerpt, lines};
use super::{Place, parse_file, write_bytes};
use crate::error::Result;
use crate::files::Format;
use crate::files::{ByteOrder, Cursor, NumberFormat};
use crate::grid::Grid;
use crate::grid::field::Field;

const FORMAT: Format = Format("SDF");
const MAGIC_LENGTH: usize = 8;
const BINARY: &[u8; MAGIC_LENGTH] = b"bISO-1.0";
/// Magic strings of binary files in this layout. The BCR format is the predecessor of SDF, with the same header.
const BINARIES: [&[u8; MAGIC_LENGTH]; 2] = [BINARY, b"bBCR-1.0"];
const TEXTS: [&[u8; MAGIC_LENGTH]; 3] = [b"aISO-1.0", b"aISO-2.0", b"aBCR-1.0"];

/// Reads the surface in a file (metres). See [`parse`].
///
/// # Errors
/// - [`Error::File`](crate::Error::File) if the file cannot be read.
/// - The errors of [`parse`].
pub fn read(path: impl AsRef<Path>) -> Result<Field> {
    parse_file(path.as_ref(), parse)
}

/// Reads the surface in the bytes of a file (metres).
///
/// The function supports version 1.0 (`bISO-1.0` or `aISO-1.0`) without compression or checksum. It also supports the
/// text form of version 2.0 (`aISO-2.0`) and the earlier BCR format (`bBCR-1.0` and `aBCR-1.0`), both of which have
/// the same layout. Binary samples are integers of 16 or 32 bits (data types 5 and 6) or floats of 32 or 64 bits (data
/// types 3 and 7). Missing points become NaN. A missing point is stored as the smallest number of the data type or as
/// NaN in a binary file, and as `BAD` in a text file. The record after the samples is ignored.
///
/// # Errors
/// - [`Error::Format`](crate::Error::Format) if the bytes are not an SDF file, or if there are fewer bytes than the
///   sizes in the file require.
///
/// ```
/// use stickslip::io::sdf;
/// let file = b"aISO-1.0\nNumPoints = 2\nNumProfiles = 1\nXscale = 1e-6\nYscale = 1e-6\nZscale = 1e-9\n*\n5 BAD\n*\n";
/// let heights = sdf::parse(file)?;
/// assert_eq!(heights.as_slice()[0], 5e-9);
/// assert!(heights.as_slice()[1].is_nan());
/// # Ok::<(), stickslip::Error>(())
/// ```
pub fn parse(bytes: &[u8]) -> Result<Field> {
    FORMAT.check_compression(bytes)?;
    if begins_as(&BINARIES, bytes) {
        parse_binary(bytes)
    } else if begins_as(&TEXTS, bytes) {
        parse_text(bytes)
    } else if is_sdf(bytes) && bytes.len() >= MAGIC_LENGTH {
        let dialect = excerpt(&String::from_utf8_lossy(&bytes[..MAGIC_LENGTH]));
        let problem = format!(
            "the file starts with the dialect {dialect}, which is not supported: save it as bISO-1.0 or aISO-1.0"
        );
        Err(FORMAT.at_byte(0, problem))
    } else {
        Err(FORMAT.at_byte(0, "the file does not start with bISO-1.0 or aISO-1.0"))
    }
}

/// Writes a surface (metres) to a file in the form of [`to_bytes`].
///
/// # Errors
/// - The errors of [`to_bytes`].
/// - [`Error::File`](crate::Error::File) if the file cannot be written.
pub fn write(path: impl AsRef<Path>, field: &Field) -> Result<()> {
    write_bytes(path.as_ref(), &to_bytes(field)?)
}

/// Returns the bytes of a file with a surface (metres): the binary form with doubles (data type 7) and scale one.
/// Samples and cell sides are restored exactly, except that the smallest double and minus infinity are read as NaN.
///
/// # Errors
/// - [`Error::Format`](crate::Error::Format) if a side has more than the 65535 points that the format allows.
pub fn to_bytes(field: &Field) -> Result<Vec<u8>> {
    let grid = field.grid();
    let count = |name: &str, cells: usize| {
        let problem = |_| {
            FORMAT.in_entry(
                name,
                format!("the number of points must be at most 65535, got {cells}"),
            )
        };
        u16::try_from(cells).map_err(problem)
    };
    let counts = [
        count("NumPoints", grid.nx())?,
        count("NumProfiles", grid.ny())?,
    ];
    let (unit_scale, unknown_resolution): (f64, f64) = (1.0, -1.0);
    let scales = [grid.dx(), grid.dy(), unit_scale, unknown_resolution];
    let flags = [0, 7, 0]; // Compression, data type and checksum.

    let mut bytes = BINARY.to_vec();
    bytes.extend_from_slice(b"stickslip ");
    bytes.extend_from_slice(&[b'0'; 24]); // The dates of creation and modification are unknown.
    bytes.extend(counts.iter().flat_map(|count| count.to_le_bytes()));
    bytes.extend(scales.iter().flat_map(|scale| scale.to_le_bytes()));
    bytes.extend_from_slice(&flags);
    bytes.extend(field.as_slice().iter().flat_map(|z| z.to_le_bytes()));
    Ok(bytes)
}

/// Returns whether the first bytes identify an SDF file of any dialect.
pub(super) fn is_sdf(bytes: &[u8]) -> bool {
    begins_as(&[b"aISO-", b"bISO-", b"aBCR-", b"bBCR-"], bytes)
}

fn begins_as<const N: usize>(magics: &[&[u8; N]], bytes: &[u8]) -> bool {
    magics.iter().any(|magic| bytes.starts_with(*magic))
}

fn parse_binary(bytes: &[u8]) -> Result<Field> {
    let mut bytes = Cursor::new(FORMAT, bytes);
    bytes.take("the magic string", BINARY.len())?;
    bytes.take("manufacturer and dates", 34)?;
    let start = bytes.position();
    let points = bytes.u16("NumPoints")?;
    let profiles = bytes.u16("NumProfiles")?;
    let sides = [bytes.f64("Xscale")?, bytes.f64("Yscale")?];
    let grid = FORMAT.grid(
        Place::Byte(start as u64),
        [points.into(), profiles.into()],
        sides,
    )?;
    let place = Place::Byte(bytes.position() as u64);
    let z_scale = FORMAT.positive(place, "Zscale", bytes.f64("Zscale")?)?;
    bytes.f64("Zresolution")?;

    let flags = bytes.position();
    let [compression, data_type, check_type] = bytes.array("the three flags")?;
    let (number, missing) = match data_type {
        3 => (NumberFormat::F32, f64::from(f32::MIN)),
        5 => (NumberFormat::I16, f64::from(i16::MIN)),
        6 => (NumberFormat::I32, f64::from(i32::MIN)),
        7 => (NumberFormat::F64, f64::MIN),
        _ => {
            return Err(FORMAT.at_byte(
                flags + 1,
                format!("data type {data_type} is not supported, expected 3, 5, 6 or 7"),
            ));
        }
    };
    if compression != 0 {
        return Err(FORMAT.at_byte(flags, format!("compression {compression} is not supported")));
    }
    if check_type != 0 {
        return Err(FORMAT.at_byte(flags + 2, format!("checksum {check_type} is not supported")));
    }
    let stored = bytes.take("the samples", grid.cells() * number.size())?;
    let mut samples = number.decode(ByteOrder::LeastFirst, stored);
    for sample in &mut samples {
        // Only the smallest number of the type and minus infinity satisfy this condition.
        *sample = if *sample <= missing {
            f64::NAN
        } else {
            *sample * z_scale
        };
    }
    Field::from_vec(grid, samples)
}

fn parse_text(bytes: &[u8]) -> Result<Field> {
    let mut lines = lines(bytes).skip(1);
    let mut header = TextHeader::default();
    let last = loop {
        let Some((number, line)) = lines.next() else {
            return Err(FORMAT.on_line(1, "the header does not end with a line `*`"));
        };
        if line.trim_start().starts_with('*') {
            break number;
        }
        header.read(number, &line)?;
    };
    let (grid, z_scale) = header.scales(last)?;

    let mut samples = Vec::new();
    let mut end = last;
    'record: for (number, line) in lines {
        end = number;
        for word in Separator::Space.split(&line) {
            if word.starts_with('*') {
                break 'record;
            }
            samples.push(z_scale * Separator::Space.number(FORMAT, number, word)?);
        }
    }
    if samples.len() != grid.cells() {
        let (found, nx, ny) = (samples.len(), grid.nx(), grid.ny());
        let problem =
            format!("the file contains {found} samples, expected {ny} profiles of {nx} points");
        return Err(FORMAT.on_line(end, problem));
    }
    Field::from_vec(grid, samples)
}

/// Relevant lines `Name = Value` of a text file.
#[derive(Debug, Default)]
struct TextHeader {
    points: Option<usize>,
    profiles: Option<usize>,
    scales: [Option<f64>; 3],
}

impl TextHeader {
    fn read(&mut self, number: usize, line: &str) -> Result<()> {
        let Some((name, value)) = line.split_once('=') else {
            return Err(FORMAT.on_line(number, "a header line must have the form Name = Value"));
        };
        let (name, value) = (name.trim(), value.trim());
        let refused = || {
            let problem = format!("{name} = {} is not a valid number", excerpt(value));
            FORMAT.on_line(number, problem)
        };
        let count = || value.parse().map(Some).map_err(|_| refused());
        let real = || value.parse().map(Some).map_err(|_| refused());
        match name {
            "NumPoints" => self.points = count()?,
            "NumProfiles" => self.profiles = count()?,
            "Xscale" => self.scales[0] = real()?,
            "Yscale" => self.scales[1] = real()?,
            "Zscale" => self.scales[2] = real()?,
            "Compression" | "CheckType" if value != "0" => {
                let problem = format!("{name} {} is not supported", excerpt(value));
                return Err(FORMAT.on_line(number, problem));
            }
            _ => {}
        }
        Ok(())
    }

    /// Returns the grid and the scale of the heights. `line` is the last line of the header.
    fn scales(&self, line: usize) -> Result<(Grid, f64)> {
        let missing = |name: &str| FORMAT.on_line(line, format!("the header has no {name}"));
        let nx = self.points.ok_or_else(|| missing("NumPoints"))?;
        let ny = self.profiles.ok_or_else(|| missing("NumProfiles"))?;
        let [dx, dy, dz] = self.scales;
        let dx = dx.ok_or_else(|| missing("Xscale"))?;
        let dy = dy.ok_or_else(|| missing("Yscale"))?;
        let dz = dz.ok_or_else(|| missing("Zscale"))?;
        let grid = FORMAT.grid(Place::Line(line), [nx, ny], [dx, dy])?;
        let z_scale = FORMAT.positive(Place::Line(line), "Zscale", dz)?;
        Ok((grid, z_scale))
    }
}
