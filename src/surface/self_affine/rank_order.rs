//! Waves of given moduli whose heights approximately follow a given distribution.
//!
//! Two steps alternate. First, each height is replaced by the height of the same rank in the distribution. Then the
//! moduli of the waves are restored, and only the new phases are kept.

use num_complex::Complex;

use super::johnson::sorted_heights;
use super::moments::{Standardised, deviation};
use crate::error::Result;
use crate::grid::field::Field;
use crate::observer::WorkObserver;
use crate::surface::waves::Waves;

/// Maximum number of iterations. Each iteration costs two transforms and a sort.
const LIMIT: usize = 20;
/// Change of skewness and kurtosis below which the iteration ends.
const SLOW: f64 = 0.01;

/// Computes waves with the moduli of the given waves. Their heights approximately follow a distribution of the given
/// skewness and kurtosis. Returns the waves and the number of iterations.
///
/// # Errors
/// - [`Error::NotConverged`](crate::Error::NotConverged) if the observer cancels.
pub(super) fn approach(
    drawn: &Waves,
    wanted: [f64; 2],
    watch: &mut WorkObserver<'_>,
) -> Result<(Waves, usize)> {
    let mut waves = drawn.clone();
    let mut surface = Standardised::new(waves.clone().into_field());
    let sorted = sorted_heights(wanted, surface.heights.as_slice().len());
    let mut iterations = 0;
    let mut change = f64::INFINITY;
    while iterations < LIMIT && change > SLOW {
        let last = surface.moments();
        watch.shown().residual = deviation(last, wanted);
        watch.notify_observer()?;
        replace_by_rank(&mut surface.heights, &sorted);
        waves = Waves::of(&surface.heights);
        waves.update_with([drawn], |_, wave, [drawn]| with_modulus_of(drawn, wave));
        // If the transform of a wave is round-off, the phases of the wave and of its mirror image are unrelated.
        waves.pair_opposite_rows();
        surface = Standardised::new(waves.clone().into_field());
        change = deviation(surface.moments(), last);
        iterations += 1;
        watch.shown().iteration = iterations;
    }
    Ok((waves, iterations))
}

/// Assigns to every cell the sorted height of its rank.
fn replace_by_rank(heights: &mut Field, sorted: &[f64]) {
    let heights = heights.as_mut_slice();
    let mut ranked: Vec<_> = heights.iter().copied().enumerate().collect();
    ranked.sort_unstable_by(|(i, a), (j, b)| a.total_cmp(b).then(i.cmp(j)));
    for ((index, _), height) in ranked.into_iter().zip(sorted) {
        heights[index] = *height;
    }
}

/// Returns a number with the phase of `wave` and the modulus of `drawn`.
fn with_modulus_of(drawn: Complex<f64>, wave: Complex<f64>) -> Complex<f64> {
    let modulus = wave.norm();
    if modulus > 0.0 {
        wave * (drawn.norm() / modulus)
    } else {
        drawn
    }
}
