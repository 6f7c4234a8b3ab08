//! The window of the contact, with all that a history keeps there.

use crate::error::Result;
use crate::field::Field;
use crate::half_space::HalfSpace;
use crate::history::spring::Sprung;
use crate::history::state::State;
use crate::history::step::Step;
use crate::operator::Operator;
use crate::stage::Stage;
use crate::tangential::{Axis, Friction, Limits, Zone, component};
use crate::window::Window;

/// The engine on the window of the contact, and the state of the cells there.
#[derive(Debug)]
pub(super) struct Patch {
    pub(super) window: Window,
    pub(super) stage: Stage<Sprung>,
    /// Displacement u after the last step, and after the one under way.
    pub(super) displacement: Vec<f64>,
    pub(super) next: Vec<f64>,
    /// What `u - delta` is in a cell while it sticks: where its last slip has left it or, outside the
    /// contact, where it would touch now.
    pub(super) offset: Vec<f64>,
    pressure: Vec<f64>,
    pub(super) limits: Limits,
}

impl Patch {
    /// At the first touch, of bodies that have no displacement.
    pub(super) fn first(
        bodies: &HalfSpace,
        axis: Axis,
        window: Window,
        state: &State,
    ) -> Result<Self> {
        let cells = window.cells();
        Ok(Self {
            window,
            stage: Stage::with(bodies, component(axis), window.size, Sprung::rigidly)?,
            displacement: vec![0.0; cells],
            next: vec![0.0; cells],
            offset: vec![-state.shift[axis.index()]; cells],
            pressure: vec![0.0; cells],
            limits: Limits::new(cells),
        })
    }

    /// Wide enough for a contact too, and a little wider, so that it may grow some more.
    pub(super) fn widened(
        &self,
        bodies: &HalfSpace,
        axis: Axis,
        contact: Window,
        state: &State,
    ) -> Result<Self> {
        let window = self.window.union(contact.widened(bodies.grid()));
        let mut patch = Self::first(bodies, axis, window, state)?;
        window.gather(state.traction[axis.index()].as_slice(), &mut patch.stage.x);
        let operator = &patch.stage.operator;
        operator.apply(
            &patch.stage.x,
            &mut patch.displacement,
            &mut operator.workspace(),
        );
        for (offset, displacement) in patch.offset.iter_mut().zip(&patch.displacement) {
            *offset += displacement;
        }
        let mut offset = vec![0.0; bodies.grid().cells()];
        window.scatter(&patch.offset, &mut offset);
        for (k, i) in self.window.indices().enumerate() {
            if state.zones[i] != Zone::Separate {
                offset[i] = self.offset[k];
            }
        }
        window.gather(&offset, &mut patch.offset);
        Ok(patch)
    }

    pub(super) fn covers(&self, contact: Window) -> bool {
        self.window.union(contact) == self.window
    }

    pub(super) fn set_limits(&mut self, pressure: &Field, friction: &Friction) {
        self.window.gather(pressure.as_slice(), &mut self.pressure);
        self.limits.set(friction, self.window, &self.pressure);
    }

    /// The motion that would leave the cell of the largest limit without traction: measured from there, a
    /// contact that has nowhere slipped asks for exactly none.
    pub(super) fn datum(&self) -> f64 {
        let cells = self.limits.cells.iter().zip(&self.offset);
        let strongest = cells.max_by(|(a, _), (b, _)| a.total_cmp(b));
        strongest.map_or(0.0, |(_, offset)| -offset)
    }

    /// Poses the problem of a step: from the last traction, with a prescribed motion and the compliance
    /// of a spring.
    pub(super) fn pose(&mut self, traction: &[f64], motion: f64, compliance: f64) {
        self.window.gather(traction, &mut self.stage.x);
        self.stage.operator.compliance = compliance;
        let cells = self.offset.iter().zip(&self.limits.cells);
        for (linear, (offset, &limit)) in self.stage.linear.iter_mut().zip(cells) {
            // What cannot carry traction does not ask for any.
            *linear = if limit > 0.0 { -(offset + motion) } else { 0.0 };
        }
    }

    /// Takes the displacement of the bodies from the engine; returns the stretch of the spring.
    pub(super) fn find_displacement(&mut self) -> f64 {
        let stretch = self.stage.operator.stretch(&self.stage.x);
        for (next, product) in self.next.iter_mut().zip(self.stage.product()) {
            *next = product - stretch;
        }
        stretch
    }

    /// Enters the solved step, in which the shift changed by `change`, into state and step.
    pub(super) fn commit(&mut self, axis: usize, change: f64, state: &mut State, step: &mut Step) {
        let cell_area = step.slip_length.grid().cell_area();
        let shift = state.shift[axis];
        let mut sum = 0.0;
        for (k, i) in self.window.indices().enumerate() {
            let traction = self.stage.x[k];
            let before = state.traction[axis].as_slice()[i];
            let mean = 0.5 * (before + traction);
            let (u_before, u) = (self.displacement[k], self.next[k]);
            let relative = u - shift;
            let is_contact = self.pressure[k] > 0.0;
            let sticks = traction.abs() < self.limits.cells[k];
            // Slip along the traction is none, but what the tolerance leaves.
            let slips = is_contact && !sticks && traction * (relative - self.offset[k]) <= 0.0;
            let slip = if slips {
                relative - self.offset[k]
            } else {
                0.0
            };
            if slips || !is_contact {
                self.offset[k] = relative;
            }
            state.zones[i] = match (is_contact, sticks) {
                (false, _) => Zone::Separate,
                (true, true) => Zone::Stick,
                (true, false) => Zone::Slip,
            };
            step.stick_cells += usize::from(state.zones[i] == Zone::Stick);
            step.slip_cells += usize::from(state.zones[i] == Zone::Slip);

            let dissipated = 0.0 - cell_area * traction * slip;
            let mid_step = 0.0 - cell_area * mean * slip;
            let rest = 0.0 - cell_area * mean * ((u - u_before) - change - slip);
            let energy = &mut step.energy;
            energy.elastic_before += 0.5 * cell_area * before * u_before;
            energy.elastic_after += 0.5 * cell_area * traction * u;
            energy.dissipated += dissipated;
            energy.dissipated_mid_step += mid_step;
            *(if is_contact {
                &mut energy.residual
            } else {
                &mut energy.released
            }) += rest;

            sum += traction;
            state.traction[axis].as_mut_slice()[i] = traction;
            state.slip[axis].as_mut_slice()[i] += slip;
            state.slip_path.as_mut_slice()[i] += slip.abs();
            state.dissipated.as_mut_slice()[i] += dissipated;
            step.slip[axis].as_mut_slice()[i] = slip;
            step.slip_length.as_mut_slice()[i] = slip.abs();
            step.dissipation.as_mut_slice()[i] = dissipated;
            step.mid_step_dissipation.as_mut_slice()[i] = mid_step;
        }
        state.force[axis] = cell_area * sum;
        std::mem::swap(&mut self.displacement, &mut self.next);
    }
}
