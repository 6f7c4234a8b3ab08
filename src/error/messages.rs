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

/// Returns a number of bytes in MiB below 1 GiB, else in GiB.
pub(super) fn size(bytes: u128) -> String {
    const MIB: f64 = 1_048_576.0;
    let mib = bytes as f64 / MIB;
    let (value, unit) = if mib < 1024.0 {
        (mib, "MiB")
    } else {
        (mib / 1024.0, "GiB")
    };
    let decimals = match value {
        ..0.01 => 6,
        ..10.0 => 3,
        _ => 1,
    };
    format!("{value:.decimals$} {unit}")
}

/// Why a tangential force cannot act, and what to do.
pub(super) fn beyond_capacity(force: f64, limit: f64, remedy: &str) -> String {
    let remedy = if limit > 0.0 {
        remedy
    } else {
        "there is no friction: give a coefficient of friction above zero"
    };
    format!("a tangential force of {force:?} exceeds the friction limit {limit:?}: {remedy}")
}

/// Why a normal force cannot act, and what to do.
pub(super) fn beyond_hardness(force: f64, capacity: f64) -> String {
    format!(
        "a normal force of {force:?} exceeds the {capacity:?} that cells at their hardness carry: take a larger grid, or prescribe an approach"
    )
}

/// That no surface has the heights asked for.
pub(super) fn heights_not_reached(skewness: f64, kurtosis: f64, reached: [f64; 2]) -> String {
    format!(
        "no surface of this spectrum was found with a skewness of {skewness:?} and a kurtosis of {kurtosis:?}; the search ended at {:?} and {:?}",
        reached[0], reached[1]
    )
}

/// Why an approach determines no pressure.
pub(super) fn beyond_mean_gap(approach: f64, mean_gap: f64) -> String {
    format!(
        "an approach of {approach:?} is not below the mean gap {mean_gap:?} of a periodic contact: it closes the gap everywhere, and the pressure is undetermined"
    )
}

/// Why a cycle cannot stand for those that follow, and what to do.
pub(super) fn not_closed(residual: f64, limit: f64) -> String {
    format!(
        "the cycle ends {residual:?} of its amplitude from where it began, more than {limit:?}: take another cycle on this gap before jumping, or allow a larger residual"
    )
}
