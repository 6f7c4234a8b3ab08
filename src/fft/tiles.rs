//! The pieces in which one stage of a transform hands its results to the next.

use bytemuck::{cast_slice, cast_slice_mut};
use num_complex::Complex;

use crate::error::Result;
use crate::fft::precision::Real;
use crate::memory::fallible::{self, try_each};

/// Rows of a tile, in pairs. With two cache lines of each it is a piece long enough for memory, small enough to be turned
/// in the cache.
pub(super) const TILE_ROWS: usize = 16;

/// Words of a tile, in either precision.
pub(super) const TILE_WORDS: usize = TILE_ROWS * 128 / size_of::<u64>();

/// A tile, row by row, in either precision; empty while the other order owns it.
#[derive(Debug, Clone, Default)]
pub(super) struct Tile(Box<[Complex<f64>]>);

impl Tile {
    pub(super) fn zero() -> Result<Self> {
        let zero = Complex::new(0.0, 0.0);
        let numbers = fallible::filled(zero, TILE_ROWS * f64::TILE_COLUMNS)?;
        Ok(Self(numbers.into_boxed_slice()))
    }

    /// The numbers of the precision it was last written in.
    pub(super) fn of<T: Real>(&self) -> &[Complex<T>] {
        cast_slice(&self.0)
    }

    /// Its memory, for what travels between ranks.
    pub(super) fn words(&self) -> &[u64] {
        cast_slice(&self.0)
    }

    pub(super) fn words_mut(&mut self) -> &mut [u64] {
        cast_slice_mut(&mut self.0)
    }

    pub(super) fn of_mut<T: Real>(&mut self) -> &mut [Complex<T>] {
        cast_slice_mut(&mut self.0)
    }
}

/// Tiles of N fields, for transforms of either precision: 16 bytes per cell of each. What is in them does not matter to
/// the next transform.
#[derive(Debug, Clone)]
pub(super) struct Tiles<const N: usize> {
    /// All tiles of a band of rows, then of the next band; a task owns bands of rows.
    pub(super) by_rows: [Vec<Tile>; N],
    /// Which bands of rows hold anything.
    pub(super) occupied: [Vec<bool>; N],
    /// The same tiles while a task owns bands of columns.
    pub(super) by_columns: [Vec<Tile>; N],
    /// Memory of tiles that were sent to other ranks, for those that come.
    pub(super) spare: Vec<Tile>,
}

impl<const N: usize> Tiles<N> {
    /// So many across and down in the bands of rows, and in those of columns; `fill` has the work done on the bands of
    /// rows.
    pub(super) fn new(
        [across, down]: [usize; 2],
        [own_across, along]: [usize; 2],
        fill: impl Fn(&mut [Tile], &(dyn Fn(&mut [Tile]) -> Result<()> + Sync)) -> Result<()>,
    ) -> Result<Self> {
        let empty = |across: usize, down: usize| fallible::filled(Tile::default(), across * down);
        let fill_band = |band: &mut [Tile]| {
            for tile in band {
                *tile = Tile::zero()?;
            }
            Ok(())
        };
        Ok(Self {
            by_rows: try_each(|_| {
                let mut tiles = empty(across, down)?;
                fill(&mut tiles, &fill_band)?;
                Ok(tiles)
            })?,
            occupied: try_each(|_| fallible::filled(false, along))?,
            by_columns: try_each(|_| empty(own_across, along))?,
            spare: Vec::new(),
        })
    }
}

/// Hands tiles over from one order to the other, `width` of which lie in a band of the first.
pub(super) fn exchange(from: &mut [Tile], to: &mut [Tile], width: usize) {
    let height = from.len() / width;
    for (j, band) in from.chunks_exact_mut(width).enumerate() {
        for (i, tile) in band.iter_mut().enumerate() {
            std::mem::swap(tile, &mut to[i * height + j]);
        }
    }
}

/// Turns a band of tiles into columns, one behind the other; each tile begins at its row.
pub(super) fn gather<T: Real>(
    tiles: &[Tile],
    rows: &[usize],
    occupied: &[bool],
    columns: &mut [Complex<T>],
    stride: usize,
) {
    for ((&row, tile), &occupied) in rows.iter().zip(tiles).zip(occupied) {
        let tile = tile.of::<T>();
        for (c, column) in columns.chunks_exact_mut(stride).enumerate() {
            let target = &mut column[row..row + TILE_ROWS];
            if occupied {
                for (value, values) in target.iter_mut().zip(tile.chunks_exact(T::TILE_COLUMNS)) {
                    *value = values[c];
                }
            } else {
                target.fill(Complex::new(T::zero(), T::zero()));
            }
        }
    }
}

/// Turns columns back into a band of tiles.
pub(super) fn scatter<T: Real>(
    columns: &[Complex<T>],
    stride: usize,
    rows: &[usize],
    tiles: &mut [Tile],
) {
    for (&row, tile) in rows.iter().zip(tiles) {
        let tile = tile.of_mut::<T>();
        for (c, column) in columns.chunks_exact(stride).enumerate() {
            let source = &column[row..row + TILE_ROWS];
            for (values, value) in tile.chunks_exact_mut(T::TILE_COLUMNS).zip(source) {
                values[c] = *value;
            }
        }
    }
}
