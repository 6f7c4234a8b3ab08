//! Window of the grid, with its local part.

use std::borrow::Cow;
use std::sync::Arc;

use crate::grid::Grid;
use crate::grid::window::Window;
use crate::half_space::HalfSpace;
use crate::parallel::layout::Layout;
use crate::parallel::ranks::partition::RowPartition;

/// Window of the grid, with the rows that this rank solves. If no ranks share the grid, these are all rows. A field of
/// a region contains these rows.
///
/// Ranks share the rows of a window evenly. The slabs of the grid, which store states and solutions, divide the window
/// differently. The rows [stored](Self::held) on this rank are the rows of the window in its slab.
#[derive(Debug, Clone)]
pub(crate) struct Region {
    window: Window,
    own: Window,
    layout: Layout,
    held: Window,
    dealt: Option<Box<RegionPartition>>,
}

/// Distribution of grid and window over ranks.
#[derive(Debug, Clone)]
struct RegionPartition {
    grid: Grid,
    outer: Arc<RowPartition>,
    inner: Arc<RowPartition>,
    /// Distribution of the window rows according to the slabs of the grid.
    held: Arc<RowPartition>,
    /// Whether the stored rows differ from the rows solved on any rank.
    moves: bool,
}

impl Region {
    pub(crate) fn new(bodies: &HalfSpace, window: Window) -> Self {
        let grid = bodies.grid();
        let shares = bodies
            .share(grid.whole().size())
            .zip(bodies.share(window.size));
        let Some((outer, inner)) = shares else {
            return Self {
                window,
                own: window,
                layout: bodies.layout(window.size),
                held: window,
                dealt: None,
            };
        };
        let [columns, rows] = window.ranges();
        let lying = outer.within(columns.len(), rows);
        Self {
            window,
            own: window.rows(inner.local_rows()),
            layout: Layout::shared(Arc::clone(&inner)),
            held: window.held(grid),
            dealt: Some(Box::new(RegionPartition {
                grid,
                moves: !lying.has_rows_of(&inner),
                held: Arc::new(lying),
                outer,
                inner,
            })),
        }
    }

    /// Returns the whole window.
    pub(crate) fn window(&self) -> Window {
        self.window
    }

    /// Returns the rows of the window that this rank solves.
    pub(crate) fn own(&self) -> Window {
        self.own
    }

    /// Returns the rows of the window that this rank stores, relative to its slab.
    pub(crate) fn held(&self) -> Window {
        self.held
    }

    /// Returns the number of cells that this rank solves.
    pub(crate) fn cells(&self) -> usize {
        self.layout.cells()
    }

    /// Returns the layout of the cells that this rank solves.
    pub(crate) fn layout(&self) -> &Layout {
        &self.layout
    }

    /// Returns the layout of the cells that this rank stores. Sums over these cells are accumulated row by row, so the
    /// sums do not depend on the slabs.
    pub(crate) fn held_layout(&self) -> Layout {
        match &self.dealt {
            Some(dealt) => Layout::shared(Arc::clone(&dealt.held)),
            None => Layout::of_rows(self.window.size),
        }
    }

    /// Returns whether ranks share the window.
    pub(crate) fn is_shared(&self) -> bool {
        self.dealt.is_some()
    }

    /// Returns whether some cells are stored and solved by different ranks. For a window that covers the whole grid, no
    /// cells are moved, so fields need no copy.
    pub(crate) fn is_moved(&self) -> bool {
        self.moving().is_some()
    }

    fn moving(&self) -> Option<&RegionPartition> {
        self.dealt.as_deref().filter(|dealt| dealt.moves)
    }

    /// Copies the region from a field of the grid.
    pub(crate) fn gather(&self, whole: &[f64], part: &mut [f64]) {
        let Some(dealt) = self.moving() else {
            return self.held.gather(whole, part);
        };
        let RegionPartition {
            grid, outer, inner, ..
        } = dealt;
        let [columns, rows] = self.window.ranges();
        let wanted = |rank: usize| {
            let own = inner.rows_of(rank);
            [
                columns.clone(),
                rows.start + own.start..rows.start + own.end,
            ]
        };
        let blocks = vec![Vec::new(); outer.team().size()];
        outer.fetch_into(whole, grid.nx(), wanted, blocks, part);
    }

    /// Fills the region like [`Self::gather`], but from a function of the local cells of the grid.
    pub(crate) fn collect(&self, of: impl Fn(usize) -> f64, part: &mut [f64]) {
        if self.is_moved() {
            let held: Vec<f64> = self.held.indices().map(of).collect();
            return self.take(&held, part);
        }
        for (part, index) in part.iter_mut().zip(self.held.indices()) {
            *part = of(index);
        }
    }

    /// Copies the region into a field of the grid.
    pub(crate) fn scatter(&self, part: &[f64], whole: &mut [f64]) {
        self.held.scatter(&self.given(part), whole);
    }

    /// Copies a field of the stored rows into a field of the region.
    pub(crate) fn take(&self, held: &[f64], part: &mut [f64]) {
        part.copy_from_slice(&self.taken(held));
    }

    /// Returns a field of the stored rows as a field of the region.
    pub(crate) fn taken<'a>(&self, held: &'a [f64]) -> Cow<'a, [f64]> {
        match self.moving() {
            Some(dealt) => Cow::Owned(self.moved(held, &dealt.held, &dealt.inner)),
            None => Cow::Borrowed(held),
        }
    }

    /// Returns a field of the region as a field of the stored rows.
    pub(crate) fn given<'a>(&self, part: &'a [f64]) -> Cow<'a, [f64]> {
        match self.moving() {
            Some(dealt) => Cow::Owned(self.moved(part, &dealt.inner, &dealt.held)),
            None => Cow::Borrowed(part),
        }
    }

    /// Redistributes a field of the window. The caller already stores fields of this size.
    fn moved(&self, field: &[f64], from: &RowPartition, to: &RowPartition) -> Vec<f64> {
        let [columns, _] = self.window.size;
        let wanted = |rank: usize| [0..columns, to.rows_of(rank)];
        let blocks = vec![Vec::new(); from.team().size()];
        let mut found = vec![0.0; to.cells()];
        from.fetch_into(field, columns, wanted, blocks, &mut found);
        found
    }
}
