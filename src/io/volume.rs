//! Volumes in VTI files, written plane by plane.
//!
//! The arrays follow the XML as raw bytes (`AppendedData` of the
//! [format](https://docs.vtk.org/en/latest/vtk_file_formats/vtkxml_file_format.html)). The position of every plane is
//! therefore known in advance, and at most one plane is in memory.

use std::fmt::Write as _;
use std::fs::File;
use std::io::{BufWriter, Seek, SeekFrom, Write};
use std::path::Path;

use crate::error::Result;
use crate::files::PartialFile;
use crate::files::refused;
use crate::grid::Grid;

/// Points of a volume: the cell centres of a grid in equally spaced planes.
#[derive(Debug, Clone, Copy)]
pub(crate) struct VolumeShape {
    pub(crate) grid: Grid,
    /// Coordinate z of the lowest plane (a length).
    pub(crate) first: f64,
    /// Distance between planes (a length).
    pub(crate) step: f64,
    pub(crate) planes: usize,
}

/// Description of an array of a volume: the name of the array and the names of its components. An array without named
/// components is a scalar.
pub(crate) type Array = (&'static str, &'static [&'static str]);

/// Writer of the planes of a volume.
#[derive(Debug)]
pub(crate) struct PlaneValues<'a> {
    file: BufWriter<File>,
    path: &'a Path,
    /// Position of the first byte of each array, and number of values of the array per plane.
    places: Vec<(u64, u64)>,
}

impl PlaneValues<'_> {
    /// Writes the values of an array in a plane, point by point with x varying fastest.
    pub(crate) fn write(
        &mut self,
        plane: usize,
        array: usize,
        values: impl Iterator<Item = f64>,
    ) -> Result<()> {
        let (start, per_plane) = self.places[array];
        let place = SeekFrom::Start(start + 8 * per_plane * plane as u64);
        let file = &mut self.file;
        let written = file.seek(place).and_then(|_| {
            let mut values = values;
            values.try_for_each(|value| file.write_all(&value.to_le_bytes()))
        });
        written.map_err(|error| refused(self.path, error))
    }
}

/// Creates or replaces a VTI file of point data, whose planes `fill` writes in any order. If an error occurs, an
/// existing file remains unchanged.
pub(crate) fn write(
    path: &Path,
    shape: &VolumeShape,
    arrays: &[Array],
    fill: impl FnOnce(&mut PlaneValues<'_>) -> Result<()>,
) -> Result<()> {
    let part = PartialFile::beside(path)?;
    let mut volume = PlaneValues {
        file: BufWriter::new(part.open()?),
        path,
        places: Vec::new(),
    };
    let end = volume.begin(shape, arrays)?;
    fill(&mut volume)?;
    let PlaneValues { mut file, .. } = volume;
    let closed = file.seek(SeekFrom::Start(end)).and_then(|_| {
        file.write_all(b"\n  </AppendedData>\n</VTKFile>\n")?;
        file.into_inner()?.sync_all()
    });
    closed.map_err(|error| refused(path, error))?;
    part.take_name()
}

impl PlaneValues<'_> {
    /// Writes everything except the values, and returns the position of their end.
    fn begin(&mut self, shape: &VolumeShape, arrays: &[Array]) -> Result<u64> {
        let VolumeShape {
            grid,
            first,
            step,
            planes,
        } = *shape;
        let [x, y] = grid.position(0, 0);
        let (dx, dy) = (grid.dx(), grid.dy());
        let extent = format!("0 {} 0 {} 0 {}", grid.nx() - 1, grid.ny() - 1, planes - 1);
        let mut text = format!(
            r#"<?xml version="1.0"?>
<VTKFile type="ImageData" version="1.0" byte_order="LittleEndian" header_type="UInt64">
  <ImageData WholeExtent="{extent}" Origin="{x} {y} {first}" Spacing="{dx} {dy} {step}">
    <Piece Extent="{extent}">
      <PointData>
"#
        );
        // Each array is preceded by its number of bytes.
        let mut offset = 0;
        for (name, components) in arrays {
            let count = components.len().max(1);
            write!(
                text,
                r#"        <DataArray type="Float64" Name="{name}" NumberOfComponents="{count}""#
            )
            .and_then(|()| {
                let mut named = components.iter().enumerate();
                named.try_for_each(|(k, name)| write!(text, r#" ComponentName{k}="{name}""#))?;
                writeln!(text, r#" format="appended" offset="{offset}"/>"#)
            })
            .expect("writing to a string cannot fail");
            let per_plane = (count * grid.cells()) as u64;
            self.places.push((offset + 8, per_plane));
            offset += 8 + 8 * per_plane * planes as u64;
        }
        text.push_str("      </PointData>\n    </Piece>\n  </ImageData>\n");
        text.push_str("  <AppendedData encoding=\"raw\">\n   _");
        let start = text.len() as u64;
        let file = &mut self.file;
        let written = file.write_all(text.as_bytes()).and_then(|()| {
            self.places.iter_mut().try_for_each(|(place, per_plane)| {
                *place += start;
                file.seek(SeekFrom::Start(*place - 8))?;
                file.write_all(&(8 * *per_plane * planes as u64).to_le_bytes())
            })
        });
        written.map_err(|error| refused(self.path, error))?;
        Ok(start + offset)
    }
}
