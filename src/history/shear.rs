//! The tangential half of a step, for tractions along one axis or both in the plane.
//!
//! The seam to the rest of the history is four calls: [`Shear::prepare`] with the pressure of the step,
//! [`Shear::solve`], then [`Shear::commit`], or [`Shear::abandon`] to leave no trace.

use crate::cgm::Settings;
use crate::error::{Error, Result, finite};
use crate::field::Field;
use crate::half_space::HalfSpace;
use crate::history::layout::axes_of;
use crate::history::motion::Motion;
use crate::history::patch::Patch;
use crate::history::state::State;
use crate::history::step::Step;
use crate::history::{EnergyBalance, LoadStep, TangentialStep};
use crate::report::Report;
use crate::stage::Observer;
use crate::tangential::{Axis, Friction, TangentialLoad};
use crate::window::Window;

/// Tractions on the window of the contact, which is made wider when the contact leaves it.
#[derive(Debug, Clone)]
pub(super) struct Shear {
    bodies: HalfSpace,
    /// The axis of the scalar model, `None` in that of the plane.
    axis: Option<Axis>,
    pub(super) patch: Option<Patch>,
    /// The patch of the step under way, where that needs a wider one.
    wider: Option<Patch>,
    /// Motion at the end of the step under way.
    motion: Motion,
    report: Report,
}

impl Shear {
    pub(super) fn new(bodies: &HalfSpace, axis: Option<Axis>) -> Self {
        Self {
            bodies: bodies.clone(),
            axis,
            patch: None,
            wider: None,
            motion: Motion::default(),
            report: Report::with_room(),
        }
    }

    pub(super) fn axis(&self) -> Option<Axis> {
        self.axis
    }

    /// Takes the pressure of the step and what friction makes of it.
    pub(super) fn prepare(
        &mut self,
        pressure: &Field,
        friction: &Friction,
        state: &State,
    ) -> Result<()> {
        let samples = pressure.as_slice();
        let contact = Window::around(pressure.grid(), |i| samples[i] > 0.0);
        if let Some(contact) = contact.map(|window| self.bodies.confined(window)) {
            self.wider = match &self.patch {
                None => Some(Patch::first(&self.bodies, self.axis, contact, state)?),
                Some(patch) if !patch.window.covers(contact) => {
                    Some(patch.widened(&self.bodies, self.axis, contact, state)?)
                }
                Some(_) => None,
            };
        }
        if let Some(patch) = self.wider.as_mut().or(self.patch.as_mut()) {
            patch.set_limits(pressure, friction);
        }
        Ok(())
    }

    /// Finds traction and motion at the end of the step.
    pub(super) fn solve(
        &mut self,
        load: &LoadStep,
        state: &State,
        settings: &Settings,
        observer: Observer<'_>,
    ) -> Result<()> {
        let cell_area = self.bodies.grid().cell_area();
        self.report.clone_from(&Report::unsolved());
        let mut motion = state.motion;
        motion.twist = load.twist_from(motion.twist);
        let Some(patch) = self.wider.as_mut().or(self.patch.as_mut()) else {
            for axis in axes_of(self.axis) {
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
            patch.datum(state, motion.twist),
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
        patch.pose(state, motion, compliance);
        let Patch {
            engine,
            limits,
            next,
            ..
        } = patch;
        engine.minimise(
            &limits.cells,
            totals,
            settings,
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
        if let Some(wider) = self.wider.take() {
            self.patch = Some(wider);
        }
        let (before, force, moment) = (state.motion, state.force, state.moment);
        step.tangential_report.clone_from(&self.report);
        (step.stick_cells, step.slip_cells) = (0, 0);
        step.energy = EnergyBalance::default();
        state.motion = self.motion;
        if let Some(patch) = &mut self.patch {
            patch.commit(before, state, step);
        }
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
