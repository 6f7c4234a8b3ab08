//! What the cells in and around the contact remember of their slip.

use crate::field::clone_in_place;
use crate::grid::Grid;
use crate::history::layout::Layout;
use crate::history::motion::{Motion, centre};
use crate::tangential::Axis;
use crate::window::Window;

/// Displacement and offset of the cells of a window, in the [layout](Layout) of the engine.
#[derive(Debug)]
pub(super) struct Memory {
    pub(super) window: Window,
    /// Displacement u after the last step.
    pub(super) displacement: Vec<f64>,
    /// What u less the motion is in a cell while it sticks: where its last slip has left it or, outside
    /// the contact, where it would touch now.
    pub(super) offset: Vec<f64>,
}

clone_in_place!(Memory {
    window,
    displacement,
    offset
});

impl Memory {
    /// At the first touch, of bodies that have no displacement.
    pub(super) fn first(grid: Grid, axis: Option<Axis>, window: Window, motion: Motion) -> Self {
        let layout = Layout::new(axis, window.cells());
        let zeros = || vec![0.0; layout.len()];
        let mut offset = zeros();
        for (k, i) in window.indices().enumerate() {
            let motion = motion.at(centre(grid, i));
            layout.set(&mut offset, k, motion.map(|motion| -motion));
        }
        Self {
            window,
            displacement: zeros(),
            offset,
        }
    }
}
