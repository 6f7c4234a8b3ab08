//! Pass over the columns of all fields, in which the kernels are applied.

use num_complex::Complex;

use crate::error::Result;
use crate::fft::aligned::Aligned;
use crate::fft::plan::{Plan, blocks, zero};
use crate::fft::precision::Real;
use crate::fft::symbol::Symbol;
use crate::fft::tiles::{self, TILE_ROWS, Tile};
use crate::memory::fallible::try_each;
use crate::memory::pool::Pool;

#[derive(Debug, Clone)]
pub(super) struct ColumnScratch<T, const N: usize> {
    columns: [Aligned<Complex<T>>; N],
    transform: Aligned<Complex<T>>,
}

impl<T: Real> Plan<T> {
    pub(super) fn column_scratch<const N: usize>(&self) -> Result<ColumnScratch<T, N>> {
        Ok(ColumnScratch {
            columns: try_each(|_| Aligned::new(zero(), T::TILE_COLUMNS * self.column_stride()))?,
            transform: Aligned::new(
                zero(),
                self.column_forward
                    .get_inplace_scratch_len()
                    .max(self.column_inverse.get_inplace_scratch_len()),
            )?,
        })
    }

    /// Returns the distance between padded columns in scratch memory. The distance includes space for whole tiles. It
    /// is never a power of two, for which all columns would map to the same cache sets.
    fn column_stride(&self) -> usize {
        let end = self.tile_rows.iter().map(|row| row + TILE_ROWS).max();
        self.frame.torus[1]
            .max(end.unwrap_or(0))
            .next_multiple_of(T::TILE_COLUMNS)
            + T::TILE_COLUMNS
    }

    /// Transforms the columns of all fields, multiplies them by the kernels, and transforms them back.
    pub(super) fn columns<const N: usize>(
        &self,
        symbol: &Symbol<T, N>,
        by_columns: &mut [&mut [Tile]; N],
        occupied: &[Vec<bool>; N],
        scratch: &Pool<ColumnScratch<T, N>>,
    ) {
        let (along, own) = (self.tiles_along(), self.own_tile_columns());
        let fields = by_columns.each_mut().map(|tiles| blocks(tiles, along));
        self.bands(own.len(), fields, |band, fields| {
            let fields = fields.map(|field| field.items);
            scratch.lend(
                || self.column_scratch(),
                |scratch| self.column_band(symbol, own.start + band, fields, occupied, scratch),
            );
        });
    }

    /// Transforms the columns of a band, multiplies them and transforms them back.
    fn column_band<const N: usize>(
        &self,
        symbol: &Symbol<T, N>,
        band: usize,
        fields: [&mut [Tile]; N],
        occupied: &[Vec<bool>; N],
        scratch: &mut ColumnScratch<T, N>,
    ) {
        let stride = self.column_stride();
        for n in 0..N {
            tiles::gather(
                fields[n],
                &self.tile_rows,
                &occupied[n],
                &mut scratch.columns[n],
                stride,
            );
        }
        self.multiply_band(band, scratch, |kx, waves| symbol.multiply(kx, waves));
        for (field, columns) in fields.into_iter().zip(&scratch.columns) {
            tiles::scatter(columns, stride, &self.tile_rows, field);
        }
    }

    /// Transforms columns from the tiles of some fields to the tiles of other fields, with any multiplication
    /// in between.
    pub(super) fn columns_between<const N: usize>(
        &self,
        from: [&[Tile]; N],
        occupied: &[Vec<bool>; N],
        to: [&mut [Tile]; N],
        scratch: &Pool<ColumnScratch<T, N>>,
        multiply: impl Fn(usize, &mut [&mut [Complex<T>]; N]) + Sync,
    ) {
        let (along, stride) = (self.tiles_along(), self.column_stride());
        let own = self.own_tile_columns();
        let fields = to.map(|tiles| blocks(tiles, along));
        self.bands(own.len(), fields, |band, fields| {
            let make = || self.column_scratch();
            scratch.lend(make, |scratch| {
                for n in 0..N {
                    let tiles = &from[n][band * along..(band + 1) * along];
                    tiles::gather(
                        tiles,
                        &self.tile_rows,
                        &occupied[n],
                        &mut scratch.columns[n],
                        stride,
                    );
                }
                self.multiply_band(own.start + band, scratch, &multiply);
                for (field, columns) in fields.into_iter().zip(&scratch.columns) {
                    tiles::scatter(columns, stride, &self.tile_rows, field.items);
                }
            });
        });
    }

    /// Transforms the gathered columns of a band, multiplies them and transforms them back.
    fn multiply_band<const N: usize>(
        &self,
        band: usize,
        scratch: &mut ColumnScratch<T, N>,
        multiply: impl Fn(usize, &mut [&mut [Complex<T>]; N]),
    ) {
        let stride = self.column_stride();
        let ColumnScratch { columns, transform } = scratch;
        let first = band * T::TILE_COLUMNS;
        for c in 0..T::TILE_COLUMNS.min(self.width() - first) {
            let mut waves = columns.each_mut().map(|columns| {
                self.waves_of(&mut columns[c * stride..(c + 1) * stride], transform)
            });
            multiply(first + c, &mut waves);
            for column in waves {
                self.column_inverse.process_with_scratch(column, transform);
            }
        }
    }

    /// Pads a column of scratch memory and transforms it.
    fn waves_of<'a>(
        &self,
        column: &'a mut [Complex<T>],
        transform: &mut [Complex<T>],
    ) -> &'a mut [Complex<T>] {
        let column = &mut column[..self.frame.torus[1]];
        column[self.frame.size[1]..].fill(zero());
        self.column_forward.process_with_scratch(column, transform);
        column
    }
}
