//! The two-dimensional real transform of a zero-padded field, one pass over memory per stage.
//!
//! Rows: real to complex, only those that are not zero. Columns, eight at a time: gather, pad,
//! transform, multiply by the kernel, transform back, keep what is wanted. Rows: complex to real.

use std::fmt;
use std::sync::Arc;

use num_complex::Complex;
use realfft::{ComplexToReal, RealFftPlanner, RealToComplex};
use rustfft::{Fft, FftPlanner};

use crate::fft::real::Real;
use crate::fft::spectrum::Spectrum;
use crate::parallel::{self, Blocks};

/// Columns transformed together: two cache lines of complex numbers a row.
const COLUMNS: usize = 8;

/// Smallest even `2^a 3^b 5^c >= least` (1 for `least <= 1`): lengths whose transform is fast.
pub(super) fn smooth_length(least: usize) -> usize {
    if least <= 1 {
        return 1;
    }
    let is_smooth = |&n: &usize| {
        let mut rest = n;
        for prime in [2, 3, 5] {
            while rest % prime == 0 {
                rest /= prime;
            }
        }
        rest == 1 && n % 2 == 0
    };
    // A power of two lies in every octave.
    (least..=2 * least).find(is_smooth).unwrap_or(2 * least)
}

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
    column_inverse: Arc<dyn Fft<T>>,
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

/// Buffers of one transform: four numbers per cell of the field, and a little for each task.
#[derive(Debug)]
pub(super) struct Buffers<T> {
    /// Rows after the first stage, row-major.
    rows: Vec<Complex<T>>,
    /// Which rows hold anything.
    occupied: Vec<bool>,
    /// Columns after the second stage: blocks of [`COLUMNS`], row-major within each.
    columns: Vec<Complex<T>>,
    row_scratch: Vec<RowScratch<T>>,
    column_scratch: Vec<ColumnScratch<T>>,
}

#[derive(Debug, Clone)]
struct RowScratch<T> {
    real: Vec<T>,
    complex: Vec<Complex<T>>,
    transform: Vec<Complex<T>>,
}

#[derive(Debug, Clone)]
struct ColumnScratch<T> {
    columns: Vec<Complex<T>>,
    transform: Vec<Complex<T>>,
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
    fn width(&self) -> usize {
        self.mx / 2 + 1
    }

    fn column_blocks(&self) -> usize {
        self.width().div_ceil(COLUMNS)
    }

    pub(super) fn workspace(&self) -> Buffers<T> {
        let zero = zero::<T>();
        let row_tasks = parallel::lanes().min(self.ny);
        let column_tasks = parallel::lanes().min(self.column_blocks());
        let row_scratch = RowScratch {
            real: vec![T::zero(); self.mx],
            complex: vec![zero; self.width()],
            transform: vec![
                zero;
                self.row_forward
                    .get_scratch_len()
                    .max(self.row_inverse.get_scratch_len())
            ],
        };
        let column_scratch = ColumnScratch {
            columns: vec![zero; COLUMNS * self.my],
            transform: vec![
                zero;
                self.column_forward
                    .get_inplace_scratch_len()
                    .max(self.column_inverse.get_inplace_scratch_len())
            ],
        };
        Buffers {
            rows: vec![zero; self.ny * self.width()],
            occupied: vec![false; self.ny],
            columns: vec![zero; self.column_blocks() * COLUMNS * self.ny],
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
        assert!(
            x.len() == cells
                && out.len() == cells
                && workspace.rows.len() == self.ny * self.width(),
            "fields and workspace must be those of the {} x {} cells of the operator",
            self.nx,
            self.ny
        );
        let Buffers {
            rows,
            occupied,
            columns,
            row_scratch,
            column_scratch,
        } = workspace;
        self.forward_rows(x, scales[0], rows, occupied, row_scratch);
        self.columns(spectrum, rows, occupied, columns, column_scratch);
        self.inverse_rows(columns, out, scales[1], row_scratch);
    }

    fn forward_rows(
        &self,
        x: &[f64],
        scale: f64,
        rows: &mut [Complex<T>],
        occupied: &mut [bool],
        scratch: &mut [RowScratch<T>],
    ) {
        let (width, tasks) = (self.width(), scratch.len());
        let per_task = self.ny.div_ceil(tasks);
        let data = (
            blocks(rows, per_task * width),
            blocks(occupied, per_task),
            blocks(scratch, 1),
        );
        let work = |task: usize, (rows, occupied, scratch): RowTask<'_, T>| {
            let scratch = &mut scratch.items[0];
            let input = x[(task * per_task * self.nx).min(x.len())..].chunks_exact(self.nx);
            let output = rows.items.chunks_exact_mut(width);
            for ((input, output), occupied) in input.zip(output).zip(occupied.items) {
                *occupied = input.iter().any(|&value| value != 0.0);
                if *occupied {
                    for (value, x) in scratch.real.iter_mut().zip(input) {
                        let scaled: f64 = x * scale;
                        *value = T::of(scaled);
                    }
                    scratch.real[self.nx..].fill(T::zero());
                    self.row_forward
                        .process_with_scratch(&mut scratch.real, output, &mut scratch.transform)
                        .expect("the plan sized every buffer");
                }
            }
        };
        parallel::sweep(0..tasks, data, &work, &|(), ()| ());
    }

    fn columns(
        &self,
        spectrum: &Spectrum<T>,
        rows: &[Complex<T>],
        occupied: &[bool],
        columns: &mut [Complex<T>],
        scratch: &mut [ColumnScratch<T>],
    ) {
        let (width, tasks) = (self.width(), scratch.len());
        let block_len = COLUMNS * self.ny;
        let per_task = self.column_blocks().div_ceil(tasks);
        let data = (blocks(columns, per_task * block_len), blocks(scratch, 1));
        let work =
            |task: usize, (columns, scratch): (Blocks<'_, _>, Blocks<'_, ColumnScratch<T>>)| {
                let ColumnScratch {
                    columns: padded,
                    transform,
                } = &mut scratch.items[0];
                for (index, block) in columns.items.chunks_exact_mut(block_len).enumerate() {
                    let first = (task * per_task + index) * COLUMNS;
                    let count = COLUMNS.min(width - first);
                    self.gather(rows, occupied, first, count, padded);
                    for (c, column) in padded.chunks_exact_mut(self.my).take(count).enumerate() {
                        self.column_forward.process_with_scratch(column, transform);
                        spectrum.multiply(first + c, column);
                        self.column_inverse.process_with_scratch(column, transform);
                    }
                    for (row, values) in block.chunks_exact_mut(COLUMNS).enumerate() {
                        for (c, value) in values.iter_mut().take(count).enumerate() {
                            *value = padded[c * self.my + row];
                        }
                    }
                }
            };
        parallel::sweep(0..tasks, data, &work, &|(), ()| ());
    }

    /// Copies `count` columns from `first` on, one behind the other, padded with zeros.
    fn gather(
        &self,
        rows: &[Complex<T>],
        occupied: &[bool],
        first: usize,
        count: usize,
        padded: &mut [Complex<T>],
    ) {
        for column in padded.chunks_exact_mut(self.my).take(count) {
            column[self.ny..].fill(zero());
        }
        let rows = rows.chunks_exact(self.width());
        for (index, (row, &occupied)) in rows.zip(occupied).enumerate() {
            for c in 0..count {
                padded[c * self.my + index] = if occupied { row[first + c] } else { zero() };
            }
        }
    }

    fn inverse_rows(
        &self,
        columns: &[Complex<T>],
        out: &mut [f64],
        scale: f64,
        scratch: &mut [RowScratch<T>],
    ) {
        let (width, tasks) = (self.width(), scratch.len());
        let per_task = self.ny.div_ceil(tasks);
        let data = (blocks(out, per_task * self.nx), blocks(scratch, 1));
        let work = |task: usize, (out, scratch): (Blocks<'_, f64>, Blocks<'_, RowScratch<T>>)| {
            let scratch = &mut scratch.items[0];
            for (index, output) in out.items.chunks_exact_mut(self.nx).enumerate() {
                let row = task * per_task + index;
                let blocks = columns.chunks_exact(COLUMNS * self.ny);
                for (values, block) in scratch.complex.chunks_mut(COLUMNS).zip(blocks) {
                    values.copy_from_slice(&block[row * COLUMNS..][..values.len()]);
                }
                // A real row has real ends; round-off must not tell the transform otherwise.
                scratch.complex[0].im = T::zero();
                if self.mx % 2 == 0 {
                    scratch.complex[width - 1].im = T::zero();
                }
                self.row_inverse
                    .process_with_scratch(
                        &mut scratch.complex,
                        &mut scratch.real,
                        &mut scratch.transform,
                    )
                    .expect("the plan sized every buffer and the ends of the row are real");
                for (out, value) in output.iter_mut().zip(&scratch.real) {
                    *out = value.double() * scale;
                }
            }
        };
        parallel::sweep(0..tasks, data, &work, &|(), ()| ());
    }
}

type RowTask<'a, T> = (
    Blocks<'a, Complex<T>>,
    Blocks<'a, bool>,
    Blocks<'a, RowScratch<T>>,
);

fn blocks<T>(items: &mut [T], width: usize) -> Blocks<'_, T> {
    Blocks { items, width }
}

fn zero<T: Real>() -> Complex<T> {
    Complex::new(T::zero(), T::zero())
}
