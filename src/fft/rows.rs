//! Transforms of the rows of one field. Two real rows are the real and imaginary parts of one complex row, whose waves
//! are `Z = A + i B`. The waves of the real rows are
//!
//! ```math
//! 2 A_k = Z_k + \overline{Z_{m-k}}, \qquad 2 B_k = -i \bigl(Z_k - \overline{Z_{m-k}}\bigr) .
//! ```

use std::array::from_fn;
use std::ops::Range;

use num_complex::Complex;

use crate::error::Result;
use crate::fft::aligned::Aligned;
use crate::fft::plan::{Plan, blocks, zero};
use crate::fft::precision::Real;
use crate::fft::symbol::Symbol;
use crate::fft::tiles::{TILE_ROWS, Tile};
use crate::memory::pool::Pool;

/// Number of pairs of rows in a band of tiles.
const PAIRS: usize = TILE_ROWS / 2;

/// Number of columns of a tile in single precision, which is larger than the number in double precision.
const MOST_COLUMNS: usize = f32::TILE_COLUMNS;

/// Number of waves in a block. The compiler unrolls loops over a block and reverses its order with vector instructions.
const BLOCK: usize = 8;

#[derive(Debug, Clone)]
pub(super) struct RowScratch<T> {
    /// Pairs of a band, and later their waves. The first wave of each pair is repeated after its last.
    pairs: Aligned<Complex<T>>,
    transform: Aligned<Complex<T>>,
}

impl<T: Real> Plan<T> {
    pub(super) fn row_scratch(&self) -> Result<RowScratch<T>> {
        let forward = self.row_forward.get_inplace_scratch_len();
        let inverse = self.row_inverse.get_inplace_scratch_len();
        Ok(RowScratch {
            pairs: Aligned::new(zero(), PAIRS * self.row_stride())?,
            transform: Aligned::new(zero(), forward.max(inverse))?,
        })
    }

    /// Returns the distance between pairs of rows in scratch memory. The distance is never a power of two, because all
    /// pairs would then map to the same cache sets.
    fn row_stride(&self) -> usize {
        (self.frame.torus[0] + 1).next_multiple_of(T::TILE_COLUMNS) + T::TILE_COLUMNS
    }

    /// Transforms the nonzero rows of `x` times `scale`, and records which bands contain such rows.
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

    /// Returns the cells of a band.
    fn rows_of(&self, band: usize) -> Range<usize> {
        let (first, nx) = (band * TILE_ROWS, self.frame.size[0]);
        first * nx..(first + TILE_ROWS).min(self.frame.local_rows().len()) * nx
    }

    /// Returns the columns of waves for each tile of a band.
    fn columns_of_tiles(&self) -> impl Iterator<Item = Range<usize>> {
        let width = self.width();
        let ends = move |first: usize| first..(first + T::TILE_COLUMNS).min(width);
        (0..width).step_by(T::TILE_COLUMNS).map(ends)
    }

    /// Transforms the rows of a band into its tiles.
    fn forward_band(
        &self,
        input: &[f64],
        scale: f64,
        band: &mut [Tile],
        scratch: &mut RowScratch<T>,
    ) {
        let RowScratch { pairs, transform } = scratch;
        let stride = self.row_stride();
        let rows = input.chunks(2 * self.frame.size[0]);
        let waves = &mut pairs[..rows.len() * stride];
        for (rows, waves) in rows.zip(waves.chunks_exact_mut(stride)) {
            self.forward_pair(rows, scale, waves, transform);
        }
        for (tile, columns) in band.iter_mut().zip(self.columns_of_tiles()) {
            let rows = tile.of_mut::<T>().chunks_exact_mut(2 * T::TILE_COLUMNS);
            for (rows, waves) in rows.zip(waves.chunks_exact(stride)) {
                let (a, b) = rows.split_at_mut(T::TILE_COLUMNS);
                self.separate(waves, columns.clone(), a, b);
            }
        }
    }

    /// Transforms two rows, or a single last row, to half their waves. The factor is one half because
    /// [`Self::separate`] adds two waves.
    fn forward_pair(
        &self,
        rows: &[f64],
        scale: f64,
        waves: &mut [Complex<T>],
        transform: &mut [Complex<T>],
    ) {
        if !is_occupied(rows) {
            return waves.fill(zero());
        }
        let torus = self.frame.torus[0];
        let (a, b) = rows.split_at(self.frame.size[0]);
        let half = 0.5 * scale;
        let of = |a: f64, b: f64| Complex::new(T::of(a * half), T::of(b * half));
        if b.is_empty() {
            for (z, &a) in waves.iter_mut().zip(a) {
                *z = of(a, 0.0);
            }
        } else {
            for ((z, &a), &b) in waves.iter_mut().zip(a).zip(b) {
                *z = of(a, b);
            }
        }
        waves[a.len()..].fill(zero());
        self.row_forward
            .process_with_scratch(&mut waves[..torus], transform);
        waves[torus] = waves[0];
    }

    /// Computes the waves of each of two rows in these columns from half the waves of the pair.
    #[inline]
    fn separate(
        &self,
        waves: &[Complex<T>],
        columns: Range<usize>,
        a: &mut [Complex<T>],
        b: &mut [Complex<T>],
    ) {
        let torus = self.frame.torus[0];
        let back = torus + 1 - columns.end..torus + 1 - columns.start;
        let (forward, backward) = (&waves[columns], &waves[back]);
        let count = forward.len();
        let whole = count - count % BLOCK;
        let (a, b) = (&mut a[..count], &mut b[..count]);
        let of = |z: Complex<T>, y: Complex<T>| {
            (
                Complex::new(z.re + y.re, z.im - y.im),
                Complex::new(z.im + y.im, y.re - z.re),
            )
        };
        let blocks = a.chunks_exact_mut(BLOCK).zip(b.chunks_exact_mut(BLOCK));
        let waves = forward.chunks_exact(BLOCK);
        let waves = waves.zip(backward.rchunks_exact(BLOCK));
        for ((a, b), (z, y)) in blocks.zip(waves) {
            for k in 0..BLOCK {
                (a[k], b[k]) = of(z[k], y[BLOCK - 1 - k]);
            }
        }
        for k in whole..count {
            (a[k], b[k]) = of(forward[k], backward[count - 1 - k]);
        }
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
                |scratch| self.inverse_band(tiles, output.items, scale, scratch),
            );
        });
    }

    /// Transforms the tiles of a band back into its rows.
    fn inverse_band(
        &self,
        band: &[Tile],
        output: &mut [f64],
        scale: f64,
        scratch: &mut RowScratch<T>,
    ) {
        let RowScratch { pairs, transform } = scratch;
        let stride = self.row_stride();
        let nothing = [zero(); MOST_COLUMNS];
        let numbers = output.len() / self.frame.size[0] * T::TILE_COLUMNS;
        let rows = output.chunks_mut(2 * self.frame.size[0]);
        let waves = &mut pairs[..rows.len() * stride];
        for (tile, columns) in band.iter().zip(self.columns_of_tiles()) {
            // The values of a tile beyond the last row are undefined.
            let pairs = tile.of::<T>()[..numbers].chunks_exact(2 * T::TILE_COLUMNS);
            let lone = pairs.remainder();
            let mut waves = waves.chunks_exact_mut(stride);
            for (rows, waves) in pairs.zip(&mut waves) {
                let (a, b) = rows.split_at(T::TILE_COLUMNS);
                self.join(a, b, columns.clone(), waves);
            }
            if let (Some(waves), false) = (waves.next(), lone.is_empty()) {
                self.join(lone, &nothing, columns, waves);
            }
        }
        for (rows, waves) in rows.zip(waves.chunks_exact_mut(stride)) {
            self.inverse_pair(waves, rows, scale, transform);
        }
    }

    /// Computes the waves of a pair from the waves of each row in these columns.
    #[inline]
    fn join(
        &self,
        a: &[Complex<T>],
        b: &[Complex<T>],
        columns: Range<usize>,
        waves: &mut [Complex<T>],
    ) {
        let torus = self.frame.torus[0];
        // The first and middle waves of real rows are real. The imaginary part is round-off and must not enter the other
        // row.
        let ends = |column: usize| Complex::new(a[column].re, b[column].re);
        let inner = columns.start..columns.end.min(torus.div_ceil(2));
        let back = torus + 1 - inner.end..torus + 1 - inner.start;
        for ((z, a), b) in waves[inner.clone()].iter_mut().zip(a).zip(b) {
            *z = Complex::new(a.re - b.im, a.im + b.re);
        }
        let (backward, count) = (&mut waves[back], inner.len());
        let of = |a: Complex<T>, b: Complex<T>| Complex::new(a.re + b.im, b.re - a.im);
        let blocks = a[..count]
            .chunks_exact(BLOCK)
            .zip(b[..count].chunks_exact(BLOCK));
        for ((a, b), y) in blocks.zip(backward.rchunks_exact_mut(BLOCK)) {
            for k in 0..BLOCK {
                y[BLOCK - 1 - k] = of(a[k], b[k]);
            }
        }
        for k in count - count % BLOCK..count {
            backward[count - 1 - k] = of(a[k], b[k]);
        }
        if columns.start == 0 {
            waves[0] = ends(0);
        }
        if inner.end < columns.end {
            waves[inner.end] = ends(inner.len());
        }
    }

    /// Transforms the waves of two rows, or of a single last row, back.
    fn inverse_pair(
        &self,
        waves: &mut [Complex<T>],
        rows: &mut [f64],
        scale: f64,
        transform: &mut [Complex<T>],
    ) {
        self.row_inverse
            .process_with_scratch(&mut waves[..self.frame.torus[0]], transform);
        let (a, b) = rows.split_at_mut(self.frame.size[0]);
        for (out, z) in a.iter_mut().zip(waves.iter()) {
            *out = z.re.double() * scale;
        }
        for (out, z) in b.iter_mut().zip(waves.iter()) {
            *out = z.im.double() * scale;
        }
    }

    /// Computes the whole product of fields that are lines. Each line is paired with zeros.
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
            let RowScratch { pairs, transform } = scratch;
            let (waves, rest) = pairs.split_at_mut(self.row_stride());
            let (nothing, rest) = rest.split_at_mut(self.row_stride());
            let mut lines = rest.chunks_exact_mut(self.row_stride());
            let mut lines: [_; N] = from_fn(|_| match lines.next() {
                Some(line) => &mut line[..self.width()],
                None => Default::default(),
            });
            let all = 0..self.width();
            for (line, x) in lines.iter_mut().zip(x) {
                self.forward_pair(x, scales[0], waves, transform);
                self.separate(waves, all.clone(), line, nothing);
            }
            symbol.multiply_line(&mut lines);
            nothing.fill(zero());
            for (line, out) in lines.into_iter().zip(out) {
                self.join(line, nothing, all.clone(), waves);
                self.inverse_pair(waves, out, scales[1], transform);
            }
        });
    }
}

/// Returns whether any value is nonzero.
fn is_occupied(values: &[f64]) -> bool {
    values.iter().any(|&value| value != 0.0)
}
