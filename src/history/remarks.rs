//! What a step has to be warned of, and a cycle of steps.

use crate::contact_map::Warning;
use crate::history::Cycle;

/// What is wrong with a step, or with any step of a cycle.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub(super) struct Remarks {
    /// Whether the pressure was held although the gap had changed.
    pub(super) is_pressure_stale: bool,
    /// Contact cells on the edge of the grid, the most of any step.
    pub(super) edge_cells: usize,
    /// Whether nothing touched.
    pub(super) is_apart: bool,
    /// Cells pressed beyond the hardness a material states, the most of any step.
    pub(super) overloaded_cells: usize,
}

impl Remarks {
    /// With those of another step.
    pub(super) fn and(self, other: Self) -> Self {
        Self {
            is_pressure_stale: self.is_pressure_stale || other.is_pressure_stale,
            edge_cells: self.edge_cells.max(other.edge_cells),
            is_apart: self.is_apart || other.is_apart,
            overloaded_cells: self.overloaded_cells.max(other.overloaded_cells),
        }
    }

    pub(super) fn warnings(self) -> Vec<Warning> {
        let cells = self.edge_cells;
        let stale = self.is_pressure_stale.then_some(Warning::StalePressure);
        let at_edge = (cells > 0).then_some(Warning::ContactAtEdge { cells });
        let apart = self.is_apart.then_some(Warning::NoContact);
        let cells = self.overloaded_cells;
        let beyond = (cells > 0).then_some(Warning::BeyondHardness { cells });
        let all = stale.into_iter().chain(at_edge).chain(apart);
        all.chain(beyond).collect()
    }
}

impl Cycle {
    /// The [warnings](crate::history::StepResult::warnings) of any of its steps, each once, with the largest count. What
    /// concerns the grid and the spots of the contact is in those of [`History::normal`](crate::History::normal).
    #[must_use]
    pub fn warnings(&self) -> Vec<Warning> {
        self.remarks.warnings()
    }
}
