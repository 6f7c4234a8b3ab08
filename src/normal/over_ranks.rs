//! Counts and sums of the pressure over all ranks, stored with the slab of each rank.

use std::sync::Arc;

use crate::cgm::reduce;
use crate::contact::contact_counts::ContactCounts;
use crate::contact::pressure_fingerprint::PressureFingerprint;
use crate::half_space::HalfSpace;
use crate::parallel::ranks::partition::RowPartition;

/// Counts and sums of the whole grid, equal on every rank.
#[derive(Debug, Clone)]
pub(super) struct PressureSums {
    pub(super) contact: ContactCounts,
    /// Sums of p, x p and y p over all cells.
    pub(super) sums: [f64; 3],
    /// Number of cells whose pressure exceeds the hardness of the softer body.
    pub(super) overloaded: usize,
    pub(super) fingerprint: PressureFingerprint,
    /// Partition of the grid over the ranks.
    pub(super) share: Arc<RowPartition>,
}

/// Compares the results and ignores the partition.
impl PartialEq for PressureSums {
    fn eq(&self, other: &Self) -> bool {
        let of = |whole: &Self| (whole.contact, whole.sums, whole.overloaded);
        of(self) == of(other)
    }
}

impl PressureSums {
    /// Computes the counts and sums from the pressure of every rank. Returns `None` if the bodies are not distributed.
    pub(super) fn of(bodies: &HalfSpace, pressure: &[f64]) -> Option<Box<Self>> {
        let grid = bodies.grid();
        let columns = grid.nx();
        let share = bodies.share(bodies.grid().whole().size())?;
        let contact = bodies.survey(|i| pressure[i] > 0.0)?;
        let layout = bodies.grid_layout();
        let total = reduce::sum(&layout, |i| pressure[i]);
        let moments = reduce::sum(&layout, |i| {
            let (x, y) = (grid.x(i % columns), grid.y(i / columns));
            [x * pressure[i], y * pressure[i]]
        });
        let hardness = bodies.pair().hardness();
        Some(Box::new(Self {
            contact,
            sums: [total, moments[0], moments[1]],
            overloaded: reduce::sum(&layout, |i| usize::from(pressure[i] > hardness)),
            fingerprint: PressureFingerprint::of(grid, &layout, |i| (i, pressure[i])),
            share,
        }))
    }
}
