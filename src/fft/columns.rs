//! The pass over the columns of all fields, in which they meet the kernels.

use std::array::from_fn;

use num_complex::Complex;

use crate::fft::aligned::Aligned;
use crate::fft::plan::{Plan, blocks, zero};
use crate::fft::real::Real;
use crate::fft::symbol::Symbol;
use crate::fft::tiles::{self, TILE_COLUMNS, TILE_ROWS, Tile};
use crate::parallel::{self, Blocks};

#[derive(Debug, Clone)]
pub(super) struct ColumnScratch<T, const N: usize> {
    columns: [Aligned<Complex<T>>; N],
    transform: Aligned<Complex<T>>,
}

type ColumnTask<'a, T, const N: usize> =
    ([Blocks<'a, Tile<T>>; N], Blocks<'a, ColumnScratch<T, N>>);

impl<T: Real> Plan<T> {
    pub(super) fn column_scratch<const N: usize>(&self) -> ColumnScratch<T, N> {
        ColumnScratch {
            columns: from_fn(|_| Aligned::new(zero(), TILE_COLUMNS * self.column_stride())),
            transform: Aligned::new(
                zero(),
                self.column_forward
                    .get_inplace_scratch_len()
                    .max(self.column_inverse.get_inplace_scratch_len()),
            ),
        }
    }

    /// From one padded column to the next in scratch memory: room for whole tiles, and off the powers
    /// of two, at which all columns would share one corner of the cache.
    fn column_stride(&self) -> usize {
        self.my
            .max(self.tiles_down() * TILE_ROWS)
            .next_multiple_of(TILE_COLUMNS)
            + TILE_COLUMNS
    }

    /// Transforms the columns of all fields, multiplies them by the kernels, and transforms them back.
    pub(super) fn columns<const N: usize>(
        &self,
        symbol: &Symbol<T, N>,
        by_columns: &mut [Vec<Tile<T>>; N],
        occupied: &[Vec<bool>; N],
        scratch: &mut [ColumnScratch<T, N>],
    ) {
        let (stride, tasks) = (self.column_stride(), scratch.len());
        let (band, per_task) = (self.tiles_down(), self.tiles_across().div_ceil(tasks));
        let tiles = by_columns
            .each_mut()
            .map(|tiles| blocks(tiles, per_task * band));
        let work = |task: usize, (mut fields, scratch): ColumnTask<'_, T, N>| {
            let ColumnScratch { columns, transform } = &mut scratch.items[0];
            for index in 0..fields[0].items.len() / band {
                let tiles = index * band..(index + 1) * band;
                for n in 0..N {
                    let tiles = &fields[n].items[tiles.clone()];
                    tiles::gather(tiles, &occupied[n], &mut columns[n], stride);
                }
                let first = (task * per_task + index) * TILE_COLUMNS;
                for c in 0..TILE_COLUMNS.min(self.width() - first) {
                    let mut waves = columns.each_mut().map(|columns| {
                        self.waves_of(&mut columns[c * stride..(c + 1) * stride], transform)
                    });
                    symbol.multiply(first + c, &mut waves);
                    for column in waves {
                        self.column_inverse.process_with_scratch(column, transform);
                    }
                }
                for (field, columns) in fields.iter_mut().zip(&*columns) {
                    tiles::scatter(columns, stride, &mut field.items[tiles.clone()]);
                }
            }
        };
        parallel::sweep(0..tasks, (tiles, blocks(scratch, 1)), &work, &|(), ()| ());
    }

    /// Pads a column of scratch memory and transforms it.
    fn waves_of<'a>(
        &self,
        column: &'a mut [Complex<T>],
        transform: &mut [Complex<T>],
    ) -> &'a mut [Complex<T>] {
        let column = &mut column[..self.my];
        column[self.ny..].fill(zero());
        self.column_forward.process_with_scratch(column, transform);
        column
    }
}
