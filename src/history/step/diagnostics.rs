//! Diagnostics behind the warnings of a step or a cycle.

use crate::half_space::HalfSpace;
use crate::history::cycle::hysteresis::repeats_loop;
use crate::history::{Cycle, State};
use crate::normal::{GapChange, Scale};
use crate::tangential::FrictionScale;
use crate::warning::{Resolution, Warning};

/// Diagnostics of a step, or of all steps of a cycle.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(default)
)]
#[expect(
    clippy::struct_excessive_bools,
    reason = "each value belongs to one warning"
)]
pub(in crate::history) struct StepDiagnostics {
    /// Whether the pressure was held although the gap had changed.
    pub(in crate::history) is_pressure_stale: bool,
    /// Whether a contact of dissimilar bodies grew too much in the step.
    pub(in crate::history) is_pressed_at_once: bool,
    /// Largest number of contact cells on the edge of the grid in any step.
    pub(in crate::history) edge_cells: usize,
    /// Whether the bodies did not touch.
    pub(in crate::history) is_apart: bool,
    /// Largest number of cells above the hardness of a material in any step.
    pub(in crate::history) overloaded_cells: usize,
    /// Largest approach, contact radius and slope in any step.
    #[cfg_attr(feature = "serde", serde(default))]
    pub(in crate::history) scale: Scale,
    /// Largest loss of tangential force under a held shift after any step, in per cent.
    #[cfg_attr(feature = "serde", serde(default))]
    pub(in crate::history) lost_per_cent: usize,
    /// Whether a relative displacement of the amount zero had no effect.
    pub(in crate::history) is_displacement_unused: bool,
    /// Largest shift of a step that is larger than the grid, over the longest side of the grid, in tenths.
    pub(in crate::history) shift_tenths: Option<usize>,
    /// Largest component of the bulk strain that is not small, in thousandths.
    pub(in crate::history) strain_per_mille: Option<usize>,
    /// Largest twist of a step that is not small, in tenths of a radian. Saved histories do not contain it.
    #[cfg_attr(feature = "serde", serde(skip))]
    pub(in crate::history) twist_tenths: Option<usize>,
    /// Largest prescribed creepage of a rolled step that is not small, in per cent. Saved histories do not contain it.
    #[cfg_attr(feature = "serde", serde(skip))]
    pub(in crate::history) creepage_per_cent: Option<usize>,
    /// Whether the bodies rolled.
    pub(in crate::history) is_rolled: bool,
    /// Coefficient and cap of the friction.
    pub(in crate::history) friction: FrictionScale,
    /// Hardness divided by the plane-strain modulus in thousandths, if the hardness exceeds this modulus and has no effect.
    pub(in crate::history) hardness_per_mille: Option<usize>,
    /// Whether cells have reached their hardness.
    pub(in crate::history) has_yielded: bool,
    /// Contact modulus divided by the largest pressure of a step in which almost all contact cells are at a low hardness.
    pub(in crate::history) hardness_parts: Option<usize>,
    /// Changes of the gap since the last pressure.
    pub(in crate::history) gap_change: GapDiagnostics,
    /// Largest lift due to the tractions of a rolled step that the pressure ignores, in millionths of the normal
    /// displacement.
    pub(in crate::history) neglected_lift: Option<usize>,
    /// Dundurs' beta over the mean coefficient of friction in a step with large neglected tractions, in per cent.
    pub(in crate::history) coupling_per_cent: Option<usize>,
    /// Resolution of the contact and its zones: the smallest number of stick cells and the widest slip zone.
    pub(in crate::history) resolution: Resolution,
}

/// Diagnostics of a change of the gap since the last pressure.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub(in crate::history) struct GapDiagnostics {
    /// Largest change that is not small, in tenths of the largest normal displacement.
    pub(in crate::history) tenths: Option<usize>,
    /// Number of cells in which the change resembles wear of the wrong sign. Saved histories do not contain it.
    #[cfg_attr(feature = "serde", serde(skip))]
    pub(in crate::history) negative_cells: usize,
}

impl GapDiagnostics {
    /// Returns the diagnostics of a change before the pressure of the state. The change includes the number of cells in which it
    /// resembles wear of the wrong sign.
    pub(in crate::history) fn of(
        state: &State,
        bodies: &HalfSpace,
        change: Option<(GapChange, usize)>,
    ) -> Self {
        let Some((change, negative_cells)) = change else {
            return Self::default();
        };
        Self {
            tenths: Warning::gap_change_beyond(change.relative_to(state.pressed(bodies))),
            negative_cells,
        }
    }

    /// Returns the larger value of each quantity.
    pub(in crate::history) fn max(self, other: Self) -> Self {
        Self {
            tenths: self.tenths.max(other.tenths),
            negative_cells: self.negative_cells.max(other.negative_cells),
        }
    }

    fn warnings(self) -> impl Iterator<Item = Warning> {
        let large = self.tenths.map(|tenths| Warning::LargeGapChange { tenths });
        let cells = self.negative_cells;
        let negative = (cells > 0).then_some(Warning::NegativeWear { cells });
        large.into_iter().chain(negative)
    }
}

/// Largest loss of tangential force under a held shift without a warning, in per cent.
pub(in crate::history) const LARGEST_LOSS: usize = 50;

impl StepDiagnostics {
    /// Returns whether the range of the motion ends, because bodies that are apart or roll may move further than the grid.
    pub(in crate::history) fn ends_motion_range(&self) -> bool {
        self.is_apart || self.is_rolled
    }

    /// Combines the diagnostics with the diagnostics of another step.
    pub(in crate::history) fn and(self, other: Self) -> Self {
        Self {
            is_pressure_stale: self.is_pressure_stale || other.is_pressure_stale,
            is_pressed_at_once: self.is_pressed_at_once || other.is_pressed_at_once,
            edge_cells: self.edge_cells.max(other.edge_cells),
            is_apart: self.is_apart || other.is_apart,
            overloaded_cells: self.overloaded_cells.max(other.overloaded_cells),
            scale: self.scale.max(other.scale),
            lost_per_cent: self.lost_per_cent.max(other.lost_per_cent),
            is_displacement_unused: self.is_displacement_unused || other.is_displacement_unused,
            shift_tenths: self.shift_tenths.max(other.shift_tenths),
            strain_per_mille: self.strain_per_mille.max(other.strain_per_mille),
            twist_tenths: self.twist_tenths.max(other.twist_tenths),
            creepage_per_cent: self.creepage_per_cent.max(other.creepage_per_cent),
            is_rolled: self.is_rolled || other.is_rolled,
            friction: self.friction.max(other.friction),
            hardness_per_mille: self.hardness_per_mille.max(other.hardness_per_mille),
            has_yielded: self.has_yielded || other.has_yielded,
            hardness_parts: self.hardness_parts.max(other.hardness_parts),
            gap_change: self.gap_change.max(other.gap_change),
            neglected_lift: self.neglected_lift.max(other.neglected_lift),
            coupling_per_cent: self.coupling_per_cent.max(other.coupling_per_cent),
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
        let unused = self.is_displacement_unused;
        let unused = unused.then_some(Warning::UnusedRelativeDisplacement);
        let shift = self.shift_tenths;
        let shift = shift.map(|tenths| Warning::ShiftBeyondGrid { tenths });
        let twist = self.twist_tenths;
        let twist = twist.map(|tenths| Warning::LargeTwist { tenths });
        let creepage = self.creepage_per_cent;
        let creepage = creepage.map(|per_cent| Warning::LargeCreepage { per_cent });
        let high = self
            .hardness_per_mille
            .filter(|_| !self.has_yielded && self.overloaded_cells == 0);
        let hardness = Warning::of_hardness(self.hardness_parts, high);
        let lift = self.neglected_lift;
        let lift = lift.map(|per_million| Warning::NeglectedLift { per_million });
        all.chain(beyond)
            .chain(hardness)
            .chain(lift)
            .chain(Warning::of_coupling(self.coupling_per_cent))
            .chain(zones)
            .chain(self.scale.warnings())
            .chain(shift)
            .chain(Warning::of_strain(self.strain_per_mille))
            .chain(twist)
            .chain(creepage)
            .chain(self.friction.warnings().into_iter().flatten())
            .chain(self.gap_change.warnings())
            .chain(lost)
            .chain(unused)
            .chain(at_once)
            .collect()
    }
}

impl Cycle {
    /// Returns the [warnings](crate::history::StepResult::warnings) of all steps. Each warning appears once, with its
    /// largest count. The warning for a narrow slip zone appears only if the zone was too narrow in all steps. The cycle has the
    /// warning [`RepeatedLoop`](Warning::RepeatedLoop) if it contains more than one loop, and [`OpenCycle`](Warning::OpenCycle) if
    /// its loads turn back but the cycle does not close. It has
    /// [`ShiftBeyondGrid`](Warning::ShiftBeyondGrid) or [`LargeTwist`](Warning::LargeTwist) if the range of the motion over
    /// consecutive steps in contact is too large, although each step is small.
    /// [`History::normal`](crate::History::normal) returns the warnings about the grid and the contact spots.
    #[must_use]
    pub fn warnings(&self) -> Vec<Warning> {
        let mut warnings = self.remarks.warnings();
        warnings.extend(repeats_loop(self.points()).then_some(Warning::RepeatedLoop));
        warnings.extend(self.open_warning());
        warnings
    }
}
