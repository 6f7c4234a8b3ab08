//! Serialisation of a history, from which it can be continued later.
//!
//! | bytes | content |
//! |---|---|
//! | 8 | `\x93STKSLIP` |
//! | 4 | version of the format |
//! | 8 | number of all bytes |
//! | | bodies, then the numbers of the state in the order of its `visit` |
//! | | values of the cells, one quantity after the other in the order of its `cell_quantities` |
//! | 1 each | zones of the cells |
//! | 8 | FNV-1a checksum of all preceding bytes |
//!
//! Numbers are little-endian. Counts are integers of 8 bytes, and samples are doubles.
//!
//! A minor series of the crate reads all files that earlier versions of the series have written. `tests/data/saved` contains
//! a file of each kind for each version of the format. A change of the format increases the version. Within a minor series
//! the reader then keeps the code for the earlier version.

mod cells;
mod codec;
mod file;
mod format;
mod slabs;

use crate::error::{Error, Result};
use crate::files::{Cursor, Format};
use crate::half_space::HalfSpace;
use crate::history::History;
use crate::history::state::State;
use crate::memory::fallible::unwrap_or_abort;
use crate::support::checksum;

use codec::{Reader, Writer};
use format::SnapshotHeader;

const FORMAT: Format = Format("saved history");
const MAGIC: &[u8; 8] = b"\x93STKSLIP";
const VERSION: u32 = 1;
/// Number of bytes of magic, version and length. `SUM` is the number of bytes of the checksum at the end.
const HEADER: usize = 20;
const SUM: usize = 8;

impl State {
    /// Returns the state as bytes, from which [`State::from_bytes`] restores it.
    ///
    /// # Memory
    /// | part | bytes, scalar model | bytes, vector model |
    /// |---|---|---|
    /// | each cell of the grid | 57 | 73 |
    /// | each cell of the window of the contact | 24 | 64 |
    /// | each cell of the window of the contact, if cells came into contact in the last step | 8 | 8 |
    /// | each cell of the window of the pressure, once the normal load has changed | 8 | 8 |
    /// | each cell of the grid, if the gap has changed since the last pressure solve | 8 | 8 |
    /// | each cell of the grid, for a friction per cell | 8 | 8 |
    /// | each cell of the grid, for a hardness per cell | 8 | 8 |
    /// | each cell of the grid, for a permanent set | 8 | 8 |
    /// | each cell of the grid, for a relative displacement | 32 | 32 |
    ///
    /// A contact that fills the grid requires at least 81 bytes per cell in the scalar model and 137 in the vector model.
    /// The last seven rows add to these numbers. A state with coupled pressure and traction requires 121 bytes per cell of
    /// the grid before the first contact, and 129 after it. The last five rows add to these numbers, in either model. The
    /// remaining values require less than a kilobyte. The call needs no further memory that depends on the number of cells.
    ///
    /// # Content
    /// All numbers are stored exactly. The wall time and the convergence history of the report of the pressure
    /// ([`Report::time`](crate::Report::time) and [`Report::history`](crate::Report::history)) are omitted. The bytes
    /// of a slab contain its rows only. [`State::from_slabs`] restores the state from the bytes of all slabs, on any
    /// number of ranks.
    ///
    /// # Versions
    /// The bytes have version 1 of the format. A minor series of the crate, such as 0.1, reads the bytes of all its earlier
    /// versions. [`State::from_bytes`] rejects bytes of any other version of the format with an error that names both
    /// versions.
    #[must_use]
    pub fn to_bytes(&self) -> Vec<u8> {
        unwrap_or_abort(self.try_to_bytes())
    }

    /// Returns the same bytes as [`State::to_bytes`], or an error if memory runs out.
    ///
    /// # Errors
    /// - [`Error::Memory`] if memory runs out.
    pub fn try_to_bytes(&self) -> Result<Vec<u8>> {
        // A gap that was set after the last pressure solve is stored in addition to the gap of the pressure.
        let mut is_gap_changed = self.pressed_gap.as_slice() != self.gap.as_slice();
        let quantities = self.cell_quantities(is_gap_changed);
        let mut writer = Writer::default();
        writer.extend(MAGIC.len(), *MAGIC)?;
        writer.extend(size_of_val(&VERSION), VERSION.to_le_bytes())?;
        // Placeholder for the length, which is known only at the end.
        writer.extend(8, [0; 8])?;
        SnapshotHeader::of(self).visit(&mut writer)?;
        // The codec takes mutable references even for writing, so it visits a copy without cells.
        let mut outline = self.outline_on(self.grid().whole().slab(0..0))?;
        outline.visit(&mut writer, &mut is_gap_changed)?;
        writer.make_room(
            self.cell_bytes_on(self.grid(), &quantities)
                .saturating_add(SUM),
        )?;
        self.write_cells(&quantities, &mut writer)?;

        let length = (writer.0.len() + SUM) as u64;
        writer.0[HEADER - 8..HEADER].copy_from_slice(&length.to_le_bytes());
        let sum = checksum::of_bytes(&writer.0);
        writer.extend(SUM, sum.to_le_bytes())?;
        Ok(writer.0)
    }

    /// Restores a state saved by [`State::to_bytes`].
    ///
    /// For a slab, the force, the contact area and similar sums of the [normal contact](State::normal) cover only the
    /// rows of the slab. The sums cover the whole grid once the slab is passed to [`State::from_slabs`] or to a history
    /// on distributed bodies.
    ///
    /// # Errors
    /// - [`Error::Format`], with the byte, if the bytes are not a saved state, have a different version, are truncated
    ///   or were changed. No memory is allocated for cells that the bytes do not contain.
    /// - [`Error::Memory`] if memory runs out.
    pub fn from_bytes(bytes: &[u8]) -> Result<Self> {
        let mut reader = Reader(opened(bytes)?);
        let mut host = SnapshotHeader::default();
        host.visit(&mut reader)?;
        let grid = host.grid()?;
        // A cell takes at least the byte of its zone.
        reader.require("the cells", grid.cells())?;
        let mut outline = host.blank(grid)?;
        let mut is_gap_changed = false;
        outline.visit(&mut reader, &mut is_gap_changed)?;
        let quantities = outline.cell_quantities(is_gap_changed);
        // No memory is allocated for cells that the bytes do not contain.
        reader.require("the cells", outline.cell_bytes_on(grid, &quantities))?;
        let mut state = outline.outline_on(grid)?;
        state.read_cells(&quantities, &mut reader)?;
        if !is_gap_changed {
            state.pressed_gap.clone_from(&state.gap);
        }
        state.count_yielded_cells();
        state.zone_cells = state.cells_of_zones(&grid.layout());
        reader.end()?;
        if state.is_joint() && !state.is_whole() {
            let problem = "a coupled contact must store both axes on its whole grid";
            return Err(FORMAT.at_byte(HEADER, problem));
        }
        Ok(state)
    }
}

#[cfg(feature = "serde")]
impl From<State> for Vec<u8> {
    fn from(state: State) -> Self {
        state.to_bytes()
    }
}

#[cfg(feature = "serde")]
impl TryFrom<Vec<u8>> for State {
    type Error = Error;

    fn try_from(bytes: Vec<u8>) -> Result<Self> {
        Self::from_bytes(&bytes)
    }
}

impl History {
    /// Returns the bytes of the [state](History::state). They contain everything that the next step requires except for
    /// the bodies. The bodies are identified by their grid, boundary, cell value and elastic constants. See
    /// [`State::to_bytes`].
    #[doc(alias = "checkpoint")]
    #[must_use]
    pub fn to_bytes(&self) -> Vec<u8> {
        self.state().to_bytes()
    }

    /// Creates a history from the bytes of [`History::to_bytes`], on the bodies that the bytes belong to. The history
    /// continues with bitwise identical results ([limits on other machines](crate::guide::embedding#restart)). Its
    /// [last step](History::last_step) is missing until the next step.
    ///
    /// # Errors
    /// Errors of [`State::from_bytes`] and [`History::from_state`].
    ///
    /// ```
    /// use stickslip::*;
    /// let grid = Grid::square(16, 4.0)?;
    /// let rubber = Material::new(1.0, 0.5)?;
    /// let bodies = HalfSpace::new(grid, ElasticPair::new(rubber, Material::rigid())?)?;
    /// let ball = surface::sphere(grid, 10.0)?;
    /// let mut history = History::builder(&bodies, &ball, Friction::coulomb(0.3)?).build()?;
    /// history.step(&LoadStep::hold().normal(NormalLoad::Force(0.1)))?;
    ///
    /// let mut restored = History::from_bytes(&bodies, &history.to_bytes())?;
    /// let shear = LoadStep::hold().tangential(Axis::X, TangentialControl::Force(0.02));
    /// assert_eq!(history.step(&shear)?.shift(), restored.step(&shear)?.shift());
    /// # Ok::<(), Error>(())
    /// ```
    pub fn from_bytes(bodies: &HalfSpace, bytes: &[u8]) -> Result<Self> {
        Self::from_state(bodies, bodies.collective_result(State::from_bytes(bytes))?)
    }
}

/// Reads the magic and the version and returns an error if they do not match this format.
fn check_kind(start: &mut Cursor<'_>) -> Result<()> {
    let magic = start.take("the magic string", MAGIC.len())?;
    FORMAT.check_compression(magic)?;
    if magic != MAGIC {
        return Err(FORMAT.at_byte(0, "the data do not start with \\x93STKSLIP"));
    }
    let version = start.u32("the version")?;
    if version != VERSION {
        return Err(other_version(version, VERSION));
    }
    Ok(())
}

/// Returns the error for a version of the format that this crate does not read.
fn other_version(found: u32, supported: u32) -> Error {
    let problem = format!(
        "version {found} of the format is not supported, expected version {supported}: use the minor series of the crate that wrote the data"
    );
    FORMAT.at_byte(MAGIC.len(), problem)
}

/// Checks magic, version, length and checksum, and returns the content.
fn opened(bytes: &[u8]) -> Result<Cursor<'_>> {
    let mut start = Cursor::new(FORMAT, bytes);
    check_kind(&mut start)?;
    let (length, found) = (start.u64("the length")?, bytes.len());
    if length != found as u64 || found < HEADER + SUM {
        let problem = format!("the data have {found} bytes, expected {length}");
        return Err(FORMAT.at_byte(MAGIC.len() + 4, problem));
    }
    let (contents, sum) = bytes.split_at(found - SUM);
    if checksum::of_bytes(contents).to_le_bytes() != sum {
        return Err(FORMAT.at_byte(
            found - SUM,
            "the checksum does not match: the data are damaged",
        ));
    }
    let mut contents = Cursor::new(FORMAT, contents);
    contents.take("the header", HEADER)?;
    Ok(contents)
}
