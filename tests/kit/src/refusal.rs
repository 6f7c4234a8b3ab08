//! Checks of parameters of every type. Invalid values must be rejected, and extreme values must be handled.

use std::fmt::Debug;

use stickslip::{Error, Field, Grid};

/// Requirement for a parameter.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Rule {
    /// Greater than zero, and finite.
    Positive,
    /// Zero or more, and finite.
    NonNegative,
    /// Any finite number.
    Finite,
}

impl Rule {
    fn broken_by(self) -> Vec<f64> {
        let mut values = vec![f64::NAN, f64::INFINITY, f64::NEG_INFINITY];
        if self != Self::Finite {
            values.extend([-1.0, -1e-300, -5e-324, -1e300]);
        }
        if self == Self::Positive {
            values.extend([0.0, -0.0]);
        }
        values
    }
}

/// Asserts that the call rejects every value that violates the rule, with an error that names the parameter and the
/// value. Asserts further that the smallest and the largest valid doubles cause no panic and give finite results or
/// errors.
pub fn assert_checked(word: &str, rule: Rule, call: impl Fn(f64) -> Result<f64, Error>) {
    for value in rule.broken_by() {
        let Err(error) = call(value) else {
            panic!("{word}: {value:e} is accepted");
        };
        let message = error.to_string();
        let names_it = message.contains(word);
        let shows_it =
            message.contains(&format!("{value}")) || message.contains(&format!("{value:e}"));
        assert!(names_it && shows_it, "{word}, {value:e}: {message}");
    }
    for value in [5e-324, 1e-310, 1e-300, 1e-160, 1e160, 1e300, 1e308] {
        let signed = if rule == Rule::Finite { -value } else { value };
        for value in [value, signed] {
            if let Ok(outcome) = call(value) {
                assert!(outcome.is_finite(), "{word}: {value:e} makes {outcome}");
            }
        }
    }
}

/// Returns the value of largest magnitude in a field, or NaN if the field contains a NaN.
pub fn extreme(field: &Field) -> f64 {
    field.as_slice().iter().fold(0.0, |largest: f64, &value| {
        if largest.is_nan() || value.is_nan() {
            f64::NAN
        } else {
            largest.max(value.abs())
        }
    })
}

/// Asserts that the message contains both sizes, and returns the error.
pub fn mismatch(quantity: &'static str, expected: Grid, found: Grid) -> Error {
    let error = Error::GridMismatch {
        quantity,
        expected_cells: [expected.nx(), expected.ny()],
        expected_sides: [expected.dx(), expected.dy()],
        found_cells: [found.nx(), found.ny()],
        found_sides: [found.dx(), found.dy()],
    };
    let message = error.to_string();
    assert!(message.contains(&format!("[{}, {}]", found.nx(), found.ny())));
    assert!(message.contains(&format!("[{}, {}]", expected.nx(), expected.ny())));
    error
}

/// Outcome of a call that should be refused.
pub trait Refusal {
    type Error: Debug;

    /// Returns the error of a refused call, or `None` if the call was accepted.
    fn refusal(self) -> Option<Self::Error>;
}

impl<T, E: Debug> Refusal for Result<T, E> {
    type Error = E;

    fn refusal(self) -> Option<E> {
        self.err()
    }
}

impl<'a, T, E: Debug> Refusal for &'a Result<T, E> {
    type Error = &'a E;

    fn refusal(self) -> Option<&'a E> {
        self.as_ref().err()
    }
}

impl<E: Debug> Refusal for Option<E> {
    type Error = E;

    fn refusal(self) -> Option<E> {
        self
    }
}

impl Refusal for Error {
    type Error = Self;

    fn refusal(self) -> Option<Self> {
        Some(self)
    }
}

/// Asserts that each call of a table is refused with the error of its row. A row is `call => pattern`, or
/// `call => pattern if condition`. All rows are checked, and the message lists the rows that fail.
#[macro_export]
macro_rules! assert_refused {
    ($($call:expr => $error:pat $(if $condition:expr)?),+ $(,)?) => {{
        let mut failed = Vec::new();
        $(match $crate::refusal::Refusal::refusal($call) {
            Some($error) $(if $condition)? => {}
            other => failed.push(format!("{}: {other:?}", stringify!($call))),
        })+
        assert!(failed.is_empty(), "accepted, or refused with another error: {failed:#?}");
    }};
}

/// Asserts rules for parameters with [`assert_checked`]. A row is `Rule "parameter" => call`.
#[macro_export]
macro_rules! assert_all_checked {
    ($($rule:ident $word:literal => $call:expr),+ $(,)?) => {
        $($crate::refusal::assert_checked($word, $crate::refusal::Rule::$rule, $call);)+
    };
}
