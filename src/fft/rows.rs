//! The transforms of the rows of one field.

use crate::error::Result;
use crate::fft::aligned::Aligned;
use crate::fft::plan::{Plan, blocks, zero};
use crate::fft::real::Real;
use crate::fft::symbol::Symbol;
use crate::fft::tiles::{TILE_ROWS, Tile};
use crate::pool::Pool;
use num_complex::Complex;
use std::array::from_fn;
use std::ops::Range;

#[derive(Debug, Clone)]
pub(super) struct RowScratch<T> {
    real: Aligned<T>,
    /// Transforms of the rows of a band.
    complex: Aligned<Complex<T>>,
    transform: Aligned<Complex<T>>,
}

impl<T: Real> Plan<T> {
    pub(super) fn row_scratch(&self) -> Result<RowScratch<T>> {
        Ok(RowScratch {
            real: Aligned::new(T::zero(), self.frame.torus[0])?,
            complex: Aligned::new(zero(), TILE_ROWS * self.row_stride())?,
            transform: Aligned::new(
                zero(),
                self.row_forward
                    .get_scratch_len()
                    .max(self.row_inverse.get_scratch_len()),
            )?,
        })
    }

    /// From one transformed row to the next in scratch memory.
    fn row_stride(&self) -> usize {
        self.tiles_across() * T::TILE_COLUMNS
    }

    /// Transforms the rows of `x` times `scale` that are not zero, and notes which bands hold any.
    pub(super) fn forward_rows(
        &self,
        x: &[f64],
        scale: f64,
        by_rows: &mut [Tile],
        occupied: &mut [bool],
        scratch: &Pool<RowScratch<T>>,
    ) {
        let bands = (blocks(by_rows, self.tiles_across()), blocks(occupied, 1));
        self.bands(self.tiles_down(), bands, |band, (tiles, occupied)| {
            let input = self.rows_of(band);
            let input = &x[input];
            let is_occupied = is_occupied(input);
            occupied.items[0] = is_occupied;
            if is_occupied {
                let make = || self.row_scratch();
                scratch.lend(make, |scratch| {
                    self.forward_band(input, scale, tiles.items, scratch);
                });
            }
        });
    }

    /// The cells of a band.
    fn rows_of(&self, band: usize) -> Range<usize> {
        let (first, nx) = (band * TILE_ROWS, self.frame.size[0]);
        first * nx..(first + TILE_ROWS).min(self.frame.own_rows().len()) * nx
    }

    /// Transforms the rows of a band into its tiles.
    fn forward_band(
        &self,
        input: &[f64],
        scale: f64,
        band: &mut [Tile],
        scratch: &mut RowScratch<T>,
    ) {
        let RowScratch {
            real,
            complex,
            transform,
        } = scratch;
        let rows = complex.chunks_exact_mut(self.row_stride());
        for (input, output) in input.chunks_exact(self.frame.size[0]).zip(rows) {
            self.forward_row(input, scale, &mut output[..self.width()], real, transform);
        }
        for (column, tile) in (0..).step_by(T::TILE_COLUMNS).zip(band) {
            for (row, values) in tile
                .of_mut::<T>()
                .chunks_exact_mut(T::TILE_COLUMNS)
                .enumerate()
            {
                values.copy_from_slice(
                    &scratch.complex[row * self.row_stride() + column..][..T::TILE_COLUMNS],
                );
            }
        }
    }

    /// Transforms a row.
    fn forward_row(
        &self,
        input: &[f64],
        scale: f64,
        output: &mut [Complex<T>],
        real: &mut [T],
        transform: &mut [Complex<T>],
    ) {
        if !is_occupied(input) {
            return output.fill(zero());
        }
        for (value, x) in real.iter_mut().zip(input) {
            let scaled: f64 = x * scale;
            *value = T::of(scaled);
        }
        real[self.frame.size[0]..].fill(T::zero());
        // Fails for a wrong length alone; all are from the same plan.
        self.row_forward
            .process_with_scratch(real, output, transform)
            .expect("the plan sized every buffer");
    }

    /// Transforms the rows back and writes them, times `scale`, to `out`.
    pub(super) fn inverse_rows(
        &self,
        by_rows: &[Tile],
        out: &mut [f64],
        scale: f64,
        scratch: &Pool<RowScratch<T>>,
    ) {
        let across = self.tiles_across();
        let rows = blocks(out, TILE_ROWS * self.frame.size[0]);
        self.bands(self.tiles_down(), rows, |band, output| {
            let tiles = &by_rows[band * across..(band + 1) * across];
            scratch.lend(
                || self.row_scratch(),
                |scratch| {
                    for (column, tile) in (0..).step_by(T::TILE_COLUMNS).zip(tiles) {
                        for (row, values) in
                            tile.of::<T>().chunks_exact(T::TILE_COLUMNS).enumerate()
                        {
                            scratch.complex[row * self.row_stride() + column..][..T::TILE_COLUMNS]
                                .copy_from_slice(values);
                        }
                    }
                    self.inverse_band(output.items, scale, scratch);
                },
            );
        });
    }

    /// Transforms the rows of a band back from scratch memory.
    fn inverse_band(&self, output: &mut [f64], scale: f64, scratch: &mut RowScratch<T>) {
        let RowScratch {
            real,
            complex,
            transform,
        } = scratch;
        let rows = complex.chunks_exact_mut(self.row_stride());
        for (row, output) in rows.zip(output.chunks_exact_mut(self.frame.size[0])) {
            self.inverse_row(&mut row[..self.width()], scale, output, real, transform);
        }
    }

    /// Transforms a row back.
    fn inverse_row(
        &self,
        row: &mut [Complex<T>],
        scale: f64,
        output: &mut [f64],
        real: &mut [T],
        transform: &mut [Complex<T>],
    ) {
        // A real row has real ends; round-off must not tell the transform otherwise.
        row[0].im = T::zero();
        if self.frame.torus[0] % 2 == 0 {
            row[self.width() - 1].im = T::zero();
        }
        // Fails for a wrong length, or ends that are not real: set to zero above.
        self.row_inverse
            .process_with_scratch(row, real, transform)
            .expect("the plan sized every buffer and the ends of the row are real");
        for (out, value) in output.iter_mut().zip(real.iter()) {
            *out = value.double() * scale;
        }
    }

    /// The whole product of fields that are lines.
    pub(super) fn convolve_line<const N: usize>(
        &self,
        symbol: &Symbol<T, N>,
        x: [&[f64]; N],
        out: [&mut [f64]; N],
        scales: [f64; 2],
        scratch: &Pool<RowScratch<T>>,
    ) {
        let make = || self.row_scratch();
        scratch.lend(make, |scratch| {
            let RowScratch {
                real,
                complex,
                transform,
            } = scratch;
            let mut rows = complex.chunks_exact_mut(self.row_stride());
            let mut lines: [_; N] = from_fn(|_| match rows.next() {
                Some(row) => &mut row[..self.width()],
                None => Default::default(),
            });
            for (line, x) in lines.iter_mut().zip(x) {
                self.forward_row(x, scales[0], line, real, transform);
            }
            symbol.multiply_line(&mut lines);
            for (line, out) in lines.into_iter().zip(out) {
                self.inverse_row(line, scales[1], out, real, transform);
            }
        });
    }
}

/// Whether anything is not zero.
fn is_occupied(values: &[f64]) -> bool {
    values.iter().any(|&value| value != 0.0)
}
