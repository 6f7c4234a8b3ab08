//! The steps of bodies whose pressure and traction are found together.

use crate::bodies::coupling::Coupling;
use crate::contact::{Conditions, Trend};
use crate::coupled::{CoupledDemand, CoupledIncrement};
use crate::error::Result;
use crate::grid::window::Window;
use crate::half_space::HalfSpace;
use crate::history::state::State;
use crate::history::state::memory::Memory;
use crate::history::{History, LoadStep};
use crate::memory::fallible::TryClone;
use crate::normal::NormalControl;
use crate::observer::Observer;
use crate::tangential::{Axis, Motion};

impl State {
    /// With this much coupling. Where pressure and traction are found together, that is on all of the grid and along both
    /// axes.
    pub(in crate::history) fn coupled(mut self, coupling: Coupling) -> Result<Self> {
        self.coupling = coupling;
        if self.is_joint() {
            let (grid, axes) = (self.grid(), Axis::BOTH);
            let mut memory = Memory::first(grid, axes, Window::whole(grid), self.motion)?;
            memory.trend = Trend::default();
            (self.axes, self.contact) = (axes, Some(memory));
        }
        Ok(self)
    }

    /// Whether pressure and traction are found together.
    pub(crate) fn is_joint(&self) -> bool {
        self.coupling.is_joint(self.pair())
    }

    /// Whether what a state of coupled bodies remembers is all there.
    pub(in crate::history) fn is_whole(&self) -> bool {
        let whole = Window::whole(self.grid());
        let remembers = |memory: &Memory| memory.window == whole;
        self.axes == Axis::BOTH && self.contact.as_ref().is_some_and(remembers)
    }
}

impl History {
    /// Solves a step whose pressure and traction are coupled without a trace in the state; returns the motion of body 2 at
    /// its end, `None` if they are not.
    pub(in crate::history) fn find_jointly(
        &mut self,
        load: &LoadStep,
        observer: Observer<'_>,
    ) -> Result<Option<Motion>> {
        let (state, Some(joint)) = (&self.state, &mut self.joint) else {
            return Ok(None);
        };
        let normal = match load.normal_control() {
            NormalControl::Hold => NormalControl::Force(state.normal.force()),
            control => control,
        };
        let hardness = state.hardness.as_ref();
        normal.check(&self.bodies, &state.gap, hardness)?;
        if let Some(memory) = &state.contact {
            joint.set_offset(&memory.offset);
        }
        if let Some(change) = state.displaced_by(load) {
            joint.displace(change);
        }
        joint.enter(state.closing(&self.bodies, normal, false))?;
        let (pressure, traction) = (state.pressure(), state.traction());
        joint.set_start(pressure, traction, state.approach(), state.shift());
        let mut conditions = Conditions::new(&state.settings, observer);
        let demand = CoupledDemand {
            gap: &state.gap,
            friction: &state.friction,
            hardness,
            normal,
            tangential: load.demand(state.motion.twist),
        };
        joint.solve(demand, state.motion, &mut conditions)?;
        let candidate = self.candidate.take(|| state.normal.try_clone())?;
        joint.write(&state.gap, hardness, candidate);
        Ok(Some(joint.answer().motion))
    }
}

/// What solves the steps of a coupled state.
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
