//! Equality of states.

use crate::history::state::State;
use crate::history::state::memory::Memory;
use crate::history::state::relative_displacement::RelativeDisplacementState;

/// Two states are equal if they describe the same contact, so that the same next step gives the same results.
///
/// The comparison includes grid, boundary, materials, model, settings, friction, loads, all fields, and the start of the
/// next solve. It excludes the report of the pressure and its warnings. All values of a state are finite, so a state
/// equals itself and its [saved bytes](State::to_bytes).
impl PartialEq for State {
    fn eq(&self, other: &Self) -> bool {
        let Self {
            axes,
            settings,
            friction,
            gap,
            hardness,
            yielded,
            relative,
            normal,
            pressed_gap,
            is_pressure_stale,
            is_friction_new,
            pressed_by,
            press_window,
            trend,
            contact,
            traction,
            slip,
            accumulated_slip,
            dissipated_energy,
            zones,
            motion,
            motion_range: _,
            force,
            held_force,
            moment,
            steps,
            entry_rule,
            coupling,
            capacity: _,
            zone_cells: _,
            origin: _,
        } = self;
        *axes == other.axes
            && *settings == other.settings
            && *steps == other.steps
            && *entry_rule == other.entry_rule
            && *coupling == other.coupling
            && *pressed_by == other.pressed_by
            && *is_pressure_stale == other.is_pressure_stale
            && *is_friction_new == other.is_friction_new
            && *press_window == other.press_window
            && *motion == other.motion
            && *force == other.force
            && *held_force == other.held_force
            && *moment == other.moment
            && normal.eq_contact(&other.normal)
            && *friction == other.friction
            && *hardness == other.hardness
            && *gap == other.gap
            && *pressed_gap == other.pressed_gap
            && *yielded == other.yielded
            && *relative == other.relative
            && *trend == other.trend
            && *traction == other.traction
            && *slip == other.slip
            && *accumulated_slip == other.accumulated_slip
            && *dissipated_energy == other.dissipated_energy
            && *zones == other.zones
            && *contact == other.contact
    }
}

impl PartialEq for Memory {
    fn eq(&self, other: &Self) -> bool {
        let Self {
            window,
            displacement,
            offset,
            trend,
            slip,
            entered,
            has_entered,
        } = self;
        *window == other.window
            && *displacement == other.displacement
            && *offset == other.offset
            && *trend == other.trend
            && *slip == other.slip
            && *has_entered == other.has_entered
            && (!has_entered || *entered == other.entered)
    }
}

impl PartialEq for RelativeDisplacementState {
    fn eq(&self, other: &Self) -> bool {
        let Self {
            pattern,
            amount,
            reached,
        } = self;
        *pattern == other.pattern && *amount == other.amount && *reached == other.reached
    }
}
