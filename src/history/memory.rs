//! What the cells in and around the contact remember of their slip.

use crate::error::Result;
use crate::field::{Field, clone_in_place};
use crate::grid::Grid;
use crate::half_space::HalfSpace;
use crate::history::state::State;
use crate::tangential::{
    Axis, Demand, Increment, Motion, PlaneVector, Pressed, TangentialControl, Zone, centre, zeros,
};
use crate::window::Window;

/// Parts of the last step that are round-off, and beyond which nothing is extrapolated.
const NO_PART: f64 = 1e-9;
const FARTHEST: f64 = 2.0;

/// Displacement and offset of the cells of a window.
#[derive(Debug)]
pub(super) struct Memory {
    pub(super) window: Window,
    /// Displacement u after the last step.
    pub(super) displacement: PlaneVector,
    /// What u less the motion is in a cell while it sticks: where its last slip has left it or, outside
    /// the contact, where it would touch now.
    pub(super) offset: PlaneVector,
    /// How the tractions changed in the last step, and force and shift with them; nothing where pressure and shear are
    /// found together.
    pub(super) trend: PlaneVector,
    pub(super) trend_by: [[f64; 2]; 2],
}

clone_in_place!(Memory {
    window,
    displacement,
    offset,
    trend,
    trend_by
});

impl Memory {
    /// At the first touch, of bodies that have no displacement.
    pub(super) fn first(grid: Grid, axes: &[Axis], window: Window, motion: Motion) -> Self {
        let mut offset = zeros(axes, window.cells());
        for (k, i) in window.indices().enumerate() {
            let moved = motion.at(centre(grid, i));
            for axis in axes.iter().map(|axis| axis.index()) {
                offset[axis][k] = -moved[axis];
            }
        }
        Self {
            window,
            displacement: zeros(axes, window.cells()),
            offset,
            trend: zeros(axes, window.cells()),
            trend_by: [[0.0; 2]; 2],
        }
    }

    /// On a window wide enough for a contact too, and a little wider, so that it may grow some more; with the
    /// increment that works there.
    pub(super) fn widened(
        &self,
        bodies: &HalfSpace,
        contact: Window,
        state: &State,
    ) -> Result<(Increment, Self)> {
        let grid = bodies.grid();
        let window = self.window.union(contact.widened(grid));
        let mut increment =
            Increment::new(bodies, state.axes, Pressed::new(window), state.coupling)?;
        increment.set_traction(state.traction.each_ref().map(Field::as_slice));
        let mut wide = Self::first(grid, state.axes, window, state.motion);
        wide.displacement = increment.fresh_displacement();
        let mut whole = vec![0.0; grid.cells()];
        for axis in state.axes.iter().map(|axis| axis.index()) {
            let offset = &mut wide.offset[axis];
            for (offset, displacement) in offset.iter_mut().zip(&wide.displacement[axis]) {
                *offset += displacement;
            }
            window.scatter(offset, &mut whole);
            for (i, offset) in self.window.indices().zip(&self.offset[axis]) {
                if state.zones[i] != Zone::Separated {
                    whole[i] = *offset;
                }
            }
            window.gather(&whole, offset);
        }
        Ok((increment, wide))
    }

    /// How many times as far as in the last step the load goes on along its way; `None` where it does not go on.
    pub(super) fn parts_ahead(&self, state: &State, demand: &Demand) -> Option<f64> {
        let [by_force, by_shift] = self.trend_by;
        let (mut ahead, mut squares) = (0.0, 0.0);
        for axis in [0, 1] {
            let (force, shift) = (state.force[axis], state.motion.shift[axis]);
            let parts = match demand.controls[axis] {
                TangentialControl::Hold => 0.0,
                TangentialControl::Force(end) => (end - force) / by_force[axis],
                TangentialControl::Shift(end) => (end - shift) / by_shift[axis],
                TangentialControl::Spring {
                    position,
                    stiffness,
                } => {
                    let by = by_shift[axis] + by_force[axis] / stiffness;
                    (position - shift - force / stiffness) / by
                }
            };
            let square = by_force[axis] * by_force[axis];
            if square > 0.0 {
                ahead += square * parts;
                squares += square;
            }
        }
        let parts = ahead / squares;
        let turns = demand.twist.to_bits() != state.motion.twist.to_bits();
        (!turns && parts > NO_PART && parts <= FARTHEST).then_some(parts)
    }

    /// The displacements of all cells, of a window that is the grid.
    pub(super) fn fields(&self, grid: Grid) -> Result<[Field; 2]> {
        let [x, y] = self
            .displacement
            .each_ref()
            .map(|part| Field::from_vec(grid, part.clone()));
        Ok([x?, y?])
    }
}
