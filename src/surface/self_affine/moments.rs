//! Means over the cells of a field.

use std::ops::Range;

use crate::grid::field::Field;
use crate::parallel;
use crate::parallel::layout::Layout;

/// Computes the mean of a function of the samples. The result does not depend on the number of threads.
pub(super) fn mean_of(field: &Field, f: impl Fn(f64) -> f64 + Sync) -> f64 {
    mean_over(&field.grid().layout(), field.as_slice(), f)
}

/// Computes the mean of a function of samples with the given layout, which may extend over several ranks.
pub(super) fn mean_over(layout: &Layout, samples: &[f64], f: impl Fn(f64) -> f64 + Sync) -> f64 {
    let sum_over = |range: Range<usize>| samples[range].iter().map(|&z| f(z)).sum::<f64>();
    layout.fold(sum_over, |a, b| a + b) / layout.of_all_ranks() as f64
}

/// Heights of mean zero and mean square one, with the scale of the normalisation.
#[derive(Debug)]
pub(super) struct Standardised {
    pub(super) heights: Field,
    /// Root mean square of the original heights, relative to their mean.
    pub(super) deviation: f64,
    pub(super) skewness: f64,
    pub(super) kurtosis: f64,
}

impl Standardised {
    pub(super) fn new(mut heights: Field) -> Self {
        let mean = mean_of(&heights, |z| z);
        let deviation = mean_of(&heights, |z| (z - mean).powi(2)).sqrt();
        parallel::update(heights.as_mut_slice(), |_, chunk| {
            for height in chunk {
                *height = (*height - mean) / deviation;
            }
        });
        Self {
            skewness: mean_of(&heights, |x| x.powi(3)),
            kurtosis: mean_of(&heights, |x| x.powi(4)),
            heights,
            deviation,
        }
    }

    /// Returns skewness and kurtosis.
    pub(super) fn moments(&self) -> [f64; 2] {
        [self.skewness, self.kurtosis]
    }
}

/// Returns the larger of the differences in skewness and kurtosis.
pub(super) fn deviation([s, k]: [f64; 2], [other_s, other_k]: [f64; 2]) -> f64 {
    (s - other_s).abs().max((k - other_k).abs())
}
