//! A cylinder that rolls on a plane with creepage, in plane strain.

use super::hertz::dome;
use super::line::HertzLine;
use crate::error::{Error, Result, finite, non_negative};

/// A cylinder that rolls steadily with longitudinal creepage, in plane strain: Carter's solution.
///
/// The leading edge is at x = a. A strip of half-width c that ends at this edge sticks. The rest of the contact
/// slips, opposite to the traction:
///
/// ```math
/// \frac ca = 1 - \frac{|\xi|}{\xi_s}, \qquad \xi_s = \frac{2\mu p_0}{E^*} = \frac{\mu a}{R}, \qquad
/// q = \pm\mu p_0\left[\sqrt{1-\frac{x^2}{a^2}} - \frac ca\sqrt{1-\frac{(x-a+c)^2}{c^2}}\,H(c-|x-a+c|)\right], \qquad
/// Q = \pm\mu P\left(1 - \frac{c^2}{a^2}\right)
/// ```
///
/// with the sign of the creepage $`\xi`$. The whole contact slips if $`|\xi| \ge \xi_s`$. The bodies must be equal or
/// have a [`dundurs_beta`](crate::ElasticPair::dundurs_beta) of zero. F. W. Carter, Proc. R. Soc. A 112 (1926) 151,
/// <https://doi.org/10.1098/rspa.1926.0100>; Johnson (1985), section 8.3.
///
/// ```
/// use stickslip::{ElasticPair, Material, analytical::{Carter, HertzLine}};
/// let steel = Material::new(210e3, 0.3)?;
/// let hertz = HertzLine::new(&ElasticPair::new(steel, steel)?, 10.0, 100.0)?;
/// let slides_at = Carter::new(hertz, 0.3, 0.0)?.sliding_creepage();
/// assert!((slides_at / (0.3 * hertz.half_width() / 10.0) - 1.0).abs() < 1e-12);
/// let carter = Carter::new(hertz, 0.3, 0.4 * slides_at)?;
/// assert!((carter.force() / 30.0 - 0.64).abs() < 1e-12);
/// # Ok::<(), stickslip::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Carter {
    hertz: HertzLine,
    friction: f64,
    creepage: f64,
}

impl Carter {
    /// Creates the contact `hertz` with the coefficient of friction `friction` and the creepage `creepage`
    /// (dimensionless, of either sign).
    ///
    /// # Errors
    /// - [`Error::NegativeOrNotFinite`] if the coefficient of friction is negative or not finite.
    /// - [`Error::NotFinite`] if the creepage or the sliding creepage is not finite.
    /// - [`Error::CoupledMaterials`] if the [`dundurs_beta`](crate::ElasticPair::dundurs_beta) of the bodies is not
    ///   zero.
    pub fn new(hertz: HertzLine, friction: f64, creepage: f64) -> Result<Self> {
        non_negative("coefficient of friction", friction)?;
        finite("creepage", creepage)?;
        if hertz.pair().is_coupled() {
            let beta = hertz.pair().dundurs_beta();
            return Err(Error::CoupledMaterials { beta });
        }
        let carter = Self {
            hertz,
            friction,
            creepage,
        };
        finite("creepage at full sliding", carter.sliding_creepage())?;
        Ok(carter)
    }

    /// Returns the smallest magnitude of the creepage at which the whole contact slips (dimensionless).
    #[must_use]
    pub fn sliding_creepage(&self) -> f64 {
        2.0 * self.friction * self.hertz.max_pressure() / self.hertz.pair().contact_modulus()
    }

    /// Returns the half-width c of the stick strip at the leading edge (a length).
    #[must_use]
    pub fn stick_half_width(&self) -> f64 {
        let (creepage, limit) = (self.creepage.abs(), self.sliding_creepage());
        if creepage < limit {
            self.hertz.half_width() * (limit - creepage) / limit
        } else {
            0.0
        }
    }

    /// Returns the tangential force Q on body 1 (a force per length), with the sign of the creepage.
    #[must_use]
    pub fn force(&self) -> f64 {
        let ratio = self.stick_half_width() / self.hertz.half_width();
        let part = (1.0 - ratio) * (1.0 + ratio);
        self.direction() * self.friction * self.hertz.load() * part
    }

    /// Returns the traction q on body 1 along x (a pressure) at `x`. It is zero outside the contact.
    #[must_use]
    pub fn traction(&self, x: f64) -> f64 {
        let (a, c) = (self.hertz.half_width(), self.stick_half_width());
        let inner = if c > 0.0 {
            c / a * dome((x - a + c).abs() / c)
        } else {
            0.0
        };
        let limit = self.friction * self.hertz.max_pressure();
        self.direction() * limit * (dome(x.abs() / a) - inner)
    }

    fn direction(&self) -> f64 {
        if self.creepage == 0.0 {
            0.0
        } else {
            self.creepage.signum()
        }
    }
}
