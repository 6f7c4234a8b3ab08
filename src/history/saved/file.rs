//! File of a history: the bytes of its state, or a table followed by the slabs of all ranks.
//!
//! | bytes | content |
//! |---|---|
//! | 8 | `\x93STKSLAB` |
//! | 4 | version of the table |
//! | 8 | number of slabs |
//! | 8 each | numbers of bytes of the slabs |
//! | | the slabs, each a saved state |
//!
//! Numbers are little-endian.

use std::fs::File;
use std::io::{Read, Result as IoResult, Seek, SeekFrom, Write};
use std::ops::Range;
use std::path::Path;

use super::format::SnapshotHeader;
use super::{FORMAT, HEADER, Reader, check_kind, other_version};
use crate::error::Result;
use crate::files::{Cursor, in_file, refused, replace, replace_bytes};
use crate::half_space::HalfSpace;
use crate::history::History;
use crate::history::state::State;

const MAGIC: &[u8; 8] = b"\x93STKSLAB";
const VERSION: u32 = 1;
/// Number of bytes of magic, version and number of slabs.
const TABLE: usize = 20;
/// Number of bytes at the start of a slab that contain its range of rows.
const BEGINNING: u64 = 256;

impl History {
    /// Saves the [state](History::state) in a file. An existing file is replaced as a whole or not at all. If the
    /// program is interrupted or the disk is full, the previous file is kept. The bytes are on the disk when the
    /// function returns.
    ///
    /// For distributed bodies the call is collective, and all ranks pass the path of the same file. Each rank writes
    /// its slab, and the file receives its name when every rank has finished. Until then the name of the file is
    /// `NAME.PID.NUMBER.part` in the same directory, as with [`HalfSpace::write_npy`]. [`History::load`] reads the file
    /// on any number of ranks, or for bodies that are not distributed.
    ///
    /// ```
    /// use std::sync::Arc;
    /// use std::time::Duration;
    /// use stickslip::{*, ranks::Threads};
    /// # let path = std::env::temp_dir().join(format!("stickslip_history_{}.state", std::process::id()));
    /// let grid = Grid::square(32, 8.0)?;
    /// let pair = ElasticPair::new(Material::new(1.0, 0.5)?, Material::rigid())?;
    /// let outcomes = Threads::run(3, Duration::from_secs(60), |rank| -> stickslip::Result<[f64; 2]> {
    ///     let bodies = HalfSpace::distributed(grid, pair, Boundary::NonPeriodic, Arc::new(rank))?;
    ///     let ball = surface::sphere(bodies.grid(), 10.0)?;
    ///     let mut history = History::builder(&bodies, &ball, Friction::coulomb(0.3)?).build()?;
    ///     history.step(&LoadStep::hold().normal(NormalLoad::Force(0.5)))?;
    ///     history.save(&path)?;
    ///     Ok(history.step(&LoadStep::force([0.1, 0.0]))?.shift())
    /// });
    /// // One process loads the file that three ranks have saved.
    /// let mut history = History::load(&HalfSpace::new(grid, pair)?, &path)?;
    /// let shift = history.step(&LoadStep::force([0.1, 0.0]))?.shift();
    /// for outcome in outcomes {
    ///     assert_eq!(outcome?, shift);
    /// }
    /// # std::fs::remove_file(path).ok();
    /// # Ok::<(), Error>(())
    /// ```
    ///
    /// # Errors
    /// - [`Error::File`](crate::Error::File) if the file cannot be written.
    /// - [`Error::Memory`](crate::Error::Memory) if memory runs out.
    /// - [`Error::Ranks`](crate::Error::Ranks) if another rank has failed.
    #[doc(alias = "checkpoint")]
    pub fn save(&self, path: impl AsRef<Path>) -> Result<()> {
        let path = path.as_ref();
        let bytes = self.bodies.collective_result(self.state().try_to_bytes())?;
        let Some(team) = self.bodies.team() else {
            return replace_bytes(path, &bytes);
        };
        let Some(lengths) = team.gather(&[bytes.len() as u64], &vec![1; team.size()]) else {
            return team.check();
        };
        let table = table_of(&lengths);
        let before: u64 = lengths[..team.rank()].iter().sum();
        replace(path, Some(team), |file| {
            if team.rank() == 0 {
                file.write_all(&table)?;
            }
            file.seek(SeekFrom::Start(table.len() as u64 + before))?;
            file.write_all(&bytes)
        })
    }

    /// Creates a history from a file of [`History::save`], on the bodies that the file belongs to. The history
    /// continues with bitwise identical results ([limits on other
    /// machines](crate::guide::embedding#restart)). The number of ranks may differ from the number of ranks that
    /// [saved](History::save) the file. A single process without ranks may also save or load the file. The call is
    /// collective: each rank reads the slabs that contain its local rows.
    ///
    /// # Errors
    /// - [`Error::File`](crate::Error::File) if the file cannot be read.
    /// - Errors of [`History::from_bytes`].
    /// - Errors of [`State::from_slabs`] for a file of slabs.
    pub fn load(bodies: &HalfSpace, path: impl AsRef<Path>) -> Result<Self> {
        let path = path.as_ref();
        let parts = bodies.collective_result(parts_of(path))?;
        let state = match &parts[..] {
            [part] if !bodies.is_shared() => state_in(path, part)?,
            _ => State::from_slabs(bodies, local_slabs(path, &parts, &bodies.grid().rows()))?,
        };
        Self::from_state(bodies, state)
    }
}

/// Returns the table in front of slabs with these numbers of bytes.
fn table_of(lengths: &[u64]) -> Vec<u8> {
    let mut table = MAGIC.to_vec();
    table.extend(VERSION.to_le_bytes());
    table.extend((lengths.len() as u64).to_le_bytes());
    table.extend(lengths.iter().flat_map(|length| length.to_le_bytes()));
    table
}

/// Returns the first slab of a file and the slabs with local rows. The first slab contains the values that all slabs
/// have in common.
fn local_slabs<'a>(
    path: &'a Path,
    parts: &'a [Range<u64>],
    held: &'a Range<usize>,
) -> impl Iterator<Item = Result<State>> + 'a {
    parts.iter().enumerate().filter_map(move |(number, part)| {
        let is_of_use = number == 0
            || match rows_in(path, part) {
                Ok(rows) => rows.start < held.end && held.start < rows.end,
                Err(error) => return Some(Err(error)),
            };
        is_of_use.then(|| state_in(path, part))
    })
}

/// Returns the byte ranges of the slabs in a file. For a file with a single state, this is the range of the whole file.
fn parts_of(path: &Path) -> Result<Vec<Range<u64>>> {
    let about = std::fs::metadata(path).map_err(|error| refused(path, error))?;
    let length = about.len();
    let start = bytes_in(path, &(0..length.min(TABLE as u64)))?;
    if !start.starts_with(MAGIC) {
        let all = 0..length;
        return Ok(vec![all]);
    }
    let parts = || {
        let mut start = Cursor::new(FORMAT, &start);
        start.take("the magic string", MAGIC.len())?;
        let version = start.u32("the version")?;
        if version != VERSION {
            return Err(other_version(version, VERSION));
        }
        let count = start.u64("the number of slabs")?;
        let end = count.saturating_mul(8).saturating_add(TABLE as u64);
        let table = bytes_in(path, &(TABLE as u64..end.min(length)))?;
        let mut table = Cursor::new(FORMAT, &table);
        let (mut parts, mut first) = (Vec::new(), end);
        for _ in 0..count {
            let next = first.saturating_add(table.u64("the table of slabs")?);
            parts.push(first..next);
            first = next;
        }
        if first == length {
            return Ok(parts);
        }
        let problem = format!("the file has {length} bytes, expected {first}");
        Err(FORMAT.at_byte(TABLE, problem))
    };
    parts().map_err(|error| in_file(path, error))
}

/// Reads the state in a range of bytes of a file.
fn state_in(path: &Path, part: &Range<u64>) -> Result<State> {
    let bytes = bytes_in(path, part)?;
    State::from_bytes(&bytes).map_err(|error| in_file(path, error))
}

/// Reads the range of rows of the state in a range of bytes of a file.
fn rows_in(path: &Path, part: &Range<u64>) -> Result<Range<usize>> {
    let beginning = bytes_in(path, &(part.start..part.end.min(part.start + BEGINNING)))?;
    let rows = || {
        let mut start = Cursor::new(FORMAT, &beginning);
        check_kind(&mut start)?;
        start.take("the length", HEADER - start.position())?;
        let mut host = SnapshotHeader::default();
        host.visit(&mut Reader(start))?;
        Ok(host.rows())
    };
    rows().map_err(|error| in_file(path, error))
}

/// Reads a range of bytes of a file, or fewer bytes if the file ends earlier.
fn bytes_in(path: &Path, part: &Range<u64>) -> Result<Vec<u8>> {
    let read = || -> IoResult<Vec<u8>> {
        let mut bytes = Vec::new();
        let mut file = File::open(path)?;
        file.seek(SeekFrom::Start(part.start))?;
        file.take(part.end - part.start).read_to_end(&mut bytes)?;
        Ok(bytes)
    };
    read().map_err(|error| refused(path, error))
}
