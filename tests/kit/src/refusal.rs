//! Parameters of every kind, and what has to become of those that make no sense.

use stickslip::{Error, Field, Grid};

/// What a parameter must be.
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

/// The call refuses every value that breaks the rule with an error that names the parameter and the value, and
/// neither panics nor comes to no number on those at the ends of what doubles can say.
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

/// The number of largest size in a field, NaN if there is one.
pub fn extreme(field: &Field) -> f64 {
    field.as_slice().iter().fold(0.0, |largest: f64, &value| {
        if largest.is_nan() || value.is_nan() {
            f64::NAN
        } else {
            largest.max(value.abs())
        }
    })
}

/// Both sizes that do not fit, in numbers.
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
