//! Whether the outer steps of an active-set method still get anywhere.

/// Reduction of the inner residual per outer step, while the sets make progress.
pub(super) const INNER_REDUCTION: f64 = 0.1;
/// The same at the least: what the sets are decided by may be this part of the largest residual, where cells are long.
const LEAST_REDUCTION: f64 = 1e-6;
/// Outer steps without progress after which the inner solution is taken for too coarse to decide by.
const DOUBT: usize = 2;

/// Residual of the step before, above which single precision tells the sets as well as double does.
const EARLY: f64 = 5e-4;

/// Part of the tolerance to which the last inner iteration reduces the residual.
const LAST: f64 = 0.6;
/// Least reduction still to go to the tolerance at which the linear problem is solved to it at once, though the sets may
/// still change.
const IN_SIGHT: f64 = 0.02;

/// Outer steps in which neither the residual halves nor fewer entries change sets than ever before after which the
/// method is stuck, once the sets stand.
const PATIENCE: usize = 4;

/// What the outer steps have come to.
#[derive(Debug)]
pub(super) struct Progress {
    /// The same while the sets change.
    cycle: usize,
    /// Entries that changed sets in the last step; as many as can be before the first.
    pub(super) changes: usize,
    fewest: usize,
    best: f64,
    without: usize,
    /// Reduction of the inner residual while sets change: once tightened it stays so.
    pub(super) inner_reduction: f64,
}

impl Progress {
    /// Before the first step; `cycle` steps without progress are a cycle.
    pub(super) fn new(cycle: usize, inner_reduction: f64) -> Self {
        Self {
            cycle,
            changes: usize::MAX,
            fewest: usize::MAX,
            best: f64::INFINITY,
            without: 0,
            inner_reduction,
        }
    }

    /// Whether a residual to single precision is enough to go on by.
    pub(super) fn is_early(&self) -> bool {
        self.best > EARLY && self.without == 0
    }

    /// Takes note of a step; says if the method is stuck.
    pub(super) fn is_stuck_at(&mut self, merit: f64) -> bool {
        // Infinite ones do not count as halved.
        if merit < 0.5 * self.best || self.changes < self.fewest {
            self.best = self.best.min(merit);
            self.fewest = self.fewest.min(self.changes);
            self.without = 0;
            return false;
        }
        self.without += 1;
        if self.without >= DOUBT {
            self.inner_reduction = (0.1 * self.inner_reduction).max(LEAST_REDUCTION);
        }
        let patience = if self.changes == 0 {
            PATIENCE
        } else {
            self.cycle
        };
        self.without >= patience
    }

    /// How far the next inner iteration should reduce its residual.
    pub(super) fn reduction(&self, merit: f64, tolerance: f64) -> f64 {
        let last = (LAST * tolerance / merit).clamp(1e-4, INNER_REDUCTION);
        if self.changes == 0 || last > IN_SIGHT {
            last.min(self.inner_reduction)
        } else {
            self.inner_reduction
        }
    }
}
