//! Solution of a step before it is committed to the state.

use crate::contact::{Cancellation, SolveContext};
use crate::error::{Result, of_rolling};
use crate::grid::field::Field;
use crate::grid::window::Window;
use crate::half_space::HalfSpace;
use crate::history::state::memory::Memory;
use crate::history::step::neglected::StepLift;
use crate::history::{History, LoadStep, State};
use crate::memory::fallible::{self, TryClone};
use crate::normal::{NormalControl, NormalInput, NormalLoad};
use crate::observer::Observer;
use crate::parallel;
use crate::rolling::RollingShift;
use crate::rolling::entry::compliance;
use crate::tangential::{
    EntryCompliance, RigidMotion, Start, TangentialIncrement, TangentialTarget,
};

impl History {
    /// Solves the normal and the tangential contact of a step and returns the motion of body 2 at its end. In the state
    /// only the window of the memory changes. It may become wider. If the solve fails or the observer panics, the
    /// history is restored.
    pub(in crate::history) fn attempt(
        &mut self,
        load: &LoadStep,
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
            .find(load, &mut cancellation.watch(observer));
        let History {
            bodies,
            joint,
            increment,
            press,
            ..
        } = &*attempt.history;
        let mut outcome = cancellation.applied(bodies, found, || {
            let of_traction = || increment.as_ref().map(TangentialIncrement::report);
            let report = match joint {
                Some(joint) => Some(joint.report()),
                None => of_traction(),
            };
            report.unwrap_or(press.report()).clone().cancelled()
        });
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
        let State { trend, .. } = &mut self.state;
        let [change] = &mut trend.change;
        fallible::make_room(change, self.press.trend_cells())?;
        let entered = match &self.joint {
            Some(_) => self.bodies.grid().cells(),
            None => self
                .increment
                .as_ref()
                .map_or(0, TangentialIncrement::entered_cells),
        };
        let memory = self.state.contact.as_mut();
        memory.map_or(Ok(()), |memory| {
            fallible::make_room(&mut memory.entered, entered)
        })
    }

    /// Solves the normal and the tangential contact of a step.
    fn find(&mut self, load: &LoadStep, observer: Observer<'_>) -> Result<RigidMotion> {
        self.press.tick();
        let joint = self.joint.as_ref();
        let window = joint.map_or_else(|| self.press.window(), |joint| joint.window());
        if window != self.state.press_window || joint.is_some() != self.state.is_joint() {
            self.take_back()?;
        }
        if let Some(motion) = self.find_jointly(load, &mut *observer)? {
            return Ok(motion);
        }
        let control = load.normal_control();
        if let Some(normal) = control
            .load()
            .filter(|_| !self.state.is_pressed_by(control))
        {
            self.find_pressure(normal, &mut *observer)?;
        }
        self.find_tractions(load, observer)
    }

    /// Solves for the pressure of the step, which becomes the candidate.
    fn find_pressure(&mut self, load: NormalLoad, observer: Observer<'_>) -> Result<()> {
        let state = &self.state;
        load.check(&self.bodies, &state.gap, state.hardness.as_ref())?;
        let of = NormalInput {
            bodies: &self.bodies,
            gap: &state.gap,
            hardness: state.hardness.as_ref(),
            load,
            settings: &state.settings,
        };
        let candidate = self.candidate.take(|| state.normal.try_clone())?;
        let pressure = candidate.pressure_mut();
        parallel::copy(state.pressure().as_slice(), pressure);
        self.press.solve(&of, pressure, observer)?;
        self.press.finish(&of, candidate);
        Ok(())
    }

    /// Solves for the tractions of the step under the pressure of the candidate. If the pressure is held, it is the
    /// pressure of the state.
    fn find_tractions(&mut self, load: &LoadStep, observer: Observer<'_>) -> Result<RigidMotion> {
        let (grid, demand) = (self.bodies.grid(), self.state.demand(load, &self.bodies));
        let travel = load.rolling().map(|rolling| rolling.travel(&self.bodies));
        let State { axes, motion, .. } = self.state;
        let candidate = self.candidate.held();
        let pressed = candidate.unwrap_or(&self.state.normal);
        let memory = &mut self.state.contact;
        let present = memory.as_ref().map(|memory| memory.window);
        let Some(mut window) = window_of(&self.bodies, pressed.pressure(), present) else {
            return demand.without_contact(axes, motion);
        };
        if let Some(travel) = &travel {
            let pressures = [self.state.normal.pressure(), pressed.pressure()];
            window = travel.reach(&self.bodies, window, pressures)?;
        }
        let kind = (axes, self.state.coupling);
        let increment = self.increments.take(&self.bodies, kind, window)?;
        let increment = self.increment.insert(increment);
        let memory = match memory {
            Some(memory) => memory,
            none => none.insert(Memory::first(grid, axes, window, motion)?),
        };
        let is_widened = memory.window != window;
        if is_widened {
            memory.widen(grid, increment, self.state.traction.each_ref(), motion)?;
        }
        increment.set_offset(&memory.offset);
        let (state, is_pressed) = (&self.state, candidate.is_some());
        let pressure = pressed.pressure().as_slice();
        increment.pressed.set(pressure, &state.friction);
        if let Some(change) = state.displaced_by(load) {
            increment.displace(change);
        }
        let control = load.normal_control();
        if let Some(travel) = &travel {
            roll(increment, state, (&self.bodies, control), travel, &demand)?;
            let pressures = [state.pressure(), pressed.pressure()];
            increment.collect_traction(|axis, cell| {
                travel.in_proportion(&state.traction[axis], pressures, cell)
            });
        } else {
            press(increment, state, (&self.bodies, control), is_pressed)?;
            increment.set_traction(state.traction.each_ref().map(Field::as_slice));
        }
        let mut conditions = SolveContext::new(&state.settings, observer);
        let memory = state.contact.as_ref().filter(|_| !is_widened);
        let is_rolled = travel.is_some();
        let ahead = memory
            .and_then(|memory| Some((memory, memory.parts_ahead(state, &demand, is_rolled)?)));
        let start = match ahead {
            Some((memory, parts)) => {
                increment.extrapolate(&memory.trend, parts);
                Start::Near
            }
            None if is_rolled => Start::Near,
            None => Start::Present(state.shift()),
        };
        let solved = increment.solve(&demand, motion, start, &mut conditions);
        if is_rolled {
            solved.map_err(of_rolling)?;
        } else {
            solved?;
        }
        if is_rolled && state.coupling.is_one_way(self.bodies.pair()) {
            let gap = if is_pressed {
                &state.gap
            } else {
                &state.pressed_gap
            };
            let tolerance = state.settings.tolerance;
            let (lifting, answer) = (&mut self.lifting, increment.answer());
            StepLift::measure(lifting, &self.bodies, &answer, (pressed, gap), tolerance)?;
        }
        Ok(increment.motion())
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
            let History {
                press,
                candidate,
                increment,
                joint,
                ..
            } = &mut *self.history;
            press.reset();
            *candidate = candidate.clone();
            (*increment, *joint) = (None, None);
        }
    }
}

/// Sets up a step in which the pressure of the cells may change.
fn press(
    increment: &mut TangentialIncrement,
    state: &State,
    (bodies, control): (&HalfSpace, NormalControl),
    is_pressed: bool,
) -> Result<()> {
    if is_pressed {
        let before = state.pressure().as_slice();
        increment.draw_from(|i| before[i]);
    }
    let closing = is_pressed.then(|| state.closing(bodies, control, false));
    let Some(gap) = closing.flatten() else {
        increment.enter_nowhere();
        return Ok(());
    };
    increment.enter(gap)
}

/// Sets up a step in which other particles move into the cells.
fn roll(
    increment: &mut TangentialIncrement,
    state: &State,
    (bodies, control): (&HalfSpace, NormalControl),
    travel: &RollingShift,
    demand: &TangentialTarget,
) -> Result<()> {
    let passage = travel.through(increment.pressed.window().size);
    let turned = travel.rotation_correction(0.5 * (state.twist() + demand.twist));
    increment.carry_offset(|part| passage.shift_with_particles(part), turned);
    let pressure = state.pressure().as_slice();
    increment.draw_from(|i| travel.before(i).map_or(0.0, |before| pressure[before]));
    let Some(gap) = state.closing(bodies, control, true) else {
        increment.enter_nowhere();
        return Ok(());
    };
    increment.set_rolling_entry_compliance(|i, pressure| {
        let entered = |before| compliance(&state.normal, before, gap(before), pressure);
        travel.before(i).map_or(EntryCompliance::NONE, entered)
    })
}

/// Returns the window for the tractions under a pressure, or `None` before the first contact. The present window is
/// returned if it contains the contact or if there is no contact. Otherwise the window is wider, with a margin for
/// further growth. The window of the first contact has no margin.
fn window_of(bodies: &HalfSpace, pressure: &Field, present: Option<Window>) -> Option<Window> {
    let (grid, samples) = (bodies.grid(), pressure.as_slice());
    let Some(contact) = bodies.around(|i| samples[i] > 0.0) else {
        return present;
    };
    let contact = bodies.restrict_to_window(contact);
    Some(match present {
        Some(window) if window.covers(contact) => window,
        Some(window) => window.union(contact.widened(grid)),
        None => contact,
    })
}
