//! Units of the lengths of surfaces: kept and compared, never asked for.

use std::sync::Arc;

use pyo3::PyResult;
use pyo3::exceptions::PyValueError;

/// As it is written.
pub(crate) type Unit = Arc<str>;

/// Metres in a unit of length.
pub(crate) fn metres(unit: &str) -> PyResult<f64> {
    Ok(match unit {
        "m" => 1.0,
        "dm" => 1e-1,
        "cm" => 1e-2,
        "mm" => 1e-3,
        // The micro sign, and the letter mu.
        "um" | "\u{b5}m" | "\u{3bc}m" => 1e-6,
        "nm" => 1e-9,
        // The letter with a ring, and the sign.
        "A" | "\u{c5}" | "\u{212b}" => 1e-10,
        "pm" => 1e-12,
        other => {
            return Err(PyValueError::new_err(format!(
                "{other} is no unit of length from pm to m"
            )));
        }
    })
}

/// Whether two names are of one unit, such as um and \u{b5}m.
pub(crate) fn is_same(a: &str, b: &str) -> bool {
    let sizes = metres(a).ok().zip(metres(b).ok());
    a == b || sizes.is_some_and(|(a, b)| a.to_bits() == b.to_bits())
}

/// The unit that is stated; an error if two differ.
pub(crate) fn one_of(units: impl IntoIterator<Item = Option<Unit>>) -> PyResult<Option<Unit>> {
    let mut first: Option<Unit> = None;
    for unit in units.into_iter().flatten() {
        match &first {
            Some(first) if !is_same(first, &unit) => {
                return Err(PyValueError::new_err(format!(
                    "one surface is in {first} and another in {unit}: give both in one unit, surface.to_unit(...)"
                )));
            }
            Some(_) => {}
            None => first = Some(unit),
        }
    }
    Ok(first)
}
