//! The two-dimensional real transform of a zero-padded field, one pass over memory per stage.
//!
//! Rows: real to complex, only those that are not zero. Columns, eight at a time: gather, pad,
//! transform, multiply by the kernel, transform back, keep what is wanted. Rows: complex to real.
//! Between the stages the field lies in tiles; from stage to stage their owners change, not their places.

use std::fmt;
use std::sync::Arc;

use num_complex::Complex;
use realfft::{ComplexToReal, RealFftPlanner, RealToComplex};
use rustfft::{Fft, FftPlanner};

use crate::fft::aligned::Aligned;
use crate::fft::real::Real;
use crate::fft::spectrum::Spectrum;
use crate::fft::tiles::{self, TILE_COLUMNS, TILE_ROWS, Tile, exchange};
use crate::parallel::{self, Blocks};

/// Transforms of an `nx` x `ny` field padded to `mx` x `my`. Immutable and shared.
#[derive(Clone)]
pub(super) struct Plan<T: Real> {
    pub(super) nx: usize,
    pub(super) ny: usize,
    pub(super) mx: usize,
    pub(super) my: usize,
    row_forward: Arc<dyn RealToComplex<T>>,
    row_inverse: Arc<dyn ComplexToReal<T>>,
    column_forward: Arc<dyn Fft<T>>,
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

/// Buffers of one transform: two numbers per cell of the field, and a little for each task.
#[derive(Debug, Clone)]
pub(super) struct Buffers<T> {
    /// All tiles of a band of rows, then of the next band; a task owns bands of rows.
    pub(super) by_rows: Vec<Tile<T>>,
    /// Which bands of rows hold anything.
    pub(super) occupied: Vec<bool>,
    /// The same tiles while a task owns bands of columns.
    pub(super) by_columns: Vec<Tile<T>>,
    pub(super) row_scratch: Vec<RowScratch<T>>,
    pub(super) column_scratch: Vec<ColumnScratch<T>>,
}

#[derive(Debug, Clone)]
pub(super) struct RowScratch<T> {
    real: Aligned<T>,
    /// Transforms of the rows of a band.
    complex: Aligned<Complex<T>>,
    transform: Aligned<Complex<T>>,
}

#[derive(Debug, Clone)]
pub(super) struct ColumnScratch<T> {
    pub(super) columns: Aligned<Complex<T>>,
    pub(super) transform: Aligned<Complex<T>>,
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

    /// From one transformed row to the next in scratch memory.
    fn row_stride(&self) -> usize {
        self.tiles_across() * TILE_COLUMNS
    }

    /// From one padded column to the next in scratch memory: room for whole tiles, and off the powers
    /// of two, at which all columns would share one corner of the cache.
    pub(super) fn column_stride(&self) -> usize {
        self.my
            .max(self.tiles_down() * TILE_ROWS)
            .next_multiple_of(TILE_COLUMNS)
            + TILE_COLUMNS
    }

    pub(super) fn workspace(&self) -> Buffers<T> {
        let zero = zero::<T>();
        let row_tasks = parallel::lanes().min(self.tiles_down());
        let column_tasks = parallel::lanes().min(self.tiles_across());
        let row_scratch = RowScratch {
            real: Aligned::new(T::zero(), self.mx),
            complex: Aligned::new(zero, TILE_ROWS * self.row_stride()),
            transform: Aligned::new(
                zero,
                self.row_forward
                    .get_scratch_len()
                    .max(self.row_inverse.get_scratch_len()),
            ),
        };
        let column_scratch = ColumnScratch {
            columns: Aligned::new(zero, TILE_COLUMNS * self.column_stride()),
            transform: Aligned::new(
                zero,
                self.column_forward
                    .get_inplace_scratch_len()
                    .max(self.column_inverse.get_inplace_scratch_len()),
            ),
        };
        let tiles = self.tiles_down() * self.tiles_across();
        Buffers {
            by_rows: vec![tiles::zero(); tiles],
            occupied: vec![false; self.tiles_down()],
            by_columns: vec![Tile::default(); tiles],
            row_scratch: vec![row_scratch; row_tasks],
            column_scratch: vec![column_scratch; column_tasks],
        }
    }

    /// `out = inverse(spectrum * forward(x))`, both fields `nx` x `ny`; `scales` multiply what goes
    /// in and what comes out.
    pub(super) fn convolve(
        &self,
        spectrum: &Spectrum<T>,
        x: &[f64],
        out: &mut [f64],
        scales: [f64; 2],
        workspace: &mut Buffers<T>,
    ) {
        let cells = self.nx * self.ny;
        let tiles = self.tiles_down() * self.tiles_across();
        assert!(
            x.len() == cells && out.len() == cells && workspace.by_rows.len() == tiles,
            "fields and workspace must be those of the {} x {} cells of the operator",
            self.nx,
            self.ny
        );
        let Buffers {
            by_rows,
            occupied,
            by_columns,
            row_scratch,
            column_scratch,
        } = workspace;
        self.forward_rows(x, scales[0], by_rows, occupied, row_scratch);
        exchange(by_rows, by_columns, self.tiles_across());
        self.columns(spectrum, by_columns, occupied, column_scratch);
        exchange(by_columns, by_rows, self.tiles_down());
        self.inverse_rows(by_rows, out, scales[1], row_scratch);
    }

    pub(super) fn forward_rows(
        &self,
        x: &[f64],
        scale: f64,
        by_rows: &mut [Tile<T>],
        occupied: &mut [bool],
        scratch: &mut [RowScratch<T>],
    ) {
        let (band, tasks) = (self.tiles_across(), scratch.len());
        let per_task = self.tiles_down().div_ceil(tasks);
        let data = (
            blocks(by_rows, per_task * band),
            blocks(occupied, per_task),
            blocks(scratch, 1),
        );
        let work = |task: usize, (bands, occupied, scratch): RowTask<'_, T>| {
            let scratch = &mut scratch.items[0];
            let first = (task * per_task * TILE_ROWS * self.nx).min(x.len());
            let inputs = x[first..].chunks(TILE_ROWS * self.nx);
            let outputs = bands.items.chunks_exact_mut(band);
            for ((input, output), occupied) in inputs.zip(outputs).zip(occupied.items) {
                *occupied = is_occupied(input);
                if *occupied {
                    self.forward_band(input, scale, output, scratch);
                }
            }
        };
        parallel::sweep(0..tasks, data, &work, &|(), ()| ());
    }

    /// Transforms the rows of a band into its tiles.
    fn forward_band(
        &self,
        input: &[f64],
        scale: f64,
        band: &mut [Tile<T>],
        scratch: &mut RowScratch<T>,
    ) {
        let rows = scratch.complex.chunks_exact_mut(self.row_stride());
        for (input, output) in input.chunks_exact(self.nx).zip(rows) {
            let output = &mut output[..self.width()];
            if is_occupied(input) {
                for (value, x) in scratch.real.iter_mut().zip(input) {
                    let scaled: f64 = x * scale;
                    *value = T::of(scaled);
                }
                scratch.real[self.nx..].fill(T::zero());
                self.row_forward
                    .process_with_scratch(&mut scratch.real, output, &mut scratch.transform)
                    .expect("the plan sized every buffer");
            } else {
                output.fill(zero());
            }
        }
        for (column, tile) in (0..).step_by(TILE_COLUMNS).zip(band) {
            for (row, values) in tile.chunks_exact_mut(TILE_COLUMNS).enumerate() {
                values.copy_from_slice(
                    &scratch.complex[row * self.row_stride() + column..][..TILE_COLUMNS],
                );
            }
        }
    }

    fn columns(
        &self,
        spectrum: &Spectrum<T>,
        by_columns: &mut [Tile<T>],
        occupied: &[bool],
        scratch: &mut [ColumnScratch<T>],
    ) {
        let (stride, tasks) = (self.column_stride(), scratch.len());
        let (band, per_task) = (self.tiles_down(), self.tiles_across().div_ceil(tasks));
        let data = (blocks(by_columns, per_task * band), blocks(scratch, 1));
        let work = |task: usize, (bands, scratch): ColumnTask<'_, T>| {
            let ColumnScratch { columns, transform } = &mut scratch.items[0];
            for (index, tiles) in bands.items.chunks_exact_mut(band).enumerate() {
                let first = (task * per_task + index) * TILE_COLUMNS;
                tiles::gather(tiles, occupied, columns, stride);
                let used = columns.chunks_exact_mut(stride).take(self.width() - first);
                for (c, column) in used.enumerate() {
                    let column = self.waves_of(column, transform);
                    spectrum.multiply(first + c, column);
                    self.column_inverse.process_with_scratch(column, transform);
                }
                tiles::scatter(columns, stride, tiles);
            }
        };
        parallel::sweep(0..tasks, data, &work, &|(), ()| ());
    }

    /// Pads a column of scratch memory and transforms it.
    pub(super) fn waves_of<'a>(
        &self,
        column: &'a mut [Complex<T>],
        transform: &mut [Complex<T>],
    ) -> &'a mut [Complex<T>] {
        let column = &mut column[..self.my];
        column[self.ny..].fill(zero());
        self.column_forward.process_with_scratch(column, transform);
        column
    }

    pub(super) fn inverse_rows(
        &self,
        by_rows: &mut [Tile<T>],
        out: &mut [f64],
        scale: f64,
        scratch: &mut [RowScratch<T>],
    ) {
        let (across, tasks) = (self.tiles_across(), scratch.len());
        let per_task = self.tiles_down().div_ceil(tasks);
        let data = (
            blocks(out, per_task * TILE_ROWS * self.nx),
            blocks(scratch, 1),
        );
        let work = |task: usize, (out, scratch): (Blocks<'_, f64>, Blocks<'_, RowScratch<T>>)| {
            let scratch = &mut scratch.items[0];
            let bands = by_rows.chunks_exact(across).skip(task * per_task);
            for (output, band) in out.items.chunks_mut(TILE_ROWS * self.nx).zip(bands) {
                for (column, tile) in (0..).step_by(TILE_COLUMNS).zip(band) {
                    for (row, values) in tile.chunks_exact(TILE_COLUMNS).enumerate() {
                        scratch.complex[row * self.row_stride() + column..][..TILE_COLUMNS]
                            .copy_from_slice(values);
                    }
                }
                self.inverse_band(output, scale, scratch);
            }
        };
        parallel::sweep(0..tasks, data, &work, &|(), ()| ());
    }

    /// Transforms the rows of a band back from scratch memory.
    fn inverse_band(&self, output: &mut [f64], scale: f64, scratch: &mut RowScratch<T>) {
        let rows = scratch.complex.chunks_exact_mut(self.row_stride());
        for (row, output) in rows.zip(output.chunks_exact_mut(self.nx)) {
            let row = &mut row[..self.width()];
            // A real row has real ends; round-off must not tell the transform otherwise.
            row[0].im = T::zero();
            if self.mx % 2 == 0 {
                row[self.width() - 1].im = T::zero();
            }
            self.row_inverse
                .process_with_scratch(row, &mut scratch.real, &mut scratch.transform)
                .expect("the plan sized every buffer and the ends of the row are real");
            for (out, value) in output.iter_mut().zip(scratch.real.iter()) {
                *out = value.double() * scale;
            }
        }
    }
}

/// Whether anything is not zero.
fn is_occupied(values: &[f64]) -> bool {
    values.iter().any(|&value| value != 0.0)
}

type RowTask<'a, T> = (
    Blocks<'a, Tile<T>>,
    Blocks<'a, bool>,
    Blocks<'a, RowScratch<T>>,
);

pub(super) type ColumnTask<'a, T> = (Blocks<'a, Tile<T>>, Blocks<'a, ColumnScratch<T>>);

pub(super) fn blocks<T>(items: &mut [T], width: usize) -> Blocks<'_, T> {
    Blocks { items, width }
}

fn zero<T: Real>() -> Complex<T> {
    Complex::new(T::zero(), T::zero())
}
