//! What survives from one step to the next.

use crate::field::Field;
use crate::grid::Grid;
use crate::history::motion::Motion;
use crate::tangential::Zone;

/// Tangential state of all cells, and what has added up since the start.
#[derive(Debug, Clone)]
pub(super) struct State {
    pub(super) traction: [Field; 2],
    pub(super) slip: [Field; 2],
    pub(super) slip_path: Field,
    pub(super) dissipated: Field,
    pub(super) zones: Vec<Zone>,
    pub(super) motion: Motion,
    pub(super) force: [f64; 2],
    pub(super) moment: f64,
    pub(super) steps: u64,
}

impl State {
    /// Unsheared, nothing in contact.
    pub(super) fn new(grid: Grid) -> Self {
        let zeros = || Field::zeros(grid);
        Self {
            traction: [zeros(), zeros()],
            slip: [zeros(), zeros()],
            slip_path: zeros(),
            dissipated: zeros(),
            zones: vec![Zone::Separate; grid.cells()],
            motion: Motion::default(),
            force: [0.0; 2],
            moment: 0.0,
            steps: 0,
        }
    }

    pub(super) fn grid(&self) -> Grid {
        self.dissipated.grid()
    }
}
