//! Solution of a step before it is committed to the state.

use crate::contact::Cancellation;
use crate::error::{Result, with_remedy};
use crate::grid::window::Window;
use crate::half_space::{HalfSpace, Region};
use crate::history::step::scheme::Scheme;
use crate::history::{History, LoadStep, State};
use crate::memory::fallible;
use crate::normal::NormalControl;
use crate::observer::Observer;
use crate::rolling::RollingShift;
use crate::rolling::entry::compliance;
use crate::tangential::{EntryCompliance, Offsets, RigidMotion, TangentialTarget, carry_offsets};

/// Load of a step, with the tangential target and the paths of the particles that follow from the load.
#[derive(Debug, Clone, Copy)]
pub(in crate::history) struct StepInput<'a> {
    pub(in crate::history) load: &'a LoadStep,
    pub(in crate::history) target: TangentialTarget,
    /// Paths of the particles of rolling bodies, or `None` if the step does not roll.
    pub(in crate::history) travel: Option<RollingShift>,
}

impl History {
    /// Solves the normal and the tangential contact of a step and returns the motion of body 2 at its end. The solve
    /// may widen the window of the memory, and leaves the rest of the state unchanged. If the solve fails or the
    /// observer panics, the history is restored.
    pub(in crate::history) fn attempt(
        &mut self,
        step: &StepInput<'_>,
        observer: Observer<'_>,
    ) -> Result<RigidMotion> {
        let mut attempt = StepTransaction {
            remembered: self.state.contact.as_ref().map(|memory| memory.window),
            history: self,
            is_over: false,
        };
        let cancellation = Cancellation::default();
        let found = attempt
            .history
            .find(step, &mut cancellation.record(observer));
        let History { bodies, scheme, .. } = &*attempt.history;
        let mut outcome =
            cancellation.applied(bodies, found, || scheme.report().clone().cancelled());
        if outcome.is_ok() {
            outcome = attempt.history.make_room().and(outcome);
        }
        attempt.is_over = true;
        if outcome.is_err() {
            attempt.forget();
            attempt.history.take_back()?;
        }
        outcome
    }

    /// Reserves memory in the state for the results of a step, because the commit must not fail.
    fn make_room(&mut self) -> Result<()> {
        let found = self.scheme.solution();
        let memory = self.state.contact.as_mut();
        found.zip(memory).map_or(Ok(()), |(found, memory)| {
            fallible::make_room(&mut memory.entered, found.entered_cells())
        })
    }

    /// Solves a step with the scheme of the state.
    fn find(&mut self, step: &StepInput<'_>, observer: Observer<'_>) -> Result<RigidMotion> {
        if !self.scheme.is_for(&self.state) {
            self.take_back()?;
        }
        let Self {
            bodies,
            state,
            candidate,
            ..
        } = self;
        let found = self.scheme.solve(bodies, step, state, candidate, observer);
        if step.travel.is_some() {
            let remedy = self.state.friction.rolling_remedy();
            return found.map_err(|error| with_remedy(error, remedy));
        }
        found
    }
}

/// Step in progress.
struct StepTransaction<'a> {
    history: &'a mut History,
    /// Window of the memory before the step, or `None` before the first contact.
    remembered: Option<Window>,
    is_over: bool,
}

impl StepTransaction<'_> {
    /// Restores the state before the step.
    fn forget(&mut self) {
        self.history.state.crop_memory(self.remembered);
    }
}

impl Drop for StepTransaction<'_> {
    /// Discards solvers that a panic of the observer may have left in an inconsistent state. The next step creates them
    /// again.
    fn drop(&mut self) {
        if !self.is_over {
            self.forget();
            self.history.candidate = self.history.candidate.clone();
            self.history.scheme = Scheme::default();
        }
    }
}

impl State {
    /// Sets the offsets of the cells of a region for a step.
    pub(in crate::history) fn set_offsets(
        &self,
        step: &StepInput<'_>,
        region: &Region,
        offsets: &mut Offsets,
    ) {
        if let Some(memory) = &self.contact {
            offsets.set(region, &memory.offset);
        }
        if let Some(change) = self.displaced_by(step.load) {
            offsets.displace(region, change);
        }
        if let Some(travel) = &step.travel {
            let passage = travel.through(region.window().size);
            let turned = travel.rotation_correction(0.5 * (self.twist() + step.target.twist));
            carry_offsets(
                &mut offsets.cells,
                |part| passage.shift_with_particles(part),
                turned,
            );
        }
    }

    /// Sets the entry compliances of the cells of a region for a step under this normal load. `pressure` returns the
    /// pressure of a cell of the region at the end of the step. It returns one if the same solve computes the pressure.
    pub(in crate::history) fn set_entry(
        &self,
        (bodies, region): (&HalfSpace, &Region),
        step: &StepInput<'_>,
        control: NormalControl,
        offsets: &mut Offsets,
        pressure: impl Fn(usize) -> f64,
    ) -> Result<()> {
        let Some(gap) = self.closing(bodies, control, step.travel.is_some()) else {
            offsets.entry.clear();
            return Ok(());
        };
        let Some(travel) = &step.travel else {
            return offsets.entry.set(bodies, region, gap, pressure);
        };
        let axes = offsets.axes();
        offsets.entry.set_rolling(axes, region, |k, cell| {
            let entered = |before| compliance(&self.normal, before, gap(before), pressure(k));
            travel.before(cell).map_or(EntryCompliance::NONE, entered)
        })
    }
}
