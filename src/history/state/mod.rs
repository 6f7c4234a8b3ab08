//! State of a history, which persists from one step to the next.

mod equality;
pub(super) mod held_force;
pub(super) mod mark;
pub(super) mod memory;
pub(super) mod motion_range;
pub(super) mod over_ranks;
pub(super) mod permanent_set;
pub(super) mod readers;
pub(super) mod relative_displacement;
pub(super) mod window_shrinking;

use crate::bodies::component::Direction;
use crate::bodies::coupling::Coupling;
use crate::bodies::material::ElasticPair;
use crate::cgm::Settings;
use crate::contact::LoadTrend;
use crate::coupled::check_joint;
use crate::error::{Error, Result};
use crate::grid::boundary::Boundary;
use crate::grid::cell_value::CellValue;
use crate::grid::field::{Field, clone_in_place};
use crate::grid::window::Window;
use crate::half_space::HalfSpace;
use crate::history::state::memory::Memory;
use crate::history::state::motion_range::MotionRange;
use crate::history::state::relative_displacement::RelativeDisplacementState;
use crate::memory::fallible::{self, TryClone, try_clone};
use crate::normal::{Hardness, NormalControl, NormalSolution};
use crate::support::debug::shown;
use crate::tangential::EntryRule;
use crate::tangential::{Axis, Friction, RigidMotion, Zone, check_axes};

/// Implements `Clone` and `TryClone` for a struct with the given fields: first the fields with buffers, then the fields
/// without.
macro_rules! clones {
    ($type:ident { $($part:ident),* $(,)? } { $($plain:ident),* $(,)? }) => {
        clone_in_place!($type { $($part,)* $($plain),* });
        try_clone!($type { $($part),* } { $($plain),* });
    };
}

use clones;

/// State of a [`History`](crate::History). It contains everything that the next step starts from, except for the bodies
/// and the buffers.
///
/// [`History::state`](crate::History::state) returns a reference to the state. A clone saves the state, and
/// [`History::set_state`](crate::History::set_state) restores it. `clone_from` and `set_state` copy into existing
/// memory. Vectors are `[x, y]`. In the scalar model the component across the axis of the tractions is zero.
///
/// ```
/// use stickslip::*;
/// let grid = Grid::square(32, 0.30e-3)?;
/// let steel = Material::new(213e9, 0.29)?;
/// let bodies = HalfSpace::new(grid, ElasticPair::new(steel, steel)?)?;
/// let ball = surface::sphere(grid, 3.5e-3)?;
/// let mut history = History::builder(&bodies, &ball, Friction::coulomb(0.5)?).build()?;
/// history.step(&LoadStep::hold().normal(NormalControl::Force(100.0)))?;
///
/// // Try a step, and undo it.
/// let mut kept = history.state().clone();
/// let shear = |force| LoadStep::hold().tangential(Axis::X, TangentialControl::Force(force));
/// history.step(&shear(40.0))?;
/// history.set_state(&kept)?;
/// assert_eq!((history.steps(), history.tangential_force()), (1, [0.0, 0.0]));
///
/// // Take a smaller step, and keep it.
/// history.step(&shear(20.0))?;
/// kept.clone_from(history.state());
/// assert!(kept.tangential_force()[0] > 19.9 && kept.shift()[0] > 0.0);
///
/// // Continue in another history, with bitwise identical results.
/// let mut other = History::from_state(&bodies, kept)?;
/// assert_eq!(other.step(&shear(0.0))?.shift(), history.step(&shear(0.0))?.shift());
/// # Ok::<(), Error>(())
/// ```
///
/// The page on [embedding](crate::guide::embedding#restart) describes restarts on other machines.
///
/// The feature `serde` serialises a state as the bytes of [`State::to_bytes`] in any format.
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(into = "Vec<u8>", try_from = "Vec<u8>")
)]
pub struct State {
    /// Axes of the tractions.
    pub(super) axes: &'static [Axis],
    pub(super) settings: Settings,
    pub(super) friction: Friction,
    pub(super) gap: Field,
    /// Hardness that limits the pressure of all steps.
    pub(crate) hardness: Option<Hardness>,
    /// Accumulated plastic depth, or `None` if the depth is not permanent.
    pub(super) yielded: Option<Field>,
    /// Relative displacement that the contact does not cause.
    pub(super) relative: Option<RelativeDisplacementState>,
    /// Normal contact after the last step.
    pub(super) normal: NormalSolution,
    /// Gap of the present pressure, which differs from `gap` after wear.
    pub(super) pressed_gap: Field,
    pub(super) is_pressure_stale: bool,
    /// Whether the friction limits of the contact have changed since the last step.
    pub(super) is_friction_new: bool,
    /// Load of the present pressure, or `Hold` before the first pressure solve.
    pub(super) pressed_by: NormalControl,
    /// Window of the last pressure solve, or `None` before the first contact.
    pub(crate) press_window: Option<Window>,
    /// Change of the pressure with the load, on the window `press_window`.
    pub(super) trend: LoadTrend<1>,
    /// Memory of the cells in and around the contact, or `None` before the first contact.
    pub(crate) contact: Option<Memory>,
    pub(super) traction: [Field; 2],
    pub(super) slip: [Field; 2],
    pub(super) accumulated_slip: Field,
    pub(super) dissipated_energy: Field,
    pub(super) zones: Vec<Zone>,
    pub(super) motion: RigidMotion,
    /// Range of the motion, for warnings. Saved states do not contain it.
    pub(super) motion_range: MotionRange,
    pub(super) force: [f64; 2],
    /// Force that a held shift is expected to keep.
    pub(super) held_force: [f64; 2],
    pub(super) moment: f64,
    pub(super) steps: u64,
    /// Numbers of cells that stick and that slip, over all ranks.
    pub(super) zone_cells: [usize; 2],
    pub(super) entry_rule: EntryRule,
    pub(crate) coupling: Coupling,
    /// Friction capacity of the whole contact if the grid is distributed.
    pub(super) capacity: Option<f64>,
    /// Digest of the input from which the history was built, or `None` for a state that was read from bytes.
    pub(super) origin: Option<u64>,
}

shown!(State: grid(), steps(), approach(), tangential_force(), shift(), twist());

clones!(State {
    friction, gap, hardness, yielded, relative, normal, pressed_gap, trend, contact, traction, slip, accumulated_slip,
    dissipated_energy, zones,
} {
    axes, settings, is_pressure_stale, is_friction_new, pressed_by, press_window, motion, motion_range, force, held_force, moment, steps, zone_cells, entry_rule, coupling, capacity, origin,
});

const QUANTITY: &str = "state of a history";

impl State {
    /// Creates an unloaded state without contact.
    pub(super) fn new(
        gap: Field,
        (boundary, cell_value): (Boundary, CellValue),
        pair: &ElasticPair,
        friction: Friction,
        axes: &'static [Axis],
        settings: Settings,
        entry_rule: EntryRule,
    ) -> Result<Self> {
        let grid = gap.grid();
        let zeros = || Field::try_zeros(grid);
        let normal = NormalSolution::empty(&gap, (boundary, cell_value), pair)?;
        Ok(Self {
            axes,
            settings,
            friction,
            normal,
            pressed_gap: gap.try_clone()?,
            gap,
            hardness: None,
            yielded: None,
            relative: None,
            is_pressure_stale: false,
            is_friction_new: false,
            pressed_by: NormalControl::Hold,
            press_window: None,
            trend: LoadTrend::default(),
            contact: None,
            traction: [zeros()?, zeros()?],
            slip: [zeros()?, zeros()?],
            accumulated_slip: zeros()?,
            dissipated_energy: zeros()?,
            zones: fallible::filled(Zone::Separated, grid.cells())?,
            motion: RigidMotion::default(),
            motion_range: MotionRange::default(),
            force: [0.0; 2],
            held_force: [0.0; 2],
            moment: 0.0,
            steps: 0,
            zone_cells: [0; 2],
            entry_rule,
            coupling: Coupling::default(),
            capacity: None,
            origin: None,
        })
    }

    /// Returns whether the pressure is the solution under this load within the present tolerance.
    pub(super) fn is_pressed_by(&self, load: NormalControl) -> bool {
        let report = self.normal.report();
        load == self.pressed_by
            && !self.is_pressure_stale
            && report.is_converged()
            && report.is_within(self.settings.tolerance)
    }

    /// Restores the memory to this window after a later widening, or removes the memory if `window` is `None`.
    pub(super) fn crop_memory(&mut self, window: Option<Window>) {
        let grid = self.grid();
        match (&mut self.contact, window) {
            (Some(memory), Some(window)) => memory.narrow(grid, window),
            (contact, _) => *contact = None,
        }
    }

    /// Returns an error if the state does not belong to the local cells of these bodies.
    pub(super) fn check_bodies(&self, bodies: &HalfSpace) -> Result<()> {
        bodies.grid().check_equal(QUANTITY, self.grid())?;
        self.check_origin(bodies)?;
        if self.is_joint() {
            return check_joint(bodies);
        }
        bodies.check_directions([Direction::Z], false)?;
        check_axes(bodies, self.axes, self.coupling)
    }

    /// Returns an error if the state does not belong to these bodies or to some of their rows.
    pub(super) fn check_origin(&self, bodies: &HalfSpace) -> Result<()> {
        let whole = bodies.grid().whole();
        whole.check_equal(QUANTITY, self.grid().whole())?;
        if self.boundary() != bodies.boundary() {
            return Err(Error::BoundaryMismatch { quantity: QUANTITY });
        }
        bodies.check_values(QUANTITY, self.normal.cell_value())?;
        bodies.check_pair(QUANTITY, self.pair())
    }
}
