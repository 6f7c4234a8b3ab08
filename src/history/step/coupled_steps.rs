//! Steps of bodies with coupled pressure and traction.

use crate::bodies::coupling::Coupling;
use crate::contact::{LoadTrend, SolveContext};
use crate::coupled::{CoupledIncrement, CoupledTarget};
use crate::error::{Result, of_rolling};
use crate::grid::window::Window;
use crate::half_space::HalfSpace;
use crate::history::state::State;
use crate::history::state::memory::Memory;
use crate::history::{History, LoadStep};
use crate::memory::fallible::TryClone;
use crate::normal::{NormalControl, NormalLoad};
use crate::observer::Observer;
use crate::rolling::RollingShift;
use crate::rolling::entry::compliance;
use crate::tangential::{Axis, EntryCompliance, RigidMotion};

impl State {
    /// Sets the coupling. The memory of a coupled solve covers the whole grid and both axes.
    pub(in crate::history) fn coupled(mut self, coupling: Coupling) -> Result<Self> {
        self.coupling = coupling;
        if self.is_joint() {
            let (grid, axes) = (self.grid(), Axis::BOTH);
            let mut memory = Memory::first(grid, axes, Window::whole(grid), self.motion)?;
            memory.trend = LoadTrend::default();
            (self.axes, self.contact) = (axes, Some(memory));
        }
        Ok(self)
    }

    /// Returns whether pressure and traction are coupled and solved together.
    pub(crate) fn is_joint(&self) -> bool {
        self.coupling.is_joint(self.pair())
    }

    /// Returns whether the memory of coupled bodies covers the whole grid and both axes.
    pub(in crate::history) fn is_whole(&self) -> bool {
        let whole = Window::whole(self.grid());
        let remembers = |memory: &Memory| memory.window == whole;
        self.axes == Axis::BOTH && self.contact.as_ref().is_some_and(remembers)
    }
}

impl History {
    /// Solves a step with coupled pressure and traction without changing the state. Returns the motion of body 2 at the
    /// end of the step, or `None` if the bodies are not coupled.
    pub(in crate::history) fn find_jointly(
        &mut self,
        load: &LoadStep,
        observer: Observer<'_>,
    ) -> Result<Option<RigidMotion>> {
        let (state, Some(joint)) = (&self.state, &mut self.joint) else {
            return Ok(None);
        };
        let held = || NormalLoad::Force(state.normal.force());
        let normal = load.normal_control().load().unwrap_or_else(held);
        let hardness = state.hardness.as_ref();
        normal.check(&self.bodies, &state.gap, hardness)?;
        if let Some(memory) = &state.contact {
            joint.set_offset(&memory.offset);
        }
        if let Some(change) = state.displaced_by(load) {
            joint.displace(change);
        }
        let travel = load.rolling().map(|rolling| rolling.travel(&self.bodies));
        let motion = state.demand(load, &self.bodies);
        match &travel {
            Some(travel) => roll(
                joint,
                state,
                (&self.bodies, normal.into()),
                travel,
                motion.twist,
            )?,
            None => joint.enter(state.closing(&self.bodies, normal.into(), false))?,
        }
        let (pressure, traction) = (state.pressure(), state.traction());
        joint.set_start(pressure, traction, state.approach(), state.shift());
        let mut conditions = SolveContext::new(&state.settings, observer);
        let demand = CoupledTarget {
            gap: &state.gap,
            friction: &state.friction,
            hardness,
            normal,
            tangential: motion,
        };
        let solved = joint.solve(demand, state.motion, &mut conditions);
        if travel.is_some() {
            solved.map_err(of_rolling)?;
        } else {
            solved?;
        }
        let candidate = self.candidate.take(|| state.normal.try_clone())?;
        joint.write(&state.gap, hardness, candidate);
        if let Some(travel) = &travel {
            travel.check_ahead(&self.bodies, candidate.pressure())?;
        }
        Ok(Some(joint.answer().motion))
    }
}

/// Sets up a step that moves other particles into the cells. `twist` is the twist of body 2 at the end of the step.
fn roll(
    joint: &mut CoupledIncrement,
    state: &State,
    (bodies, control): (&HalfSpace, NormalControl),
    travel: &RollingShift,
    twist: f64,
) -> Result<()> {
    let passage = travel.through(state.grid().size());
    let turned = travel.rotation_correction(0.5 * (state.twist() + twist));
    joint.carry_offset(|part| passage.shift_with_particles(part), turned);
    let Some(gap) = state.closing(bodies, control, true) else {
        return joint.enter(None::<fn(usize) -> f64>);
    };
    // The compliance is set for a unit pressure, because the pressure of the cell is not known before the solve.
    joint.set_rolling_entry_compliance(Some(|i: usize| {
        let entered = |before| compliance(&state.normal, before, gap(before), 1.0);
        travel.before(i).map_or(EntryCompliance::NONE, entered)
    }))
}

/// Creates the solver for the steps of a coupled state. Returns `None` if the state is not coupled.
pub(in crate::history) fn new_joint(
    bodies: &HalfSpace,
    state: &State,
) -> Result<Option<Box<CoupledIncrement>>> {
    let make = || {
        let mut joint = CoupledIncrement::new(bodies)?;
        joint.resume(state.press_window)?;
        Ok(Box::new(joint))
    };
    state.is_joint().then(make).transpose()
}
