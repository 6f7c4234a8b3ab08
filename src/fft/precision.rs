//! The two precisions of a transform.

use std::sync::Arc;

use bytemuck::Pod;
use num_complex::Complex;
use rustfft::{Fft, FftDirection, FftNum, FftPlanner};

/// `f64`, or `f32` where an iteration needs no more.
pub(super) trait Real: FftNum + Pod {
    /// Complex numbers in a cache line, twice: columns of a tile.
    const TILE_COLUMNS: usize = 128 / size_of::<Complex<Self>>();

    /// The nearest number.
    fn of(value: f64) -> Self;

    /// The same number in double precision.
    fn double(self) -> f64;

    /// Plans the forward and the inverse transform of both lengths.
    ///
    /// The implementations are not generic. The transforms are therefore compiled in this crate alone, and not again in
    /// each program that uses a generic item of it.
    fn transforms(lengths: [usize; 2]) -> [[Arc<dyn Fft<Self>>; 2]; 2];
}

fn planned<T: FftNum>(lengths: [usize; 2]) -> [[Arc<dyn Fft<T>>; 2]; 2] {
    let mut planner = FftPlanner::new();
    lengths.map(|length| {
        [FftDirection::Forward, FftDirection::Inverse].map(|way| planner.plan_fft(length, way))
    })
}

impl Real for f64 {
    fn of(value: f64) -> Self {
        value
    }

    fn double(self) -> f64 {
        self
    }

    fn transforms(lengths: [usize; 2]) -> [[Arc<dyn Fft<Self>>; 2]; 2] {
        planned(lengths)
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

    fn transforms(lengths: [usize; 2]) -> [[Arc<dyn Fft<Self>>; 2]; 2] {
        planned(lengths)
    }
}
