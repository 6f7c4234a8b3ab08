//! How an error is shown, beyond the sentence of its variant.

use std::fmt;

use crate::error::Error;

impl fmt::Debug for Error {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, formatter)
    }
}

/// The name of a file before what is wrong in it.
pub(super) fn prefix(file: Option<&str>) -> String {
    file.map_or_else(String::new, |file| format!("{file}: "))
}

/// Why a tangential force cannot act, and what to do.
pub(super) fn beyond_capacity(force: f64, limit: f64) -> String {
    let remedy = if limit > 0.0 {
        "prescribe a shift or a spring to let the body slide"
    } else {
        "nothing is pressed, or there is no friction: give a normal load and a coefficient of friction above zero"
    };
    format!("a tangential force of {force:e} exceeds the friction limit {limit:e}: {remedy}")
}

/// Why a normal force cannot act, and what to do.
pub(super) fn beyond_hardness(force: f64, capacity: f64) -> String {
    format!(
        "a normal force of {force:e} exceeds the {capacity:e} that cells at their hardness carry: take a larger grid, or prescribe an approach"
    )
}

/// That no surface has the heights asked for.
pub(super) fn heights_not_reached(skewness: f64, kurtosis: f64, reached: [f64; 2]) -> String {
    format!(
        "no surface of this spectrum was found with a skewness of {skewness} and a kurtosis of {kurtosis}; the search ended at {} and {}",
        reached[0], reached[1]
    )
}

/// Why an approach determines no pressure.
pub(super) fn beyond_mean_gap(approach: f64, mean_gap: f64) -> String {
    format!(
        "an approach of {approach:e} is not below the mean gap {mean_gap:e} of a periodic contact: it closes the gap everywhere, and the pressure is undetermined"
    )
}

/// Why a cycle cannot stand for those that follow, and what to do.
pub(super) fn not_closed(residual: f64, limit: f64) -> String {
    format!(
        "the cycle ends {residual:e} of its amplitude from where it began, more than {limit:e}: take another cycle on this gap before jumping, or allow a larger residual"
    )
}
