//! Requirements on measured heights before they are processed.

use crate::error::{Result, samples_obey};
use crate::grid::field::Field;
#[cfg(feature = "roughness")]
use crate::parallel::reduce;
#[cfg(feature = "roughness")]
use crate::surface::Slab;

/// Returns an error if a height is missing or infinite.
pub(super) fn complete(quantity: &'static str, heights: &Field) -> Result<()> {
    let rule = "must be finite; fill missing heights first";
    samples_obey(quantity, heights.as_slice(), rule, f64::is_finite)
}

/// Returns an error if a height is infinite. Missing heights (NaN) are accepted.
pub(super) fn finite_or_missing(heights: &Field) -> Result<()> {
    let rule = "must be finite, or NaN if the height is missing";
    samples_obey("height", heights.as_slice(), rule, |z| !z.is_infinite())
}

/// Returns the number of measured heights over all ranks.
#[cfg(feature = "roughness")]
pub(super) fn measured_points(heights: &Field, slab: &Slab) -> usize {
    let z = heights.as_slice();
    reduce::sum(slab.layout(), |i| usize::from(!z[i].is_nan()))
}

/// Returns the heights relative to the mean over all ranks, and the mean. Missing heights (NaN) have no weight and remain
/// missing. `points` is the number of measured heights.
///
/// The sum is formed relative to the first measured height. A flat surface therefore has exactly zero deviation, and a
/// distant datum does not increase round-off.
#[cfg(feature = "roughness")]
pub(super) fn about_mean(heights: &Field, slab: &Slab, points: usize) -> (Field, f64) {
    let z = heights.as_slice();
    let first = z.iter().copied().find(|z| !z.is_nan());
    let datum = slab
        .layout()
        .combined(first, Option::or)
        .unwrap_or_default();
    let [sum] = reduce::sum(slab.layout(), |i| [or_zero(z[i] - datum)]);
    let shift = sum / points as f64;
    let mut deviations = heights.clone();
    for value in deviations.as_mut_slice() {
        *value = (*value - datum) - shift;
    }
    (deviations, datum + shift)
}

/// Returns the summand of a height, which is zero if the height is missing.
#[cfg(feature = "roughness")]
#[inline]
pub(super) fn or_zero(z: f64) -> f64 {
    if z.is_nan() { 0.0 } else { z }
}
