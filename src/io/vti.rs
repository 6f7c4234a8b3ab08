//! VTI, the image data of VTK, for ParaView and related programs.
//!
//! Source: the file formats of VTK,
//! <https://docs.vtk.org/en/latest/vtk_file_formats/vtkxml_file_format.html>.

use std::fmt::Write;
use std::path::Path;

use super::{Format, write_bytes};
use crate::error::Result;
use crate::field::Field;

const FORMAT: Format = Format("VTI");

/// Writes named fields of one grid to a file, as [`to_bytes`].
///
/// # Errors
/// As [`to_bytes`]; [`Error::File`](crate::Error::File) if the file cannot be written.
#[doc(alias = "paraview")]
#[doc(alias = "ParaView")]
pub fn write(path: impl AsRef<Path>, fields: &[(&str, &Field)]) -> Result<()> {
    write_bytes(path.as_ref(), &to_bytes(fields)?)
}

/// Named fields on one grid as a file: one array of cell data each, in doubles that keep every bit,
/// on a flat image in the plane `z = 0` whose origin is the corner of least x and y.
///
/// # Errors
/// [`Error::Format`](crate::Error::Format) if there is no field, or if a field is on another grid than the
/// first, or has a name that is already taken, is empty or holds control characters.
///
/// ```
/// use stickslip::{Field, Grid, io::vti};
/// let field = Field::zeros(Grid::new(2, 3, 1.0, 1.0)?);
/// let file = vti::to_bytes(&[("pressure", &field)])?;
/// let text = String::from_utf8_lossy(&file);
/// assert!(text.contains("<ImageData WholeExtent=\"0 2 0 3 0 0\" Origin=\"-1 -1.5 0\""));
/// # Ok::<(), stickslip::Error>(())
/// ```
pub fn to_bytes(fields: &[(&str, &Field)]) -> Result<Vec<u8>> {
    let Some((_, first)) = fields.first() else {
        return Err(FORMAT.in_entry("CellData", "there is no field to write"));
    };
    let grid = first.grid();
    for (index, (name, field)) in fields.iter().enumerate() {
        let problem = if !grid.agrees_with(field.grid()) {
            "the field is on another grid than the first"
        } else if name.is_empty() || name.contains(char::is_control) {
            "the name is empty or holds control characters"
        } else if fields[..index].iter().any(|(other, _)| other == name) {
            "the name is given twice"
        } else {
            continue;
        };
        return Err(FORMAT.in_entry(name, problem));
    }

    let (nx, ny, dx, dy) = (grid.nx(), grid.ny(), grid.dx(), grid.dy());
    let corner = [-0.5 * nx as f64 * dx, -0.5 * ny as f64 * dy];
    let mut text = format!(
        r#"<?xml version="1.0"?>
<VTKFile type="ImageData" version="1.0" byte_order="LittleEndian" header_type="UInt64">
  <ImageData WholeExtent="0 {nx} 0 {ny} 0 0" Origin="{} {} 0" Spacing="{dx} {dy} 1">
    <Piece Extent="0 {nx} 0 {ny} 0 0">
      <CellData>
"#,
        corner[0], corner[1]
    );
    for (name, field) in fields {
        let name = escape(name);
        write!(
            text,
            r#"        <DataArray type="Float64" Name="{name}" format="binary">"#
        )
        .expect("writing to a string cannot fail");
        push_base64(&mut text, field.as_slice());
        text.push_str("</DataArray>\n");
    }
    text.push_str("      </CellData>\n    </Piece>\n  </ImageData>\n</VTKFile>\n");
    Ok(text.into_bytes())
}

/// A text as the value of an attribute.
fn escape(text: &str) -> String {
    let text = text.replace('&', "&amp;").replace('<', "&lt;");
    text.replace('>', "&gt;").replace('"', "&quot;")
}

/// The number of bytes and the samples, three bytes in four characters (RFC 4648).
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
