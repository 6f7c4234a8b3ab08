//! Loads of a sheared contact, compared with the prescribed loads.

use crate::numerics::agreement::agree;
use crate::tangential::{Axis, TangentialControl, TangentialSolution, TangentialTarget};

/// Motion and loads of a sheared contact.
#[derive(Debug, Clone, Copy)]
pub(super) struct ShearLoads {
    pub(super) force: [f64; 2],
    pub(super) shift: [f64; 2],
    pub(super) twist: f64,
    /// Integral of the friction limit, the scale of the forces.
    pub(super) capacity: f64,
}

impl ShearLoads {
    /// Returns the loads of a solution whose friction can carry this force.
    pub(super) fn of(solution: &TangentialSolution, capacity: f64) -> Self {
        Self {
            force: solution.force(),
            shift: solution.shift(),
            twist: solution.twist(),
            capacity,
        }
    }

    /// Returns whether the values agree with a prescribed load. A control that keeps the shift prescribes `held`, if known.
    pub(super) fn are_prescribed_by(&self, target: &TangentialTarget, held: Option<f64>) -> bool {
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
