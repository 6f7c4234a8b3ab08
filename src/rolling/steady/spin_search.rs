//! The search for the spin of a moment.

/// Growth of the steps while the spin is bounded from one side alone.
const GROWTH: f64 = 4.0;

/// Secants through the last two spins, within the spins between which the moment is crossed.
#[derive(Debug)]
pub(in crate::rolling) struct SpinSearch {
    /// The longest step while there is no bound ahead.
    stride: f64,
    /// The last spin, and the moment that it lacked.
    last: Option<[f64; 2]>,
    low: f64,
    high: f64,
}

impl SpinSearch {
    pub(in crate::rolling) fn new(stride: f64) -> Self {
        Self {
            stride,
            last: None,
            low: f64::NEG_INFINITY,
            high: f64::INFINITY,
        }
    }

    /// The spin to try after one that lacks so much of the moment.
    pub(in crate::rolling) fn next(&mut self, spin: f64, missing: f64) -> f64 {
        let first = self.stride.copysign(missing);
        let step = self.last.map_or(first, |[before, lacked]| {
            missing * (spin - before) / (lacked - missing)
        });
        self.last = Some([spin, missing]);
        if missing > 0.0 {
            self.low = self.low.max(spin);
        } else {
            self.high = self.high.min(spin);
        }
        let next = spin + step;
        let is_between = self.low < next && next < self.high;
        if (self.high - self.low).is_finite() {
            let middle = self.low + 0.5 * (self.high - self.low);
            return if is_between { next } else { middle };
        }
        let next = if is_between && step.abs() < self.stride {
            next
        } else {
            spin + first
        };
        self.stride *= GROWTH;
        next
    }
}
