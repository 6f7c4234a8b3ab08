//! Counts and sums of the tractions over all ranks, stored with the slab of each rank.

use crate::cgm::reduce;
use crate::contact::contact_counts::ContactCounts;
use crate::grid::field::Field;
use crate::half_space::HalfSpace;
use crate::parallel::layout::Layout;
use crate::tangential::Zone;
use crate::tangential::rigid_motion::centre;

/// Sums over the cells of a tangential contact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct TractionSums {
    /// Sums of the tractions along x and along y.
    pub(super) force: [f64; 2],
    pub(super) moment: f64,
    /// Sum of the products of traction and slip.
    pub(super) work: f64,
    /// Numbers of cells that stick and that slip.
    pub(super) stick: usize,
    pub(super) slip: usize,
}

impl TractionSums {
    /// Computes the sums over the cells of a layout.
    pub(super) fn of(
        layout: &Layout,
        traction: &[Field; 2],
        slip: &[Field; 2],
        zones: &[Zone],
    ) -> Self {
        let grid = traction[0].grid();
        let [x, y] = traction.each_ref().map(Field::as_slice);
        let [slip_x, slip_y] = slip.each_ref().map(Field::as_slice);
        let (force, moment, work, [stick, slip]) = reduce::sum(layout, |i| {
            let [along_x, along_y] = centre(grid, i);
            (
                [x[i], y[i]],
                along_x * y[i] - along_y * x[i],
                x[i] * slip_x[i] + y[i] * slip_y[i],
                [Zone::Stick, Zone::Slip].map(|zone| usize::from(zones[i] == zone)),
            )
        });
        Self {
            force,
            moment,
            work,
            stick,
            slip,
        }
    }
}

/// Counts and sums of the whole grid, equal on every rank.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct ShearSums {
    pub(super) contact: ContactCounts,
    pub(super) sums: TractionSums,
}

impl ShearSums {
    /// Computes the counts and sums, or returns `None` if the bodies are not distributed.
    pub(super) fn of(
        bodies: &HalfSpace,
        traction: &[Field; 2],
        slip: &[Field; 2],
        zones: &[Zone],
    ) -> Option<Box<Self>> {
        let contact = bodies.survey(|i| zones[i] != Zone::Separated)?;
        let sums = TractionSums::of(&bodies.grid_layout(), traction, slip, zones);
        Some(Box::new(Self { contact, sums }))
    }
}
