//! A history as bytes, to go on from later.
//!
//! | bytes | holds |
//! |---|---|
//! | 8 | `\x93STKSLIP` |
//! | 4 | version of the format, 2 |
//! | 8 | number of all bytes |
//! | | bodies, options, friction, scalars, windows, fields |
//! | 8 | FNV-1a sum of all bytes before |
//!
//! Numbers are little-endian; counts take 8 bytes, samples are doubles.

mod reader;
mod writer;

use crate::error::Result;
use crate::half_space::HalfSpace;
use crate::history::History;
use crate::history::layout::axes_of;
use crate::history::motion::Motion;
use crate::history::patch::Patch;
use crate::io::{Cursor, Format};

use reader::{FINITE, NOT_NEGATIVE, Reader};
use writer::Writer;

const FORMAT: Format = Format("saved history");
const MAGIC: &[u8; 8] = b"\x93STKSLIP";
const VERSION: u32 = 2;
/// Magic, version and length; and the sum at the end.
const HEADER: usize = 20;
const SUM: usize = 8;

impl History {
    /// All that the next step needs, as bytes: [`History::restore`] goes on from them to the same bits.
    ///
    /// The bodies are not among them, but enough to know them again. Nor is that the gap has changed since the
    /// pressure was found: after a restart a step that holds it carries no
    /// [`Warning::StalePressure`](crate::Warning::StalePressure). Some 60 bytes per cell, 80 of a history in the
    /// plane.
    #[must_use]
    pub fn to_bytes(&self) -> Vec<u8> {
        let mut bytes = Writer::default();
        bytes.raw(MAGIC);
        bytes.raw(&VERSION.to_le_bytes());
        // The length, which only the end knows.
        bytes.count(0);
        bytes.bodies(&self.bodies);
        bytes.options(self.axis(), &self.settings);
        bytes.friction(&self.friction);

        let (normal, state) = (&self.normal, &self.state);
        bytes.raw(&state.steps.to_le_bytes());
        bytes.numbers(&state.motion.shift);
        bytes.numbers(&state.force);
        bytes.numbers(&[state.motion.twist, state.moment, normal.approach()]);
        bytes.report(normal.report());
        let patch = self.shear.patch.as_ref();
        bytes.window(self.press.window());
        bytes.window(patch.map(|patch| patch.window));
        for field in [self.gap(), normal.pressure(), normal.gap()] {
            bytes.numbers(field.as_slice());
        }
        for axis in axes_of(self.axis()) {
            bytes.numbers(state.traction[axis.index()].as_slice());
            bytes.numbers(state.slip[axis.index()].as_slice());
        }
        bytes.numbers(state.slip_path.as_slice());
        bytes.numbers(state.dissipated.as_slice());
        bytes.zones(&state.zones);
        if let Some(patch) = patch {
            bytes.numbers(&patch.displacement);
            bytes.numbers(&patch.offset);
        }

        let mut bytes = bytes.into_bytes();
        let length = (bytes.len() + SUM) as u64;
        bytes[HEADER - 8..HEADER].copy_from_slice(&length.to_le_bytes());
        let sum = checksum(&bytes);
        bytes.extend(sum.to_le_bytes());
        bytes
    }

    /// A history saved by [`History::to_bytes`], on the bodies it had. Its [last
    /// step](History::last_step) is empty.
    ///
    /// # Errors
    /// [`Error::Format`](crate::Error::Format) if the bytes are no such history, of another version, truncated or changed;
    /// [`Error::GridMismatch`](crate::Error::GridMismatch), [`Error::BoundaryMismatch`](crate::Error::BoundaryMismatch) or [`Error::MaterialMismatch`](crate::Error::MaterialMismatch) if it was saved
    /// from other bodies; [`Error::Sample`](crate::Error::Sample) for a field that breaks its rule.
    ///
    /// ```
    /// use stickslip::*;
    /// let grid = Grid::square(16, 4.0)?;
    /// let rubber = Material::new(1.0, 0.5)?;
    /// let bodies = HalfSpace::new(grid, ElasticPair::new(rubber, Material::rigid())?)?;
    /// let ball = surface::sphere(grid, 10.0)?;
    /// let mut history = History::builder(&bodies, &ball, Friction::coulomb(0.3)?).build()?;
    /// history.step(&LoadStep::hold().normal(NormalStep::Force(0.1)))?;
    ///
    /// let mut restored = History::restore(&bodies, &history.to_bytes())?;
    /// let shear = LoadStep::hold().tangential(Axis::X, TangentialStep::Force(0.02));
    /// assert_eq!(history.step(&shear)?.shift(), restored.step(&shear)?.shift());
    /// # Ok::<(), Error>(())
    /// ```
    pub fn restore(bodies: &HalfSpace, bytes: &[u8]) -> Result<Self> {
        let grid = bodies.grid();
        let mut reader = Reader::new(opened(bytes)?);
        reader.expect(bodies)?;
        let (axis, settings) = reader.options()?;
        let friction = reader.friction(grid)?;

        let steps = reader.steps()?;
        let shift = [reader.finite("shift")?, reader.finite("shift")?];
        let what = "tangential force";
        let force = [reader.finite(what)?, reader.finite(what)?];
        let twist = reader.finite("twist")?;
        let moment = reader.finite("moment")?;
        let approach = reader.finite("approach")?;
        let report = reader.report()?;
        let window = reader.window(grid)?;
        let patch_window = reader.window(grid)?;
        let gap = reader.field("gap", grid, FINITE)?;
        let pressure = reader.field("pressure", grid, NOT_NEGATIVE)?;
        let gap_under_load = reader.field("gap under load", grid, FINITE)?;

        let mut history = Self::new(bodies, &gap, friction, axis, settings)?;
        let (pressure, loaded) = (pressure.as_slice(), gap_under_load.as_slice());
        history.normal.restore(pressure, loaded, approach, &report);
        history.press.resume(pressure, window)?;
        let state = &mut history.state;
        state.steps = steps;
        state.motion = Motion { shift, twist };
        (state.force, state.moment) = (force, moment);
        for axis in axes_of(axis) {
            state.traction[axis.index()] = reader.field("traction", grid, FINITE)?;
            state.slip[axis.index()] = reader.field("slip", grid, FINITE)?;
        }
        state.slip_path = reader.field("slip path", grid, NOT_NEGATIVE)?;
        state.dissipated = reader.field("dissipated energy", grid, NOT_NEGATIVE)?;
        state.zones = reader.zones(grid.cells())?;
        if let Some(window) = patch_window {
            let mut patch = Patch::first(bodies, axis, window, state)?;
            let count = patch.layout().len();
            patch.displacement = reader.numbers("displacement", count, FINITE)?;
            patch.offset = reader.numbers("offset", count, FINITE)?;
            history.shear.patch = Some(patch);
        }
        reader.end()?;
        Ok(history)
    }
}

/// The contents of the bytes, whose magic, version, length and sum are right.
fn opened(bytes: &[u8]) -> Result<Cursor<'_>> {
    let mut start = Cursor::new(FORMAT, bytes);
    if start.take("the magic string", MAGIC.len())? != MAGIC {
        return Err(FORMAT.at_byte(0, "the bytes do not begin with \\x93STKSLIP"));
    }
    let version = start.u32("the version")?;
    if version != VERSION {
        let problem = format!("version {version} is unknown; this is version {VERSION}");
        return Err(FORMAT.at_byte(MAGIC.len(), problem));
    }
    let (length, found) = (start.u64("the length")?, bytes.len());
    if length != found as u64 || found < HEADER + SUM {
        let problem = format!("{length} bytes were saved, {found} are here");
        return Err(FORMAT.at_byte(MAGIC.len() + 4, problem));
    }
    let (contents, sum) = bytes.split_at(found - SUM);
    if checksum(contents).to_le_bytes() != sum {
        return Err(FORMAT.at_byte(found - SUM, "the checksum of the bytes is another"));
    }
    let mut contents = Cursor::new(FORMAT, contents);
    contents.take("the header", HEADER)?;
    Ok(contents)
}

/// FNV-1a of 64 bits: <https://datatracker.ietf.org/doc/html/rfc9923>.
fn checksum(bytes: &[u8]) -> u64 {
    let step = |sum: u64, &byte: &u8| (sum ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3);
    bytes.iter().fold(0xcbf2_9ce4_8422_2325, step)
}

/// What tells the bodies from others: moduli and Poisson's ratios.
fn elasticity(bodies: &HalfSpace) -> [f64; 4] {
    let [one, two] = bodies.pair().bodies();
    [
        one.shear_modulus(),
        one.poisson_ratio(),
        two.shear_modulus(),
        two.poisson_ratio(),
    ]
}
