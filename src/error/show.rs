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
        "nothing is pressed yet: give the normal load first"
    };
    format!("a tangential force of {force:e} exceeds the friction limit {limit:e}: {remedy}")
}

/// Why a normal force cannot act, and what to do.
pub(super) fn beyond_hardness(force: f64, capacity: f64) -> String {
    format!(
        "a normal force of {force:e} exceeds the {capacity:e} that cells at their hardness carry: take a larger grid, or prescribe an approach"
    )
}
