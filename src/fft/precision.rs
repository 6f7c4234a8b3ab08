//! The two precisions of a transform.

use std::sync::Arc;

use bytemuck::Pod;
use num_complex::Complex;
use rustfft::{Fft, FftDirection, FftNum, FftPlanner};

/// Number type of a transform: `f64`, or `f32` if an iteration needs no more accuracy.
pub(super) trait Real: FftNum + Pod {
    /// Number of columns of a tile: the complex values in two cache lines.
    const TILE_COLUMNS: usize = 128 / size_of::<Complex<Self>>();

    /// Rounds a value to this precision.
    fn of(value: f64) -> Self;

    /// Converts the value to double precision.
    fn double(self) -> f64;

    /// Plans the forward and the inverse transform of both lengths.
    ///
    /// The implementations are not generic. The transforms are therefore compiled only in this crate, and not again in
    /// every program that uses one of its generic items.
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
