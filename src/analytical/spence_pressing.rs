//! Stick zone of bodies of different materials that are pressed together.

use super::elliptic::Integrals;
use crate::bodies::material::ElasticPair;
use crate::error::{Result, non_negative};

/// Size of the stick zone of bodies of different materials that are pressed together by a growing normal load alone.
///
/// The contact has the radius or half-width $`a`$. Coupling makes the surfaces slip inwards near the edge, and the zone
/// within $`c = ka`$ sticks. If shear does not change the pressure (Goodman's assumption,
/// [`Coupling::OneWay`](crate::Coupling::OneWay)), then
///
/// ```math
/// \frac{1}{2k}\ln\frac{1+k}{1-k} = \frac{\mu}{|\beta|}\,K'(k) \quad\text{(round)}, \qquad
/// \frac{K(k)}{K'(k)} = \frac{\mu}{|\beta|} \quad\text{(plane)},
/// ```
///
/// with the complete elliptic integral $`K`$ of modulus $`k`$ and $`K'(k) = K(\sqrt{1-k^2})`$. The equations are valid
/// for a flat punch, and for a sphere, a cone or any other power of the distance, because their contacts grow
/// self-similarly. A numerical solution needs one load step for the punch and many steps for the other shapes. With
/// full coupling, the same $`k`$ requires a larger coefficient of friction. At $`k = 0.5`$ it is larger by 0.5 % for
/// $`\beta = 0.1`$, by 5 % for $`\beta = 2/7`$ and by 17 % for $`\beta = 1/2`$.
///
/// Round: D. A. Spence, *J. Elasticity* 5 (1975) 297-319, [doi:10.1007/BF00126993](https://doi.org/10.1007/BF00126993).
/// Plane: D. A. Spence, *Proc. Camb. Phil. Soc.* 73 (1973) 249-268. See also Johnson (1985), section 5.4.
///
/// ```
/// use stickslip::{ElasticPair, Material, analytical::SpencePressing};
/// let cork = ElasticPair::new(Material::new(1.0, 0.0)?, Material::rigid())?;
/// let pressed = SpencePressing::round(&cork, 0.25472)?;
/// assert!((pressed.stick_radius() - 0.5).abs() < 1e-4);
/// # Ok::<(), stickslip::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct SpencePressing {
    stick_radius: f64,
}

impl SpencePressing {
    /// Creates the solution for a body of revolution with the coefficient of friction `friction` (dimensionless).
    ///
    /// # Errors
    /// - [`Error::NegativeOrNotFinite`](crate::Error::NegativeOrNotFinite) if the coefficient is negative or not finite.
    pub fn round(pair: &ElasticPair, friction: f64) -> Result<Self> {
        Self::where_equal(pair, friction, |k, moduli| k.atanh() / k / moduli.prime)
    }

    /// Creates the solution for a cylinder or strip in plane strain with the coefficient of friction `friction`
    /// (dimensionless).
    ///
    /// # Errors
    /// - [`Error::NegativeOrNotFinite`](crate::Error::NegativeOrNotFinite) if the coefficient is negative or not finite.
    pub fn plane(pair: &ElasticPair, friction: f64) -> Result<Self> {
        Self::where_equal(pair, friction, |_, moduli| moduli.whole / moduli.prime)
    }

    /// Returns the ratio $`k`$ in `[0, 1]` of the radius or half-width of the stick zone to the radius or half-width of
    /// the contact. The ratio is one without coupling. With coupling it is zero without friction.
    #[must_use]
    pub fn stick_radius(&self) -> f64 {
        self.stick_radius
    }

    /// Solves for the k at which `function`, which increases with k, equals the coefficient of friction divided by |beta|.
    fn where_equal(
        pair: &ElasticPair,
        friction: f64,
        function: impl Fn(f64, Moduli) -> f64,
    ) -> Result<Self> {
        pair.check_closed_form()?;
        let ratio = non_negative("coefficient of friction", friction)? / pair.dundurs_beta().abs();
        if pair.dundurs_beta() == 0.0 || friction == 0.0 {
            let stick_radius = if friction == 0.0 && pair.dundurs_beta() != 0.0 {
                0.0
            } else {
                1.0
            };
            return Ok(Self { stick_radius });
        }
        let (mut low, mut high) = (0.0_f64, 1.0_f64);
        // The bisection ends when no floating-point number lies between the bounds.
        loop {
            let middle = 0.5 * (low + high);
            if middle <= low || middle >= high {
                return Ok(Self {
                    stick_radius: middle,
                });
            }
            if function(middle, Moduli::at(middle)) < ratio {
                low = middle;
            } else {
                high = middle;
            }
        }
    }
}

/// Complete elliptic integrals of modulus $`k`$.
struct Moduli {
    /// $`K(k)`$.
    whole: f64,
    /// $`K'(k)`$.
    prime: f64,
}

impl Moduli {
    fn at(k: f64) -> Self {
        let complement = ((1.0 - k) * (1.0 + k)).sqrt();
        Self {
            whole: Integrals::of_axis_ratio(complement).k,
            prime: Integrals::of_axis_ratio(k).k,
        }
    }
}
