//! The steps of bodies whose pressure and shear are found together.

use crate::cascade::Conditions;
use crate::clock::Instant;
use crate::coupled::{CoupledDemand, CoupledIncrement};
use crate::elastic::Observer;
use crate::error::Result;
use crate::half_space::HalfSpace;
use crate::history::state::State;
use crate::history::{History, LoadStep};
use crate::normal::NormalControl;
use crate::tangential::Motion;

impl History {
    /// Solves a step whose pressure and shear are coupled without a trace in the state; returns the motion of body 2 at
    /// its end.
    pub(super) fn attempt_joint(
        &mut self,
        joint: &mut CoupledIncrement,
        load: &LoadStep,
        observer: Observer<'_>,
    ) -> Result<Motion> {
        let state = &self.state;
        let normal = match load.normal_control() {
            NormalControl::Hold => NormalControl::Force(state.normal.force()),
            control => control,
        };
        self.press.set_load(normal)?;
        if let Some(memory) = &state.contact {
            joint.set_offset(&memory.offset);
        }
        let (pressure, traction) = (state.pressure(), state.traction());
        joint.set_start(pressure, traction, state.approach(), state.shift());
        let mut conditions = Conditions {
            settings: &state.settings,
            start: Instant::now(),
            observer,
        };
        let demand = CoupledDemand {
            gap: &state.gap,
            friction: &state.friction,
            normal,
            tangential: load.demand(state.motion.twist),
        };
        joint.solve(demand, state.motion, &mut conditions)?;
        joint.write(&state.gap, &mut self.candidate);
        Ok(joint.answer().motion)
    }
}

/// What solves the steps of a coupled state.
pub(super) fn new_joint(
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
