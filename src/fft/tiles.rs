//! The pieces in which one stage of a transform hands its results to the next.

use num_complex::Complex;

use crate::fft::real::Real;

/// Rows and columns of a tile: a piece long enough for memory, small enough to be turned in the cache.
pub(super) const TILE_ROWS: usize = 16;
pub(super) const TILE_COLUMNS: usize = 8;

/// A tile, row by row; empty while the other order owns it.
pub(super) type Tile<T> = Box<[Complex<T>]>;

/// A tile of zeros.
pub(super) fn zero<T: Real>() -> Tile<T> {
    vec![Complex::new(T::zero(), T::zero()); TILE_ROWS * TILE_COLUMNS].into_boxed_slice()
}

/// Hands tiles over from one order to the other, `width` of which lie in a band of the first.
pub(super) fn exchange<T>(from: &mut [Tile<T>], to: &mut [Tile<T>], width: usize) {
    let height = from.len() / width;
    for (j, band) in from.chunks_exact_mut(width).enumerate() {
        for (i, tile) in band.iter_mut().enumerate() {
            std::mem::swap(tile, &mut to[i * height + j]);
        }
    }
}

/// Turns a band of tiles into columns, one behind the other.
pub(super) fn gather<T: Real>(
    tiles: &[Tile<T>],
    occupied: &[bool],
    columns: &mut [Complex<T>],
    stride: usize,
) {
    for ((row, tile), &occupied) in (0..).step_by(TILE_ROWS).zip(tiles).zip(occupied) {
        for (c, column) in columns.chunks_exact_mut(stride).enumerate() {
            let target = &mut column[row..row + TILE_ROWS];
            if occupied {
                for (value, values) in target.iter_mut().zip(tile.chunks_exact(TILE_COLUMNS)) {
                    *value = values[c];
                }
            } else {
                target.fill(Complex::new(T::zero(), T::zero()));
            }
        }
    }
}

/// Turns columns back into a band of tiles.
pub(super) fn scatter<T: Real>(columns: &[Complex<T>], stride: usize, tiles: &mut [Tile<T>]) {
    for (row, tile) in (0..).step_by(TILE_ROWS).zip(tiles) {
        for (c, column) in columns.chunks_exact(stride).enumerate() {
            let source = &column[row..row + TILE_ROWS];
            for (values, value) in tile.chunks_exact_mut(TILE_COLUMNS).zip(source) {
                values[c] = *value;
            }
        }
    }
}
