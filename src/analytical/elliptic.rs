//! Complete elliptic integrals by the arithmetic-geometric mean.

use std::f64::consts::FRAC_PI_2;

/// Complete elliptic integrals of an elliptic contact, for the parameter $`m = 1 - \kappa^2`$.
///
/// The integral of the second kind is $`E = K - m D`$.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Integrals {
    /// $`K = \int_0^{\pi/2} (1 - m\sin^2 t)^{-1/2}\,dt`$.
    pub(crate) k: f64,
    /// $`D = (K - E)/m = \int_0^{\pi/2} \sin^2 t\,(1 - m\sin^2 t)^{-1/2}\,dt`$.
    pub(crate) d: f64,
}

impl Integrals {
    /// Computes the integrals at the complementary modulus $`\kappa = \sqrt{1-m}`$, the axis ratio of an ellipse, in
    /// `(0, 1]`.
    ///
    /// With $`a_0 = 1`$, $`b_0 = \kappa`$, $`c_0^2 = m`$ and the means $`a_{n+1} = (a_n+b_n)/2`$, $`b_{n+1} = \sqrt{a_n
    /// b_n}`$, $`c_{n+1} = c_n^2/(4a_{n+1})`$: $`K = \pi/(2a_\infty)`$ and $`D = K \sum_n 2^{n-1} c_n^2/m`$ (Abramowitz
    /// and Stegun, 17.6). All terms of the sum are positive and the first is 1/2. There is therefore no cancellation,
    /// not even at $`m = 0`$, where $`D = \pi/4`$.
    pub(crate) fn of_axis_ratio(kappa: f64) -> Self {
        let m = (1.0 - kappa) * (1.0 + kappa);
        let (mut a, mut b) = (f64::midpoint(1.0, kappa), kappa.sqrt());
        // Start with c_1 and 2^0 c_1^2/m, where c_0^2 = m is cancelled analytically.
        let mut c = 0.25 * m / a;
        let mut term = 0.25 * c / a;
        let mut sum = 0.5 + term;
        // The means agree to rounding after 4 steps for a near-circle, and after 14 steps at kappa = 1e-300.
        for _ in 0..24 {
            if term <= sum * f64::EPSILON && c.abs() <= a * f64::EPSILON {
                break;
            }
            (a, b) = (f64::midpoint(a, b), (a * b).sqrt());
            let next = 0.25 * c * c / a;
            // The factor yields 2^n c_(n+1)^2/m from 2^(n-1) c_n^2/m without a division by m.
            term *= 0.125 * c / a * (c / a);
            c = next;
            sum += term;
        }
        let k = FRAC_PI_2 / a;
        Self { k, d: k * sum }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    #[test]
    fn the_circle_needs_no_limit() {
        let circle = Integrals::of_axis_ratio(1.0);
        assert_relative_eq!(circle.k, FRAC_PI_2, max_relative = 1e-15);
        assert_relative_eq!(circle.d, 0.5 * FRAC_PI_2, max_relative = 1e-15);
        // Near the circle, K = pi/2 (1 + m/4 + ..) and D = pi/4 (1 + 3m/8 + ..), with m = 2e-9.
        let near = Integrals::of_axis_ratio(1.0 - 1e-9);
        assert_relative_eq!(near.k, FRAC_PI_2 * (1.0 + 0.5e-9), max_relative = 1e-15);
        assert_relative_eq!(
            near.d,
            0.5 * FRAC_PI_2 * (1.0 + 0.75e-9),
            max_relative = 1e-15
        );
    }

    #[test]
    fn legendre_relation_holds() {
        // Legendre's relation: E K' + E' K - K K' = pi/2.
        for kappa in [0.01_f64, 0.1, 0.3, 0.5, 0.7, 0.9, 0.99] {
            let m = 1.0 - kappa * kappa;
            let one = Integrals::of_axis_ratio(kappa);
            let two = Integrals::of_axis_ratio(m.sqrt());
            let (e_one, e_two) = (one.k - m * one.d, two.k - kappa * kappa * two.d);
            let sum = e_one * two.k + e_two * one.k - one.k * two.k;
            assert_relative_eq!(sum, FRAC_PI_2, max_relative = 1e-14);
        }
    }

    #[test]
    fn thin_ellipse_is_logarithmic() {
        // For small kappa, K -> ln(4/kappa) and D -> ln(4/kappa) - 1, up to kappa^2 ln(kappa).
        for kappa in [1e-9_f64, 1e-30, 1e-150, 1e-300] {
            let thin = Integrals::of_axis_ratio(kappa);
            let logarithm = (4.0 / kappa).ln();
            assert_relative_eq!(thin.k, logarithm, max_relative = 1e-13);
            assert_relative_eq!(thin.d, logarithm - 1.0, max_relative = 1e-13);
        }
    }
}
