//! VTI, the image data of VTK, for ParaView and related programs.
//!
//! Source: the file formats of VTK,
//! <https://docs.vtk.org/en/latest/vtk_file_formats/vtkxml_file_format.html>.

use std::fmt::Write;
use std::ops::Range;
use std::path::Path;

use super::write_bytes;
use crate::error::Result;
use crate::files::Format;
use crate::grid::Grid;
use crate::grid::field::Field;

const FORMAT: Format = Format("VTI");

/// Array to be written under a name: a field, or a vector of two fields along x and y.
///
/// ParaView can draw vectors as arrows. The third component of a vector is zero.
#[derive(Debug, Clone, Copy)]
#[non_exhaustive]
pub enum Array<'a> {
    /// One value per cell.
    Scalar(&'a Field),
    /// Components along x and y.
    Vector([&'a Field; 2]),
}

impl<'a> From<&'a Field> for Array<'a> {
    fn from(field: &'a Field) -> Self {
        Self::Scalar(field)
    }
}

impl<'a> From<[&'a Field; 2]> for Array<'a> {
    fn from(fields: [&'a Field; 2]) -> Self {
        Self::Vector(fields)
    }
}

impl<'a> Array<'a> {
    fn fields(&self) -> &[&'a Field] {
        match self {
            Self::Scalar(field) => std::slice::from_ref(field),
            Self::Vector(fields) => fields,
        }
    }

    /// Returns the XML attribute that describes the components.
    pub(super) fn attribute(&self) -> &'static str {
        match self {
            Self::Scalar(_) => "",
            Self::Vector(_) => r#" NumberOfComponents="3""#,
        }
    }

    /// Returns the samples in the order of the file.
    fn samples(&self) -> Vec<f64> {
        match self {
            Self::Scalar(field) => field.as_slice().to_vec(),
            Self::Vector([x, y]) => {
                let cells = x.as_slice().iter().zip(y.as_slice());
                cells.flat_map(|(x, y)| [*x, *y, 0.0]).collect()
            }
        }
    }
}

/// Writes named fields and vectors of one grid to a file in the form of [`to_bytes`].
///
/// # Errors
/// - The errors of [`to_bytes`].
/// - [`Error::File`](crate::Error::File) if the file cannot be written.
#[doc(alias = "paraview")]
#[doc(alias = "ParaView")]
pub fn write<'a>(
    path: impl AsRef<Path>,
    fields: &[(&str, impl Into<Array<'a>> + Copy)],
) -> Result<()> {
    write_bytes(path.as_ref(), &to_bytes(fields)?)
}

/// Returns the bytes of a file with named fields and vectors on one grid. Each field or vector is an array of cell
/// data, stored exactly as doubles. The image is flat and lies in the plane `z = 0`. Its origin is the corner with the
/// smallest x and y.
///
/// Fields on a slab form an image of its rows only, at their position in the whole grid. As required for the pieces of
/// an image, the origin is the corner of the whole grid. The extent along y counts the rows of the whole grid
/// ([`Grid::rows`]).
///
/// # Errors
/// - [`Error::Format`](crate::Error::Format) if there is no field or if a field is on a different grid from the first.
/// - [`Error::Format`](crate::Error::Format) if a name is empty, occurs twice or contains control characters.
///
/// ```
/// use stickslip::{Field, Grid, io::vti};
/// let field = Field::zeros(Grid::new(2, 3, 1.0, 1.0)?);
/// let traction = [&field, &field];
/// let file = vti::to_bytes(&[("pressure", vti::Array::from(&field)), ("traction", traction.into())])?;
/// let text = String::from_utf8_lossy(&file);
/// assert!(text.contains("<ImageData WholeExtent=\"0 2 0 3 0 0\" Origin=\"-1 -1.5 0\""));
/// # Ok::<(), stickslip::Error>(())
/// ```
pub fn to_bytes<'a>(fields: &[(&str, impl Into<Array<'a>> + Copy)]) -> Result<Vec<u8>> {
    let arrays = named(fields);
    let grid = check(&arrays)?;
    Ok(piece(&arrays, grid))
}

/// Converts named fields and vectors to arrays.
pub(crate) fn named<'n, 'a>(
    fields: &[(&'n str, impl Into<Array<'a>> + Copy)],
) -> Vec<(&'n str, Array<'a>)> {
    let arrays = fields.iter().map(|&(name, array)| (name, array.into()));
    arrays.collect()
}

/// Returns the grid of all arrays, or an error if they cannot be written.
pub(super) fn check(arrays: &[(&str, Array<'_>)]) -> Result<Grid> {
    let Some((_, first)) = arrays.first() else {
        return Err(FORMAT.in_entry("CellData", "give at least one field to write"));
    };
    let grid = first.fields()[0].grid();
    for (index, (name, array)) in arrays.iter().enumerate() {
        let agrees = |field: &&Field| grid.agrees_with(field.grid());
        let problem = if !array.fields().iter().all(agrees) {
            "the field is not on the grid of the first field"
        } else if name.is_empty() || name.contains(char::is_control) {
            "the name must not be empty or contain control characters"
        } else if arrays[..index].iter().any(|(other, _)| other == name) {
            "the name is given twice: give each field a different name"
        } else {
            continue;
        };
        return Err(FORMAT.in_entry(name, problem));
    }
    Ok(grid)
}

/// Returns the extent of a range of rows of an image, in numbers of points.
pub(super) fn extent(nx: usize, rows: &Range<usize>) -> String {
    format!("0 {nx} {} {} 0 0", rows.start, rows.end)
}

/// Returns the attributes for the origin of an image and the sides of its cells.
pub(super) fn place(grid: Grid) -> String {
    let (nx, ny, dx, dy) = (grid.nx(), grid.whole().ny(), grid.dx(), grid.dy());
    let corner = [-0.5 * nx as f64 * dx, -0.5 * ny as f64 * dy];
    format!(
        r#"Origin="{} {} 0" Spacing="{dx} {dy} 1""#,
        corner[0], corner[1]
    )
}

/// Returns the bytes of a file with arrays on a grid, or on a slab at its position in the whole grid.
pub(super) fn piece(arrays: &[(&str, Array<'_>)], grid: Grid) -> Vec<u8> {
    let (extent, place) = (extent(grid.nx(), &grid.rows()), place(grid));
    let mut text = format!(
        r#"<?xml version="1.0"?>
<VTKFile type="ImageData" version="1.0" byte_order="LittleEndian" header_type="UInt64">
  <ImageData WholeExtent="{extent}" {place}>
    <Piece Extent="{extent}">
      <CellData>
"#
    );
    for (name, array) in arrays {
        let (name, components) = (escape(name), array.attribute());
        write!(
            text,
            r#"        <DataArray type="Float64" Name="{name}"{components} format="binary">"#
        )
        .expect("writing to a string cannot fail");
        push_base64(&mut text, &array.samples());
        text.push_str("</DataArray>\n");
    }
    text.push_str("      </CellData>\n    </Piece>\n  </ImageData>\n</VTKFile>\n");
    text.into_bytes()
}

/// Escapes a text for use as the value of an attribute.
pub(super) fn escape(text: &str) -> String {
    let text = text.replace('&', "&amp;").replace('<', "&lt;");
    text.replace('>', "&gt;").replace('"', "&quot;")
}

/// Appends the number of bytes and the samples in base64, three bytes in four characters (RFC 4648).
fn push_base64(text: &mut String, samples: &[f64]) {
    const DIGITS: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    let mut bytes = Vec::with_capacity(8 * (samples.len() + 1));
    bytes.extend((8 * samples.len() as u64).to_le_bytes());
    bytes.extend(samples.iter().flat_map(|sample| sample.to_le_bytes()));
    text.reserve(bytes.len().div_ceil(3) * 4);
    for three in bytes.chunks(3) {
        let at = |index| u32::from(three.get(index).copied().unwrap_or(0));
        let bits = at(0) << 16 | at(1) << 8 | at(2);
        for digit in 0..4 {
            text.push(if digit <= three.len() {
                char::from(DIGITS[(bits >> (18 - 6 * digit)) as usize & 63])
            } else {
                '='
            });
        }
    }
}
