//! Cylinders of different materials that roll freely on each other, in plane strain.

use super::line::HertzLine;
use crate::error::{Result, finite, non_negative};

/// Half-width of the middle strip that carries half the load of a [`HertzLine`], divided by the half-width of the contact.
/// It is the root of $`\arcsin t + t\sqrt{1-t^2} = \pi/4`$.
const MIDDLE: f64 = 0.403_972_753_299_517_2;

/// Cylinders of different materials that roll freely, without a tangential force and with little friction. The solution
/// is the limit $`\mu \ll |\beta|`$ of Bentall and Johnson's solution.
///
/// The pressure compresses the surfaces along x by different amounts, so that they slip. Let $`\beta`$ be
/// [`dundurs_beta`](crate::ElasticPair::dundurs_beta) and $`\xi`$ the creepage. If friction is too weak to prevent this slip, the
/// slip of body 1 over body 2 per rolled length is
///
/// ```math
/// s = \frac{2\beta}{E^*}\,p - \xi, \qquad q = -\mu p\,\operatorname{sign} s .
/// ```
///
/// The tangential force is zero if the slip reverses at the ends $`\pm ta`$ of the strip that carries half the load:
///
/// ```math
/// \arcsin t + t\sqrt{1-t^2} = \frac\pi4, \qquad t = 0.4040, \qquad
/// \xi = \sqrt{1-t^2}\,\frac{\beta a}{R} = 0.9148\,\frac{\beta a}{R}, \qquad
/// D = \frac{8t(1 - t^2/3) - 8/3}{\pi}\,\frac{\mu|\beta| P a}{R} = 0.1239\,\frac{\mu|\beta| P a}{R} .
/// ```
///
/// The leading edge is at +x. If it is at -x, creepage and slip change their signs. A positive creepage moves body 2 along
/// +x over body 1, as in [`rolling`](crate::rolling). The solution neglects the influence of the traction on the pressure
/// (Goodman's assumption) and the narrow stick strips around the reversals of slip. The creepage of the [numerical
/// solution](crate::rolling::RollingProblem) is smaller by 0.3 % at $`\mu = 0.009\,|\beta|`$, by 5 % at $`0.085\,|\beta|`$,
/// and by 28 % at $`0.86\,|\beta|`$.
///
/// R. H. Bentall and K. L. Johnson, Int. J. Mech. Sci. 9 (1967) 389-404,
/// <https://doi.org/10.1016/0020-7403(67)90043-4>; Johnson (1985), section 8.2.
///
/// ```
/// use stickslip::{ElasticPair, Material, analytical::{BentallJohnson, HertzLine}};
/// // Rollers of aluminium and steel, in mm, N and MPa.
/// let pair = ElasticPair::new(Material::new(70e3, 0.33)?, Material::new(210e3, 0.3)?)?;
/// let hertz = HertzLine::new(&pair, 10.0, 100.0)?;
/// let free = BentallJohnson::new(hertz, 0.01)?;
/// let unit = pair.dundurs_beta() * hertz.half_width() / 10.0;
/// assert!((free.creepage() / unit - 0.9148).abs() < 1e-4);
/// // Friction holds the middle back, which slips forward, and drags the sides along.
/// assert!(free.slip(0.0) > 0.0 && free.traction(0.0) < 0.0);
/// assert!(free.slip(0.1) < 0.0 && free.traction(0.1) > 0.0);
/// # Ok::<(), stickslip::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct BentallJohnson {
    hertz: HertzLine,
    friction: f64,
    creepage: f64,
}

impl BentallJohnson {
    /// Creates the contact `hertz` with the coefficient of friction `friction`. The bodies do not slip if their
    /// [`dundurs_beta`](crate::ElasticPair::dundurs_beta) is zero.
    ///
    /// # Errors
    /// - [`Error::NegativeOrNotFinite`](crate::Error::NegativeOrNotFinite) if the coefficient of friction is negative or not
    ///   finite.
    /// - [`Error::NotFinite`](crate::Error::NotFinite) if the friction limit, the creepage or the dissipation is not
    ///   finite.
    pub fn new(hertz: HertzLine, friction: f64) -> Result<Self> {
        non_negative("coefficient of friction", friction)?;
        finite("friction limit", friction * hertz.max_pressure())?;
        let mut free = Self {
            hertz,
            friction,
            creepage: 0.0,
        };
        free.creepage = finite("creepage", free.stretch(free.reversal()))?;
        finite("dissipation", free.dissipation())?;
        Ok(free)
    }

    /// Returns the creepage $`\xi`$ (dimensionless), with the sign of $`\beta`$.
    #[must_use]
    pub fn creepage(&self) -> f64 {
        self.creepage
    }

    /// Returns the half-width of the middle strip (a length), at whose ends the slip reverses: $`0.4040\,a`$.
    #[must_use]
    pub fn reversal(&self) -> f64 {
        MIDDLE * self.hertz.half_width()
    }

    /// Returns the slip s of body 1 over body 2 at `x` per rolled length (dimensionless). It is zero outside the contact.
    #[must_use]
    pub fn slip(&self, x: f64) -> f64 {
        if x.abs() < self.hertz.half_width() {
            self.stretch(x) - self.creepage
        } else {
            0.0
        }
    }

    /// Returns the traction q on body 1 along x (a pressure) at `x`. Its magnitude is $`\mu p`$ and its sign is opposite to
    /// the slip. It is zero outside the contact.
    #[must_use]
    pub fn traction(&self, x: f64) -> f64 {
        let slip = self.slip(x);
        if slip == 0.0 {
            0.0
        } else {
            -slip.signum() * self.friction * self.hertz.pressure(x)
        }
    }

    /// Returns the energy D that slip dissipates per rolled length (a force per length): the work needed to keep the
    /// cylinders rolling.
    #[must_use]
    pub fn dissipation(&self) -> f64 {
        let sum = MIDDLE * (1.0 - MIDDLE * MIDDLE / 3.0) - 1.0 / 3.0;
        let limit = self.friction * self.hertz.max_pressure() * self.hertz.half_width();
        4.0 * sum * limit * self.stretch(0.0).abs()
    }

    /// Returns $`2\beta p/E^*`$, the strain by which the pressure shortens body 1 more than body 2.
    fn stretch(&self, x: f64) -> f64 {
        let pair = self.hertz.pair();
        2.0 * pair.dundurs_beta() * (self.hertz.pressure(x) / pair.contact_modulus())
    }
}
