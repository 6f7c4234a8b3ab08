//! Frictionless contact of paraboloids.

use std::f64::consts::PI;

use super::elliptic::Integrals;
use super::sines::sine_minus_arc_cosine;
use crate::bodies::material::ElasticPair;
use crate::error::{Result, positive};

/// A sphere pressed on a half-space, or a paraboloid of revolution.
///
/// For two spheres $`1/R = 1/R_1 + 1/R_2`$. The initial gap is $`r^2/2R`$ and
///
/// ```math
/// a^3 = \frac{3WR}{4E^*}, \qquad p_0 = \frac{3W}{2\pi a^2}, \qquad \delta = \frac{a^2}{R}
/// ```
///
/// The solution is exact for a paraboloid and elastic half-spaces. For a sphere it is valid if $`a \ll R`$. See
/// equation 29 of the paper; Johnson (1985), 4.22-4.24.
///
/// ```
/// use stickslip::{ElasticPair, Material, analytical::HertzSphere};
/// // Table 2 of the paper: a steel ball of radius 3.5 mm under 100 N, in mm, N and MPa.
/// let steel = Material::new(213e3, 0.29)?;
/// let ball = HertzSphere::new(&ElasticPair::new(steel, steel)?, 3.5, 100.0)?;
/// assert!((ball.contact_radius() - 0.1311825).abs() < 1e-7);
/// assert!((ball.max_pressure() - 2774.53).abs() < 0.01);
/// assert!((ball.approach() - 4.916814e-3).abs() < 1e-9);
/// # Ok::<(), stickslip::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct HertzSphere {
    pair: ElasticPair,
    radius: f64,
    load: f64,
    contact_radius: f64,
    max_pressure: f64,
    approach: f64,
}

impl HertzSphere {
    /// Creates the contact of a sphere of radius `radius` (a length) under the normal load `load` (a force).
    ///
    /// # Errors
    /// - [`Error::NotPositive`](crate::Error::NotPositive) if the radius, the load or a result is not positive and
    ///   finite.
    /// - [`Error::UnsupportedForCoatings`](crate::Error::UnsupportedForCoatings) if a body is coated.
    pub fn new(pair: &ElasticPair, radius: f64, load: f64) -> Result<Self> {
        pair.check_closed_form()?;
        positive("radius", radius)?;
        positive("load", load)?;
        let a = (0.75 * (load / pair.contact_modulus()) * radius).cbrt();
        Ok(Self {
            pair: *pair,
            radius,
            load,
            contact_radius: positive("contact radius", a)?,
            max_pressure: positive("maximum pressure", 1.5 * load / PI / a / a)?,
            approach: positive("approach", a * (a / radius))?,
        })
    }

    /// Returns the bodies.
    #[must_use]
    pub fn pair(&self) -> &ElasticPair {
        &self.pair
    }

    /// Returns the radius of the sphere $`R`$ (a length).
    #[must_use]
    pub fn radius(&self) -> f64 {
        self.radius
    }

    /// Returns the normal load $`W`$ (a force), positive in compression.
    #[must_use]
    pub fn load(&self) -> f64 {
        self.load
    }

    /// Returns the radius of the contact circle $`a = (3WR/4E^*)^{1/3}`$ (a length). Johnson (1985), 4.22.
    #[must_use]
    pub fn contact_radius(&self) -> f64 {
        self.contact_radius
    }

    /// Returns the area of the contact circle $`\pi a^2`$ (a length squared).
    #[must_use]
    pub fn contact_area(&self) -> f64 {
        PI * self.contact_radius * self.contact_radius
    }

    /// Returns the pressure at the centre $`p_0 = 3W/2\pi a^2`$. Johnson (1985), 4.24.
    #[must_use]
    pub fn max_pressure(&self) -> f64 {
        self.max_pressure
    }

    /// Returns the mean pressure over the contact circle $`W/\pi a^2 = \tfrac23 p_0`$.
    #[must_use]
    pub fn mean_pressure(&self) -> f64 {
        self.max_pressure * (2.0 / 3.0)
    }

    /// Returns the approach of the bodies $`\delta = a^2/R`$ (a length), positive. Johnson (1985), 4.23.
    #[must_use]
    pub fn approach(&self) -> f64 {
        self.approach
    }

    /// Returns the pressure $`p = p_0\sqrt{1-r^2/a^2}`$ at the distance $`r`$ from the centre. It is zero outside the
    /// contact. Johnson (1985), 3.39.
    #[must_use]
    pub fn pressure(&self, r: f64) -> f64 {
        self.max_pressure * dome(r.abs() / self.contact_radius)
    }

    /// Returns the normal displacement of the surfaces (a length) at the distance $`r`$ from the centre, inside and
    /// outside the contact. It is the sum over the bodies, positive into each body.
    ///
    /// ```math
    /// u_z = \frac{\pi p_0}{4aE^*}(2a^2-r^2) \quad (r \le a), \qquad
    /// u_z = \frac{p_0}{2aE^*}\left[(2a^2-r^2)\,\sigma + r^2\sin\sigma\cos\sigma\right] \quad (r > a)
    /// ```
    ///
    /// with $`\sin\sigma = a/r`$. Johnson (1985), 3.41a and 3.42a.
    #[must_use]
    pub fn displacement(&self, r: f64) -> f64 {
        let rho = r.abs() / self.contact_radius;
        if rho > 1.0 {
            self.approach * outer_sag(rho, arc_sine(1.0, rho))
        } else {
            self.approach * (1.0 - 0.5 * rho * rho)
        }
    }

    /// Returns the gap $`g = u_z + r^2/2R - \delta`$ between the surfaces (a length) at the distance $`r`$ from the
    /// centre. It is zero in the contact and positive outside.
    ///
    /// The gap is evaluated as $`\frac{\delta}{2\pi}\frac{r^2}{a^2}(\sin 2\varphi - 2\varphi\cos 2\varphi)`$ with
    /// $`\cos\varphi = a/r`$, which avoids cancellation. Johnson (1985), 3.42a.
    #[must_use]
    pub fn gap(&self, r: f64) -> f64 {
        let rho = r.abs() / self.contact_radius;
        if rho > 1.0 {
            self.approach * outer_sag(rho, arc_cosine(1.0, rho))
        } else {
            0.0
        }
    }
}

/// A paraboloid with two different curvatures pressed on a half-space.
///
/// The initial gap is $`x^2/2R_x + y^2/2R_y`$. The longer radius is $`R'`$ and the shorter radius is $`R''`$. The
/// semi-axes are $`a \ge b`$, and $`a`$ lies along the longer radius. With $`m = 1-b^2/a^2`$ and the complete elliptic
/// integrals $`K(m)`$, $`E(m)`$, $`D = (K-E)/m`$:
///
/// ```math
/// \frac{R''}{R'} = \frac{b^2}{a^2}\,\frac{D}{K-D}, \qquad a^3 = \frac{3WR'D}{\pi E^*}, \qquad
/// p_0 = \frac{3W}{2\pi ab}, \qquad \delta = \frac{p_0 b K}{E^*}
/// ```
///
/// These formulas, written with $`D`$, are also valid for the circle, where $`K = \pi/2`$ and $`D = \pi/4`$. Johnson
/// (1985), 4.26-4.32.
///
/// ```
/// use stickslip::{ElasticPair, Material, analytical::{HertzEllipse, HertzSphere}};
/// let steel = Material::new(213e3, 0.29)?;
/// let pair = ElasticPair::new(steel, steel)?;
/// // Table 2 of the paper, in mm, N and MPa. Equal radii make a ball.
/// let ball = HertzEllipse::new(&pair, 3.5, 3.5, 100.0)?;
/// assert!((ball.semi_axes()[0] - 0.1311825).abs() < 1e-7);
/// assert!((ball.max_pressure() - 2774.53).abs() < 0.01);
/// assert!((ball.approach() - 4.916814e-3).abs() < 1e-9);
/// // The contact is longer along the flatter direction.
/// let barrel = HertzEllipse::new(&pair, 7.0, 3.5, 100.0)?;
/// let [along_x, along_y] = barrel.semi_axes();
/// assert!(along_x > 1.5 * along_y);
/// # Ok::<(), stickslip::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct HertzEllipse {
    pair: ElasticPair,
    radii: [f64; 2],
    load: f64,
    semi_axes: [f64; 2],
    max_pressure: f64,
    approach: f64,
}

impl HertzEllipse {
    /// Creates the contact of a paraboloid with the radii of curvature `radius_x` and `radius_y` (lengths) under the
    /// normal load `load` (a force).
    ///
    /// # Errors
    /// - [`Error::NotPositive`](crate::Error::NotPositive) if a radius, the load or a result is not positive and
    ///   finite.
    /// - [`Error::UnsupportedForCoatings`](crate::Error::UnsupportedForCoatings) if a body is coated.
    pub fn new(pair: &ElasticPair, radius_x: f64, radius_y: f64, load: f64) -> Result<Self> {
        pair.check_closed_form()?;
        positive("radius along x", radius_x)?;
        positive("radius along y", radius_y)?;
        positive("load", load)?;
        let long_radius = radius_x.max(radius_y);
        let radius_ratio = radius_x.min(radius_y) / long_radius;
        let (kappa, integrals) = axis_ratio(positive("ratio of the radii", radius_ratio)?);
        let compressed = load / pair.contact_modulus();
        let a = (3.0 / PI * integrals.d * compressed * long_radius).cbrt();
        let b = kappa * a;
        positive("longer semi-axis", a)?;
        positive("shorter semi-axis", b)?;
        Ok(Self {
            pair: *pair,
            radii: [radius_x, radius_y],
            load,
            semi_axes: if radius_x >= radius_y { [a, b] } else { [b, a] },
            max_pressure: positive("maximum pressure", 1.5 * load / PI / a / b)?,
            approach: positive("approach", 1.5 / PI * integrals.k * (compressed / a))?,
        })
    }

    /// Returns the bodies.
    #[must_use]
    pub fn pair(&self) -> &ElasticPair {
        &self.pair
    }

    /// Returns the radii of curvature $`[R_x, R_y]`$ (lengths).
    #[must_use]
    pub fn radii(&self) -> [f64; 2] {
        self.radii
    }

    /// Returns the normal load $`W`$ (a force), positive in compression.
    #[must_use]
    pub fn load(&self) -> f64 {
        self.load
    }

    /// Returns the semi-axes of the contact ellipse (lengths), along x and along y. Johnson (1985), 4.28-4.31.
    #[doc(alias = "eccentricity")]
    #[doc(alias = "ellipticity")]
    #[must_use]
    pub fn semi_axes(&self) -> [f64; 2] {
        self.semi_axes
    }

    /// Returns the area of the contact ellipse $`\pi ab`$ (a length squared).
    #[must_use]
    pub fn contact_area(&self) -> f64 {
        PI * self.semi_axes[0] * self.semi_axes[1]
    }

    /// Returns the pressure at the centre $`p_0 = 3W/2\pi ab`$. Johnson (1985), 4.27.
    #[must_use]
    pub fn max_pressure(&self) -> f64 {
        self.max_pressure
    }

    /// Returns the approach of the bodies $`\delta = p_0 b K/E^*`$ (a length), positive. Johnson (1985), 4.26c.
    #[must_use]
    pub fn approach(&self) -> f64 {
        self.approach
    }

    /// Returns the pressure $`p = p_0\sqrt{1-x^2/a_x^2-y^2/a_y^2}`$. It is zero outside the contact. Johnson (1985),
    /// 3.58.
    #[must_use]
    pub fn pressure(&self, x: f64, y: f64) -> f64 {
        self.max_pressure * dome(self.relative_radius(x, y))
    }

    /// Returns the relative distance from the centre, which is 1 on the edge of the contact.
    pub(super) fn relative_radius(&self, x: f64, y: f64) -> f64 {
        (x / self.semi_axes[0]).hypot(y / self.semi_axes[1])
    }
}

/// Computes the axis ratio $`b/a`$ of the contact for the ratio of radii $`R''/R' \le 1`$, and the elliptic integrals
/// for this axis ratio.
fn axis_ratio(radius_ratio: f64) -> (f64, Integrals) {
    // Locally R''/R' = kappa^s, with an exponent s that grows from 3/2 for the circle to 2 for a line. A step with the
    // exponent 7/4 leaves at most 1/6 of the error in ln(kappa), and 24 steps reduce the error to round-off.
    let mut kappa = radius_ratio.powf(4.0 / 7.0);
    let mut integrals = Integrals::of_axis_ratio(kappa);
    for _ in 0..24 {
        // Divide the prescribed ratio R''/R' by the ratio of the iterate. The square of kappa alone could underflow.
        let miss = radius_ratio / kappa / kappa * (integrals.k - integrals.d) / integrals.d;
        kappa = (kappa * miss.powf(4.0 / 7.0)).min(1.0);
        integrals = Integrals::of_axis_ratio(kappa);
    }
    (kappa, integrals)
}

/// Returns $`\sqrt{1-\rho^2}`$ for $`\rho < 1`$, otherwise zero.
pub(super) fn dome(rho: f64) -> f64 {
    if rho < 1.0 {
        ((1.0 - rho) * (1.0 + rho)).sqrt()
    } else {
        0.0
    }
}

/// Returns $`\arcsin(b/r)`$ for $`r \ge b > 0`$, accurate to round-off near $`r = b`$.
pub(super) fn arc_sine(b: f64, r: f64) -> f64 {
    b.atan2(((r - b) * (r + b)).sqrt())
}

/// Returns $`\arccos(b/r)`$ for $`r \ge b`$, $`r > 0`$, accurate to round-off near $`r = b`$.
pub(super) fn arc_cosine(b: f64, r: f64) -> f64 {
    ((r - b) * (r + b)).sqrt().atan2(b)
}

/// Returns $`\frac{\rho^2}{2\pi}(\sin 2\alpha - 2\alpha\cos 2\alpha)`$, in units of the approach. It is the
/// displacement outside the contact for $`\alpha = \arcsin(1/\rho)`$, and the gap for $`\alpha = \arccos(1/\rho)`$.
fn outer_sag(rho: f64, angle: f64) -> f64 {
    rho * rho * sine_minus_arc_cosine(2.0 * angle) / (2.0 * PI)
}
