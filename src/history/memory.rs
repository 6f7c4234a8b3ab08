//! What the cells in and around the contact remember of their slip.

use crate::error::Result;
use crate::field::{Field, clone_in_place};
use crate::grid::Grid;
use crate::history::state::State;
use crate::tangential::{Axis, Demand, Increment, Motion, PlaneVector, centre, zeros};
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

    /// Takes the window of an increment, which is wider; what it knew of its own cells stays, bit for bit.
    pub(super) fn widen(
        &mut self,
        grid: Grid,
        increment: &mut Increment,
        traction: [&Field; 2],
        motion: Motion,
    ) {
        let (window, old) = (increment.pressed.window(), self.window);
        for field in self.fields_mut() {
            window.spread(old, field);
        }
        self.window = window;
        increment.set_traction(traction.map(Field::as_slice));
        let axes = increment.axes();
        let displacement = increment.fresh_displacement();
        let added = window
            .indices()
            .enumerate()
            .filter(|(_, i)| !old.contains(*i));
        for (k, i) in added {
            let moved = motion.at(centre(grid, i));
            for axis in axes.iter().map(|axis| axis.index()) {
                self.displacement[axis][k] = displacement[axis][k];
                self.offset[axis][k] = displacement[axis][k] - moved[axis];
            }
        }
    }

    /// Takes a smaller window around all contact. What a cell apart remembers is lost with it: [`Self::widen`] finds it
    /// again.
    pub(super) fn narrow(&mut self, window: Window) {
        let old = self.window;
        for field in self.fields_mut() {
            window.cut(old, field);
        }
        self.window = window;
    }

    /// All fields of the window.
    fn fields_mut(&mut self) -> impl Iterator<Item = &mut Vec<f64>> {
        let Self {
            displacement,
            offset,
            trend,
            ..
        } = self;
        let vectors = [displacement, offset, &mut trend.change];
        let fields = vectors.into_iter().flatten();
        fields.filter(|field| !field.is_empty())
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
