//! What a step has to be warned of, and a cycle of steps.

use crate::history::Cycle;
use crate::normal::Scale;
use crate::warning::{Resolution, Warning};

/// What is wrong with a step, or with any step of a cycle.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(default)
)]
pub(in crate::history) struct StepDiagnostics {
    /// Whether the pressure was held although the gap had changed.
    pub(in crate::history) is_pressure_stale: bool,
    /// Whether a contact of dissimilar bodies grew too much in the step.
    pub(in crate::history) is_pressed_at_once: bool,
    /// Contact cells on the edge of the grid, the most of any step.
    pub(in crate::history) edge_cells: usize,
    /// Whether nothing touched.
    pub(in crate::history) is_apart: bool,
    /// Cells pressed beyond the hardness a material states, the most of any step.
    pub(in crate::history) overloaded_cells: usize,
    /// Approach, contact radius and slope, the largest of any step.
    #[cfg_attr(feature = "serde", serde(default))]
    pub(in crate::history) scale: Scale,
    /// Part of the tangential force that a held shift has lost, in per cent, the most of any step.
    #[cfg_attr(feature = "serde", serde(default))]
    pub(in crate::history) lost_per_cent: usize,
    /// Lift by the tractions of a rolled step that the pressure ignores, in millionths of the normal displacement, the most
    /// of any step.
    pub(in crate::history) neglected_lift: Option<usize>,
    /// Cells in contact and its zones: the fewest that stick and the widest zone that slips.
    pub(in crate::history) resolution: Resolution,
}

/// Largest part of the tangential force that a held shift may lose without a warning, in per cent.
const LARGEST_LOSS: usize = 50;

impl StepDiagnostics {
    /// With those of another step.
    pub(in crate::history) fn and(self, other: Self) -> Self {
        Self {
            is_pressure_stale: self.is_pressure_stale || other.is_pressure_stale,
            is_pressed_at_once: self.is_pressed_at_once || other.is_pressed_at_once,
            edge_cells: self.edge_cells.max(other.edge_cells),
            is_apart: self.is_apart || other.is_apart,
            overloaded_cells: self.overloaded_cells.max(other.overloaded_cells),
            scale: self.scale.max(other.scale),
            lost_per_cent: self.lost_per_cent.max(other.lost_per_cent),
            neglected_lift: self.neglected_lift.max(other.neglected_lift),
            resolution: self.resolution.and(other.resolution),
        }
    }

    pub(in crate::history) fn warnings(self) -> Vec<Warning> {
        let cells = self.edge_cells;
        let stale = self.is_pressure_stale.then_some(Warning::StalePressure);
        let at_once = self.is_pressed_at_once.then_some(Warning::SingleLoadStep);
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
        let per_cent = self.lost_per_cent;
        let lost = (per_cent > LARGEST_LOSS).then_some(Warning::HeldShiftLostForce { per_cent });
        let lift = self.neglected_lift;
        let lift = lift.map(|per_million| Warning::NeglectedLift { per_million });
        all.chain(beyond)
            .chain(lift)
            .chain(zones)
            .chain(self.scale.warnings())
            .chain(lost)
            .chain(at_once)
            .collect()
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
