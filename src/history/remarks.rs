//! What a step has to be warned of, and a cycle of steps.

use crate::history::Cycle;
use crate::warning::{Resolution, Warning};

/// What is wrong with a step, or with any step of a cycle.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(default)
)]
pub(super) struct Remarks {
    /// Whether the pressure was held although the gap had changed.
    pub(super) is_pressure_stale: bool,
    /// Whether a contact of dissimilar bodies grew too much in the step.
    pub(super) is_pressed_at_once: bool,
    /// Contact cells on the edge of the grid, the most of any step.
    pub(super) edge_cells: usize,
    /// Whether nothing touched.
    pub(super) is_apart: bool,
    /// Cells pressed beyond the hardness a material states, the most of any step.
    pub(super) overloaded_cells: usize,
    /// Cells in contact and its zones: the fewest that stick and the widest zone that slips.
    pub(super) resolution: Resolution,
}

impl Remarks {
    /// With those of another step.
    pub(super) fn and(self, other: Self) -> Self {
        Self {
            is_pressure_stale: self.is_pressure_stale || other.is_pressure_stale,
            is_pressed_at_once: self.is_pressed_at_once || other.is_pressed_at_once,
            edge_cells: self.edge_cells.max(other.edge_cells),
            is_apart: self.is_apart || other.is_apart,
            overloaded_cells: self.overloaded_cells.max(other.overloaded_cells),
            resolution: self.resolution.and(other.resolution),
        }
    }

    pub(super) fn warnings(self) -> Vec<Warning> {
        let cells = self.edge_cells;
        let stale = self.is_pressure_stale.then_some(Warning::StalePressure);
        let at_once = self.is_pressed_at_once.then_some(Warning::PressedAtOnce);
        let at_edge = (cells > 0).then_some(Warning::ContactAtEdge { cells });
        let apart = self.is_apart.then_some(Warning::NoContact);
        let cells = self.overloaded_cells;
        let beyond = (cells > 0).then_some(Warning::BeyondHardness { cells });
        let all = stale.into_iter().chain(at_edge).chain(apart);
        let resolution = self.resolution;
        let zones = resolution
            .contact_warning()
            .into_iter()
            .chain(resolution.zone_warnings());
        all.chain(beyond).chain(zones).chain(at_once).collect()
    }
}

impl Cycle {
    /// The [warnings](crate::history::StepResult::warnings) of any of its steps, each once, with the largest count; of the
    /// zone that slips, only if it was too narrow in all steps. What concerns the grid and the spots of the contact is in those of [`History::normal`](crate::History::normal).
    #[must_use]
    pub fn warnings(&self) -> Vec<Warning> {
        self.remarks.warnings()
    }
}
