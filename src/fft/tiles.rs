//! The tiles that pass the results of one stage of a transform to the next.

use bytemuck::{cast_slice, cast_slice_mut};
use num_complex::Complex;

use crate::error::Result;
use crate::fft::precision::Real;
use crate::memory::fallible::{self, try_each};

/// Number of rows of a tile. It is even because rows are transformed in pairs. A row of a tile occupies two cache lines,
/// which is sufficient for efficient memory access. The tile is small enough to be transposed in the cache.
pub(super) const TILE_ROWS: usize = 16;

/// Number of words of a tile, in either precision.
pub(super) const TILE_WORDS: usize = TILE_ROWS * 128 / size_of::<u64>();

/// Tile, stored row by row, in either precision. The tile is empty while its memory belongs to the other order.
#[derive(Debug, Clone, Default)]
pub(super) struct Tile(Box<[Complex<f64>]>);

impl Tile {
    pub(super) fn zero() -> Result<Self> {
        let zero = Complex::new(0.0, 0.0);
        let numbers = fallible::filled(zero, TILE_ROWS * f64::TILE_COLUMNS)?;
        Ok(Self(numbers.into_boxed_slice()))
    }

    /// Returns the values in the precision in which the tile was last written.
    pub(super) fn of<T: Real>(&self) -> &[Complex<T>] {
        cast_slice(&self.0)
    }

    /// Returns the memory of the tile for messages between ranks.
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

/// Tiles of N fields for transforms of either precision: 16 bytes per cell and field. The next transform overwrites the
/// content of the tiles.
#[derive(Debug, Clone)]
pub(super) struct Tiles<const N: usize> {
    /// All tiles of a band of rows, followed by the next band, while tasks own bands of rows.
    pub(super) by_rows: [Vec<Tile>; N],
    /// Whether each band of rows contains nonzero values.
    pub(super) occupied: [Vec<bool>; N],
    /// Tiles in the order of column bands, while tasks own bands of columns.
    pub(super) by_columns: [Vec<Tile>; N],
    /// Memory of tiles sent to other ranks, reused for received tiles.
    pub(super) spare: Vec<Tile>,
}

impl<const N: usize> Tiles<N> {
    /// Creates tiles with the given numbers across and down, in the order of row bands and in the order of column bands.
    /// `fill` runs the allocation over the bands of rows.
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

/// Swaps the tiles of one order into the other. `width` is the number of tiles in a band of the first order.
pub(super) fn exchange(from: &mut [Tile], to: &mut [Tile], width: usize) {
    let height = from.len() / width;
    for (j, band) in from.chunks_exact_mut(width).enumerate() {
        for (i, tile) in band.iter_mut().enumerate() {
            std::mem::swap(tile, &mut to[i * height + j]);
        }
    }
}

/// Transposes a band of tiles into consecutive columns. Each tile starts at its own row.
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
                // A slice of the accessed length avoids bounds checks in the loop.
                let values = &tile[c..=c + (TILE_ROWS - 1) * T::TILE_COLUMNS];
                for (r, value) in target.iter_mut().enumerate() {
                    *value = values[r * T::TILE_COLUMNS];
                }
            } else {
                target.fill(Complex::new(T::zero(), T::zero()));
            }
        }
    }
}

/// Transposes columns back into a band of tiles.
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
            let values = &mut tile[c..=c + (TILE_ROWS - 1) * T::TILE_COLUMNS];
            for (r, value) in source.iter().enumerate() {
                values[r * T::TILE_COLUMNS] = *value;
            }
        }
    }
}
