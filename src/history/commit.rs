//! A solved step enters state and account.

use crate::cgm::plane::dot;
use crate::history::memory::Memory;
use crate::history::motion::{Motion, centre};
use crate::history::patch::Patch;
use crate::history::state::State;
use crate::history::step::Step;
use crate::tangential::Zone;

impl Patch {
    /// Enters the solved step, from the motion `before` to that of the state, into memory, state and step.
    pub(super) fn commit(
        &mut self,
        before: Motion,
        memory: &mut Memory,
        state: &mut State,
        step: &mut Step,
    ) {
        let (grid, layout) = (state.grid(), self.layout());
        let cell_area = grid.cell_area();
        let change = state.motion.since(before);
        let (mut sum, mut moment) = ([0.0; 2], 0.0);
        for (k, i) in self.window.indices().enumerate() {
            let centre = centre(grid, i);
            let traction = layout.at(self.engine.traction(), k);
            let before = state.traction.each_ref().map(|field| field.as_slice()[i]);
            let mean = [0, 1].map(|axis| 0.5 * (before[axis] + traction[axis]));
            let (u_before, u) = (layout.at(&memory.displacement, k), layout.at(&self.next, k));
            let relative = difference(u, state.motion.at(centre));
            let moved = difference(relative, layout.at(&memory.offset, k));
            let is_contact = self.pressure[k] > 0.0;
            let sticks = !self.engine.is_at_limit(traction, self.limits.cells[k]);
            // Slip along the traction is none, but what the tolerance leaves.
            let slips = is_contact && !sticks && dot(traction, moved) <= 0.0;
            let slip = if slips { moved } else { [0.0; 2] };
            if slips || !is_contact {
                layout.set(&mut memory.offset, k, relative);
            }
            state.zones[i] = match (is_contact, sticks) {
                (false, _) => Zone::Separate,
                (true, true) => Zone::Stick,
                (true, false) => Zone::Slip,
            };
            step.stick_cells += usize::from(state.zones[i] == Zone::Stick);
            step.slip_cells += usize::from(state.zones[i] == Zone::Slip);

            let dissipated = 0.0 - cell_area * dot(traction, slip);
            let mid_step = 0.0 - cell_area * dot(mean, slip);
            let stretched = difference(difference(u, u_before), change.at(centre));
            let rest = 0.0 - cell_area * dot(mean, difference(stretched, slip));
            let energy = &mut step.energy;
            energy.elastic_before += 0.5 * cell_area * dot(before, u_before);
            energy.elastic_after += 0.5 * cell_area * dot(traction, u);
            energy.dissipated += dissipated;
            energy.dissipated_mid_step += mid_step;
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
            state.slip_path.as_mut_slice()[i] += length;
            state.dissipated.as_mut_slice()[i] += dissipated;
            step.slip_length.as_mut_slice()[i] = length;
            step.dissipation.as_mut_slice()[i] = dissipated;
            step.mid_step_dissipation.as_mut_slice()[i] = mid_step;
        }
        state.force = sum.map(|sum| cell_area * sum);
        state.moment = cell_area * moment;
        std::mem::swap(&mut memory.displacement, &mut self.next);
    }
}

fn difference(a: [f64; 2], b: [f64; 2]) -> [f64; 2] {
    [a[0] - b[0], a[1] - b[1]]
}
