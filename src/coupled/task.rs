//! What is asked of a solve.

use crate::cgm::Total;
use crate::normal::Hardness;
use crate::tangential::Friction;

/// Components of a vector: along z, x and y.
pub(super) const N: usize = 3;

/// How a solve begins.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Start {
    /// From a sweep of halves.
    Halves,
    /// From the present tractions, interpolated from coarser cells.
    Coarse,
    /// From the present tractions, unless they are far from the answer.
    Present,
}

/// What is asked of a solve beside gap and demands of the cells.
#[derive(Debug, Clone, Copy)]
pub(super) struct Task<'a> {
    /// What is prescribed of the sums.
    pub(super) totals: [Total; N],
    /// Approach and shift beyond what is prescribed, as far as they are known before.
    pub(super) multiplier: [f64; N],
    pub(super) friction: &'a Friction,
    /// What limits the pressure, if anything does.
    pub(super) hardness: Option<&'a Hardness>,
    /// The largest coefficient of the whole grid.
    pub(super) largest_coefficient: f64,
    /// Whether a force that friction does not hold at the pressure found so far ends the solve as stalled at once.
    pub(super) is_doubtful: bool,
}

impl Task<'_> {
    /// Whether no tangential force or spring moves the bodies.
    pub(super) fn is_driven_by_shift(&self) -> bool {
        self.totals[1..].iter().all(|total| *total == Total::Free)
    }

    /// The size of the prescribed sum of the tractions.
    pub(super) fn force(&self) -> f64 {
        let [x, y] = [1, 2].map(|c| self.totals[c].sum().unwrap_or(0.0));
        x.hypot(y)
    }
}
