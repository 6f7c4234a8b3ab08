//! Differences of sines that vanish as the cube of their angle.
//!
//! Displacements and gaps outside a contact consist of these differences. Evaluated directly, they would lose all
//! digits at the edge of the contact and some digits far from it.

/// Returns $`\sin t - t\cos t = t^3/3 - \dots`$, for $`0 \le t \le 2\pi`$.
pub(crate) fn sine_minus_arc_cosine(t: f64) -> f64 {
    if t < SERIES_BELOW {
        series(t, t * t, |k| 2.0 * k)
    } else {
        t.sin() - t * t.cos()
    }
}

/// Returns $`t - \sin t = t^3/6 - \dots`$, for $`0 \le t \le 2\pi`$.
pub(crate) fn arc_minus_sine(t: f64) -> f64 {
    if t < SERIES_BELOW {
        series(t, t * t, |_| 1.0)
    } else {
        t - t.sin()
    }
}

/// Returns $`\sinh t - t = t^3/6 + \dots`$, for $`t \ge 0`$.
pub(crate) fn hyperbolic_sine_minus_arc(t: f64) -> f64 {
    if t < SERIES_BELOW {
        -series(t, -t * t, |_| 1.0)
    } else {
        t.sinh() - t
    }
}

/// Angle below which the series converges to round-off within [`TERMS`] terms. Above this angle less than one digit
/// cancels.
const SERIES_BELOW: f64 = 1.0;
const TERMS: u32 = 8;

/// Sums the series $`\sum_{k \ge 1} (-1)^{k+1} w_k\, t\,s^k/(2k+1)!`$ with the square $`s = t^2`$, or $`s = -t^2`$ for
/// hyperbolic functions.
fn series(t: f64, square: f64, weight: impl Fn(f64) -> f64) -> f64 {
    let mut term = t;
    let mut sum = 0.0;
    for k in (1..=TERMS).map(f64::from) {
        term *= -square / (2.0 * k * (2.0 * k + 1.0));
        sum -= weight(k) * term;
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    #[test]
    fn series_meets_closed_form() {
        for t in [0.9, 0.99, 0.999_999_f64] {
            let (sine, cosine) = t.sin_cos();
            let expected = sine - t * cosine;
            assert_relative_eq!(sine_minus_arc_cosine(t), expected, max_relative = 2e-15);
            assert_relative_eq!(arc_minus_sine(t), t - sine, max_relative = 2e-15);
            let found = hyperbolic_sine_minus_arc(t);
            assert_relative_eq!(found, t.sinh() - t, max_relative = 4e-15);
        }
    }

    #[test]
    fn small_angles_keep_their_digits() {
        let t = 1e-5_f64;
        let cube = t * t * t;
        assert_relative_eq!(
            sine_minus_arc_cosine(t),
            cube / 3.0 * (1.0 - t * t / 10.0),
            max_relative = 1e-15,
            epsilon = 0.0
        );
        assert_relative_eq!(
            arc_minus_sine(t),
            cube / 6.0 * (1.0 - t * t / 20.0),
            max_relative = 1e-15,
            epsilon = 0.0
        );
        assert_relative_eq!(
            hyperbolic_sine_minus_arc(t),
            cube / 6.0 * (1.0 + t * t / 20.0),
            max_relative = 1e-15,
            epsilon = 0.0
        );
    }
}
