//! Comparison of values up to round-off.

/// Relative difference below which two values count as equal.
pub(crate) const ROUND_OFF: f64 = 1e-9;

/// Returns whether two values are equal within the round-off of values of the size `scale`.
pub(crate) fn agree(one: f64, other: f64, scale: f64) -> bool {
    (one - other).abs() <= ROUND_OFF * one.abs().max(other.abs()).max(scale)
}
