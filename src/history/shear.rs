//! The tangential half of a step, for tractions along one axis or both in the plane.
//!
//! The seam to the rest of the history is four calls: [`Shear::prepare`] with the pressure of the step,
//! [`Shear::solve`], then [`Shear::commit`], or [`Shear::abandon`] to leave no trace.

use crate::error::{Error, Result, finite};
use crate::field::Field;
use crate::half_space::HalfSpace;
use crate::history::layout::axes_of;
use crate::history::memory::Memory;
use crate::history::motion::Motion;
use crate::history::patch::Patch;
use crate::history::state::State;
use crate::history::step::Step;
use crate::history::{EnergyBalance, LoadStep, TangentialStep};
use crate::report::Report;
use crate::stage::Observer;
use crate::tangential::TangentialLoad;
use crate::window::Window;

/// Tractions on the window of the contact, which is made wider when the contact leaves it.
#[derive(Debug, Clone)]
pub(super) struct Shear {
    bodies: HalfSpace,
    /// On the window of the [`Memory`] in the state, if there is one.
    patch: Option<Patch>,
    /// What takes the place of both if the step under way, which needs a wider window, succeeds.
    wider: Option<(Patch, Memory)>,
    /// Motion at the end of the step under way.
    motion: Motion,
    report: Report,
}

impl Shear {
    pub(super) fn new(bodies: &HalfSpace) -> Self {
        Self {
            bodies: bodies.clone(),
            patch: None,
            wider: None,
            motion: Motion::default(),
            report: Report::with_room(),
        }
    }

    /// Goes on from a state: in the buffers there are, if they are of its window and model.
    pub(super) fn resume(&mut self, state: &State) -> Result<()> {
        let fits = match (&self.patch, &state.contact) {
            (None, None) => true,
            (Some(patch), Some(memory)) => {
                patch.window == memory.window && patch.layout().axes == axes_of(state.axis)
            }
            _ => false,
        };
        if !fits {
            let make = |memory: &Memory| Patch::new(&self.bodies, state.axis, memory.window);
            self.patch = state.contact.as_ref().map(make).transpose()?;
        }
        Ok(())
    }

    /// Takes the pressure of the step and what friction makes of it.
    pub(super) fn prepare(&mut self, pressure: &Field, state: &State) -> Result<()> {
        let samples = pressure.as_slice();
        let contact = Window::around(pressure.grid(), |i| samples[i] > 0.0);
        if let Some(contact) = contact.map(|window| self.bodies.confined(window)) {
            self.wider = match self.patch.as_ref().zip(state.contact.as_ref()) {
                None => {
                    let (grid, axis) = (pressure.grid(), state.axis);
                    let patch = Patch::new(&self.bodies, axis, contact)?;
                    Some((patch, Memory::first(grid, axis, contact, state.motion)))
                }
                Some((patch, memory)) if !patch.window.covers(contact) => {
                    Some(patch.widened(memory, &self.bodies, contact, state)?)
                }
                Some(_) => None,
            };
        }
        let wider = self.wider.as_mut().map(|(patch, _)| patch);
        if let Some(patch) = wider.or(self.patch.as_mut()) {
            patch.set_limits(pressure, &state.friction);
        }
        Ok(())
    }

    /// Finds traction and motion at the end of the step.
    pub(super) fn solve(
        &mut self,
        load: &LoadStep,
        state: &State,
        observer: Observer<'_>,
    ) -> Result<()> {
        let cell_area = self.bodies.grid().cell_area();
        self.report.clone_from(&Report::unsolved());
        let mut motion = state.motion;
        motion.twist = load.twist_from(motion.twist);
        let under_way = match &mut self.wider {
            Some((patch, memory)) => Some((patch, &*memory)),
            None => self.patch.as_mut().zip(state.contact.as_ref()),
        };
        let Some((patch, memory)) = under_way else {
            for axis in axes_of(state.axis) {
                let shift = &mut motion.shift[axis.index()];
                *shift = shift_without_contact(load.along(*axis), *shift)?;
            }
            self.motion = motion;
            return Ok(());
        };

        let axes = patch.layout().axes;
        let mut force = [0.0; 2];
        for axis in axes {
            if let TangentialStep::Force(value) = load.along(*axis) {
                force[axis.index()] = value;
            }
        }
        let limits = &patch.limits;
        limits.check(TangentialLoad::Force(force), cell_area)?;
        let (sums, datum) = (
            limits.totals(force, cell_area),
            patch.datum(memory, state, motion.twist),
        );
        let (mut totals, mut compliance) = ([None; 2], [0.0; 2]);
        for axis in axes {
            let component = axis.index();
            let shift = &mut motion.shift[component];
            match load.along(*axis) {
                TangentialStep::Shift(prescribed) => *shift = prescribed,
                // Where nothing can be carried the shift is free, and stays.
                TangentialStep::Force(_) if limits.sum > 0.0 => {
                    (*shift, totals[component]) = (datum[component], Some(sums[component]));
                }
                TangentialStep::Hold | TangentialStep::Force(_) => {}
                TangentialStep::Spring {
                    position,
                    stiffness,
                } => {
                    let quantity = "cell area over the stiffness of the spring";
                    let softness = finite(quantity, cell_area / stiffness)?;
                    (*shift, compliance[component]) = (position, softness);
                }
            }
        }
        patch.pose(memory, state, motion, compliance);
        let Patch {
            engine,
            limits,
            next,
            ..
        } = patch;
        engine.minimise(
            &limits.cells,
            totals,
            &state.settings,
            observer,
            next,
            &mut self.report,
        )?;
        let beyond = engine.multiplier();
        motion.shift = [0, 1].map(|axis| motion.shift[axis] + beyond[axis]);
        self.motion = motion;
        Ok(())
    }

    /// Makes the step part of the state and writes down what it did.
    pub(super) fn commit(&mut self, state: &mut State, step: &mut Step) {
        if let Some((patch, memory)) = self.wider.take() {
            (self.patch, state.contact) = (Some(patch), Some(memory));
        }
        let (before, force, moment) = (state.motion, state.force, state.moment);
        step.tangential_report.clone_from(&self.report);
        (step.stick_cells, step.slip_cells) = (0, 0);
        step.energy = EnergyBalance::default();
        state.motion = self.motion;
        // Out of the state and back, so that both can be written.
        let mut contact = state.contact.take();
        if let Some((patch, memory)) = self.patch.as_mut().zip(contact.as_mut()) {
            patch.commit(before, memory, state, step);
        }
        state.contact = contact;
        let change = state.motion.since(before);
        let shifted: f64 = (0..2)
            .map(|axis| 0.5 * (force[axis] + state.force[axis]) * change.shift[axis])
            .sum();
        step.energy.work = shifted + 0.5 * (moment + state.moment) * change.twist;
        (step.force, step.moment) = (state.force, state.moment);
        (step.shift, step.twist) = (state.motion.shift, state.motion.twist);
        state.steps += 1;
    }

    /// Forgets the step under way.
    pub(super) fn abandon(&mut self) {
        self.wider = None;
    }
}

/// Before anything has touched no force can act, and the shift is that of the machine.
fn shift_without_contact(step: TangentialStep, last: f64) -> Result<f64> {
    match step {
        TangentialStep::Force(force) if force != 0.0 => Err(Error::BeyondSliding {
            force: force.abs(),
            limit: 0.0,
        }),
        TangentialStep::Force(_) | TangentialStep::Hold => Ok(last),
        TangentialStep::Shift(shift) => Ok(shift),
        TangentialStep::Spring { position, .. } => Ok(position),
    }
}
