//! What a transform works on, and what of it this rank does.

use std::ops::Range;
use std::sync::Arc;

use crate::error::Result;
use crate::parallel::ranks::WireFormat;
use crate::parallel::ranks::partition::RowPartition;

/// Fields of some cells on a torus, whose rows and columns may be dealt out to ranks.
#[derive(Debug, Clone)]
pub(super) struct TorusLayout {
    /// Cells of a field, `[along x, along y]`, of all ranks together.
    pub(super) size: [usize; 2],
    pub(super) torus: [usize; 2],
    /// How the rows are dealt out, if they are.
    pub(super) share: Option<Arc<RowPartition>>,
}

/// Columns of waves that a rank has are a multiple of this: whole tiles of either precision.
const COLUMN_STEP: usize = 16;

impl TorusLayout {
    /// Columns of waves, of all ranks together.
    pub(super) fn width(&self) -> usize {
        self.torus[0] / 2 + 1
    }

    /// Rows of cells held here.
    pub(super) fn local_rows(&self) -> Range<usize> {
        self.share
            .as_ref()
            .map_or(0..self.size[1], |share| share.local_rows())
    }

    /// The columns of waves that a rank multiplies.
    pub(super) fn columns_of(&self, rank: usize) -> Range<usize> {
        let ranks = self.share.as_ref().map_or(1, |share| share.team().size());
        let steps = self.width().div_ceil(COLUMN_STEP);
        let first = |rank: usize| (steps * rank / ranks * COLUMN_STEP).min(self.width());
        first(rank)..first(rank + 1)
    }

    /// The columns of waves that are multiplied here.
    pub(super) fn own_columns(&self) -> Range<usize> {
        let rank = self.share.as_ref().map_or(0, |share| share.team().rank());
        self.columns_of(rank)
    }

    /// The result of work in which ranks may agree on the way; an error if it failed on any.
    pub(super) fn run_collectively<T>(&self, work: impl FnOnce() -> Result<T>) -> Result<T> {
        match &self.share {
            Some(share) => share.team().run_collectively(work),
            None => work(),
        }
    }

    /// What the values of all ranks come to, combined in their order; only for combinations that do not round.
    pub(super) fn over_ranks<T: WireFormat>(&self, own: T, combine: impl Fn(T, T) -> T) -> T {
        match &self.share {
            Some(share) => share.team().combined(own, combine),
            None => own,
        }
    }
}
