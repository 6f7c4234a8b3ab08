//! Memory of the cells in and around the contact.

use crate::contact::LoadTrend;
use crate::error::Result;
use crate::grid::Grid;
use crate::grid::field::{Field, clone_in_place};
use crate::grid::window::Window;
use crate::history::state::{State, clones};
use crate::history::step::solve::StepInput;
use crate::memory::fallible::{self, TryClone, try_clone, try_each};
use crate::tangential::{Axis, RigidMotion, TangentialIncrement, TangentialVector, centre, zeros};

/// Displacement and offset of the local cells of a window.
#[derive(Debug)]
pub(crate) struct Memory {
    pub(crate) window: Window,
    /// Displacement u after the last step.
    pub(in crate::history) displacement: TangentialVector,
    /// Value of u minus the motion, constant in a cell while the cell sticks. In the contact, the offset results from
    /// the last slip of the cell. Outside the contact, the offset is the value for a cell that comes into contact now.
    pub(in crate::history) offset: TangentialVector,
    /// Change of the tractions in the last step, together with the changes of force and shift. Empty for coupled
    /// bodies.
    pub(in crate::history) trend: LoadTrend<2>,
    /// Slip of the last step, which determines the stiffness against a change of direction. Empty in the scalar model.
    pub(crate) slip: TangentialVector,
    /// Entry compliance of the cells that came into contact in the last step. Empty if no cell came into contact.
    pub(crate) entered: Vec<f64>,
    /// Whether a cell of any rank came into contact in the last step.
    pub(in crate::history) has_entered: bool,
}

clones!(Memory { displacement, offset, trend, slip, entered } { window, has_entered });

impl Memory {
    /// Creates the memory at the first touch of bodies without displacement.
    pub(in crate::history) fn first(
        grid: Grid,
        axes: &[Axis],
        window: Window,
        motion: RigidMotion,
    ) -> Result<Self> {
        let held = window.held(grid);
        let mut offset = zeros(axes, held.cells())?;
        for (k, i) in held.indices().enumerate() {
            let moved = motion.at(centre(grid, i));
            for axis in axes.iter().map(|axis| axis.index()) {
                offset[axis][k] = -moved[axis];
            }
        }
        Ok(Self {
            window,
            displacement: zeros(axes, held.cells())?,
            offset,
            trend: LoadTrend {
                change: zeros(axes, held.cells())?,
                ..LoadTrend::default()
            },
            slip: if axes == Axis::BOTH {
                zeros(axes, held.cells())?
            } else {
                TangentialVector::default()
            },
            entered: Vec::new(),
            has_entered: false,
        })
    }

    /// Extends the memory to the wider window of an increment. The values of the present cells remain bitwise
    /// unchanged.
    ///
    /// # Errors
    /// - [`Error::Memory`](crate::Error::Memory) if memory runs out. A call of [`Self::narrow`] with the earlier window
    ///   then restores the memory.
    pub(in crate::history) fn widen(
        &mut self,
        grid: Grid,
        increment: &mut TangentialIncrement,
        traction: [&Field; 2],
        motion: RigidMotion,
    ) -> Result<()> {
        let (held, old) = (increment.pressed.region.held(), self.window.held(grid));
        let axes = increment.axes();
        for field in self.fields_mut(axes) {
            fallible::make_room(field, held.cells())?;
        }
        for field in self.fields_mut(axes) {
            held.spread(old, field);
        }
        self.window = increment.pressed.window();
        increment.set_traction(|axis, cell| traction[axis].as_slice()[cell]);
        let displacement = increment.fresh_displacement()?;
        let cells = held.indices().enumerate();
        let added = cells.filter(|(_, i)| !old.contains(*i));
        for (k, i) in added {
            let moved = motion.at(centre(grid, i));
            for axis in axes.iter().map(|axis| axis.index()) {
                self.displacement[axis][k] = displacement[axis][k];
                self.offset[axis][k] = displacement[axis][k] - moved[axis];
            }
        }
        Ok(())
    }

    /// Reduces the memory to a smaller window around the whole contact. The values of the removed separated cells are
    /// lost. [`Self::widen`] recomputes them.
    pub(in crate::history) fn narrow(&mut self, grid: Grid, window: Window) {
        let (held, old) = (window.held(grid), self.window.held(grid));
        let fields = self.fields_mut(Axis::BOTH);
        for field in fields.filter(|field| !field.is_empty()) {
            held.cut(old, field);
        }
        self.window = window;
    }

    /// Returns the fields of the window along these axes.
    fn fields_mut(&mut self, axes: &[Axis]) -> impl Iterator<Item = &mut Vec<f64>> {
        let has_slip = axes == Axis::BOTH;
        let vectors = [
            Some(&mut self.displacement),
            Some(&mut self.offset),
            Some(&mut self.trend.change),
            has_slip.then_some(&mut self.slip),
        ];
        let parts = vectors.into_iter().flatten().flat_map(|parts| {
            let parts = parts.iter_mut().zip([Axis::X, Axis::Y]);
            parts
                .filter(|(_, axis)| axes.contains(axis))
                .map(|(part, _)| part)
        });
        parts.chain(self.has_entered.then_some(&mut self.entered))
    }

    /// Returns the ratio of the remaining change of the load to the change in the last step. Returns `None` if the load
    /// does not continue in the same direction, or turns without rolling.
    pub(in crate::history) fn parts_ahead(
        &self,
        state: &State,
        step: &StepInput<'_>,
    ) -> Option<f64> {
        let ahead = step.target.remaining_load(state.force, state.motion.shift);
        let is_turned = step.target.twist.to_bits() != state.motion.twist.to_bits();
        let turns = is_turned && step.travel.is_none();
        let parts = self.trend.parts(ahead);
        parts.filter(|parts| *parts > 0.0 && !turns)
    }

    /// Returns the displacements of all cells. The window must be the whole grid.
    pub(in crate::history) fn fields(&self, grid: Grid) -> Result<[Field; 2]> {
        try_each(|axis| Field::from_vec(grid, self.displacement[axis].try_clone()?))
    }
}
