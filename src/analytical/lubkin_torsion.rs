//! Partial slip of a sphere in torsion.

use std::f64::consts::{FRAC_2_PI, PI};

use super::elliptic::Integrals;
use super::hertz::{HertzSphere, dome};
use super::quadrature::integral;
use crate::error::{Result, finite, positive};

/// A sphere in torsion. Under a constant normal load, a twist about the normal increases monotonically.
///
/// A disc of radius $`c`$ sticks and rotates rigidly, and the ring around it slips. The complete elliptic integrals
/// $`K`$ and $`E`$ have the parameter $`m = 1-c^2/a^2`$, and the integral $`E(s)`$ has the parameter $`m = 1-s^2/a^2`$.
/// The rotation of one body relative to the other is $`\beta`$:
///
/// ```math
/// \beta = \frac{\mu p_0}{2G}(K-E), \qquad
/// M = \frac83\mu p_0\int_c^a s^2\,E(s)\,ds, \qquad
/// q = \frac2\pi\mu p_0\,r\int_c^a \frac{E(s)\,ds}{s\sqrt{s^2-r^2}} \quad (r < c)
/// ```
///
/// The traction is circumferential and equals $`\mu p`$ in the ring. The centre sticks at any twist. For large twists
/// the moment tends to $`\frac{3\pi}{16}\mu Wa`$. The theory assumes small rotations. The twist is not checked for
/// this, and a twist in degrees gives almost the moment of sliding. Slip is parallel to the traction, so no component of slip is
/// neglected for any $`\nu`$. Lubkin (1951); Johnson (1985), section 7.2.
///
/// ```
/// use stickslip::{ElasticPair, Material, analytical::{HertzSphere, LubkinTorsion}};
/// // Table 2 of the paper, in mm, N and MPa.
/// let steel = Material::new(213e3, 0.29)?;
/// let pair = ElasticPair::new(steel, steel)?;
/// let ball = HertzSphere::new(&pair, 3.5, 100.0)?;
/// let torsion = LubkinTorsion::new(ball, 0.5, 0.01)?;
/// let (a, c) = (ball.contact_radius(), torsion.stick_radius());
/// assert!(c < a && torsion.moment() < torsion.sliding_moment());
/// // A small twist causes hardly any slip: M = (16/3) G a^3 beta.
/// let small = LubkinTorsion::new(ball, 0.5, 1e-9)?;
/// let stick = 16.0 / 3.0 * pair.equivalent_shear_modulus() * a.powi(3) * 1e-9;
/// assert!((small.moment() / stick - 1.0).abs() < 1e-6);
/// # Ok::<(), stickslip::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct LubkinTorsion {
    hertz: HertzSphere,
    friction: f64,
    twist: f64,
    /// $`\ln(c/a)`$.
    log_stick: f64,
    moment: f64,
}

impl LubkinTorsion {
    /// Creates the contact `hertz` with the coefficient of friction `friction`, twisted by the angle `twist` (radians,
    /// of either sign). The twist is the rotation of body 2 relative to body 1 about the normal, far from the contact,
    /// positive from x to y. The coupling between pressure and traction of dissimilar bodies is neglected.
    ///
    /// # Errors
    /// - [`Error::NotPositive`](crate::Error::NotPositive) if the coefficient of friction is not positive and finite,
    ///   or if the twist reduces the stick radius to zero.
    /// - [`Error::NotFinite`](crate::Error::NotFinite) if the twist or a result is not finite.
    pub fn new(hertz: HertzSphere, friction: f64, twist: f64) -> Result<Self> {
        positive("coefficient of friction", friction)?;
        finite("twist", twist)?;
        let limit = positive("friction limit", friction * hertz.max_pressure())?;
        let strain = 2.0 * hertz.pair().equivalent_shear_modulus() / limit * twist.abs();
        let a = hertz.contact_radius();
        // This product is a lower bound of the stick radius, because E is at least one.
        positive("stick radius", a * (-strain).exp())?;
        let log_stick = log_stick_ratio(strain);
        let sum = integral(-log_stick, |x| {
            let s = (-x).exp();
            s * s * s * second_kind(s)
        });
        let moment = twist.signum() * (8.0 / 3.0) * limit * a * a * a * sum;
        Ok(Self {
            hertz,
            friction,
            twist,
            log_stick,
            moment: finite("moment", moment)?,
        })
    }

    /// Returns the normal contact.
    #[must_use]
    pub fn hertz(&self) -> HertzSphere {
        self.hertz
    }

    /// Returns the twist $`\beta`$ (an angle): the rigid rotation of body 2 relative to body 1, positive from x to y.
    #[must_use]
    pub fn twist(&self) -> f64 {
        self.twist
    }

    /// Returns the radius of the stick disc $`c`$ (a length), positive. The formula is given on the [type](Self);
    /// Lubkin (1951).
    #[must_use]
    pub fn stick_radius(&self) -> f64 {
        self.hertz.contact_radius() * self.log_stick.exp()
    }

    /// Returns the fraction of the contact area that sticks, $`c^2/a^2`$.
    #[must_use]
    pub fn stick_ratio(&self) -> f64 {
        (2.0 * self.log_stick).exp()
    }

    /// Returns the moment $`M`$ about the normal on body 1 (a force times a length), with the sign of the twist. For
    /// small twists the moment is $`\frac{16}{3}Ga^3\beta`$. The formula is given on the [type](Self); Lubkin (1951).
    #[must_use]
    pub fn moment(&self) -> f64 {
        self.moment
    }

    /// Returns the moment at which the whole contact slides, $`\frac{3\pi}{16}\mu Wa`$ (a force times a length,
    /// positive): the limit of the [`moment`](Self::moment) for large twists.
    #[must_use]
    pub fn sliding_moment(&self) -> f64 {
        3.0 * PI / 16.0 * self.friction * self.hertz.load() * self.hertz.contact_radius()
    }

    /// Returns the traction $`q`$ on body 1 at the distance $`r`$ from the centre (a pressure, with the sign of the
    /// twist). The traction acts along the circle of radius $`r`$, from x to y: $`q_x = -qy/r`$, $`q_y = qx/r`$. The
    /// traction is zero outside the contact. The formula is given on the [type](Self); Lubkin (1951).
    ///
    /// The integral is evaluated with the substitution $`s = c\cosh x + \sqrt{c^2-r^2}\sinh x`$, which
    /// removes the root from the integrand.
    #[must_use]
    pub fn traction(&self, r: f64) -> f64 {
        let rho = r.abs() / self.hertz.contact_radius();
        let scale = self.twist.signum() * self.friction;
        let stick = self.log_stick.exp();
        if rho >= stick {
            return scale * self.hertz.pressure(r);
        }
        let root = ((stick - rho) * (stick + rho)).sqrt();
        // The integral ends at the value of x for s = a.
        let end = (ring(self.log_stick) / (stick * dome(rho) + root)).asinh();
        let sum = integral(end, |x| {
            let s = stick * x.cosh() + root * x.sinh();
            second_kind(s.min(1.0)) / s
        });
        scale * self.hertz.max_pressure() * FRAC_2_PI * rho * sum
    }
}

/// Computes $`\ln(c/a)`$ for which $`K-E`$ equals `strain`.
fn log_stick_ratio(strain: f64) -> f64 {
    // The derivative of K - E with respect to ln(c/a) is -E, which lies between -pi/2 and -1 and increases. After the
    // first step Newton's method therefore approaches the root from one side.
    let mut log_stick = 0.0_f64;
    for _ in 0..60 {
        let Integrals { k, d } = Integrals::of_axis_ratio(log_stick.exp());
        let m = ring(log_stick);
        let step = (m * d - strain) / (k - m * d);
        log_stick = (log_stick + step).min(0.0);
        if step.abs() <= 2.0 * f64::EPSILON * log_stick.abs() {
            break;
        }
    }
    log_stick
}

/// Returns $`m = 1-c^2/a^2`$, accurate to round-off for small twists.
fn ring(log_stick: f64) -> f64 {
    -(2.0 * log_stick).exp_m1()
}

/// Returns $`E`$ for the parameter $`1-s^2`$, with $`0 < s \le 1`$.
fn second_kind(s: f64) -> f64 {
    let Integrals { k, d } = Integrals::of_axis_ratio(s);
    k - (1.0 - s) * (1.0 + s) * d
}
