//! Steps in which pressure and tractions are solved one after the other.

use crate::contact::{LoadTrend, SolveContext, within_time};
use crate::error::Result;
use crate::grid::field::Field;
use crate::grid::window::Window;
use crate::half_space::HalfSpace;
use crate::history::State;
use crate::history::state::memory::Memory;
use crate::history::step::neglected::StepLift;
use crate::history::step::pool::IncrementPool;
use crate::history::step::scheme::StepSolver;
use crate::history::step::solve::StepInput;
use crate::memory::fallible::{self, TryClone};
use crate::memory::pool::PooledBuffer;
use crate::normal::{NormalInput, NormalLoad, NormalSolution, PressureSolver};
use crate::observer::Observer;
use crate::parallel;
use crate::report::Report;
use crate::tangential::{RigidMotion, Start, StepSolution, TangentialIncrement};

/// Solver of the pressure, then of the tractions under this pressure.
#[derive(Clone)]
pub(in crate::history) struct SequentialSolver {
    press: PressureSolver,
    increments: IncrementPool,
    /// Tangential contact of the present step.
    increment: Option<TangentialIncrement>,
    /// Lift due to the tractions of rolled steps with one-way coupling, or `None` before the first such step.
    lifting: Option<StepLift>,
}

impl Default for SequentialSolver {
    fn default() -> Self {
        Self {
            press: PressureSolver::new(),
            increments: IncrementPool::default(),
            increment: None,
            lifting: None,
        }
    }
}

impl StepSolver for SequentialSolver {
    fn solve(
        &mut self,
        bodies: &HalfSpace,
        step: &StepInput<'_>,
        state: &mut State,
        normal: &mut PooledBuffer<NormalSolution>,
        observer: Observer<'_>,
    ) -> Result<RigidMotion> {
        self.press.tick();
        if let Some(lifting) = &mut self.lifting {
            lifting.found = None;
        }
        if self.window() != state.press_window {
            self.resume(bodies, state)?;
        }
        let control = step.load.normal_control();
        if let Some(load) = control.load().filter(|_| !state.is_pressed_by(control)) {
            let normal = normal.take(|| state.normal.try_clone())?;
            self.solve_pressure(bodies, load, state, normal, &mut *observer)?;
        }
        self.solve_tractions(bodies, step, state, normal.held(), observer)
    }

    fn solution(&self) -> Option<StepSolution<'_>> {
        self.increment.as_ref().map(TangentialIncrement::answer)
    }

    fn report(&self) -> &Report {
        let increment = self.increment.as_ref();
        increment.map_or(self.press.report(), TangentialIncrement::report)
    }

    fn window(&self) -> Option<Window> {
        self.press.window()
    }

    fn resume(&mut self, bodies: &HalfSpace, state: &State) -> Result<()> {
        let (window, trend) = (state.press_window, &state.trend);
        self.press.resume(bodies, state.approach(), window, trend)
    }

    fn write_trend(&self, trend: &mut LoadTrend<1>) {
        self.press.write_trend(trend);
    }

    fn neglected_lift(&self) -> Option<usize> {
        self.lifting.as_ref().and_then(|lifting| lifting.found)
    }

    fn release(&mut self) {
        if let Some(increment) = self.increment.take() {
            self.increments.give_back(increment);
        }
    }
}

impl SequentialSolver {
    /// Solves for the pressure of the step.
    fn solve_pressure(
        &mut self,
        bodies: &HalfSpace,
        load: NormalLoad,
        state: &mut State,
        normal: &mut NormalSolution,
        observer: Observer<'_>,
    ) -> Result<()> {
        load.check(bodies, &state.gap, state.hardness.as_ref())?;
        let of = NormalInput {
            bodies,
            gap: &state.gap,
            hardness: state.hardness.as_ref(),
            load,
            settings: &state.settings,
        };
        let pressure = normal.pressure_mut();
        parallel::copy(state.normal.pressure().as_slice(), pressure);
        self.press.solve(&of, pressure, observer)?;
        self.press.finish(&of, normal);
        let [change] = &mut state.trend.change;
        fallible::make_room(change, self.press.trend_cells())
    }

    /// Solves for the tractions of the step under a new pressure, or under the pressure of the state if it is held.
    fn solve_tractions(
        &mut self,
        bodies: &HalfSpace,
        step: &StepInput<'_>,
        state: &mut State,
        normal: Option<&NormalSolution>,
        observer: Observer<'_>,
    ) -> Result<RigidMotion> {
        let (grid, axes, motion) = (bodies.grid(), state.axes, state.motion);
        let pressed = normal.unwrap_or(&state.normal);
        let memory = &mut state.contact;
        let present = memory.as_ref().map(|memory| memory.window);
        let Some(mut window) = window_of(bodies, pressed.pressure(), present) else {
            return step.target.without_contact(axes, motion);
        };
        if let Some(travel) = &step.travel {
            let pressures = [state.normal.pressure(), pressed.pressure()];
            window = travel.reach(bodies, window, pressures)?;
        }
        let kind = (axes, state.coupling);
        let increment = self.increments.take(bodies, kind, window)?;
        let increment = self.increment.insert(increment);
        let memory = match memory {
            Some(memory) => memory,
            none => none.insert(Memory::first(grid, axes, window, motion)?),
        };
        let is_widened = memory.window != window;
        if is_widened {
            memory.widen(grid, increment, state.traction.each_ref(), motion)?;
        }
        let (state, is_pressed) = (&*state, normal.is_some());
        let pressures = [state.pressure(), pressed.pressure()];
        let [before, after] = pressures.map(Field::as_slice);
        increment.pressed.set(after, &state.friction);
        let TangentialIncrement {
            offsets,
            pressed: cells,
            ..
        } = &mut *increment;
        state.set_offsets(step, &cells.region, offsets);
        if is_pressed || step.travel.is_some() {
            let pressure = |k: usize| {
                if cells.limits.cells[k] > 0.0 {
                    cells.pressure[k]
                } else {
                    0.0
                }
            };
            let place = (bodies, &cells.region);
            state.set_entry(place, step, step.load.normal_control(), offsets, pressure)?;
            offsets.entry.clear_if_zero(cells.region.layout());
        } else {
            offsets.entry.clear();
        }
        if let Some(travel) = &step.travel {
            increment.draw_from(|i| travel.before(i).map_or(0.0, |cell| before[cell]));
            increment.set_traction(|axis, cell| {
                travel.in_proportion(&state.traction[axis], pressures, cell)
            });
        } else {
            if is_pressed {
                increment.draw_from(|i| before[i]);
            }
            increment.set_traction(|axis, cell| state.traction[axis].as_slice()[cell]);
        }
        let memory = state.contact.as_ref().filter(|_| !is_widened);
        let ahead = memory.and_then(|memory| Some((memory, memory.parts_ahead(state, step)?)));
        let start = match ahead {
            Some((memory, parts)) => {
                increment.extrapolate(&memory.trend, parts);
                Start::Near
            }
            None if step.travel.is_some() => Start::Near,
            None => Start::Present(state.shift()),
        };
        let mut observer = within_time(&state.settings, observer);
        let mut conditions = SolveContext::new(&state.settings, &mut observer);
        increment.solve(&step.target, motion, start, &mut conditions)?;
        if step.travel.is_some() && state.coupling.is_one_way(bodies.pair()) {
            let gap = normal.map_or(&state.pressed_gap, |_| &state.gap);
            let (tolerance, answer) = (state.settings.tolerance, increment.answer());
            StepLift::measure(
                &mut self.lifting,
                bodies,
                &answer,
                (pressed, gap),
                tolerance,
            )?;
        }
        Ok(increment.motion())
    }
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
