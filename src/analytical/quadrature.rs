//! Quadrature of a smooth function.

/// Computes the integral of `integrand` from zero to `length`. The result is accurate to a few rounding errors if the
/// integrand is analytic within a distance of one from the interval.
pub(super) fn integral(length: f64, integrand: impl Fn(f64) -> f64) -> f64 {
    let panels = (length / LONGEST_PANEL).ceil().max(1.0);
    let half = 0.5 * length / panels;
    let mut sum = 0.0;
    // The loop counts the panels instead of comparing positions, because the width of a panel can underflow to zero.
    let mut panel = 0.0;
    while panel < panels {
        let middle = (2.0 * panel + 1.0) * half;
        panel += 1.0;
        for [node, weight] in GAUSS_8 {
            let reach = half * node;
            sum += weight * (integrand(middle - reach) + integrand(middle + reach));
        }
    }
    half * sum
}

/// Length of the longest panel. The nearest singularity is then four half panels away, and eight nodes are exact to
/// 1e-14.
const LONGEST_PANEL: f64 = 0.5;

/// Positive nodes of the Gauss-Legendre rule on `[-1, 1]` and their weights. The negative nodes have the same weights.
const GAUSS_8: [[f64; 2]; 4] = [
    [0.1834346424956498, 0.362683783378362],
    [0.525532409916329, 0.3137066458778873],
    [0.7966664774136267, 0.2223810344533745],
    [0.9602898564975363, 0.1012285362903763],
];

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    #[test]
    fn known_integrals() {
        for length in [1e-9_f64, 0.3, 0.5, 1.0, 7.3, 40.0] {
            let exponential = integral(length, |x| (-x).exp());
            assert_relative_eq!(exponential, -(-length).exp_m1(), max_relative = 1e-14);
            let rational = integral(length, |x| 1.0 / (1.0 + x * x));
            assert_relative_eq!(rational, length.atan(), max_relative = 1e-14);
        }
        assert!(integral(0.0, |_| 1.0).abs() <= 0.0);
    }
}
