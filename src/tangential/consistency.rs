//! Consistency of a tangential solution with the pressure and friction for which it was computed.

use crate::cgm::reduce;
use crate::grid::field::Field;
use crate::half_space::HalfSpace;
use crate::numerics::cell_vector::length;
use crate::tangential::friction_limits::NEGLIGIBLE;
use crate::tangential::{Friction, TangentialSolution, Zone};

/// Relative difference below which two values count as equal.
const ROUND_OFF: f64 = 1e-9;

/// Returns whether two values are equal within the round-off of values of the size `scale`.
pub(crate) fn agree(one: f64, other: f64, scale: f64) -> bool {
    (one - other).abs() <= ROUND_OFF * one.abs().max(other.abs()).max(scale)
}

impl TangentialSolution {
    /// Returns whether the solution belongs to this pressure of the local cells and this friction. Exactly the cells with pressure
    /// are then in contact, slipping cells are at their friction limit, and no traction exceeds its limit.
    pub(crate) fn belongs_to(
        &self,
        bodies: &HalfSpace,
        pressure: &[f64],
        friction: &Friction,
    ) -> bool {
        let layout = bodies.grid_layout();
        let limit = |i: usize| {
            if pressure[i] > 0.0 {
                friction.limit(i, pressure[i])
            } else {
                0.0
            }
        };
        let least = NEGLIGIBLE * reduce::max(&layout, limit);
        let [x, y] = self.traction().map(Field::as_slice);
        let is_violated = |i: usize| {
            let (size, zone) = (length([x[i], y[i]]), self.zones()[i]);
            let limit = Some(limit(i))
                .filter(|limit| *limit >= least)
                .unwrap_or(0.0);
            let is_permitted = match zone {
                Zone::Slip => agree(size, limit, 0.0),
                Zone::Stick | Zone::Separated => size <= limit * (1.0 + ROUND_OFF),
            };
            !is_permitted || (zone != Zone::Separated) != (pressure[i] > 0.0)
        };
        !reduce::any(&layout, is_violated)
    }
}
