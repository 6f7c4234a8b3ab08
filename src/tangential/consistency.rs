//! Consistency of a tangential solution with the pressure and friction for which it was computed.

use crate::cgm::reduce;
use crate::error::{Error, Result};
use crate::grid::field::Field;
use crate::normal::NormalSolution;
use crate::numerics::agreement::{agree_within, tolerance_of};
use crate::numerics::cell_vector::length;
use crate::parallel::layout::Layout;
use crate::tangential::friction_limits::NEGLIGIBLE;
use crate::tangential::{Friction, TangentialSolution, Zone};

impl TangentialSolution {
    /// Returns whether the solution belongs to this pressure of the local cells and this friction. Exactly the cells with pressure
    /// are then in contact, slipping cells are at their friction limit, and no traction exceeds its limit. `tolerance` is relative
    /// to the largest limit.
    pub(crate) fn belongs_to(
        &self,
        layout: &Layout,
        pressure: &[f64],
        friction: &Friction,
        tolerance: f64,
    ) -> bool {
        let limit = |i: usize| {
            if pressure[i] > 0.0 {
                friction.limit(i, pressure[i])
            } else {
                0.0
            }
        };
        let largest = reduce::max(layout, limit);
        let (least, negligible) = (NEGLIGIBLE * largest, tolerance * largest);
        let [x, y] = self.traction().map(Field::as_slice);
        let is_violated = |i: usize| {
            let (size, zone) = (length([x[i], y[i]]), self.zones()[i]);
            let limit = Some(limit(i))
                .filter(|limit| *limit >= least)
                .unwrap_or(0.0);
            let is_permitted = match zone {
                Zone::Slip => agree_within(tolerance, size, limit, largest),
                Zone::Stick | Zone::Separated => size <= limit + negligible,
            };
            let is_moved = (zone != Zone::Separated) != (pressure[i] > 0.0);
            !is_permitted || is_moved && size.max(limit) > negligible
        };
        !reduce::any(layout, is_violated)
    }

    /// Returns an error unless the problem took its pressure from this normal solution. Ranks compare their local cells, and sums
    /// over all cells.
    pub(crate) fn check_normal(&self, normal: &NormalSolution, result: &'static str) -> Result<()> {
        let quantity = "normal contact";
        self.grid().check_equal(quantity, normal.grid())?;
        if self.boundary() != normal.boundary() {
            return Err(Error::BoundaryMismatch { quantity });
        }
        if self.cell_value() != normal.cell_value() {
            return Err(Error::CellValueMismatch { quantity });
        }
        if self.pair() != normal.pair() {
            return Err(Error::MaterialMismatch { quantity });
        }
        let tolerance = tolerance_of(&[self.report(), normal.report()]);
        // Two solves of one problem may differ in cells of negligible pressure at the edge of the contact.
        let negligible = tolerance * normal.pressure().max();
        let [x, y] = self.traction().map(Field::as_slice);
        let mut cells = self
            .zones()
            .iter()
            .zip(normal.pressure().as_slice())
            .enumerate();
        let is_moved = cells.any(|(i, (zone, pressure))| {
            let is_moved = (*zone != Zone::Separated) != (*pressure > 0.0);
            is_moved && length([x[i], y[i]]).max(*pressure) > negligible
        });
        let (own, given) = (self.pressure_fingerprint(), normal.fingerprint());
        let is_same = given.is_none_or(|given| own.agrees_with(&given, tolerance));
        if is_same && !is_moved {
            return Ok(());
        }
        Err(Error::OutdatedSolution {
            quantity: result,
            changed: "the pressure",
            remedy: "pass the normal solution whose pressure the tangential contact took",
        })
    }
}
