//! The tangential half of a step, for tractions along one axis.
//!
//! The seam to the rest of the history is four calls: [`Shear::prepare`] with the pressure of the step,
//! [`Shear::solve`], then [`Shear::commit`], or [`Shear::abandon`] to leave no trace.

use std::time::Instant;

use crate::cgm::{self, Magnitude, Settings};
use crate::error::{Error, Result};
use crate::field::Field;
use crate::half_space::HalfSpace;
use crate::history::patch::Patch;
use crate::history::state::State;
use crate::history::step::Step;
use crate::history::{EnergyBalance, TangentialStep};
use crate::operator::Operator;
use crate::report::Report;
use crate::stage::{Observer, with_time_left};
use crate::tangential::{Axis, Friction, TangentialLoad};
use crate::window::Window;

/// Tractions along one axis on the window of the contact, which is made wider when the contact leaves it.
#[derive(Debug)]
pub(super) struct Shear {
    bodies: HalfSpace,
    axis: Axis,
    pub(super) patch: Option<Patch>,
    /// The patch of the step under way, where that needs a wider one.
    wider: Option<Patch>,
    /// Shift at the end of the step under way.
    shift: f64,
    report: Report,
}

impl Shear {
    pub(super) fn new(bodies: &HalfSpace, axis: Axis) -> Self {
        Self {
            bodies: bodies.clone(),
            axis,
            patch: None,
            wider: None,
            shift: 0.0,
            report: Report::unsolved(),
        }
    }

    pub(super) fn axis(&self) -> Axis {
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
        if let Ok(contact) = contact.map(|window| self.bodies.confined(window)) {
            self.wider = match &self.patch {
                None => Some(Patch::first(&self.bodies, self.axis, contact, state)?),
                Some(patch) if !patch.covers(contact) => {
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

    /// Finds traction and shift at the end of the step.
    pub(super) fn solve(
        &mut self,
        step: TangentialStep,
        state: &State,
        settings: &Settings,
        observer: Observer<'_>,
    ) -> Result<()> {
        let cell_area = self.bodies.grid().cell_area();
        let axis = self.axis.index();
        let (last, traction) = (state.shift[axis], state.traction[axis].as_slice());
        self.report.clone_from(&Report::unsolved());
        let Some(patch) = self.wider.as_mut().or(self.patch.as_mut()) else {
            self.shift = shift_without_contact(step, last)?;
            return Ok(());
        };

        let limits = &patch.limits;
        let (mut origin, mut total, mut compliance) = (last, None, 0.0);
        match step {
            TangentialStep::Hold => {}
            TangentialStep::Shift(shift) => origin = shift,
            TangentialStep::Force(force) => {
                limits.check(TangentialLoad::Force([force, 0.0]), cell_area)?;
                // Where nothing can be carried the shift is free, and stays.
                if limits.sum > 0.0 {
                    (origin, total) = (
                        patch.datum(),
                        Some(limits.totals([force, 0.0], cell_area)[0]),
                    );
                }
            }
            TangentialStep::Spring {
                position,
                stiffness,
            } => (origin, compliance) = (position, cell_area / stiffness),
        }
        patch.pose(traction, origin, compliance);
        minimise(patch, total, settings, observer, &mut self.report)?;
        let stretch = patch.stage.operator.stretch(&patch.stage.x);
        self.shift = origin + patch.stage.multiplier() - stretch;
        Ok(())
    }

    /// Makes the step part of the state and writes down what it did.
    pub(super) fn commit(&mut self, state: &mut State, step: &mut Step) {
        if let Some(wider) = self.wider.take() {
            self.patch = Some(wider);
        }
        let axis = self.axis.index();
        let change = self.shift - state.shift[axis];
        let force = state.force[axis];
        step.tangential_report.clone_from(&self.report);
        (step.stick_cells, step.slip_cells) = (0, 0);
        step.energy = EnergyBalance::default();
        state.shift[axis] = self.shift;
        if let Some(patch) = &mut self.patch {
            patch.commit(axis, change, state, step);
        }
        step.energy.work = 0.5 * (force + state.force[axis]) * change;
        (step.force, step.shift) = (state.force, state.shift);
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

/// Solves on the patch, and again more closely while errors measured by the displacement of the bodies
/// alone are too large: the engine's measure holds the stretch of a spring too, which may be far more.
fn minimise(
    patch: &mut Patch,
    total: Option<f64>,
    settings: &Settings,
    observer: Observer<'_>,
    report: &mut Report,
) -> Result<()> {
    let start = Instant::now();
    let (mut aim, mut earlier) = (settings.tolerance, [0; 3]);
    loop {
        let left = with_time_left(settings, start).tolerance(aim);
        let constraint = Magnitude(&patch.limits.cells);
        let stage = &mut patch.stage;
        let outcome = stage.minimise(constraint, total, &left, observer);
        if !matches!(outcome, Ok(()) | Err(Error::NotConverged(_))) {
            return outcome;
        }
        report.clone_from(stage.report());
        report.iterations += earlier[0];
        report.convolutions += earlier[1];
        report.rough_convolutions += earlier[2];
        report.time = start.elapsed();
        if outcome.is_err() {
            return Err(Error::NotConverged(Box::new(report.clone())));
        }
        let stretch = patch.find_displacement();
        if patch.stage.operator.compliance == 0.0 {
            return Ok(());
        }
        let findings = cgm::examine(
            &patch.stage.x,
            &patch.next,
            &patch.stage.linear,
            &Magnitude(&patch.limits.cells),
            None,
            -stretch,
            patch.stage.operator.lower_bound(),
        );
        findings.write_to(report);
        if report.is_within(settings.tolerance) {
            return Ok(());
        }
        aim *= 0.1;
        earlier = [
            report.iterations,
            report.convolutions,
            report.rough_convolutions,
        ];
    }
}
