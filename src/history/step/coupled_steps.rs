//! Steps in which pressure and tractions are solved together.

use crate::bodies::coupling::Coupling;
use crate::contact::{LoadTrend, SolveContext, within_time};
use crate::coupled::{CoupledIncrement, CoupledTarget};
use crate::error::Result;
use crate::grid::window::Window;
use crate::half_space::HalfSpace;
use crate::history::state::State;
use crate::history::state::memory::Memory;
use crate::history::step::scheme::StepSolver;
use crate::history::step::solve::StepInput;
use crate::memory::fallible::TryClone;
use crate::memory::pool::PooledBuffer;
use crate::normal::{NormalLoad, NormalSolution};
use crate::observer::Observer;
use crate::report::Report;
use crate::tangential::{Axis, RigidMotion, StepSolution};

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

impl StepSolver for CoupledIncrement {
    fn solve(
        &mut self,
        bodies: &HalfSpace,
        step: &StepInput<'_>,
        state: &mut State,
        normal: &mut PooledBuffer<NormalSolution>,
        observer: Observer<'_>,
    ) -> Result<RigidMotion> {
        if self.window() != state.press_window {
            Self::resume(self, state.press_window)?;
        }
        let held = || NormalLoad::Force(state.normal.force());
        let control = step.load.normal_control().load().unwrap_or_else(held);
        let hardness = state.hardness.as_ref();
        control.check(bodies, &state.gap, hardness)?;
        let Self {
            offsets, pressed, ..
        } = self;
        state.set_offsets(step, &pressed.region, offsets);
        // The solve divides the compliances by the pressure that it computes.
        let place = (bodies, &pressed.region);
        state.set_entry(place, step, control.into(), offsets, |_| 1.0)?;
        let (pressure, traction) = (state.pressure(), state.traction());
        self.set_start(pressure, traction, state.approach(), state.shift());
        let target = CoupledTarget {
            gap: &state.gap,
            friction: &state.friction,
            hardness,
            normal: control,
            tangential: step.target,
        };
        let mut observer = within_time(&state.settings, observer);
        let mut conditions = SolveContext::new(&state.settings, &mut observer);
        Self::solve(self, target, state.motion, &mut conditions)?;
        let normal = normal.take(|| state.normal.try_clone())?;
        self.write(&state.gap, hardness, normal);
        if let Some(travel) = &step.travel {
            travel.check_ahead(bodies, normal.pressure())?;
        }
        Ok(self.answer().motion)
    }

    fn solution(&self) -> Option<StepSolution<'_>> {
        Some(self.answer())
    }

    fn report(&self) -> &Report {
        Self::report(self)
    }

    fn window(&self) -> Option<Window> {
        Self::window(self)
    }

    fn resume(&mut self, _: &HalfSpace, state: &State) -> Result<()> {
        Self::resume(self, state.press_window)
    }
}
