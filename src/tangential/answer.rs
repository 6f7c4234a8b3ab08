//! What a step has found in the cells of a window, however it was found.

use crate::cgm::vector::{dot, minus};
use crate::tangential::engine::at;
use crate::tangential::limits::is_at_limit;
use crate::tangential::{Motion, Pressed};

/// Tractions and displacements at the end of a step, on the window of a contact. A component that the model leaves out
/// has no cells.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Answer<'a> {
    /// The window, with pressure and limits.
    pub(crate) pressed: &'a Pressed,
    pub(crate) traction: [&'a [f64]; 2],
    pub(crate) displacement: [&'a [f64]; 2],
    /// What displacement less motion is in a cell while it sticks.
    pub(crate) offset: [&'a [f64]; 2],
    /// Of body 2, at the end of the step.
    pub(crate) motion: Motion,
}

impl Answer<'_> {
    /// The traction of a cell.
    pub(crate) fn traction(&self, cell: usize) -> [f64; 2] {
        at(&self.traction, cell)
    }

    /// The displacement of a cell.
    pub(crate) fn displacement(&self, cell: usize) -> [f64; 2] {
        at(&self.displacement, cell)
    }

    /// The offset of a cell.
    pub(crate) fn offset(&self, cell: usize) -> [f64; 2] {
        at(&self.offset, cell)
    }

    /// Slip of a cell in the step, if it slips: of a cell that carries all that friction holds and has moved against its
    /// traction. A motion along the traction is residual of the solve.
    pub(crate) fn slip(&self, cell: usize, centre: [f64; 2]) -> Option<[f64; 2]> {
        let moved = minus(self.displacement(cell), self.motion.at(centre));
        let moved = minus(moved, self.offset(cell));
        let slips = self.is_at_limit(cell) && dot(self.traction(cell), moved) <= 0.0;
        slips.then_some(moved)
    }

    /// Whether a cell carries all that friction holds there.
    pub(crate) fn is_at_limit(&self, cell: usize) -> bool {
        let [x, y] = self.traction(cell);
        is_at_limit(x.hypot(y), self.pressed.limits.cells[cell])
    }
}
