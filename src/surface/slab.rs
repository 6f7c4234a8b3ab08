//! Local rows of a surface, and the order of sums over all ranks.

use std::borrow::Cow;
use std::sync::Arc;

use super::waves::shared_columns;
use crate::error::{Error, Result};
use crate::grid::Grid;
use crate::grid::field::Field;
use crate::memory::fallible;
use crate::parallel::layout::Layout;
use crate::parallel::ranks::partition::RowPartition;

/// Local rows of a surface: all rows, or a slab of a distributed surface.
#[derive(Debug)]
pub(crate) struct Slab {
    whole: Grid,
    first_row: usize,
    share: Option<Arc<RowPartition>>,
    layout: Layout,
}

impl Slab {
    /// Creates the local slab of a grid. `share` is the distribution of the rows, or `None` if the rows are not
    /// distributed.
    pub(crate) fn new(whole: Grid, share: Option<Arc<RowPartition>>) -> Self {
        let (first_row, layout) = match &share {
            Some(share) => (share.local_rows().start, Layout::shared(Arc::clone(share))),
            None => (0, whole.layout()),
        };
        Self {
            whole,
            first_row,
            share,
            layout,
        }
    }

    /// Treats a field as a whole surface, even if the field is a slab of a distributed surface. Returns an error if the
    /// field has no cells.
    pub(super) fn alone(heights: &Field) -> Result<Self> {
        let grid = heights.grid();
        let [nx, ny] = grid.size();
        if grid.cells() == 0 {
            return Err(Error::GridSize { nx, ny });
        }
        Ok(Self::new(grid.of_size([nx, ny]), None))
    }

    /// Returns the grid of all rows.
    pub(super) fn whole(&self) -> Grid {
        self.whole
    }

    /// Returns the first local row.
    pub(super) fn first_row(&self) -> usize {
        self.first_row
    }

    pub(super) fn layout(&self) -> &Layout {
        &self.layout
    }

    /// Returns the local rows and the next row, if it exists.
    pub(super) fn with_next_row<'a>(&self, heights: &'a Field) -> Result<Cow<'a, [f64]>> {
        let own = heights.as_slice();
        let Some(share) = &self.share else {
            return Ok(Cow::Borrowed(own));
        };
        let [nx, ny] = self.whole.size();
        let next = |rank: usize| {
            let rows = share.rows_of(rank);
            let count = usize::from(!rows.is_empty() && rows.end < ny);
            [0..nx, rows.end..rows.end + count]
        };
        let mut rows = share
            .team()
            .collective_result(fallible::with_room(own.len() + nx))?;
        rows.extend_from_slice(own);
        rows.extend(share.fetch(own, nx, next)?);
        Ok(Cow::Owned(rows))
    }

    /// Returns the distributions of the rows and of the columns of waves over the ranks, or `None` without ranks.
    pub(super) fn shares(&self) -> Option<[Arc<RowPartition>; 2]> {
        let rows = self.share.as_ref()?;
        let columns = shared_columns(self.whole, rows.team());
        Some([Arc::clone(rows), Arc::new(columns)])
    }
}
