//! The normal problem on coarser cells.

use crate::cascade::Scene;
use crate::cgm::{Constraint, Interval, NonNegative, Total};
use crate::influence::Direction;
use crate::window::{coarsened, refined};

/// The gap from a datum, and the sum of pressures: all a normal contact depends on.
pub(super) struct PressureScene {
    pub(super) linear: Vec<f64>,
    pub(super) total: Total,
}

impl Scene<1> for PressureScene {
    type Set = Interval;

    fn directions(&self) -> [Direction; 1] {
        [Direction::Z]
    }

    fn constraint(&self) -> impl Constraint<1, Set = Interval> {
        NonNegative
    }

    fn linear(&self) -> [&[f64]; 1] {
        [&self.linear]
    }

    fn totals(&self) -> [Total; 1] {
        [self.total]
    }

    fn coarsened(&self, size: [usize; 2]) -> Self {
        Self {
            linear: coarsened(size, &self.linear),
            total: self.total.scaled(0.25),
        }
    }

    /// Uniform pressure under a force, zero under an approach.
    fn plain_start(&self) -> [Vec<f64>; 1] {
        let cells = self.linear.len();
        [vec![self.total.sum().unwrap_or(0.0) / cells as f64; cells]]
    }

    fn refined_start(&self, size: [usize; 2], _: &Self, [answer]: &[Vec<f64>; 1]) -> [Vec<f64>; 1] {
        [refined(size, answer)]
    }
}
