//! X3P, the zipped XML format of ISO 25178-72 (previously ISO 5436-2). The module requires the feature `x3p`.
//!
//! Lengths are in metres. Rows are ordered towards larger y.
//!
//! Sources: ISO 25178-72:2017, Geometrical product specifications, Surface texture: Areal, Part 72: XML file format
//! x3p, and the schema of <https://sourceforge.net/projects/open-gps/>.

mod xml;
mod zip;

use std::path::Path;

use super::text::excerpt;
use super::{Place, parse_file};
use crate::error::{Error, Result};
use crate::files::Format;
use crate::files::{ByteOrder, NumberFormat};
use crate::grid::Grid;
use crate::grid::field::Field;
use zip::Archive;

const FORMAT: Format = Format("X3P");
const MAIN: &str = "main.xml";

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
/// The file must contain one layer on a regular grid without rotated axes. Samples are signed integers of 16 or 32 bits
/// (data types I and L) or floats of 32 or 64 bits (data types F and D). They are stored in a separate file or as text
/// in the list of data. Integers are multiplied by the increment of the z axis. Floats are not multiplied by the
/// increment, in agreement with openGPS, the library of the standard. The offset of the z axis is added to integers and
/// floats.
///
/// Missing points become NaN. A point is missing if it is NaN or infinite in the file, if it is empty in the list, or
/// if its bit in the file of valid points is cleared. The checksums of the archive are verified, but the MD5 checksums
/// of the format are not. An element without text counts as absent.
///
/// `main.xml` may be in a folder of the archive. Links to data are then relative to this folder. The archive may
/// contain stored and deflated files. Each file may expand to at most a hundred times its packed size or to 4 MiB,
/// whichever is larger.
///
/// # Errors
/// - [`Error::Format`], with the name of the file within the archive, if the bytes are not an X3P archive or if its
///   files contradict each other.
pub fn parse(bytes: &[u8]) -> Result<Field> {
    // The format itself is a zip archive.
    if !bytes.starts_with(b"PK") {
        FORMAT.check_compression(bytes)?;
    }
    let archive = Archive::new(bytes)?;
    let folder = archive.folder_of(MAIN)?;
    let main = Main::parse(&archive.read(&format!("{folder}{MAIN}"), None)?)?;
    let linked = |name: &str, size: usize| {
        let place = format!("{folder}{name}");
        let is_there = folder.is_empty() || archive.has(&place)?;
        archive.read(if is_there { &place } else { name }, Some(size))
    };
    let grid = main.grid()?;
    let mut samples = match (&main.data, main.list.is_empty()) {
        (Some(name), _) => {
            let number = required("Record1/Axes/CZ/DataType", main.number)?;
            let stored = linked(name, grid.cells() * number.size())?;
            number.decode(ByteOrder::LeastFirst, &stored)
        }
        (None, false) => main.list,
        (None, true) => {
            return Err(
                FORMAT.in_entry(MAIN, "the file contains no data, neither linked nor listed")
            );
        }
    };
    if samples.len() != grid.cells() {
        let (found, nx, ny) = (samples.len(), grid.nx(), grid.ny());
        let problem = format!("the file lists {found} samples, expected {nx} x {ny} points");
        return Err(FORMAT.in_entry(MAIN, problem));
    }
    let is_float = matches!(main.number, Some(NumberFormat::F32 | NumberFormat::F64));
    let increment = main.height_increment.filter(|_| !is_float).unwrap_or(1.0);
    let offset = main.height_offset.unwrap_or(0.0);
    for sample in &mut samples {
        *sample = if sample.is_finite() {
            *sample * increment + offset
        } else {
            f64::NAN
        };
    }
    if let Some(name) = &main.valid {
        let valid = linked(name, samples.len().div_ceil(8))?;
        for (index, sample) in samples.iter_mut().enumerate() {
            if valid[index / 8] >> (index % 8) & 1 == 0 {
                *sample = f64::NAN;
            }
        }
    }
    Field::from_vec(grid, samples)
}

/// Contents of `main.xml`.
#[derive(Debug, Default)]
struct Main {
    sizes: [Option<usize>; 2],
    increments: [Option<f64>; 2],
    number: Option<NumberFormat>,
    height_increment: Option<f64>,
    height_offset: Option<f64>,
    /// Name of the file of samples, or the samples themselves.
    data: Option<String>,
    list: Vec<f64>,
    /// Name of the file of valid points, with one bit per point.
    valid: Option<String>,
}

impl Main {
    fn parse(xml: &[u8]) -> Result<Self> {
        let mut main = Self::default();
        xml::elements(xml, |path, text| main.read(&Element { path, text }))?;
        Ok(main)
    }

    /// Reads one element.
    fn read(&mut self, element: &Element<'_>) -> Result<()> {
        match element.path {
            "Record3/DataList/Datum" if element.text.is_empty() => self.list.push(f64::NAN),
            _ if element.text.is_empty() => {}
            "Record1/FeatureType" => element.check_text("SUR")?,
            "Record1/Axes/CX/AxisType" | "Record1/Axes/CY/AxisType" => element.check_text("I")?,
            "Record1/Axes/CZ/AxisType" => element.check_text("A")?,
            "Record1/Axes/CX/Increment" => self.increments[0] = Some(element.real()?),
            "Record1/Axes/CY/Increment" => self.increments[1] = Some(element.real()?),
            "Record1/Axes/CZ/Increment" => self.height_increment = Some(element.positive()?),
            "Record1/Axes/CZ/Offset" => self.height_offset = Some(element.real()?),
            "Record1/Axes/CZ/DataType" => self.number = Some(element.data_type()?),
            "Record1/Axes/Rotation/r11"
            | "Record1/Axes/Rotation/r22"
            | "Record1/Axes/Rotation/r33" => element.expect_near(1.0)?,
            path if path.starts_with("Record1/Axes/Rotation/r") => element.expect_near(0.0)?,
            "Record3/MatrixDimension/SizeX" => self.sizes[0] = Some(element.count()?),
            "Record3/MatrixDimension/SizeY" => self.sizes[1] = Some(element.count()?),
            "Record3/MatrixDimension/SizeZ" => element.check_text("1")?,
            "Record3/DataLink/PointDataLink" => self.data = Some(element.text.to_owned()),
            "Record3/DataLink/ValidPointsLink" => self.valid = Some(element.text.to_owned()),
            "Record3/DataList/Datum" => self.list.push(element.number()?),
            _ => {}
        }
        Ok(())
    }

    fn grid(&self) -> Result<Grid> {
        let size = [
            required("Record3/MatrixDimension/SizeX", self.sizes[0])?,
            required("Record3/MatrixDimension/SizeY", self.sizes[1])?,
        ];
        let sides = [
            required("Record1/Axes/CX/Increment", self.increments[0])?,
            required("Record1/Axes/CY/Increment", self.increments[1])?,
        ];
        FORMAT.grid(Place::Entry(MAIN.into()), size, sides)
    }
}

/// Returns the value of an element, or an error if it is missing.
fn required<T>(path: &str, value: Option<T>) -> Result<T> {
    value.ok_or_else(|| FORMAT.in_entry(MAIN, format!("the element {path} is missing")))
}

/// Element of `main.xml`.
#[derive(Debug)]
struct Element<'a> {
    path: &'a str,
    text: &'a str,
}

impl Element<'_> {
    fn refused(&self, problem: &str) -> Error {
        let problem = format!("{} is {}, but {problem}", self.path, excerpt(self.text));
        FORMAT.in_entry(MAIN, problem)
    }

    fn check_text(&self, supported: &str) -> Result<()> {
        if self.text == supported {
            Ok(())
        } else {
            Err(self.refused(&format!("only {supported} is supported")))
        }
    }

    /// Returns an error if an entry of the rotation matrix differs from the same entry of the identity matrix.
    fn expect_near(&self, entry: f64) -> Result<()> {
        if (self.real()? - entry).abs() < 1e-9 {
            Ok(())
        } else {
            Err(self.refused("rotated axes are not supported"))
        }
    }

    fn count(&self) -> Result<usize> {
        let count = self.text.parse();
        count.map_err(|_| self.refused("must be a whole number of points"))
    }

    /// Parses a number. NaN and infinities are accepted.
    fn number(&self) -> Result<f64> {
        let number = self.text.parse();
        number.map_err(|_| self.refused("must be a number"))
    }

    fn real(&self) -> Result<f64> {
        let number = self.number()?;
        if number.is_finite() {
            Ok(number)
        } else {
            Err(self.refused("must be finite"))
        }
    }

    fn positive(&self) -> Result<f64> {
        let number = self.real()?;
        if number > 0.0 {
            Ok(number)
        } else {
            Err(self.refused("must be positive"))
        }
    }

    fn data_type(&self) -> Result<NumberFormat> {
        match self.text {
            "I" => Ok(NumberFormat::I16),
            "L" => Ok(NumberFormat::I32),
            "F" => Ok(NumberFormat::F32),
            "D" => Ok(NumberFormat::F64),
            _ => Err(self.refused("must be I, L, F or D")),
        }
    }
}
