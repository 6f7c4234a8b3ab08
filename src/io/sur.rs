//! SUR, the surface file of Digital Surf (`MountainsMap`), in its uncompressed form.
//!
//! Heights and cell sides are returned in metres. The file stores them in single precision and in its own units. Lines
//! are ordered towards larger y.
//!
//! Gwyddion, `SurfaceTopography`, surfalize and `RosettaSciIO` read the same layout. Their results differ in a constant
//! added to all heights, which does not affect the contact. This module adds the offset given in the file.

use std::path::Path;

use super::text::excerpt;
use super::{Place, parse_file};
use crate::error::Result;
use crate::files::Format;
use crate::files::{ByteOrder, Cursor, NumberFormat};
use crate::grid::field::Field;

const FORMAT: Format = Format("SUR");
const MAGIC: &[u8; 12] = b"DIGITAL SURF";
const COMPRESSED: &[u8; 12] = b"DSCOMPRESSED";

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
/// The file must contain a single surface or profile that is neither inverted nor mirrored. Its points must have 16 or
/// 32 bits. Units range from the picometre to the metre. Points marked in the file as not measured are NaN.
///
/// # Errors
/// - [`Error::Format`](crate::Error::Format) if the bytes are not a SUR file, if there are fewer bytes than the sizes
///   in the file require, or if the file is compressed (`DSCOMPRESSED`). The remedy for a compressed file is to save it
///   uncompressed.
pub fn parse(bytes: &[u8]) -> Result<Field> {
    FORMAT.check_compression(bytes)?;
    let mut bytes = Cursor::new(FORMAT, bytes);
    let magic = bytes.take("the magic string", MAGIC.len())?;
    if magic == COMPRESSED {
        return Err(FORMAT.at_byte(
            0,
            "compressed files are not supported: save the file uncompressed",
        ));
    }
    if magic != MAGIC {
        return Err(FORMAT.at_byte(0, "the file does not start with DIGITAL SURF"));
    }
    expect(&mut bytes, "byte order", &[0])?;
    expect(&mut bytes, "number of objects", &[0, 1])?;
    expect(&mut bytes, "version", &[1])?;
    expect(&mut bytes, "kind of object", &[1, 2])?;
    bytes.take("names and acquisition", 66)?;
    let has_missing = expect(&mut bytes, "flag of missing points", &[0, 1])? == 1;
    bytes.take("resolution of the gauge", 10)?;
    let bits = expect(&mut bytes, "bits per point", &[16, 32])?;
    let least = bytes.i32("the smallest sample")?;
    bytes.take("the largest sample", 4)?;

    let start = bytes.position();
    let counts = [
        bytes.u32("the points per line")?,
        bytes.u32("the number of lines")?,
    ];
    let total = bytes.u32("the number of points")?;
    if counts[0].checked_mul(counts[1]) != Some(total) {
        let problem = format!(
            "the header states {} x {} points, but a total of {total} points",
            counts[0], counts[1]
        );
        return Err(FORMAT.at_byte(start, problem));
    }
    let steps_start = bytes.position();
    let [dx, dy, dz] = [
        f64::from(bytes.f32("the spacing along x")?),
        f64::from(bytes.f32("the spacing along y")?),
        f64::from(bytes.f32("the spacing along z")?),
    ];
    bytes.take("the names of the axes", 48)?;
    let unit_x = metres(&mut bytes)?;
    let unit_y = metres(&mut bytes)?;
    let unit_z = metres(&mut bytes)?;
    let place = Place::Byte(steps_start as u64 + 8);
    FORMAT.positive(place, "spacing along z", dz)?;
    let size = counts.map(|count| count as usize);
    let place = Place::Byte(steps_start as u64);
    let grid = FORMAT.grid(place, size, [dx * unit_x, dy * unit_y])?;

    bytes.take("units of length and their ratios", 60)?;
    bytes.take("imprint", 2)?;
    expect(&mut bytes, "inversion", &[0])?;
    bytes.take("levelling and dates", 42)?;
    let comment = bytes.u16("the length of the comment")?;
    let private = bytes.u16("the length of the private zone")?;
    bytes.take("client zone and offsets", 136)?;
    let offset_start = bytes.position();
    let offset = f64::from(bytes.f32("the offset along z")?);
    if !offset.is_finite() {
        let problem = format!("the offset along z must be finite, got {offset}");
        return Err(FORMAT.at_byte(offset_start, problem));
    }
    bytes.take("the end of the header", 34)?;
    bytes.take("the comment", comment.into())?;
    bytes.take("the private zone", private.into())?;

    let number = if bits == 16 {
        NumberFormat::I16
    } else {
        NumberFormat::I32
    };
    let stored = bytes.take("the samples", grid.cells() * number.size())?;
    let mut samples = number.decode(ByteOrder::LeastFirst, stored);
    let missing = f64::from(least) - 2.0;
    for sample in &mut samples {
        // Both values are integers.
        *sample = if has_missing && (*sample - missing).abs() < 0.5 {
            f64::NAN
        } else {
            (*sample * dz + offset) * unit_z
        };
    }
    Field::from_vec(grid, samples)
}

/// Returns whether the first bytes identify a SUR file, compressed or not.
pub(super) fn is_sur(bytes: &[u8]) -> bool {
    bytes.starts_with(MAGIC) || bytes.starts_with(COMPRESSED)
}

/// Reads the next number of the header. Returns an error if its value is not supported.
fn expect(bytes: &mut Cursor<'_>, what: &str, supported: &[u16]) -> Result<u16> {
    let start = bytes.position();
    let value = bytes.u16(what)?;
    if supported.contains(&value) {
        Ok(value)
    } else {
        Err(FORMAT.at_byte(start, format!("{what} {value} is not supported")))
    }
}

/// Returns the length in metres of the unit named in the next 16 bytes.
fn metres(bytes: &mut Cursor<'_>) -> Result<f64> {
    let start = bytes.position();
    let stored = bytes.take("a unit", 16)?;
    let name = stored.split(|&byte| byte == 0).next().unwrap_or_default();
    match name.trim_ascii() {
        b"m" => Ok(1.0),
        b"dm" => Ok(1e-1),
        b"cm" => Ok(1e-2),
        b"mm" => Ok(1e-3),
        // The prefix of the micrometre is the micro sign in Latin-1, in UTF-8 or in an old DOS code page, the letter
        // mu, or u.
        b"\xb5m" | b"\xc2\xb5m" | b"\xce\xbcm" | b"\xe6m" | b"um" => Ok(1e-6),
        b"nm" => Ok(1e-9),
        b"pm" => Ok(1e-12),
        other => {
            let unit = excerpt(&String::from_utf8_lossy(other));
            Err(FORMAT.at_byte(
                start,
                format!("{unit} is not a unit of length from pm to m"),
            ))
        }
    }
}
