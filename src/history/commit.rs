//! A solved step enters state and account.

use crate::cgm::vector::{dot, minus};
use crate::history::EnergyBalance;
use crate::history::memory::Memory;
use crate::history::state::State;
use crate::history::step::StepResult;
use crate::tangential::{Answer, Motion, Zone, centre};

/// Makes a step that ended with the motion part of the state, and writes down what it did.
pub(super) fn commit(
    answer: Option<&Answer<'_>>,
    motion: Motion,
    state: &mut State,
    step: &mut StepResult,
) {
    let (before, force, moment) = (state.motion, state.force, state.moment);
    (step.stick_cells, step.slip_cells) = (0, 0);
    step.energy = EnergyBalance::default();
    state.motion = motion;
    // Out of the state and back, so that both can be written.
    let mut contact = state.contact.take();
    if let Some((answer, memory)) = answer.zip(contact.as_mut()) {
        enter(answer, before, memory, state, step);
    }
    state.contact = contact;
    let change = motion.since(before);
    let shifted: f64 = (0..2)
        .map(|axis| 0.5 * (force[axis] + state.force[axis]) * change.shift[axis])
        .sum();
    step.energy.work += shifted + 0.5 * (moment + state.moment) * change.twist;
    (step.force, step.moment) = (state.force, state.moment);
    (step.shift, step.twist) = (motion.shift, motion.twist);
    state.steps += 1;
}

/// Enters the cells of the window, whose step led from the motion `before` to that of the state.
fn enter(
    answer: &Answer<'_>,
    before: Motion,
    memory: &mut Memory,
    state: &mut State,
    step: &mut StepResult,
) {
    let (grid, pressed) = (state.grid(), answer.pressed);
    let cell_area = grid.cell_area();
    let change = state.motion.since(before);
    let (mut sum, mut moment) = ([0.0; 2], 0.0);
    for (k, i) in pressed.window.indices().enumerate() {
        let centre = centre(grid, i);
        let (traction, u) = (answer.traction(k), answer.displacement(k));
        let before = state.traction.each_ref().map(|field| field.as_slice()[i]);
        let mean = [0, 1].map(|axis| 0.5 * (before[axis] + traction[axis]));
        let (u_before, offset) = (memory.displacement(k), answer.offset(k));
        // What a cell that came into contact was spared of the motion of the step.
        let lag = minus(memory.offset(k), offset);
        let relative = minus(u, state.motion.at(centre));
        let is_contact = pressed.pressure[k] > 0.0;
        let sticks = !answer.is_at_limit(k);
        let found = answer.slip(k, centre).filter(|_| is_contact);
        let slip = found.unwrap_or([0.0; 2]);
        let is_loose = found.is_some() || !is_contact;
        memory.set_offset(k, if is_loose { relative } else { offset });
        state.zones[i] = match (is_contact, sticks) {
            (false, _) => Zone::Separated,
            (true, true) => Zone::Stick,
            (true, false) => Zone::Slip,
        };
        step.stick_cells += usize::from(state.zones[i] == Zone::Stick);
        step.slip_cells += usize::from(state.zones[i] == Zone::Slip);

        let dissipated = 0.0 - cell_area * dot(traction, slip);
        let mid_step = 0.0 - cell_area * dot(mean, slip);
        let followed = minus(change.at(centre), lag);
        let stretched = minus(minus(u, u_before), followed);
        let rest = 0.0 - cell_area * dot(mean, minus(stretched, slip));
        let energy = &mut step.energy;
        energy.work -= cell_area * dot(mean, lag);
        energy.elastic_before += 0.5 * cell_area * dot(before, u_before);
        energy.elastic_after += 0.5 * cell_area * dot(traction, u);
        energy.dissipated_energy += dissipated;
        energy.mid_step_dissipated_energy += mid_step;
        *(if is_contact {
            &mut energy.residual
        } else {
            &mut energy.released
        }) += rest;

        let length = slip[0].hypot(slip[1]);
        for axis in 0..2 {
            sum[axis] += traction[axis];
            state.traction[axis].as_mut_slice()[i] = traction[axis];
            state.slip[axis].as_mut_slice()[i] += slip[axis];
            step.slip[axis].as_mut_slice()[i] = slip[axis];
        }
        moment += centre[0] * traction[1] - centre[1] * traction[0];
        state.accumulated_slip.as_mut_slice()[i] += length;
        state.dissipated_energy.as_mut_slice()[i] += dissipated;
        step.slip_distance.as_mut_slice()[i] = length;
        step.dissipated_energy.as_mut_slice()[i] = dissipated;
        step.mid_step_dissipated_energy.as_mut_slice()[i] = mid_step;
    }
    state.force = sum.map(|sum| cell_area * sum);
    state.moment = cell_area * moment;
    for (memory, displacement) in memory.displacement.iter_mut().zip(answer.displacement) {
        memory.copy_from_slice(displacement);
    }
}
