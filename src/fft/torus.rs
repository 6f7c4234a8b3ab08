//! The torus of a transform, and its partition over the ranks.

use std::ops::Range;
use std::sync::Arc;

use crate::error::Result;
use crate::parallel::ranks::WireFormat;
use crate::parallel::ranks::partition::RowPartition;

/// Layout of fields on a torus, whose rows and columns may be distributed over ranks.
#[derive(Debug, Clone)]
pub(super) struct TorusLayout {
    /// Number of cells of a field, `[along x, along y]`, over all ranks.
    pub(super) size: [usize; 2],
    pub(super) torus: [usize; 2],
    /// Partition of the rows over the ranks, or `None` for a single process.
    pub(super) share: Option<Arc<RowPartition>>,
}

/// Divisor of the number of columns of waves of a rank. No tile of either precision is therefore split between
/// ranks.
const COLUMN_STEP: usize = 16;

impl TorusLayout {
    /// Returns the number of columns of waves, over all ranks.
    pub(super) fn width(&self) -> usize {
        self.torus[0] / 2 + 1
    }

    /// Returns the local rows of cells.
    pub(super) fn local_rows(&self) -> Range<usize> {
        self.share
            .as_ref()
            .map_or(0..self.size[1], |share| share.local_rows())
    }

    /// Returns the columns of waves that a rank multiplies.
    pub(super) fn columns_of(&self, rank: usize) -> Range<usize> {
        let ranks = self.share.as_ref().map_or(1, |share| share.team().size());
        let steps = self.width().div_ceil(COLUMN_STEP);
        let first = |rank: usize| (steps * rank / ranks * COLUMN_STEP).min(self.width());
        first(rank)..first(rank + 1)
    }

    /// Returns the local columns of waves.
    pub(super) fn own_columns(&self) -> Range<usize> {
        let rank = self.share.as_ref().map_or(0, |share| share.team().rank());
        self.columns_of(rank)
    }

    /// Runs work that may include collective calls. Returns an error on all ranks if the work failed on any rank.
    pub(super) fn run_collectively<T>(&self, work: impl FnOnce() -> Result<T>) -> Result<T> {
        match &self.share {
            Some(share) => share.team().run_collectively(work),
            None => work(),
        }
    }

    /// Combines the values of all ranks in rank order. The combination must not round.
    pub(super) fn over_ranks<T: WireFormat>(&self, own: T, combine: impl Fn(T, T) -> T) -> T {
        match &self.share {
            Some(share) => share.team().combined(own, combine),
            None => own,
        }
    }
}
