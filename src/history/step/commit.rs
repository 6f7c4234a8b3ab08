//! Commit of a solved step to the state and the results.

use std::ops::Range;

use crate::cgm::reduce::Reduction;
use crate::grid::field::Field;
use crate::history::state::State;
use crate::history::state::mark::StateMark;
use crate::history::state::memory::Memory;
use crate::history::state::permanent_set::update_permanent_set;
use crate::history::state::window_shrinking::narrow;
use crate::history::step::diagnostics::{GapDiagnostics, StepDiagnostics};
use crate::history::step::solve::StepInput;
use crate::history::{EnergyBalance, History, StepResult};
use crate::normal::{NormalControl, NormalSolution};
use crate::numerics::cell_vector::{dot, length, minus, plus, slices};
use crate::parallel::Blocks;
use crate::parallel::ranks::WireFormat;
use crate::report::Report;
use crate::rolling::RollingShift;
use crate::tangential::{FrictionScale, RigidMotion, StepSolution, Zone, at};
use crate::warning::{Resolution, Warning};

impl History {
    /// Commits a solved step that ended with this motion to the state, and writes its results.
    pub(in crate::history) fn commit(&mut self, input: &StepInput<'_>, motion: RigidMotion) {
        let Self {
            bodies,
            state,
            step,
            scheme,
            candidate,
            ..
        } = self;
        step.start = Some(StateMark::of(state));
        let (load, control, travel) = (input.load, input.load.normal_control(), &input.travel);
        let (mut pressing, press_window) = (EnergyBalance::default(), state.press_window);
        let is_pressed = candidate.held().is_some();
        let is_worn = is_pressed && state.is_pressure_stale && travel.is_none();
        let gap_change = is_worn.then(|| state.measure_wear(bodies));
        match candidate.held_mut() {
            None if control == NormalControl::Hold => {
                step.normal_report.clone_from(&Report::unsolved());
            }
            None => step.normal_report.recall(state.normal.report()),
            Some(candidate) => {
                if state.is_joint() {
                    let before = (&state.normal, &state.pressed_gap);
                    let (layout, after) = (bodies.grid_layout(), (&*candidate, &state.gap));
                    let place = |i: usize| travel.map_or(Some(i), |travel| travel.before(i));
                    pressing = EnergyBalance::of_pressing(&layout, before, after, place);
                }
                std::mem::swap(&mut state.normal, candidate);
                state.pressed_gap.clone_from(&state.gap);
                state.is_pressure_stale = false;
                state.pressed_by = control;
                state.press_window = scheme.window();
                scheme.write_trend(&mut state.trend);
                step.normal_report.clone_from(state.normal.report());
            }
        }
        step.remarks = StepDiagnostics {
            gap_change: GapDiagnostics::of(state, bodies, gap_change),
            is_pressure_stale: state.is_pressure_stale,
            edge_cells: state.normal.cells_on_edge(),
            is_apart: state.normal.force() <= 0.0,
            overloaded_cells: state.normal.overloaded_cells(),
            neglected_lift: scheme.neglected_lift(),
            is_rolled: travel.is_some(),
            ..StepDiagnostics::default()
        };
        state.is_friction_new = false;
        step.normal_force = state.normal.force();
        step.approach = state.approach();
        let found = scheme.solution();
        let unsolved = Report::unsolved();
        let report = found.map_or(&unsolved, |_| scheme.report());
        step.tangential_report.clone_from(report);
        let capacities = found.and_then(|found| found.capacities(&state.friction));
        step.remarks.friction = FrictionScale::of(bodies, &state.friction, capacities);
        step.remarks.coupling_per_cent =
            found.and_then(|found| found.neglected_traction(bodies, state.coupling));
        let (start, change) = (state.motion, motion.since(state.motion));
        let before = candidate.held().map(NormalSolution::pressure);
        // After a return to an earlier state, the window may differ from the window of the last step.
        let window = found.map(|found| found.region.window());
        if self.written != window {
            step.clear_fields();
            self.written = window;
        }
        let hides_slip = travel.is_none() && hides_slip(found, state, step);
        if let Some(travel) = travel {
            // The trend of the next step describes the tractions of cells, not of particles.
            state.keep_traction(travel, before);
            state.shift_with_particles(travel, motion);
        }
        commit_tractions(found, motion, travel.as_ref(), state, step);
        let rolled = load.rolling().zip(*travel);
        step.creepage =
            rolled.map(|(rolling, travel)| rolling.reached(load, change.shift, travel.length));
        step.remarks.resolution = resolution_of_zones(state, step, hides_slip, travel.is_some());
        if let (Some(before), None) = (before, travel) {
            let layout = bodies.grid_layout();
            step.remarks.is_pressed_at_once = state.has_grown_at_once(before, &layout);
        }
        step.remarks.is_displacement_unused = state.has_unused_displacement(load);
        let displacement_tenths = state.displacement_tenths(bodies, load);
        state.reach(load);
        if is_pressed {
            update_permanent_set(state);
            state.gather_capacity(bodies);
            state.normal.measure_scale(bodies, &state.pressed_gap);
        }
        step.remarks.scale = state.normal.scale();
        step.remarks.hardness_parts = state.normal.low_hardness();
        step.remarks.hardness_per_mille = state.normal.high_hardness();
        step.remarks.has_yielded = state.normal.yielded_cells() > 0;
        if !step.remarks.is_apart {
            step.remarks.strain_per_mille = state.large_strain(bodies, load);
        }
        measure_motion(state, (start, displacement_tenths), &mut step.remarks);
        let contact = (&*bodies, state.normal.pressure());
        let creepage = load.rolling().and_then(|roll| roll.large_creepage(contact));
        step.remarks.creepage_per_cent = creepage;
        step.remarks.lost_per_cent = state.lose_held_force(load);
        step.energy = step.energy.plus(pressing);
        let margins = travel.map_or([0; 2], |travel| travel.margins());
        narrow(bodies, state, before, press_window, margins);
    }
}

/// Adds the diagnostics about the motion in a step, and about the range of the motion if the step is the first one beyond a limit.
/// `displacement_tenths` belongs to the relative displacement.
fn measure_motion(
    state: &mut State,
    (start, displacement_tenths): (RigidMotion, Option<usize>),
    remarks: &mut StepDiagnostics,
) {
    if remarks.ends_motion_range() {
        state.motion_range.restart();
        return;
    }
    let grid = state.grid();
    let before = state.motion_range.tenths(grid);
    state.motion_range.extend(start, state.motion);
    let after = state.motion_range.tenths(grid);
    let [shift, twist] = [0, 1].map(|i| after[i].filter(|_| before[i].is_none()));
    let change = state.motion.since(start);
    let of_step = Warning::shift_beyond(grid, change.shift);
    remarks.shift_tenths = of_step.max(displacement_tenths).max(shift);
    remarks.twist_tenths = Warning::twist_beyond(change.twist).max(twist);
}

/// Returns whether a step has a slip zone inside its outermost cells although no cell slips. The state has the tractions before
/// the step.
fn hides_slip(found: Option<StepSolution<'_>>, state: &State, step: &StepResult) -> bool {
    step.remarks.friction.is_common()
        && found.is_some_and(|found| {
            found.with_held(|found| {
                let held = found.region.held();
                let before = state.traction.each_ref().map(Field::as_slice);
                found.hides_slip(|cell| minus(found.traction(cell), at(&before, held.index(cell))))
            })
        })
}

/// Returns the resolution of the contact and of its stick and slip zones. A rolled contact without slipping cells has almost the
/// forces of full stick, so it hides no slip.
fn resolution_of_zones(
    state: &State,
    step: &StepResult,
    hides_slip: bool,
    is_rolling: bool,
) -> Resolution {
    let zones = [step.stick_cells, step.slip_cells];
    let resolution = Resolution::of_contact(state.grid().whole(), zones[0] + zones[1]).with_zones(
        zones,
        hides_slip,
        || state.normal.edge_sides(),
    );
    if is_rolling {
        resolution.of_rolling()
    } else {
        resolution
    }
}

/// Commits the tractions of a step that ended with `motion` to the state, and writes the results of the cells. `found`
/// is `None` before the first contact. `travel` is the path of rolling bodies.
fn commit_tractions(
    found: Option<StepSolution<'_>>,
    motion: RigidMotion,
    travel: Option<&RollingShift>,
    state: &mut State,
    step: &mut StepResult,
) {
    let (before, force, moment) = (state.motion, state.force, state.moment);
    let change = motion.since(before);
    let back = travel.map_or([0.0; 2], |travel| travel.back);
    (step.stick_cells, step.slip_cells) = (0, 0);
    step.energy = EnergyBalance::default();
    state.motion = motion;
    // The memory is moved out of the state so that both can be written.
    let mut contact = state.contact.take();
    if let Some((found, memory)) = found.zip(contact.as_mut()) {
        found.with_held(|found| enter(found, (before, back), memory, state, step));
        let by = [0, 1].map(|axis| state.force[axis] - force[axis]);
        memory.trend.by = [0, 1].map(|axis| [by[axis], change.shift[axis]]);
    }
    state.contact = contact;
    state.zone_cells = [step.stick_cells, step.slip_cells];
    let shifted: f64 = (0..2)
        .map(|axis| 0.5 * (force[axis] + state.force[axis]) * change.shift[axis])
        .sum();
    // The moment acts about the middle of the path of each particle.
    let [x, y] = [0, 1].map(|axis| state.force[axis] - force[axis]);
    let turned = 0.5 * (moment + state.moment) + 0.25 * (back[0] * y - back[1] * x);
    step.energy.work += shifted + turned * change.twist;
    (step.force, step.moment) = (state.force, state.moment);
    (step.shift, step.twist) = (motion.shift, motion.twist);
    state.steps += 1;
}

/// Commits the local cells of the window in a step from the motion `before` to the motion of the state. `back` is the
/// displacement from a cell to the earlier position of its particle.
fn enter(
    answer: &StepSolution<'_>,
    (before, back): (RigidMotion, [f64; 2]),
    memory: &mut Memory,
    state: &mut State,
    step: &mut StepResult,
) {
    let (grid, held) = (state.grid(), answer.region.held());
    let taken = CommittedStep {
        answer: *answer,
        cell_area: grid.cell_area(),
        change: state.motion.since(before),
        middle: back.map(|back| 0.5 * back),
        is_rolled: back.iter().any(|part| *part != 0.0),
        displacement: slices(&memory.displacement),
    };
    let [qx, qy] = &mut state.traction;
    let [sum_x, sum_y] = &mut state.slip;
    let [slip_x, slip_y] = &mut step.slip;
    let vectors = [[qx, qy], [sum_x, sum_y], [slip_x, slip_y]];
    let numbers = [
        &mut state.accumulated_slip,
        &mut state.dissipated_energy,
        &mut step.slip_distance,
        &mut step.dissipated_energy,
        &mut step.dissipated_energy_midpoint,
    ];
    let vectors = vectors.map(|parts| parts.map(|part| held.lines_of(part.as_mut_slice())));
    let numbers = numbers.map(|field| held.lines_of(field.as_mut_slice()));
    let zones = held.lines_of(&mut state.zones);
    let own = [
        &mut memory.offset,
        &mut memory.trend.change,
        &mut memory.slip,
    ];
    let own = own.map(|parts| parts.each_mut().map(|part| held.lines(part)));
    let columns = &held.ranges()[0];
    let work = |row: usize, (vectors, numbers, (zones, own)): RowParts<'_>| {
        let vectors = vectors.map(|parts| parts.map(|part| cells_of(part.items, columns)));
        let [[qx, qy], accumulated, [slip_x, slip_y]] = vectors;
        let numbers = numbers.map(|part| cells_of(part.items, columns));
        let [path, energy, distance, dissipated, mid_step] = numbers;
        let zones = cells_of(zones.items, columns);
        let [offset, trend, last_slip] = own.map(|parts| parts.map(|part| part.items));
        let [mut offset, [trend_x, trend_y], [last_x, last_y]] = [offset, trend, last_slip];
        if !taken.is_rolled {
            combine(trend_x, qx, |_, before| before);
            combine(trend_y, qy, |_, before| before);
        }
        for part in [&mut *slip_x, slip_y, distance, dissipated, mid_step] {
            part.fill(0.0);
        }
        // Values in a local copy need not be read again after each write.
        let local = taken;
        let mut totals = StepTotals::ZERO;
        let start = row * columns.len();
        let y = grid.y(held.index(start) / grid.nx());
        for own in 0..zones.len() {
            let (k, centre) = (start + own, [grid.x(columns.start + own), y]);
            let relative = local.answer.relative(k, centre);
            let before = [qx[own], qy[own]];
            let is_contact = local.answer.pressure[k] > 0.0;
            if !is_contact && before.iter().all(|q| *q == 0.0) {
                write(&mut offset, own, relative);
                zones[own] = Zone::Separated;
                [qx[own], qy[own]] = [0.0; 2];
                continue;
            }
            let offset_before = at(&offset, own);
            let cell = local.cell((k, centre), (before, offset_before), relative);
            write(&mut offset, own, cell.offset);
            zones[own] = cell.zone;
            [qx[own], qy[own]] = cell.traction;
            if cell.zone == Zone::Slip {
                [slip_x[own], slip_y[own]] = cell.slip;
                distance[own] = length(cell.slip);
                dissipated[own] = cell.energy.dissipated_energy;
                mid_step[own] = cell.energy.dissipated_energy_midpoint;
            }
            totals = Reduction::plus(totals, cell.totals());
        }
        for (trend, traction) in [(trend_x, &*qx), (trend_y, &*qy)] {
            combine(trend, traction, |before, traction| traction - before);
        }
        for (last, slip) in [(last_x, &*slip_x), (last_y, &*slip_y)] {
            combine(last, slip, |_, slip| slip);
        }
        let [sum_x, sum_y] = accumulated;
        let parts = [&*slip_x, &*slip_y, &*distance, &*dissipated];
        for (sum, part) in [sum_x, sum_y, path, energy].into_iter().zip(parts) {
            combine(sum, part, |sum, part| sum + part);
        }
        totals
    };
    let layout = answer.region.held_layout();
    let totals = layout.sweep((vectors, numbers, (zones, own)), work, Reduction::plus);
    let (traction, moment, energy, [stick, slip]) = totals;
    state.force = traction.map(|sum| grid.cell_area() * sum);
    state.moment = grid.cell_area() * moment;
    step.energy = energy;
    (step.stick_cells, step.slip_cells) = (stick, slip);
    for (memory, displacement) in memory.displacement.iter_mut().zip(answer.displacement) {
        memory.copy_from_slice(displacement);
    }
    memory.has_entered = answer.has_entered;
    memory.entered.clear();
    memory.entered.extend_from_slice(answer.entered);
}

/// Returns the cells of a row in these columns. Slices of one length need no bounds check per cell.
fn cells_of<'a, T>(row: &'a mut [T], columns: &Range<usize>) -> &'a mut [T] {
    &mut row[columns.clone()]
}

/// Writes a vector to a cell, for the components that the model includes.
#[inline]
fn write(parts: &mut [&mut [f64]; 2], cell: usize, values: [f64; 2]) {
    for (part, value) in parts.iter_mut().zip(values) {
        if let Some(place) = part.get_mut(cell) {
            *place = value;
        }
    }
}

/// Replaces each value of `to` by `by(value, value of from)`. A component that the model omits has no values.
#[inline]
fn combine(to: &mut [f64], from: &[f64], by: impl Fn(f64, f64) -> f64) {
    for (to, from) in to.iter_mut().zip(from) {
        *to = by(*to, *from);
    }
}

/// Fields of a row that are written. The first group contains traction, accumulated slip and slip. The second group
/// contains accumulated and dissipated quantities. The third group contains zones, offsets, trends and slip of the
/// step.
type RowParts<'a> = (
    [[Blocks<'a, f64>; 2]; 3],
    [Blocks<'a, f64>; 5],
    (Blocks<'a, Zone>, [[Blocks<'a, f64>; 2]; 3]),
);

/// Values of a committed step on which the results of its cells depend.
#[derive(Clone, Copy)]
struct CommittedStep<'a> {
    answer: StepSolution<'a>,
    cell_area: f64,
    /// Motion of body 2 in the step.
    change: RigidMotion,
    /// Vector from a particle to the middle of its path.
    middle: [f64; 2],
    /// Whether the trend of a cell contains its earlier traction.
    is_rolled: bool,
    /// Displacement before the step.
    displacement: [&'a [f64]; 2],
}

impl CommittedStep<'_> {
    /// Computes the result of the step in a cell with this centre, earlier traction and earlier offset. `relative` is
    /// the displacement to the other body.
    #[inline]
    fn cell(
        &self,
        (k, centre): (usize, [f64; 2]),
        (before, offset_before): ([f64; 2], [f64; 2]),
        relative: [f64; 2],
    ) -> CellStep {
        let (answer, cell_area) = (&self.answer, self.cell_area);
        let (traction, u) = (answer.traction(k), answer.displacement(k));
        let is_contact = answer.pressure[k] > 0.0;
        let mean = [0, 1].map(|axis| 0.5 * (before[axis] + traction[axis]));
        let (u_before, offset) = (at(&self.displacement, k), answer.offset(k));
        // Part of the motion that a cell has not followed because it came into contact within the step.
        let lag = minus(offset_before, offset);
        let zone = answer.zone(k);
        let found = match zone {
            Zone::Slip => answer.slip(k, relative),
            Zone::Stick | Zone::Separated => None,
        };
        let slip = found.unwrap_or([0.0; 2]);
        let is_loose = found.is_some() || !is_contact;

        let middle = plus(centre, 1.0, self.middle);
        let followed = minus(self.change.at(middle), lag);
        let stretched = minus(minus(u, u_before), followed);
        let rest = 0.0 - cell_area * dot(mean, minus(stretched, slip));
        let (residual, released) = if is_contact { (rest, 0.0) } else { (0.0, rest) };
        CellStep {
            centre,
            traction,
            slip,
            offset: if is_loose { relative } else { offset },
            zone,
            energy: EnergyBalance {
                work: 0.0 - cell_area * dot(mean, lag),
                elastic_before: 0.5 * cell_area * dot(before, u_before),
                elastic_after: 0.5 * cell_area * dot(traction, u),
                dissipated_energy: 0.0 - cell_area * dot(traction, slip),
                dissipated_energy_midpoint: 0.0 - cell_area * dot(mean, slip),
                released,
                residual,
            },
        }
    }
}

/// Result of a step in a cell.
struct CellStep {
    centre: [f64; 2],
    traction: [f64; 2],
    slip: [f64; 2],
    offset: [f64; 2],
    zone: Zone,
    energy: EnergyBalance,
}

impl CellStep {
    #[inline]
    fn totals(&self) -> StepTotals {
        let [[x, y], [qx, qy]] = [self.centre, self.traction];
        let cells = [Zone::Stick, Zone::Slip].map(|zone| usize::from(self.zone == zone));
        (self.traction, x * qy - y * qx, self.energy, cells)
    }
}

/// Sums over cells: traction, its moment, energies, and the numbers of cells that stick and that slip.
type StepTotals = ([f64; 2], f64, EnergyBalance, [usize; 2]);
