//! The two-dimensional real transform of zero-padded fields, one pass over memory per stage.
//!
//! Rows: real to complex, only those that are not zero. Columns, eight at a time: gather, pad,
//! transform, multiply by the kernel, transform back, keep what is wanted. Rows: complex to real.
//! Between the stages a field lies in tiles; from stage to stage their owners change, not their places.

use std::array::from_fn;
use std::fmt;
use std::sync::Arc;

use num_complex::Complex;
use realfft::{ComplexToReal, RealFftPlanner, RealToComplex};
use rustfft::{Fft, FftPlanner};

use crate::fft::columns::ColumnScratch;
use crate::fft::real::Real;
use crate::fft::rows::RowScratch;
use crate::fft::symbol::Symbol;
use crate::fft::tiles::{self, TILE_COLUMNS, TILE_ROWS, Tile, exchange};
use crate::parallel::{self, Blocks, Split};
use crate::pool::Pool;

/// Transforms of an `nx` x `ny` field padded to `mx` x `my`. Immutable and shared.
#[derive(Clone)]
pub(super) struct Plan<T: Real> {
    pub(super) nx: usize,
    pub(super) ny: usize,
    pub(super) mx: usize,
    pub(super) my: usize,
    pub(super) row_forward: Arc<dyn RealToComplex<T>>,
    pub(super) row_inverse: Arc<dyn ComplexToReal<T>>,
    pub(super) column_forward: Arc<dyn Fft<T>>,
    pub(super) column_inverse: Arc<dyn Fft<T>>,
}

impl<T: Real> fmt::Debug for Plan<T> {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            formatter,
            "Plan({} x {} in {} x {})",
            self.nx, self.ny, self.mx, self.my
        )
    }
}

/// Buffers of a product: two numbers per cell of each of N fields, and a little for each task.
#[derive(Debug, Clone)]
pub(super) struct Buffers<T, const N: usize> {
    /// All tiles of a band of rows, then of the next band; a task owns bands of rows.
    by_rows: [Vec<Tile<T>>; N],
    /// Which bands of rows hold anything.
    occupied: [Vec<bool>; N],
    /// The same tiles while a task owns bands of columns.
    by_columns: [Vec<Tile<T>>; N],
    row_scratch: Pool<RowScratch<T>>,
    column_scratch: Pool<ColumnScratch<T, N>>,
}

impl<T: Real> Plan<T> {
    pub(super) fn new([nx, ny]: [usize; 2], [mx, my]: [usize; 2]) -> Self {
        let mut real = RealFftPlanner::new();
        let mut complex = FftPlanner::new();
        Self {
            nx,
            ny,
            mx,
            my,
            row_forward: real.plan_fft_forward(mx),
            row_inverse: real.plan_fft_inverse(mx),
            column_forward: complex.plan_fft_forward(my),
            column_inverse: complex.plan_fft_inverse(my),
        }
    }

    /// Cells of a field.
    pub(super) fn cells(&self) -> usize {
        self.nx * self.ny
    }

    /// Complex numbers in a transformed row.
    pub(super) fn width(&self) -> usize {
        self.mx / 2 + 1
    }

    /// Tiles along x.
    pub(super) fn tiles_across(&self) -> usize {
        self.width().div_ceil(TILE_COLUMNS)
    }

    /// Tiles along y.
    pub(super) fn tiles_down(&self) -> usize {
        self.ny.div_ceil(TILE_ROWS)
    }

    fn tiles(&self) -> usize {
        self.tiles_down() * self.tiles_across()
    }

    /// Whether a field is too short to share its work.
    fn is_short(&self) -> bool {
        parallel::is_short(self.cells())
    }

    /// Runs `work(band, its part of data)` for the bands of a stage.
    pub(super) fn bands<D: Split>(&self, bands: usize, data: D, work: impl Fn(usize, D) + Sync) {
        if self.is_short() {
            parallel::in_turn(0..bands, data, &work, &|(), ()| ());
        } else {
            parallel::sweep(0..bands, data, &work, &|(), ()| ());
        }
    }

    pub(super) fn workspace<const N: usize>(&self) -> Buffers<T, N> {
        let tasks = if self.is_short() {
            1
        } else {
            parallel::threads()
        };
        Buffers {
            by_rows: from_fn(|_| self.zero_tiles()),
            occupied: from_fn(|_| vec![false; self.tiles_down()]),
            by_columns: from_fn(|_| vec![Tile::default(); self.tiles()]),
            row_scratch: Pool::new(vec![self.row_scratch(); tasks]),
            column_scratch: Pool::new(vec![self.column_scratch(); tasks]),
        }
    }

    /// Tiles of a field, each band made by the task that first writes there.
    fn zero_tiles(&self) -> Vec<Tile<T>> {
        let mut tiles = vec![Tile::default(); self.tiles()];
        let bands = blocks(&mut tiles, self.tiles_across());
        self.bands(self.tiles_down(), bands, |_, band| {
            band.items.fill_with(tiles::zero);
        });
        tiles
    }

    /// `out = inverse(symbol * forward(x))`, all fields `nx` x `ny`; `scales` multiply what goes
    /// in and what comes out.
    pub(super) fn convolve<const N: usize>(
        &self,
        symbol: &Symbol<T, N>,
        x: [&[f64]; N],
        out: [&mut [f64]; N],
        scales: [f64; 2],
        workspace: &mut Buffers<T, N>,
    ) {
        let Buffers {
            by_rows,
            occupied,
            by_columns,
            row_scratch,
            column_scratch,
        } = workspace;
        assert!(
            x.iter().all(|x| x.len() == self.cells())
                && out.iter().all(|out| out.len() == self.cells())
                && by_rows.iter().all(|tiles| tiles.len() == self.tiles()),
            "fields and workspace must be those of the {} x {} cells of the operator",
            self.nx,
            self.ny
        );
        for n in 0..N {
            let (rows, occupied) = (&mut by_rows[n], &mut occupied[n]);
            self.forward_rows(x[n], scales[0], rows, occupied, row_scratch);
            exchange(rows, &mut by_columns[n], self.tiles_across());
        }
        self.columns(symbol, by_columns, occupied, column_scratch);
        for (n, out) in out.into_iter().enumerate() {
            exchange(&mut by_columns[n], &mut by_rows[n], self.tiles_down());
            self.inverse_rows(&by_rows[n], out, scales[1], row_scratch);
        }
    }
}

pub(super) fn blocks<T>(items: &mut [T], width: usize) -> Blocks<'_, T> {
    Blocks { items, width }
}

pub(super) fn zero<T: Real>() -> Complex<T> {
    Complex::new(T::zero(), T::zero())
}
