//! Comparison of values up to round-off, and up to the errors of solves.

use crate::report::Report;

/// Relative difference below which two values count as equal.
pub(crate) const ROUND_OFF: f64 = 1e-9;

/// Ratio of the difference at which two solutions count as different to their certified error in the energy norm. The
/// pressure of a cell and the sums over all cells have larger relative errors than the energy.
const PER_ERROR: f64 = 100.0;

/// Largest relative difference at which two solutions may count as equal.
const LARGEST: f64 = 5e-5;

/// Returns the relative difference below which the results of solves with these reports count as equal. It follows the
/// larger certified error.
pub(crate) fn tolerance_of(reports: &[&Report]) -> f64 {
    let bounds = reports.iter().map(|report| report.energy_error_bound());
    (PER_ERROR * bounds.fold(0.0, f64::max)).clamp(ROUND_OFF, LARGEST)
}

/// Returns whether two values are equal within the round-off of values of the size `scale`.
pub(crate) fn agree(one: f64, other: f64, scale: f64) -> bool {
    agree_within(ROUND_OFF, one, other, scale)
}

/// Returns whether two values are equal within a tolerance relative to the larger value or to `scale`.
pub(crate) fn agree_within(tolerance: f64, one: f64, other: f64, scale: f64) -> bool {
    (one - other).abs() <= tolerance * one.abs().max(other.abs()).max(scale)
}
