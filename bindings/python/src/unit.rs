//! Units of the lengths of surfaces, which are kept and compared but never required.

use std::sync::{Arc, OnceLock};

use pyo3::PyClass;
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::pyclass::boolean_struct::True;

/// Name of a unit as given by the user.
pub(crate) type Unit = Arc<str>;

/// Returns the power of ten that converts a unit to metres.
fn exponent(unit: &str) -> PyResult<i32> {
    Ok(match unit {
        "km" => 3,
        "m" => 0,
        "dm" => -1,
        "cm" => -2,
        "mm" => -3,
        // The micro sign and the Greek letter mu are both accepted.
        "um" | "\u{b5}m" | "\u{3bc}m" => -6,
        "nm" => -9,
        // The letter with a ring and the angstrom sign are both accepted.
        "A" | "\u{c5}" | "\u{212b}" => -10,
        "pm" => -12,
        other => {
            return Err(PyValueError::new_err(format!(
                "{other} is not a unit of length: the units are km, m, dm, cm, mm, um, nm, A and pm"
            )));
        }
    })
}

/// Returns the factor that converts lengths from one unit to another.
pub(crate) fn factor(from: &str, to: &str) -> PyResult<f64> {
    let power = exponent(from)? - exponent(to)?;
    // Powers with a positive exponent are exact.
    let exact = 10.0_f64.powi(power.abs());
    Ok(if power < 0 { 1.0 / exact } else { exact })
}

/// Returns the unit with a given name, or an error if the name is not a unit.
pub(crate) fn known(unit: &str) -> PyResult<Unit> {
    exponent(unit).map(|_| unit.into())
}

/// Returns whether two names denote the same unit, such as um and \u{b5}m.
pub(crate) fn is_same(a: &str, b: &str) -> bool {
    let powers = exponent(a).ok().zip(exponent(b).ok());
    a == b || powers.is_some_and(|(a, b)| a == b)
}

/// Returns whether two objects have the same unit; a missing unit agrees with any unit.
pub(crate) fn agree(a: Option<&Unit>, b: Option<&Unit>) -> bool {
    a.zip(b).is_none_or(|(a, b)| is_same(a, b))
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

/// Returns an error if the unit of a relative displacement differs from the unit of the lengths with which it is used.
pub(crate) fn check_relative(
    lengths: &str,
    known: Option<&Unit>,
    given: Option<&Unit>,
) -> PyResult<()> {
    match (known, given) {
        (Some(known), Some(given)) if !is_same(known, given) => {
            let factor = factor(given, known)?;
            Err(PyValueError::new_err(format!(
                "relative displacement has the unit {given}, but {lengths} has the unit {known}: \
                 give Field(grid, {factor:?} * samples, \"{known}\") if the sides of the grid are in {known}"
            )))
        }
        _ => Ok(()),
    }
}

/// Returns the unit of a history that continues from a state, or an error if the units differ.
pub(crate) fn of_state(own: Option<&Unit>, state: Option<&Unit>) -> PyResult<Option<Unit>> {
    if agree(own, state) {
        return Ok(own.or(state).cloned());
    }
    let names = [own, state].map(|unit| unit.map_or("", |unit| &**unit));
    Err(PyValueError::new_err(format!(
        "state has the unit {}, but the gap of the history has the unit {}: continue by History.from_state(bodies, state)",
        names[1], names[0]
    )))
}

/// Returns the unit of a gap that replaces another gap, or an error if the units differ. A gap without a unit has the unit of the
/// last gap.
pub(crate) fn of_next_gap(last: Option<&Unit>, given: Option<Unit>) -> PyResult<Option<Unit>> {
    match (last, given) {
        (Some(last), Some(given)) if !is_same(last, &given) => {
            let factor = factor(&given, last)?;
            Err(PyValueError::new_err(format!(
                "gap has the unit {given}, but the last gap had the unit {last}: \
                 give Field(grid, {factor:?} * heights, \"{last}\") if the sides of the grid are in {last}"
            )))
        }
        (last, given) => Ok(last.cloned().or(given)),
    }
}

/// Solution with the unit of its gap, which solves set in the finished object.
pub(crate) trait GapUnit: PyClass<Frozen = True> + Sync {
    fn unit_cell(&self) -> &OnceLock<Unit>;
}

/// Sets the unit of the gap in the solution of a solve, or in the last iterate of a failed solve.
pub(crate) fn set_in<'py, T: GapUnit>(
    outcome: PyResult<Bound<'py, T>>,
    py: Python<'py>,
    unit: Option<&Unit>,
) -> PyResult<Bound<'py, T>> {
    let iterate = match &outcome {
        Ok(solution) => Some(solution.clone()),
        Err(error) => {
            let iterate = error.value(py).getattr("last_iterate").ok();
            iterate.and_then(|iterate| iterate.cast_into().ok())
        }
    };
    if let (Some(solution), Some(unit)) = (iterate, unit) {
        solution.get().unit_cell().get_or_init(|| unit.clone());
    }
    outcome
}
