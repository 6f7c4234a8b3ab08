//! The transforms of the rows of one field.

use crate::fft::aligned::Aligned;
use crate::fft::plan::{Plan, blocks, zero};
use crate::fft::real::Real;
use crate::fft::tiles::{TILE_COLUMNS, TILE_ROWS, Tile};
use crate::parallel::{self, Blocks};
use num_complex::Complex;

#[derive(Debug, Clone)]
pub(super) struct RowScratch<T> {
    real: Aligned<T>,
    /// Transforms of the rows of a band.
    complex: Aligned<Complex<T>>,
    transform: Aligned<Complex<T>>,
}

type RowTask<'a, T> = (
    Blocks<'a, Tile<T>>,
    Blocks<'a, bool>,
    Blocks<'a, RowScratch<T>>,
);

impl<T: Real> Plan<T> {
    pub(super) fn row_scratch(&self) -> RowScratch<T> {
        RowScratch {
            real: Aligned::new(T::zero(), self.mx),
            complex: Aligned::new(zero(), TILE_ROWS * self.row_stride()),
            transform: Aligned::new(
                zero(),
                self.row_forward
                    .get_scratch_len()
                    .max(self.row_inverse.get_scratch_len()),
            ),
        }
    }

    /// From one transformed row to the next in scratch memory.
    fn row_stride(&self) -> usize {
        self.tiles_across() * TILE_COLUMNS
    }

    /// Transforms the rows of `x` times `scale` that are not zero, and notes which bands hold any.
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
                // Fails for a wrong length alone; all are from the same plan.
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

    /// Transforms the rows back and writes them, times `scale`, to `out`.
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
            // Fails for a wrong length, or ends that are not real: set to zero above.
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
