//! The two-dimensional real transform of zero-padded fields, one pass over memory per stage.
//!
//! Rows: pairs of real ones as complex ones, only those that are not zero. Columns, two cache lines of each row at a
//! time: gather, pad, transform, multiply by the kernel, transform back, keep what is wanted. Rows: back to pairs of real
//! ones.
//! Between the stages a field lies in tiles; from stage to stage their owners change, not their places.

use std::fmt;
use std::ops::Range;
use std::sync::Arc;

use num_complex::Complex;
use rustfft::Fft;

use crate::error::Result;
use crate::fft::columns::ColumnScratch;
use crate::fft::precision::Real;
use crate::fft::rows::RowScratch;
use crate::fft::symbol::Symbol;
use crate::fft::tiles::{TILE_ROWS, Tile, Tiles, exchange};
use crate::fft::torus::TorusLayout;
use crate::memory::pool::Pool;
use crate::parallel::layout::Layout;
use crate::parallel::{self, Blocks, Split};

/// Transforms of an `nx` x `ny` field padded to `mx` x `my`. Immutable and shared.
#[derive(Clone)]
pub(super) struct Plan<T: Real> {
    pub(super) frame: TorusLayout,
    /// The row at which each tile of a column begins.
    pub(super) tile_rows: Vec<usize>,
    pub(super) row_forward: Arc<dyn Fft<T>>,
    pub(super) row_inverse: Arc<dyn Fft<T>>,
    pub(super) column_forward: Arc<dyn Fft<T>>,
    pub(super) column_inverse: Arc<dyn Fft<T>>,
}

impl<T: Real> fmt::Debug for Plan<T> {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            formatter,
            "Plan({:?} in {:?})",
            self.frame.size, self.frame.torus
        )
    }
}

/// Buffers for the tasks of transforms of N fields.
#[derive(Debug, Clone)]
pub(super) struct TaskScratch<T, const N: usize> {
    pub(super) rows: Pool<RowScratch<T>>,
    pub(super) columns: Pool<ColumnScratch<T, N>>,
}

impl<T: Real> Plan<T> {
    pub(super) fn new(frame: TorusLayout) -> Self {
        let [row, column] = T::transforms(frame.torus);
        let ([row_forward, row_inverse], [column_forward, column_inverse]) = (row, column);
        Self {
            tile_rows: tile_rows(&frame),
            frame,
            row_forward,
            row_inverse,
            column_forward,
            column_inverse,
        }
    }

    /// Cells of a field.
    pub(super) fn cells(&self) -> usize {
        self.frame.size[0] * self.frame.local_rows().len()
    }

    /// Cells of the torus, all of which a sum of waves is divided by.
    pub(super) fn cells_of_torus(&self) -> f64 {
        let [mx, my] = self.frame.torus;
        (mx * my) as f64
    }

    /// How the cells of a field lie.
    pub(super) fn layout(&self) -> Layout {
        match &self.frame.share {
            Some(share) => Layout::shared(Arc::clone(share)),
            None => Layout::of(self.frame.size),
        }
    }

    /// Complex numbers in a transformed row.
    pub(super) fn width(&self) -> usize {
        self.frame.width()
    }

    /// Tiles along x, of all ranks together.
    pub(super) fn tiles_across(&self) -> usize {
        self.width().div_ceil(T::TILE_COLUMNS)
    }

    /// Tiles along x whose columns a rank multiplies.
    pub(super) fn tile_columns_of(&self, rank: usize) -> Range<usize> {
        let columns = self.frame.columns_of(rank);
        columns.start / T::TILE_COLUMNS..columns.end.div_ceil(T::TILE_COLUMNS)
    }

    /// Tiles along x whose columns are multiplied here.
    pub(super) fn own_tile_columns(&self) -> Range<usize> {
        let columns = self.frame.own_columns();
        columns.start / T::TILE_COLUMNS..columns.end.div_ceil(T::TILE_COLUMNS)
    }

    /// Tiles along y of the rows held here.
    pub(super) fn tiles_down(&self) -> usize {
        self.frame.local_rows().len().div_ceil(TILE_ROWS)
    }

    /// Tiles along y, of all ranks together.
    pub(super) fn tiles_along(&self) -> usize {
        self.tile_rows.len()
    }

    /// Whether a field is too short to share its work.
    fn is_short(&self) -> bool {
        parallel::is_short(self.cells())
    }

    /// Runs `work(band, its part of data)` for the bands of a stage.
    pub(super) fn bands<D: Split>(&self, bands: usize, data: D, work: impl Fn(usize, D) + Sync) {
        if bands == 0 {
            // Of a rank without rows, or columns.
        } else if self.is_short() {
            parallel::in_turn(0..bands, data, &work, &|(), ()| ());
        } else {
            parallel::sweep(0..bands, data, &work, &|(), ()| ());
        }
    }

    /// Whether fields are one row, of one process, whose columns have nothing to transform.
    fn is_line(&self) -> bool {
        self.frame.torus[1] == 1 && self.frame.share.is_none()
    }

    /// Tiles that products work in; a line needs none.
    ///
    /// # Errors
    /// [`Error::Memory`](crate::Error::Memory).
    pub(super) fn tiles_of_products<const N: usize>(&self) -> Result<Tiles<N>> {
        if self.is_line() {
            return Tiles::new([0; 2], [0; 2], |_, _| Ok(()));
        }
        self.tiles()
    }

    /// Tiles of N fields.
    ///
    /// # Errors
    /// [`Error::Memory`](crate::Error::Memory).
    pub(super) fn tiles<const N: usize>(&self) -> Result<Tiles<N>> {
        let (across, down) = (self.tiles_across(), self.tiles_down());
        let own_columns = self.own_tile_columns().len();
        // Each band is made by the task that first writes there.
        Tiles::new(
            [across, down],
            [own_columns, self.tiles_along()],
            |tiles, fill| {
                let (data, bands) = (blocks(tiles, across), 0..down);
                let work = |_: usize, band: Blocks<'_, Tile>| fill(band.items);
                parallel::sweep_cells(self.cells(), bands, data, &work, &Result::and)
            },
        )
    }

    /// # Errors
    /// [`Error::Memory`](crate::Error::Memory).
    pub(super) fn scratch<const N: usize>(&self) -> Result<TaskScratch<T, N>> {
        let tasks = if self.is_short() {
            1
        } else {
            parallel::threads()
        };
        Ok(TaskScratch {
            rows: Pool::of(tasks, || self.row_scratch())?,
            columns: Pool::of(tasks, || self.column_scratch())?,
        })
    }

    /// `out = inverse(symbol * forward(x))`, all fields `nx` x `ny`; `scales` multiply what goes
    /// in and what comes out.
    pub(super) fn convolve<const N: usize>(
        &self,
        symbol: &Symbol<T, N>,
        x: [&[f64]; N],
        out: [&mut [f64]; N],
        scales: [f64; 2],
        tiles: &mut Tiles<N>,
        scratch: &TaskScratch<T, N>,
    ) {
        parallel::enter_with(self.cells(), || {
            self.convolve_here(symbol, x, out, scales, tiles, scratch);
        });
    }

    fn convolve_here<const N: usize>(
        &self,
        symbol: &Symbol<T, N>,
        x: [&[f64]; N],
        out: [&mut [f64]; N],
        scales: [f64; 2],
        tiles: &mut Tiles<N>,
        scratch: &TaskScratch<T, N>,
    ) {
        assert!(
            x.iter().all(|x| x.len() == self.cells())
                && out.iter().all(|out| out.len() == self.cells()),
            "fields must be those of the {:?} cells of the operator",
            self.frame.size
        );
        if self.is_line() {
            return self.convolve_line(symbol, x, out, scales, &scratch.rows);
        }
        let (across, along) = (self.tiles_across(), self.tiles_along());
        let down = self.tiles_down();
        let (rows_tiles, columns_tiles) = (across * down, self.own_tile_columns().len() * along);
        let Tiles {
            by_rows,
            occupied,
            by_columns,
            spare,
        } = tiles;
        assert!(
            occupied.iter().all(|bands| bands.len() == along)
                && by_rows.iter().all(|tiles| tiles.len() >= rows_tiles)
                && by_columns.iter().all(|tiles| tiles.len() >= columns_tiles),
            "a workspace must be that of the {:?} cells of the operator",
            self.frame.size
        );
        let by_rows = by_rows.each_mut().map(|tiles| &mut tiles[..rows_tiles]);
        let mut by_columns = by_columns
            .each_mut()
            .map(|tiles| &mut tiles[..columns_tiles]);
        let own = self.own_tile_rows();
        for n in 0..N {
            let (rows, own) = (&mut *by_rows[n], &mut occupied[n][own.clone()]);
            self.forward_rows(x[n], scales[0], rows, own, &scratch.rows);
            self.to_columns(rows, by_columns[n], &mut occupied[n], spare);
        }
        self.columns(symbol, &mut by_columns, occupied, &scratch.columns);
        for (n, out) in out.into_iter().enumerate() {
            self.to_rows(by_columns[n], by_rows[n], spare);
            self.inverse_rows(by_rows[n], out, scales[1], &scratch.rows);
        }
    }

    /// Hands tiles from who has their rows to who multiplies their columns. Every rank then knows which bands of all hold
    /// anything.
    pub(super) fn to_columns(
        &self,
        by_rows: &mut [Tile],
        by_columns: &mut [Tile],
        occupied: &mut [bool],
        spare: &mut Vec<Tile>,
    ) {
        match &self.frame.share {
            Some(share) => self.deal_columns(share, by_rows, by_columns, occupied, spare),
            None => exchange(by_rows, by_columns, self.tiles_across()),
        }
    }

    /// Hands them back.
    pub(super) fn to_rows(
        &self,
        by_columns: &mut [Tile],
        by_rows: &mut [Tile],
        spare: &mut Vec<Tile>,
    ) {
        match &self.frame.share {
            Some(share) => self.tiles_to_rows(share, by_columns, by_rows, spare),
            None => exchange(by_columns, by_rows, self.tiles_along()),
        }
    }
}

/// The row at which each tile of a column begins: those of each rank from its own first row.
fn tile_rows(frame: &TorusLayout) -> Vec<usize> {
    let tiles = |rows: Range<usize>| rows.step_by(TILE_ROWS);
    match &frame.share {
        Some(share) => {
            let ranks = 0..share.team().size();
            ranks.flat_map(|rank| tiles(share.rows_of(rank))).collect()
        }
        None => tiles(0..frame.size[1]).collect(),
    }
}

pub(super) fn blocks<T>(items: &mut [T], width: usize) -> Blocks<'_, T> {
    Blocks { items, width }
}

pub(super) fn zero<T: Real>() -> Complex<T> {
    Complex::new(T::zero(), T::zero())
}
