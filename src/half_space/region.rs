//! A window of the grid, and what of it is held here.

use std::ops::Range;
use std::sync::Arc;

use crate::grid::Grid;
use crate::half_space::HalfSpace;
use crate::layout::Layout;
use crate::share::Share;
use crate::window::Window;

/// A window of the grid, and the rows of it that are held here: all, if no ranks share the grid. Fields of a region are
/// those of its rows held here.
#[derive(Debug, Clone)]
pub(crate) struct Region {
    window: Window,
    own: Window,
    layout: Layout,
    dealt: Option<Box<Dealt>>,
}

/// How grid and window are dealt out to ranks.
#[derive(Debug, Clone)]
struct Dealt {
    grid: Grid,
    outer: Arc<Share>,
    inner: Arc<Share>,
}

impl Region {
    pub(crate) fn new(bodies: &HalfSpace, window: Window) -> Self {
        let shares = bodies
            .share(bodies.grid().whole().size())
            .zip(bodies.share(window.size));
        let Some((outer, inner)) = shares else {
            return Self {
                window,
                own: window,
                layout: window.layout(),
                dealt: None,
            };
        };
        Self {
            window,
            own: window.rows(inner.own_rows()),
            layout: Layout::shared(Arc::clone(&inner)),
            dealt: Some(Box::new(Dealt {
                grid: bodies.grid(),
                outer,
                inner,
            })),
        }
    }

    /// The whole window.
    pub(crate) fn window(&self) -> Window {
        self.window
    }

    /// Its rows that are held here.
    pub(crate) fn own(&self) -> Window {
        self.own
    }

    /// Cells held here.
    pub(crate) fn cells(&self) -> usize {
        self.layout.cells()
    }

    /// How the cells lie.
    pub(crate) fn layout(&self) -> &Layout {
        &self.layout
    }

    /// Whether ranks share it.
    pub(crate) fn is_shared(&self) -> bool {
        self.dealt.is_some()
    }

    /// Copies the region out of a field of the grid.
    pub(crate) fn gather(&self, whole: &[f64], part: &mut [f64]) {
        let Some(Dealt { grid, outer, inner }) = self.dealt.as_deref() else {
            return self.window.gather(whole, part);
        };
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

    /// Copies the region into a field of the grid.
    pub(crate) fn scatter(&self, part: &[f64], whole: &mut [f64]) {
        let Some(Dealt { grid, outer, inner }) = self.dealt.as_deref() else {
            return self.window.scatter(part, whole);
        };
        let [columns, rows] = self.window.ranges();
        let inside = |slab: Range<usize>| {
            let (start, end) = (
                slab.start.clamp(rows.start, rows.end),
                slab.end.min(rows.end),
            );
            start - rows.start..end.max(start) - rows.start
        };
        let width = columns.len();
        let found = inner.fetch(part, width, |rank| [0..width, inside(outer.rows_of(rank))]);
        let (first, own) = (
            rows.start + inside(outer.own_rows()).start,
            outer.own_rows(),
        );
        for (row, found) in (first..).zip(found.chunks_exact(width)) {
            whole[(row - own.start) * grid.nx()..][columns.clone()].copy_from_slice(found);
        }
    }

    /// Hands what is known of each cell held here, `of(cell, its index in the whole grid)`, to who holds the cell on the
    /// grid: `put(its index there, what is known)`.
    pub(crate) fn spread<const K: usize>(
        &self,
        of: impl Fn(usize, usize) -> [f64; K],
        mut put: impl FnMut(usize, [f64; K]),
    ) {
        let Some(Dealt { grid, .. }) = self.dealt.as_deref() else {
            for (cell, index) in self.own.indices().enumerate() {
                put(index, of(cell, index));
            }
            return;
        };
        let known: Vec<[f64; K]> = (0..)
            .zip(self.own.indices())
            .map(|(cell, index)| of(cell, index))
            .collect();
        let fields: [Vec<f64>; K] = std::array::from_fn(|k| {
            let part: Vec<f64> = known.iter().map(|known| known[k]).collect();
            let mut field = vec![0.0; grid.cells()];
            self.scatter(&part, &mut field);
            field
        });
        let first = grid.rows().start * grid.nx();
        for cell in (0..grid.cells()).filter(|cell| self.window.contains(first + cell)) {
            put(cell, std::array::from_fn(|k| fields[k][cell]));
        }
    }
}
