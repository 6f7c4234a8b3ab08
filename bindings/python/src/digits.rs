//! Numbers as `repr` writes them: measures with six significant digits, in the form of Python's format `g`.

/// A number.
pub(crate) fn short(value: f64) -> String {
    rounded(value, 6)
}

/// A bound or a residual, of which the order matters.
pub(crate) fn rough(value: f64) -> String {
    rounded(value, 2)
}

/// A number with so many significant digits.
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

/// Numbers as a tuple.
pub(crate) fn tuple(values: &[f64]) -> String {
    let values: Vec<_> = values.iter().map(|&value| short(value)).collect();
    format!("({})", values.join(", "))
}

/// So many of what is called by this name in the singular.
pub(crate) fn counted(count: usize, name: &str) -> String {
    let plural = if count == 1 { "" } else { "s" };
    format!("{count} {name}{plural}")
}

/// Without the zeros at the end of the decimals.
fn trimmed(digits: &str) -> &str {
    if digits.contains('.') {
        digits.trim_end_matches('0').trim_end_matches('.')
    } else {
        digits
    }
}
