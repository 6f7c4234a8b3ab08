//! A window of the grid, and what of it is held here.

use std::borrow::Cow;
use std::sync::Arc;

use crate::grid::Grid;
use crate::grid::window::Window;
use crate::half_space::HalfSpace;
use crate::parallel::layout::Layout;
use crate::parallel::ranks::partition::RowPartition;

/// A window of the grid, and the rows of it that are solved here: all, if no ranks share the grid. Fields of a region are
/// those of its rows solved here.
///
/// Ranks share the rows of a window evenly. Those that lie in their slabs of the grid, where states and solutions are, are
/// others: its rows [held](Self::held) here.
#[derive(Debug, Clone)]
pub(crate) struct Region {
    window: Window,
    own: Window,
    layout: Layout,
    held: Window,
    dealt: Option<Box<RegionPartition>>,
}

/// How grid and window are dealt out to ranks.
#[derive(Debug, Clone)]
struct RegionPartition {
    grid: Grid,
    outer: Arc<RowPartition>,
    inner: Arc<RowPartition>,
    /// The rows of the window as the slabs of the grid have them.
    held: Arc<RowPartition>,
    /// Whether these are not the rows solved here.
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

    /// The whole window.
    pub(crate) fn window(&self) -> Window {
        self.window
    }

    /// Its rows that are solved here.
    pub(crate) fn own(&self) -> Window {
        self.own
    }

    /// Its rows that are held here, as a window of the slab.
    pub(crate) fn held(&self) -> Window {
        self.held
    }

    /// Cells solved here.
    pub(crate) fn cells(&self) -> usize {
        self.layout.cells()
    }

    /// How the cells lie.
    pub(crate) fn layout(&self) -> &Layout {
        &self.layout
    }

    /// How the cells held here lie: sums over them add up row by row, wherever a slab ends.
    pub(crate) fn held_layout(&self) -> Layout {
        match &self.dealt {
            Some(dealt) => Layout::shared(Arc::clone(&dealt.held)),
            None => Layout::of_rows(self.window.size),
        }
    }

    /// Whether ranks share it.
    pub(crate) fn is_shared(&self) -> bool {
        self.dealt.is_some()
    }

    /// Whether cells are held and solved by different ranks. A window of the whole grid has them where they are: nothing
    /// need be copied then.
    pub(crate) fn is_moved(&self) -> bool {
        self.moving().is_some()
    }

    fn moving(&self) -> Option<&RegionPartition> {
        self.dealt.as_deref().filter(|dealt| dealt.moves)
    }

    /// Copies the region out of a field of the grid.
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
        part.copy_from_slice(&outer.fetch(whole, grid.nx(), wanted));
    }

    /// The same of the values of a function of the cells of the grid held here.
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

    /// Copies a field of the rows held here into one of the region.
    pub(crate) fn take(&self, held: &[f64], part: &mut [f64]) {
        part.copy_from_slice(&self.taken(held));
    }

    /// A field of the rows held here, as one of the region.
    pub(crate) fn taken<'a>(&self, held: &'a [f64]) -> Cow<'a, [f64]> {
        match self.moving() {
            Some(dealt) => Cow::Owned(self.moved(held, &dealt.held, &dealt.inner)),
            None => Cow::Borrowed(held),
        }
    }

    /// A field of the region, as one of the rows held here.
    pub(crate) fn given<'a>(&self, part: &'a [f64]) -> Cow<'a, [f64]> {
        match self.moving() {
            Some(dealt) => Cow::Owned(self.moved(part, &dealt.inner, &dealt.held)),
            None => Cow::Borrowed(part),
        }
    }

    /// A field of the window that lies as in one share, as in the other.
    fn moved(&self, field: &[f64], from: &RowPartition, to: &RowPartition) -> Vec<f64> {
        let [columns, _] = self.window.size;
        from.fetch(field, columns, |rank| [0..columns, to.rows_of(rank)])
    }
}
