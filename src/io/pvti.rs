//! PVTI, a VTK image in pieces. Every rank writes its own piece.
//!
//! Source: the file formats of VTK,
//! <https://docs.vtk.org/en/latest/vtk_file_formats/vtkxml_file_format.html>.

use std::fmt::Write as _;
use std::io::{ErrorKind, Write as _};
use std::ops::Range;
use std::path::Path;

use super::vti::{Array, check, escape, extent, piece, place};
use crate::error::Result;
use crate::files::{Format, refused};
use crate::files::{PartialFile, replace_bytes};
use crate::grid::Grid;
use crate::parallel::ranks::RankGroup;
use crate::parallel::ranks::partition::RowPartition;

const FORMAT: Format = Format("PVTI");

/// Writes named distributed arrays. Every rank with rows writes its piece. The first rank writes the list of the
/// pieces.
pub(crate) fn write(
    path: &Path,
    slab: Grid,
    arrays: &[(&str, Array<'_>)],
    share: Option<&RowPartition>,
) -> Result<()> {
    let team = share.map(|share| &**share.team());
    let rank = team.map_or(0, RankGroup::rank);
    let of_first = |work: &dyn Fn() -> Result<()>| if rank == 0 { work() } else { Ok(()) };
    let name = name(path).and_then(|name| {
        slab.check_equal("an array to be written", check(arrays)?)?;
        Ok(name)
    });
    let name = RankGroup::agreed_of(team, name)?;

    let own = path.with_file_name(piece_of(name, rank));
    let part = if slab.ny() > 0 {
        written(&own, &piece(arrays, slab)).map(Some)
    } else {
        Ok(None)
    };
    let part = RankGroup::agreed_of(team, part)?;
    // An earlier list is removed first. Otherwise it would refer to a mixture of old and new pieces while the pieces
    // are renamed.
    RankGroup::agreed_of(team, of_first(&|| removed(path)))?;
    RankGroup::agreed_of(team, part.map_or(Ok(()), |part| part.take_name()))?;

    let rows = match share {
        Some(share) => (0..share.team().size())
            .map(|rank| share.rows_of(rank))
            .collect(),
        None => vec![slab.rows()],
    };
    let list = list(slab.whole(), arrays, name, &rows);
    RankGroup::agreed_of(team, of_first(&|| replace_bytes(path, list.as_bytes())))
}

/// Returns the name of a list without its extension.
fn name(path: &Path) -> Result<&str> {
    let name = path.file_stem().and_then(|name| name.to_str());
    name.ok_or_else(|| {
        let problem = "the path has no file name in UTF-8";
        FORMAT.in_entry(&path.display().to_string(), problem)
    })
}

/// Returns the file name of the piece of a rank.
fn piece_of(name: &str, rank: usize) -> String {
    format!("{name}_{rank}.vti")
}

/// Writes a temporary file, which the caller renames later.
fn written<'a>(path: &'a Path, bytes: &[u8]) -> Result<PartialFile<'a>> {
    let part = PartialFile::beside(path)?;
    part.write(|file| file.write_all(bytes))?;
    Ok(part)
}

/// Removes a file if it exists.
fn removed(path: &Path) -> Result<()> {
    match std::fs::remove_file(path) {
        Err(error) if error.kind() != ErrorKind::NotFound => Err(refused(path, error)),
        _ => Ok(()),
    }
}

/// Returns the list of the pieces of a grid. `rows` are the rows of each rank.
fn list(grid: Grid, arrays: &[(&str, Array<'_>)], name: &str, rows: &[Range<usize>]) -> String {
    let (whole, place) = (extent(grid.nx(), &grid.rows()), place(grid));
    let mut text = format!(
        r#"<?xml version="1.0"?>
<VTKFile type="PImageData" version="1.0" byte_order="LittleEndian" header_type="UInt64">
  <PImageData WholeExtent="{whole}" GhostLevel="0" {place}>
    <PCellData>
"#
    );
    for (name, array) in arrays {
        let (name, components) = (escape(name), array.attribute());
        writeln!(
            text,
            r#"      <PDataArray type="Float64" Name="{name}"{components}/>"#
        )
        .expect("writing to a string cannot fail");
    }
    text.push_str("    </PCellData>\n");
    for (rank, rows) in rows.iter().enumerate().filter(|(_, rows)| !rows.is_empty()) {
        let (extent, file) = (extent(grid.nx(), rows), escape(&piece_of(name, rank)));
        writeln!(text, r#"    <Piece Extent="{extent}" Source="{file}"/>"#)
            .expect("writing to a string cannot fail");
    }
    text.push_str("  </PImageData>\n</VTKFile>\n");
    text
}
