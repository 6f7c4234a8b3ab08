//! How a step is solved, before any of it enters the state.

use crate::cascade::Conditions;
use crate::clock::Instant;
use crate::elastic::Observer;
use crate::error::Result;
use crate::field::Field;
use crate::half_space::HalfSpace;
use crate::history::memory::Memory;
use crate::history::{History, LoadStep, touch};
use crate::normal::{NormalControl, Pressing};
use crate::parallel;
use crate::tangential::{Motion, Start};
use crate::window::Window;

impl History {
    /// Solves both halves of a step; returns the motion of body 2 at its end. Of the state it changes the window of what
    /// the cells remember, which may become wider.
    pub(super) fn attempt(&mut self, load: &LoadStep, observer: Observer<'_>) -> Result<Motion> {
        self.press.age();
        let joint = self.joint.as_ref().map(|joint| joint.window());
        if joint.unwrap_or_else(|| self.press.window()) != self.state.press_window {
            self.take_back()?;
        }
        if let Some(mut joint) = self.joint.take() {
            let motion = self.attempt_joint(&mut joint, load, observer);
            self.joint = Some(joint);
            return motion;
        }
        let control = load.normal_control();
        if control != NormalControl::Hold && !self.state.is_pressed_by(control) {
            self.find_pressure(control, &mut *observer)?;
        }
        let mut memory = self.state.contact.take();
        let motion = self.find_tractions(&mut memory, load, observer);
        self.state.contact = memory;
        motion
    }

    /// Finds the pressure of the step, as the candidate.
    fn find_pressure(&mut self, control: NormalControl, observer: Observer<'_>) -> Result<()> {
        let state = &self.state;
        control.check(&self.bodies, &state.gap)?;
        if let Some(hardness) = &state.hardness {
            hardness.check_load(&self.bodies, control)?;
        }
        let of = Pressing {
            bodies: &self.bodies,
            gap: &state.gap,
            least_gap: state.gap.min(),
            hardness: state.hardness.as_ref(),
            control,
            settings: &state.settings,
        };
        let candidate = self.candidate.take(|| state.normal.clone());
        let pressure = candidate.pressure_mut();
        parallel::copy(state.pressure().as_slice(), pressure);
        self.press.solve(&of, pressure, observer)?;
        self.press.finish(&of, candidate);
        Ok(())
    }

    /// Finds the tractions of the step under the pressure of the candidate, or that of the state if that is held.
    fn find_tractions(
        &mut self,
        memory: &mut Option<Memory>,
        load: &LoadStep,
        observer: Observer<'_>,
    ) -> Result<Motion> {
        let (state, demand) = (&self.state, load.demand(self.state.motion.twist));
        let candidate = self.candidate.held();
        let pressed = candidate.unwrap_or(&state.normal);
        let grid = self.bodies.grid();
        let present = memory.as_ref().map(|memory| memory.window);
        let Some(window) = window_of(&self.bodies, pressed.pressure(), present) else {
            return demand.without_contact(state.axes, state.motion);
        };
        let kind = (state.axes, state.coupling);
        let increment = self.increments.take(&self.bodies, kind, window)?;
        let increment = self.increment.insert(increment);
        let first = || Memory::first(grid, state.axes, window, state.motion);
        let memory = memory.get_or_insert_with(first);
        let is_widened = memory.window != window;
        if is_widened {
            memory.widen(grid, increment, state);
        }
        let pressure = pressed.pressure().as_slice();
        increment.pressed.set(pressure, &state.friction);
        increment.set_offset(&memory.offset);
        if let Some(change) = state.displaced_by(load) {
            increment.displace(change);
        }
        if candidate.is_some() {
            increment.draw_from(state.pressure().as_slice());
            touch::follow_growth(increment, state, pressed, load, &demand);
        }
        increment.set_traction(state.traction.each_ref().map(Field::as_slice));
        let mut conditions = Conditions {
            settings: &state.settings,
            start: Instant::now(),
            observer,
        };
        let parts = memory.parts_ahead(state, &demand);
        let start = match parts.filter(|_| !is_widened) {
            Some(parts) => {
                increment.extrapolate(&memory.trend, parts);
                Start::Near
            }
            None => Start::Present(state.shift()),
        };
        increment.solve(&demand, state.motion, start, &mut conditions)?;
        Ok(increment.motion())
    }
}

/// Where the tractions of a pressure are found: on the window that the contact has, or on one that is wide enough for a
/// contact that has left it, and a little wider, so that it may grow some more. `None` before the first contact.
fn window_of(bodies: &HalfSpace, pressure: &Field, present: Option<Window>) -> Option<Window> {
    let (grid, samples) = (bodies.grid(), pressure.as_slice());
    let Some(contact) = Window::around(grid, |i| samples[i] > 0.0) else {
        return present;
    };
    let contact = bodies.confined(contact);
    Some(match present {
        Some(window) if window.covers(contact) => window,
        Some(window) => window.union(contact.widened(grid)),
        None => contact,
    })
}
