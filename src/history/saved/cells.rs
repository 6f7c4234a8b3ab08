//! Values per cell of a saved state: their order, their rules, and access to them.

use super::codec::{Codec, FINITE, NOT_NEGATIVE, NumberRule, Reader, Writer};
use crate::contact::LoadTrend;
use crate::error::{Error, Result};
use crate::grid::Grid;
use crate::grid::field::Field;
use crate::grid::per_cell::PerCell;
use crate::grid::window::Window;
use crate::history::state::State;
use crate::history::state::memory::Memory;
use crate::history::state::relative_displacement::RelativeDisplacementState;
use crate::memory::fallible;
use crate::normal::Hardness;
use crate::tangential::{Axis, Friction, RelativeDisplacement, Zone};

/// Quantity that a state stores for each cell of the grid, or for each cell of a window.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum CellQuantity {
    Gap,
    PressedGap,
    Pressure,
    GapUnderLoad,
    Friction,
    Hardness,
    PermanentSet,
    Pattern(Axis),
    Reached(Axis),
    Traction(Axis),
    Slip(Axis),
    AccumulatedSlip,
    DissipatedEnergy,
    PressureChange,
    Displacement(Axis),
    Offset(Axis),
    TractionChange(Axis),
    LastSlip(Axis),
    EntryCompliance,
}

use CellQuantity as Of;

impl CellQuantity {
    /// Returns the name of the quantity in errors, and the rule for its values.
    fn rule(self) -> (&'static str, NumberRule) {
        match self {
            Of::Gap => ("gap", FINITE),
            Of::PressedGap => ("gap of the pressure", FINITE),
            Of::Pressure => ("pressure", NOT_NEGATIVE),
            Of::GapUnderLoad => ("gap under load", FINITE),
            Of::Friction => ("coefficient of friction", NOT_NEGATIVE),
            Of::Hardness => ("hardness", NOT_NEGATIVE),
            Of::PermanentSet => ("permanent set", NOT_NEGATIVE),
            Of::Pattern(_) | Of::Reached(_) => ("relative displacement", FINITE),
            Of::Traction(_) => ("traction", FINITE),
            Of::Slip(_) => ("slip", FINITE),
            Of::AccumulatedSlip => ("accumulated slip", NOT_NEGATIVE),
            Of::DissipatedEnergy => ("dissipated energy", NOT_NEGATIVE),
            Of::PressureChange => ("change of the pressure", FINITE),
            Of::Displacement(_) => ("displacement", FINITE),
            Of::Offset(_) => ("offset", FINITE),
            Of::TractionChange(_) => ("change of the traction", FINITE),
            Of::LastSlip(_) => ("slip of the last step", FINITE),
            Of::EntryCompliance => ("compliance of cells that came into contact", NOT_NEGATIVE),
        }
    }
}

const ZONES: [Zone; 3] = [Zone::Separated, Zone::Stick, Zone::Slip];

impl State {
    /// Returns the quantities of the state in the order in which they are saved. A changed gap is the gap of the next
    /// pressure, which differs from the gap of the present pressure.
    pub(super) fn cell_quantities(&self, is_gap_changed: bool) -> Vec<CellQuantity> {
        let mut quantities = vec![Of::Gap];
        let mut add = |is_there: bool, quantity| {
            if is_there {
                quantities.push(quantity);
            }
        };
        add(is_gap_changed, Of::PressedGap);
        add(true, Of::Pressure);
        add(true, Of::GapUnderLoad);
        add(
            matches!(self.friction.coefficients(), PerCell::Cells(_)),
            Of::Friction,
        );
        let hardness = self.hardness.as_ref();
        add(
            hardness.is_some_and(|hardness| matches!(hardness.limits(), PerCell::Cells(_))),
            Of::Hardness,
        );
        add(self.yielded.is_some(), Of::PermanentSet);
        for quantity in [Of::Pattern, Of::Reached] {
            for axis in Axis::BOTH {
                add(self.relative.is_some(), quantity(*axis));
            }
        }
        for quantity in [Of::Traction, Of::Slip] {
            for axis in self.axes {
                add(true, quantity(*axis));
            }
        }
        add(true, Of::AccumulatedSlip);
        add(true, Of::DissipatedEnergy);
        add(
            self.press_window.is_some() && self.trend.is_known(),
            Of::PressureChange,
        );
        if let Some(memory) = &self.contact {
            let (has_trend, has_slip) = (!self.is_joint(), self.axes == Axis::BOTH);
            for (quantity, is_there) in [
                (Of::Displacement as fn(Axis) -> _, true),
                (Of::Offset, true),
                (Of::TractionChange, has_trend),
                (Of::LastSlip, has_slip),
            ] {
                for axis in self.axes {
                    add(is_there, quantity(*axis));
                }
            }
            add(memory.has_entered, Of::EntryCompliance);
        }
        quantities
    }

    /// Returns the window whose local cells have values of the quantity.
    pub(super) fn window_of(&self, quantity: CellQuantity) -> Window {
        let window = match quantity {
            Of::PressureChange => self.press_window,
            Of::Displacement(_)
            | Of::Offset(_)
            | Of::TractionChange(_)
            | Of::LastSlip(_)
            | Of::EntryCompliance => self.contact.as_ref().map(|memory| memory.window),
            _ => None,
        };
        window.unwrap_or_else(|| Window::whole(self.grid()))
    }

    /// Returns the values of a quantity. They are empty if the state does not store the quantity.
    pub(super) fn values(&self, quantity: CellQuantity) -> &[f64] {
        let relative = self.relative.as_ref();
        let field = match quantity {
            Of::Gap => Some(&self.gap),
            Of::PressedGap => Some(&self.pressed_gap),
            Of::Pressure => Some(self.normal.pressure()),
            Of::GapUnderLoad => Some(self.normal.gap()),
            Of::Friction => return slice_of(self.friction.coefficients()),
            Of::Hardness => {
                let hardness = self.hardness.as_ref();
                return hardness.map_or(&[], |all| slice_of(all.limits()));
            }
            Of::PermanentSet => self.yielded.as_ref(),
            Of::Pattern(axis) => relative.map(|all| all.pattern.fields()[axis.index()]),
            Of::Reached(axis) => relative.map(|all| all.reached.fields()[axis.index()]),
            Of::Traction(axis) => Some(&self.traction[axis.index()]),
            Of::Slip(axis) => Some(&self.slip[axis.index()]),
            Of::AccumulatedSlip => Some(&self.accumulated_slip),
            Of::DissipatedEnergy => Some(&self.dissipated_energy),
            Of::PressureChange => return &self.trend.change[0],
            Of::Displacement(axis) => return self.memory(|all| &all.displacement[axis.index()]),
            Of::Offset(axis) => return self.memory(|all| &all.offset[axis.index()]),
            Of::TractionChange(axis) => return self.memory(|all| &all.trend.change[axis.index()]),
            Of::LastSlip(axis) => return self.memory(|all| &all.slip[axis.index()]),
            Of::EntryCompliance => return self.memory(|all| &all.entered),
        };
        field.map_or(&[], Field::as_slice)
    }

    fn memory(&self, part: impl FnOnce(&Memory) -> &Vec<f64>) -> &[f64] {
        self.contact.as_ref().map_or(&[], |memory| part(memory))
    }

    /// Returns mutable access to the values that [`State::values`] returns.
    pub(super) fn values_mut(&mut self, quantity: CellQuantity) -> &mut [f64] {
        let (pressure, under_load, ..) = self.normal.parts_mut();
        let (relative, contact) = (self.relative.as_mut(), self.contact.as_mut());
        let field = match quantity {
            Of::Gap => Some(&mut self.gap),
            Of::PressedGap => Some(&mut self.pressed_gap),
            Of::Pressure => Some(pressure),
            Of::GapUnderLoad => Some(under_load),
            Of::Friction => field_of(self.friction.parts_mut().0),
            Of::Hardness => {
                let hardness = self.hardness.as_mut();
                hardness.and_then(|all| field_of(all.limit_mut()))
            }
            Of::PermanentSet => self.yielded.as_mut(),
            Of::Pattern(axis) => relative.map(|all| along(axis, &mut all.pattern)),
            Of::Reached(axis) => relative.map(|all| along(axis, &mut all.reached)),
            Of::Traction(axis) => Some(&mut self.traction[axis.index()]),
            Of::Slip(axis) => Some(&mut self.slip[axis.index()]),
            Of::AccumulatedSlip => Some(&mut self.accumulated_slip),
            Of::DissipatedEnergy => Some(&mut self.dissipated_energy),
            Of::PressureChange => return &mut self.trend.change[0],
            Of::Displacement(axis) => {
                return part_of(contact, |all| &mut all.displacement[axis.index()]);
            }
            Of::Offset(axis) => return part_of(contact, |all| &mut all.offset[axis.index()]),
            Of::TractionChange(axis) => {
                return part_of(contact, |all| &mut all.trend.change[axis.index()]);
            }
            Of::LastSlip(axis) => return part_of(contact, |all| &mut all.slip[axis.index()]),
            Of::EntryCompliance => return part_of(contact, |all| &mut all.entered),
        };
        field.map_or(&mut [], Field::as_mut_slice)
    }
}

fn slice_of(quantity: PerCell<&[f64]>) -> &[f64] {
    match quantity {
        PerCell::Uniform(_) => &[],
        PerCell::Cells(cells) => cells,
    }
}

fn field_of(quantity: &mut PerCell<Field>) -> Option<&mut Field> {
    match quantity {
        PerCell::Uniform(_) => None,
        PerCell::Cells(field) => Some(field),
    }
}

fn along(axis: Axis, displacement: &mut RelativeDisplacement) -> &mut Field {
    let [along_x, along_y] = displacement.fields_mut();
    match axis {
        Axis::X => along_x,
        Axis::Y => along_y,
    }
}

fn part_of(
    memory: Option<&mut Memory>,
    part: impl FnOnce(&mut Memory) -> &mut Vec<f64>,
) -> &mut [f64] {
    memory.map_or(&mut [], |memory| part(memory))
}

impl State {
    /// Returns the state with zero values on another part of the grid. Numbers outside the cells are copied.
    pub(super) fn outline_on(&self, grid: Grid) -> Result<Self> {
        let zeros = || Field::try_zeros(grid);
        let both = || Ok::<_, Error>([zeros()?, zeros()?]);
        let friction = {
            let mut friction = Friction::coulomb(0.0)?;
            let (coefficient, cap) = friction.parts_mut();
            *coefficient = self.friction.coefficients().try_map(|_| zeros())?;
            *cap = self.friction.common().1;
            friction
        };
        let hardness = self.hardness.as_ref().map(|given| {
            let mut hardness = Hardness::blank();
            *hardness.limit_mut() = given.limits().try_map(|_| zeros())?;
            Ok(hardness)
        });
        let relative = self.relative.as_ref().map(|given| {
            let relative = RelativeDisplacementState::new(RelativeDisplacement::zeros(grid)?)?;
            Ok(RelativeDisplacementState {
                amount: given.amount,
                ..relative
            })
        });
        let trend = match self.press_window.filter(|_| self.trend.is_known()) {
            Some(window) => LoadTrend {
                change: [fallible::zeros(window.held(grid).cells())?],
                by: self.trend.by,
            },
            None => LoadTrend::default(),
        };
        let contact = self.contact.as_ref();
        let contact = contact.map(|given| self.memory_outline_on(grid, given));
        Ok(Self {
            axes: self.axes,
            settings: self.settings,
            friction,
            gap: zeros()?,
            hardness: hardness.transpose()?,
            yielded: self.yielded.as_ref().map(|_| zeros()).transpose()?,
            relative: relative.transpose()?,
            normal: self.normal.outline_on(grid)?,
            pressed_gap: zeros()?,
            is_pressure_stale: self.is_pressure_stale,
            is_friction_new: self.is_friction_new,
            pressed_by: self.pressed_by,
            press_window: self.press_window,
            trend,
            contact: contact.transpose()?,
            traction: both()?,
            slip: both()?,
            accumulated_slip: zeros()?,
            dissipated_energy: zeros()?,
            zones: fallible::filled(Zone::Separated, grid.cells())?,
            motion: self.motion,
            force: self.force,
            held_force: self.held_force,
            moment: self.moment,
            steps: self.steps,
            motion_range: self.motion_range,
            zone_cells: self.zone_cells,
            entry_rule: self.entry_rule,
            coupling: self.coupling,
            capacity: self.capacity,
            origin: self.origin,
        })
    }

    fn memory_outline_on(&self, grid: Grid, given: &Memory) -> Result<Memory> {
        let mut memory = Memory::first(grid, self.axes, given.window, self.motion)?;
        if self.is_joint() {
            memory.trend = LoadTrend::default();
        } else {
            memory.trend.by = given.trend.by;
        }
        if given.has_entered {
            memory.has_entered = true;
            memory.entered = fallible::zeros(given.window.held(grid).cells())?;
        }
        Ok(memory)
    }

    /// Returns the number of bytes of the saved values of the cells on a part of the grid.
    pub(super) fn cell_bytes_on(&self, grid: Grid, quantities: &[CellQuantity]) -> usize {
        let samples = quantities
            .iter()
            .map(|quantity| self.window_of(*quantity).held(grid).cells());
        let samples = samples.fold(0_usize, usize::saturating_add);
        samples.saturating_mul(8).saturating_add(grid.cells())
    }

    pub(super) fn write_cells(
        &self,
        quantities: &[CellQuantity],
        writer: &mut Writer,
    ) -> Result<()> {
        for quantity in quantities {
            writer.samples(self.values(*quantity))?;
        }
        let zone = |zone: &Zone| ZONES.iter().position(|of| of == zone);
        let codes = self.zones.iter().map(zone);
        let codes = codes.map(|code| u8::try_from(code.unwrap_or(0)).unwrap_or(0));
        writer.extend(self.zones.len(), codes)
    }

    pub(super) fn read_cells(
        &mut self,
        quantities: &[CellQuantity],
        reader: &mut Reader<'_>,
    ) -> Result<()> {
        for quantity in quantities {
            let (what, rule) = quantity.rule();
            reader.numbers(what, self.values_mut(*quantity), rule)?;
        }
        for zone in &mut self.zones {
            reader.kind("zone", zone, &ZONES)?;
        }
        Ok(())
    }
}
