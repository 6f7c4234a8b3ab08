//! What all ranks together have found, kept with the slab of each.

use std::sync::Arc;

use crate::cgm::reduce;
use crate::contact::contact_counts::ContactCounts;
use crate::half_space::HalfSpace;
use crate::parallel::ranks::partition::RowPartition;

/// Counts and sums of the whole grid, as every rank knows it.
#[derive(Debug, Clone)]
pub(super) struct PressureSums {
    pub(super) contact: ContactCounts,
    /// Sums of the pressure, and of x and y times it.
    pub(super) sums: [f64; 3],
    /// Cells beyond what the softer body bears.
    pub(super) overloaded: usize,
    /// How the grid is dealt out.
    pub(super) share: Arc<RowPartition>,
}

/// Whether the answers are equal, whoever has found them.
impl PartialEq for PressureSums {
    fn eq(&self, other: &Self) -> bool {
        let of = |whole: &Self| (whole.contact, whole.sums, whole.overloaded);
        of(self) == of(other)
    }
}

impl PressureSums {
    /// Of the pressure of every rank; `None` of bodies that are not shared.
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
            share,
        }))
    }
}
