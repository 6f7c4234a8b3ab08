//! Units of the lengths of surfaces, which are kept and compared but never required.

use std::sync::Arc;

use pyo3::PyResult;
use pyo3::exceptions::PyValueError;

/// Name of a unit as given by the user.
pub(crate) type Unit = Arc<str>;

/// Returns the length of a unit in metres.
pub(crate) fn metres(unit: &str) -> PyResult<f64> {
    Ok(match unit {
        "m" => 1.0,
        "dm" => 1e-1,
        "cm" => 1e-2,
        "mm" => 1e-3,
        // The micro sign and the Greek letter mu are both accepted.
        "um" | "\u{b5}m" | "\u{3bc}m" => 1e-6,
        "nm" => 1e-9,
        // The letter with a ring and the angstrom sign are both accepted.
        "A" | "\u{c5}" | "\u{212b}" => 1e-10,
        "pm" => 1e-12,
        other => {
            return Err(PyValueError::new_err(format!(
                "{other} is not a unit of length from pm to m"
            )));
        }
    })
}

/// Returns whether two names denote the same unit, such as um and \u{b5}m.
pub(crate) fn is_same(a: &str, b: &str) -> bool {
    let sizes = metres(a).ok().zip(metres(b).ok());
    a == b || sizes.is_some_and(|(a, b)| a.to_bits() == b.to_bits())
}

/// Returns the stated unit, or an error if two units differ.
pub(crate) fn one_of(units: impl IntoIterator<Item = Option<Unit>>) -> PyResult<Option<Unit>> {
    let mut first: Option<Unit> = None;
    for unit in units.into_iter().flatten() {
        match &first {
            Some(first) if !is_same(first, &unit) => {
                return Err(PyValueError::new_err(format!(
                    "the surfaces have the units {first} and {unit}: convert one of them by surface.to_unit(...)"
                )));
            }
            Some(_) => {}
            None => first = Some(unit),
        }
    }
    Ok(first)
}
