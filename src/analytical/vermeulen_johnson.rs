//! Elliptic contact that rolls with creepages and slips in part.

use super::hertz::HertzEllipse;
use super::kalker_coefficients::KalkerCoefficients;
use crate::error::{Error, Result, finite, positive};

/// Creep forces of an elliptic contact that rolls along x, without spin: the curve of Vermeulen and Johnson with
/// Kalker's initial slope.
///
/// The semi-axes are a along x and b along y. Without slip, the forces would be $`f = G a b\,(C_{11}\xi,\ C_{22}\eta)`$ with
/// the [`KalkerCoefficients`]. The creepages cause
///
/// ```math
/// F = \mu P \left[1 - \left(1 - \tfrac13 x\right)^3\right] \frac{f}{|f|}, \qquad x = \frac{|f|}{\mu P} ,
/// ```
///
/// and $`\mu P`$ for $`x \ge 3`$. A positive creepage moves body 2 along the axis over body 1 and causes a positive force on
/// body 1, as in [`rolling`](crate::rolling). The curve assumes an elliptic stick zone that touches the leading edge of the
/// contact at one point, which is an approximation. For a sphere with $`\nu = 0.25`$ and a creepage along x, the curve is below
/// the [computed](crate::rolling::RollingProblem) force. The difference is 0.9 % at x = 0.3, 2.4 % at x = 1 and 1.9 % at x = 2.
/// For a steel ellipse with a = b/2 the difference is up to 3.4 %. All differences are relative to the computed force.
///
/// P. J. Vermeulen and K. L. Johnson, J. Appl. Mech. 31 (1964) 338-340, <https://doi.org/10.1115/1.3629610>, for bodies of
/// [`dundurs_beta`](crate::ElasticPair::dundurs_beta) zero; Johnson (1985), section 8.4.
///
/// ```
/// use stickslip::{ElasticPair, Material, analytical::{HertzEllipse, VermeulenJohnson}};
/// // A steel wheel of 0.46 m on a rail of 0.3 m, in m, N and Pa.
/// let steel = Material::new(210e9, 0.28)?;
/// let hertz = HertzEllipse::new(&ElasticPair::new(steel, steel)?, 0.46, 0.3, 80e3)?;
/// let force = |xi: f64| VermeulenJohnson::new(hertz, 0.3, [xi, 0.0]).map(|curve| curve.force()[0]);
/// assert!(force(1e-3)? < 2.0 * force(0.5e-3)? && force(0.1)? == 0.3 * 80e3);
/// # Ok::<(), stickslip::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct VermeulenJohnson {
    coefficients: KalkerCoefficients,
    limit: f64,
    /// Force without slip divided by the friction limit.
    relative: [f64; 2],
}

impl VermeulenJohnson {
    /// Creates the contact `hertz` with the coefficient of friction `friction` and the creepages `creepage` along x and along y
    /// (dimensionless, of either sign). The two bodies are represented by their [mean
    /// compliances](crate::ElasticPair::equivalent_shear_modulus).
    ///
    /// # Errors
    /// - [`Error::NotPositive`] if the coefficient of friction or the friction limit is not positive and finite.
    /// - [`Error::NotFinite`] if a creepage, or a force without slip divided by the friction limit, is not finite.
    /// - [`Error::CoupledMaterials`] if the [`dundurs_beta`](crate::ElasticPair::dundurs_beta) of the bodies is not zero.
    /// - The errors of [`KalkerCoefficients::new`].
    pub fn new(hertz: HertzEllipse, friction: f64, creepage: [f64; 2]) -> Result<Self> {
        positive("coefficient of friction", friction)?;
        let limit = positive("friction limit", friction * hertz.load())?;
        for creepage in creepage {
            finite("creepage", creepage)?;
        }
        let pair = hertz.pair();
        if pair.is_coupled() {
            let beta = pair.dundurs_beta();
            return Err(Error::CoupledMaterials { beta });
        }
        let [a, b] = hertz.semi_axes();
        let coefficients = KalkerCoefficients::new(a / b, pair.equivalent_poisson_ratio())?;
        // Twice the equivalent modulus is the modulus of two equal bodies of the same total compliance.
        let unit = 2.0 * pair.equivalent_shear_modulus() * a * b / limit;
        let [c11, c22] = [coefficients.c11(), coefficients.c22()];
        let relative = [c11 * unit * creepage[0], c22 * unit * creepage[1]];
        let curve = Self {
            coefficients,
            limit,
            relative,
        };
        let x = curve.relative_creepage();
        finite("force without slip divided by the friction limit", x)?;
        Ok(curve)
    }

    /// Returns the tangential force F on body 1 along x and along y (forces).
    #[must_use]
    pub fn force(&self) -> [f64; 2] {
        let x = self.relative_creepage();
        if x == 0.0 {
            return [0.0; 2];
        }
        let left = 1.0 - (x / 3.0).min(1.0);
        // This factor is 1 - left^3 without cancellation for small creepages.
        let part = (1.0 + left + left * left) * (x / 3.0).min(1.0);
        self.relative.map(|f| self.limit * part * (f / x))
    }

    /// Returns x, the force without slip divided by the friction limit (dimensionless). It is 3 or more if the whole
    /// contact slips.
    #[must_use]
    pub fn relative_creepage(&self) -> f64 {
        self.relative[0].hypot(self.relative[1])
    }

    /// Returns Kalker's coefficients of the contact without slip.
    #[must_use]
    pub fn coefficients(&self) -> KalkerCoefficients {
        self.coefficients
    }
}
