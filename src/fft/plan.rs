//! The two-dimensional real transform of zero-padded fields, one pass over memory per stage.
//!
//! Rows: real to complex, only those that are not zero. Columns, two cache lines of each row at a time: gather, pad,
//! transform, multiply by the kernel, transform back, keep what is wanted. Rows: complex to real.
//! Between the stages a field lies in tiles; from stage to stage their owners change, not their places.

use std::fmt;
use std::sync::Arc;

use num_complex::Complex;
use realfft::{ComplexToReal, RealFftPlanner, RealToComplex};
use rustfft::{Fft, FftPlanner};

use crate::fft::columns::ColumnScratch;
use crate::fft::real::Real;
use crate::fft::rows::RowScratch;
use crate::fft::symbol::Symbol;
use crate::fft::tiles::{TILE_ROWS, Tiles, exchange};
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

/// What the tasks of transforms of N fields work in.
#[derive(Debug, Clone)]
pub(super) struct Scratch<T, const N: usize> {
    pub(super) rows: Pool<RowScratch<T>>,
    pub(super) columns: Pool<ColumnScratch<T, N>>,
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
        self.width().div_ceil(T::TILE_COLUMNS)
    }

    /// Tiles along y.
    pub(super) fn tiles_down(&self) -> usize {
        self.ny.div_ceil(TILE_ROWS)
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

    /// Tiles of N fields.
    pub(super) fn tiles<const N: usize>(&self) -> Tiles<N> {
        let (across, down) = (self.tiles_across(), self.tiles_down());
        // Each band is made by the task that first writes there.
        Tiles::new(across, down, |tiles, fill| {
            self.bands(down, blocks(tiles, across), |_, band| fill(band.items));
        })
    }

    pub(super) fn scratch<const N: usize>(&self) -> Scratch<T, N> {
        let tasks = if self.is_short() {
            1
        } else {
            parallel::threads()
        };
        Scratch {
            rows: Pool::new(vec![self.row_scratch(); tasks]),
            columns: Pool::new(vec![self.column_scratch(); tasks]),
        }
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
        scratch: &Scratch<T, N>,
    ) {
        let (across, down) = (self.tiles_across(), self.tiles_down());
        let tiles_of_field = across * down;
        let Tiles {
            by_rows,
            occupied,
            by_columns,
        } = tiles;
        assert!(
            x.iter().all(|x| x.len() == self.cells())
                && out.iter().all(|out| out.len() == self.cells())
                && occupied.iter().all(|bands| bands.len() == down)
                && by_rows.iter().all(|tiles| tiles.len() >= tiles_of_field),
            "fields and workspace must be those of the {} x {} cells of the operator",
            self.nx,
            self.ny
        );
        let by_rows = by_rows.each_mut().map(|tiles| &mut tiles[..tiles_of_field]);
        let mut by_columns = by_columns
            .each_mut()
            .map(|tiles| &mut tiles[..tiles_of_field]);
        for n in 0..N {
            let (rows, occupied) = (&mut *by_rows[n], &mut occupied[n]);
            self.forward_rows(x[n], scales[0], rows, occupied, &scratch.rows);
            exchange(rows, by_columns[n], across);
        }
        self.columns(symbol, &mut by_columns, occupied, &scratch.columns);
        for (n, out) in out.into_iter().enumerate() {
            exchange(by_columns[n], by_rows[n], down);
            self.inverse_rows(by_rows[n], out, scales[1], &scratch.rows);
        }
    }
}

pub(super) fn blocks<T>(items: &mut [T], width: usize) -> Blocks<'_, T> {
    Blocks { items, width }
}

pub(super) fn zero<T: Real>() -> Complex<T> {
    Complex::new(T::zero(), T::zero())
}
