//! Two-dimensional real transform of zero-padded fields, with one pass over memory per stage.
//!
//! The transform has three stages:
//!
//! 1. Rows: pairs of real rows are transformed as complex rows. Rows of zeros are skipped.
//! 2. Columns, two cache lines of each row at a time: gather, pad, transform, multiply by the kernel, transform back, and
//!    keep the part on the grid.
//! 3. Rows: the inverse transform back to pairs of real rows.
//!
//! Between the stages a field is stored in tiles. The owners of the tiles change from stage to stage, but the memory of the tiles
//! does not.

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

/// Transforms of an `nx` x `ny` field padded to `mx` x `my`. Plans are immutable and can be shared.
#[derive(Clone)]
pub(super) struct Plan<T: Real> {
    pub(super) frame: TorusLayout,
    /// First row of each tile of a column.
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

    /// Returns the number of local cells of a field.
    pub(super) fn cells(&self) -> usize {
        self.frame.size[0] * self.frame.local_rows().len()
    }

    /// Returns the number of cells of the torus, by which sums of waves are divided.
    pub(super) fn cells_of_torus(&self) -> f64 {
        let [mx, my] = self.frame.torus;
        (mx * my) as f64
    }

    /// Returns the layout of the cells of a field.
    pub(super) fn layout(&self) -> Layout {
        match &self.frame.share {
            Some(share) => Layout::shared(Arc::clone(share)),
            None => Layout::of(self.frame.size),
        }
    }

    /// Returns the number of complex values in a transformed row.
    pub(super) fn width(&self) -> usize {
        self.frame.width()
    }

    /// Returns the number of tiles along x, over all ranks.
    pub(super) fn tiles_across(&self) -> usize {
        self.width().div_ceil(T::TILE_COLUMNS)
    }

    /// Returns the tiles along x whose columns a rank multiplies.
    pub(super) fn tile_columns_of(&self, rank: usize) -> Range<usize> {
        let columns = self.frame.columns_of(rank);
        columns.start / T::TILE_COLUMNS..columns.end.div_ceil(T::TILE_COLUMNS)
    }

    /// Returns the tiles along x whose columns are local.
    pub(super) fn own_tile_columns(&self) -> Range<usize> {
        let columns = self.frame.own_columns();
        columns.start / T::TILE_COLUMNS..columns.end.div_ceil(T::TILE_COLUMNS)
    }

    /// Returns the number of tiles along y for the local rows.
    pub(super) fn tiles_down(&self) -> usize {
        self.frame.local_rows().len().div_ceil(TILE_ROWS)
    }

    /// Returns the number of tiles along y, over all ranks.
    pub(super) fn tiles_along(&self) -> usize {
        self.tile_rows.len()
    }

    /// Returns whether a field is too small for parallel work.
    fn is_short(&self) -> bool {
        parallel::is_short(self.cells())
    }

    /// Runs `work(band, its part of data)` for the bands of a stage.
    pub(super) fn bands<D: Split>(&self, bands: usize, data: D, work: impl Fn(usize, D) + Sync) {
        if bands == 0 {
            // This rank has no rows, or no columns.
        } else if self.is_short() {
            parallel::in_turn(0..bands, data, &work, &|(), ()| ());
        } else {
            parallel::sweep(0..bands, data, &work, &|(), ()| ());
        }
    }

    /// Returns whether fields are a single row on one process. Their columns need no transform.
    fn is_line(&self) -> bool {
        self.frame.torus[1] == 1 && self.frame.share.is_none()
    }

    /// Creates the tiles for products. A line needs no tiles.
    ///
    /// # Errors
    /// - [`Error::Memory`](crate::Error::Memory) if memory runs out.
    pub(super) fn tiles_of_products<const N: usize>(&self) -> Result<Tiles<N>> {
        if self.is_line() {
            return Tiles::new([0; 2], [0; 2], |_, _| Ok(()));
        }
        self.tiles()
    }

    /// Creates the tiles of N fields.
    ///
    /// # Errors
    /// - [`Error::Memory`](crate::Error::Memory) if memory runs out.
    pub(super) fn tiles<const N: usize>(&self) -> Result<Tiles<N>> {
        let (across, down) = (self.tiles_across(), self.tiles_down());
        let own_columns = self.own_tile_columns().len();
        // Each band is allocated by the task that first writes to it.
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
    /// - [`Error::Memory`](crate::Error::Memory) if memory runs out.
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

    /// Computes `out = inverse(symbol * forward(x))` for fields of `nx` x `ny` cells. The input and the output are multiplied by
    /// `scales`.
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
            "the fields must have the {:?} cells of the operator",
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
            "the workspace must have the {:?} cells of the operator",
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

    /// Transfers tiles from the owners of their rows to the owners of their columns. Afterwards every rank has the
    /// occupied bands of all ranks.
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

    /// Transfers tiles from the owners of their columns back to the owners of their rows.
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

/// Returns the first row of each tile of a column. The tiles of each rank start at the first row of that rank.
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
