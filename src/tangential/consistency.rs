//! Consistency of a tangential solution with the pressure, friction and load for which it was computed.

use crate::cgm::reduce;
use crate::half_space::HalfSpace;
use crate::numerics::cell_vector::length;
use crate::tangential::friction_limits::NEGLIGIBLE;
use crate::tangential::{
    Axis, Friction, TangentialControl, TangentialSolution, TangentialTarget, Zone,
};

/// Relative difference below which two values count as equal.
const ROUND_OFF: f64 = 1e-9;

/// Returns whether two values are equal within the round-off of values of the size `scale`.
pub(crate) fn agree(one: f64, other: f64, scale: f64) -> bool {
    (one - other).abs() <= ROUND_OFF * one.abs().max(other.abs()).max(scale)
}

/// Motion and loads of a sheared contact.
#[derive(Debug, Clone, Copy)]
pub(crate) struct ShearLoads {
    pub(crate) force: [f64; 2],
    pub(crate) shift: [f64; 2],
    pub(crate) twist: f64,
    /// Integral of the friction limit, the scale of the forces.
    pub(crate) capacity: f64,
}

impl ShearLoads {
    /// Returns whether the values are those of a prescribed load. A control that keeps the shift prescribes `held`, if known.
    pub(crate) fn are_prescribed_by(&self, target: &TangentialTarget, held: Option<f64>) -> bool {
        let is_prescribed = |axis: Axis| {
            let (force, shift) = (self.force[axis.index()], self.shift[axis.index()]);
            match target.control(axis) {
                TangentialControl::Force(end) => agree(force, end, self.capacity),
                TangentialControl::Shift(end) => agree(shift, end, 0.0),
                TangentialControl::Hold => held.is_none_or(|end| agree(shift, end, 0.0)),
                TangentialControl::Spring {
                    position,
                    stiffness,
                } => {
                    let scale = self.capacity + stiffness * (position.abs() + shift.abs());
                    agree(force, stiffness * (position - shift), scale)
                }
            }
        };
        Axis::BOTH.iter().all(|&axis| is_prescribed(axis)) && agree(self.twist, target.twist, 0.0)
    }
}

impl TangentialSolution {
    /// Returns the loads of the solution.
    pub(crate) fn loads(&self, capacity: f64) -> ShearLoads {
        ShearLoads {
            force: self.force(),
            shift: self.shift(),
            twist: self.twist(),
            capacity,
        }
    }

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
        let [x, y] = self.traction().map(|field| field.as_slice());
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
