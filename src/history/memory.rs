//! What the cells in and around the contact remember of their slip.

use crate::error::Result;
use crate::field::{Field, clone_in_place};
use crate::grid::Grid;
use crate::history::state::State;
use crate::tangential::{Axis, Demand, Increment, Motion, PlaneVector, Zone, centre, zeros};
use crate::trend::Trend;
use crate::window::Window;

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
    pub(super) trend: Trend<2>,
}

clone_in_place!(Memory {
    window,
    displacement,
    offset,
    trend,
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
            trend: Trend {
                change: zeros(axes, window.cells()),
                ..Trend::default()
            },
        }
    }

    /// On a wider window, that of an increment.
    pub(super) fn widened(&self, grid: Grid, increment: &mut Increment, state: &State) -> Self {
        let window = increment.pressed.window;
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
        wide
    }

    /// How many times the last step the load continues in the same direction; `None` where it does not.
    pub(super) fn parts_ahead(&self, state: &State, demand: &Demand) -> Option<f64> {
        let ahead = demand.ahead(state.force, state.motion.shift);
        let turns = demand.twist.to_bits() != state.motion.twist.to_bits();
        let parts = self.trend.parts(ahead);
        parts.filter(|parts| *parts > 0.0 && !turns)
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
