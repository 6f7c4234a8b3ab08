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

/// Returns the heights relative to the mean over all ranks, and the mean.
///
/// The sum is formed relative to the first height. A flat surface therefore has exactly zero deviation, and a distant
/// datum does not increase round-off.
#[cfg(feature = "roughness")]
pub(super) fn about_mean(heights: &Field, slab: &Slab) -> (Field, f64) {
    let z = heights.as_slice();
    let first = slab.layout().combined(z.first().copied(), Option::or);
    let datum = first.unwrap_or_default();
    let [sum] = reduce::sum(slab.layout(), |i| [z[i] - datum]);
    let shift = sum / slab.whole().cells() as f64;
    let mut deviations = heights.clone();
    for value in deviations.as_mut_slice() {
        *value = (*value - datum) - shift;
    }
    (deviations, datum + shift)
}
