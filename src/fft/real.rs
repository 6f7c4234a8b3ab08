//! The two precisions of a transform.

use bytemuck::Pod;
use num_complex::Complex;
use rustfft::FftNum;

/// `f64`, or `f32` where an iteration needs no more.
pub(super) trait Real: FftNum + Pod {
    /// Complex numbers in a cache line, twice: columns of a tile.
    const TILE_COLUMNS: usize = 128 / size_of::<Complex<Self>>();

    /// The nearest number.
    fn of(value: f64) -> Self;

    /// The same number in double precision.
    fn double(self) -> f64;
}

impl Real for f64 {
    fn of(value: f64) -> Self {
        value
    }

    fn double(self) -> f64 {
        self
    }
}

impl Real for f32 {
    #[expect(clippy::cast_possible_truncation, reason = "rounding is the purpose")]
    fn of(value: f64) -> Self {
        value as Self
    }

    fn double(self) -> f64 {
        f64::from(self)
    }
}
