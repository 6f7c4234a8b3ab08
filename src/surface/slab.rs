//! Which rows of a surface are held here, and how those of all ranks add up.

use std::borrow::Cow;
use std::sync::Arc;

use super::waves::shared_columns;
use crate::error::{Error, Result};
use crate::grid::Grid;
use crate::grid::field::Field;
use crate::parallel::layout::Layout;
use crate::parallel::ranks::partition::RowPartition;

/// The rows of a surface that are held here: all, or a slab of what ranks share.
#[derive(Debug)]
pub(crate) struct Slab {
    whole: Grid,
    first_row: usize,
    share: Option<Arc<RowPartition>>,
    layout: Layout,
}

impl Slab {
    /// Of a grid whose rows are dealt out so, if they are.
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

    /// A surface by itself, whatever it may be a slab of; an error if it has no cells.
    pub(super) fn alone(heights: &Field) -> Result<Self> {
        let grid = heights.grid();
        let [nx, ny] = grid.size();
        if grid.cells() == 0 {
            return Err(Error::GridSize { nx, ny });
        }
        Ok(Self::new(grid.of_size([nx, ny]), None))
    }

    /// The grid of all rows.
    pub(super) fn whole(&self) -> Grid {
        self.whole
    }

    /// The first row held here.
    pub(super) fn first_row(&self) -> usize {
        self.first_row
    }

    pub(super) fn layout(&self) -> &Layout {
        &self.layout
    }

    /// The rows held here and the next one, if there is any.
    pub(super) fn with_next_row<'a>(&self, heights: &'a Field) -> Cow<'a, [f64]> {
        let own = heights.as_slice();
        let Some(share) = &self.share else {
            return Cow::Borrowed(own);
        };
        let [nx, ny] = self.whole.size();
        let next = |rank: usize| {
            let rows = share.rows_of(rank);
            let count = usize::from(!rows.is_empty() && rows.end < ny);
            [0..nx, rows.end..rows.end + count]
        };
        Cow::Owned([own, &share.fetch(own, nx, next)].concat())
    }

    /// Whose waves are held where, and how rows travel there: none without ranks.
    pub(super) fn shares(&self) -> Option<[Arc<RowPartition>; 2]> {
        let rows = self.share.as_ref()?;
        let columns = shared_columns(self.whole, rows.team());
        Some([Arc::clone(rows), Arc::new(columns)])
    }
}
