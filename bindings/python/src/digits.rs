//! Numbers in the notation of Python: with six significant digits in `repr`, as in the format `g`, and with all digits in
//! messages.

use pyo3::prelude::*;
use pyo3::types::PyFloat;

/// Formats a number with six significant digits.
pub(crate) fn short(value: f64) -> String {
    rounded(value, 6)
}

/// Formats a bound or a residual, whose order of magnitude matters.
pub(crate) fn rough(value: f64) -> String {
    rounded(value, 2)
}

/// Formats a number with the given number of significant digits.
fn rounded(value: f64, digits: i32) -> String {
    if value == 0.0 {
        return "0".into();
    }
    if !value.is_finite() {
        return value.to_string().to_lowercase();
    }
    let mantissa_decimals = usize::try_from(digits - 1).unwrap_or(0);
    let scientific = format!("{value:.mantissa_decimals$e}");
    let (mantissa, exponent) = scientific.split_once('e').unwrap_or((&scientific, "0"));
    let exponent: i32 = exponent.parse().unwrap_or(0);
    match usize::try_from(digits - 1 - exponent) {
        Ok(decimals) if exponent >= -4 => trimmed(&format!("{value:.decimals$}")).into(),
        _ => format!("{}e{exponent:+03}", trimmed(mantissa)),
    }
}

/// Formats numbers as a tuple.
pub(crate) fn tuple(values: &[f64]) -> String {
    let values: Vec<_> = values.iter().map(|&value| short(value)).collect();
    format!("({})", values.join(", "))
}

/// Formats a count with its noun, given in the singular.
pub(crate) fn counted(count: usize, name: &str) -> String {
    let plural = if count == 1 { "" } else { "s" };
    format!("{count} {name}{plural}")
}

/// Removes the zeros at the end of the decimals.
fn trimmed(digits: &str) -> &str {
    if digits.contains('.') {
        digits.trim_end_matches('0').trim_end_matches('.')
    } else {
        digits
    }
}

/// Formats a number as Python does.
pub(crate) fn as_python(py: Python<'_>, value: f64) -> PyResult<String> {
    Ok(PyFloat::new(py, value).repr()?.to_string())
}

/// Returns a sentence of the crate with its numbers in Python notation. The crate writes floating-point numbers with a
/// decimal point or an exponent.
pub(crate) fn in_python(py: Python<'_>, sentence: &str) -> PyResult<String> {
    let mut parts = parts(sentence);
    for part in &mut parts {
        let is_number = part.ends_with(|last: char| last.is_ascii_digit());
        let is_floating = is_number && part.contains(['.', 'e']);
        if is_floating || part == "NaN" {
            // Other words that look like numbers remain unchanged.
            if let Ok(value) = part.parse() {
                *part = as_python(py, value)?;
            }
        }
    }
    Ok(parts.concat())
}

/// Splits a sentence into numbers, words and the text between them.
fn parts(sentence: &str) -> Vec<String> {
    let mut parts: Vec<String> = Vec::new();
    let mut rest = sentence;
    while let Some(first) = rest.chars().next() {
        let before = parts.last().and_then(|part| part.chars().last());
        let is_apart = !before.is_some_and(char::is_alphanumeric);
        let number = if is_apart { number(rest) } else { 0 };
        let word = rest.find(|letter: char| !letter.is_alphanumeric());
        let length = match number {
            0 => word.unwrap_or(rest.len()).max(first.len_utf8()),
            length => length,
        };
        let (part, after) = rest.split_at(length);
        parts.push(part.into());
        rest = after;
    }
    parts
}

/// Returns the length of the number at the start of a text; zero if the text does not start with a number.
fn number(text: &str) -> usize {
    let digits = |text: &str| text.bytes().take_while(u8::is_ascii_digit).count();
    let signed = |text: &str| {
        let sign = usize::from(text.starts_with('-'));
        match digits(&text[sign..]) {
            0 => 0,
            count => sign + count,
        }
    };
    let mut length = signed(text);
    if length == 0 {
        return 0;
    }
    if text[length..].starts_with('.') {
        let decimals = digits(&text[length + 1..]);
        length += if decimals > 0 { decimals + 1 } else { 0 };
    }
    if text[length..].starts_with('e') {
        let exponent = signed(&text[length + 1..]);
        length += if exponent > 0 { exponent + 1 } else { 0 };
    }
    length
}
