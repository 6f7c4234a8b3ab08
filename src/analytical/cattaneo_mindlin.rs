//! Partial slip of a paraboloid under a monotonically increasing tangential force.

use std::f64::consts::PI;

use super::elliptic::Integrals;
use super::hertz::{HertzEllipse, HertzSphere, arc_cosine, arc_sine};
use super::partial_slip::PartialSlip;
use super::sines::{arc_minus_sine, sine_minus_arc_cosine};
use crate::error::{Result, finite};

/// A sphere in partial slip. Under a constant normal load, a tangential force along x increases monotonically.
///
/// With $`f = |F|/\mu W`$, a disc of radius $`c`$ sticks. The ring around the disc slips, opposite to the traction:
///
/// ```math
/// \frac ca = (1-f)^{1/3}, \qquad
/// q = \mu p_0\left[\sqrt{1-\frac{r^2}{a^2}} - \frac ca\sqrt{1-\frac{r^2}{c^2}}\,H(c-r)\right],
/// \qquad \delta_x = \frac{3\mu W}{16a}\,\frac{2-\nu}{G}\left[1-(1-f)^{2/3}\right]
/// ```
///
/// A negative force reverses the signs of traction, displacement and slip. The solution belongs to the scalar model, with
/// traction along x only. It is valid for every $`\nu`$. If lateral traction is allowed, the solution is exact for $`\nu = 0`$.
/// See equations 27-31 of the paper; Cattaneo (1938); Mindlin (1949); Johnson (1985), 7.41-7.44.
///
/// ```
/// use stickslip::{ElasticPair, Material, analytical::{CattaneoMindlin, HertzSphere}};
/// // Table 2 of the paper, in mm, N and MPa.
/// let steel = Material::new(213e3, 0.29)?;
/// let pair = ElasticPair::new(steel, steel)?;
/// let ball = HertzSphere::new(&pair, 3.5, 100.0)?;
/// let shear = CattaneoMindlin::new(ball, 0.5, 20.0)?;
/// assert!((shear.stick_radius() / ball.contact_radius() - 0.84343).abs() < 1e-5);
/// assert!((shear.shift() - 0.8544566e-3).abs() < 1e-10);
/// // There is no slip inside the stick disc; outside it, slip opposes the traction.
/// assert!((shear.displacement(0.05, 0.02) - shear.shift()).abs() < 1e-15);
/// assert!(shear.slip(0.12, 0.0) < 0.0 && shear.traction(0.12) > 0.0);
/// # Ok::<(), stickslip::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct CattaneoMindlin {
    hertz: HertzSphere,
    poisson_ratio: f64,
    slip: PartialSlip,
    gross_shift: f64,
}

impl CattaneoMindlin {
    /// Creates the solution for the contact `hertz` with the coefficient of friction `friction`. The tangential force `force` acts
    /// on body 1 along x (a force, of either sign).
    ///
    /// A force equal to $`\mu W`$ to within rounding counts as the onset of gross sliding: the stick radius is zero.
    /// Without friction the stick radius is also zero. The coupling between pressure and traction of dissimilar bodies
    /// is neglected.
    ///
    /// # Errors
    /// - [`Error::NegativeOrNotFinite`](crate::Error::NegativeOrNotFinite) if the coefficient of friction is negative or not
    ///   finite.
    /// - [`Error::NotFinite`](crate::Error::NotFinite) if the force or a result is not finite.
    /// - [`Error::BeyondFrictionCapacity`](crate::Error::BeyondFrictionCapacity) if the force exceeds $`\mu W`$.
    pub fn new(hertz: HertzSphere, friction: f64, force: f64) -> Result<Self> {
        let slip = PartialSlip::new(hertz.load(), friction, force)?;
        let (pair, poisson_ratio) = (hertz.pair(), hertz.pair().equivalent_poisson_ratio());
        let compliance = (2.0 - poisson_ratio)
            / (8.0 * pair.equivalent_shear_modulus() * hertz.contact_radius());
        Ok(Self {
            hertz,
            poisson_ratio,
            slip,
            gross_shift: finite("shift at gross sliding", 1.5 * slip.held.limit * compliance)?,
        })
    }

    /// Returns the normal contact.
    #[must_use]
    pub fn hertz(&self) -> HertzSphere {
        self.hertz
    }

    /// Returns the tangential force $`F`$ on body 1, positive along +x.
    #[must_use]
    pub fn force(&self) -> f64 {
        self.slip.held.force
    }

    /// Returns the radius of the stick disc $`c = a(1-f)^{1/3}`$ (a length). See equation 27 of the paper.
    #[must_use]
    pub fn stick_radius(&self) -> f64 {
        self.slip.stick * self.hertz.contact_radius()
    }

    /// Returns the fraction of the contact area that sticks, $`c^2/a^2 = (1-f)^{2/3}`$. See equation 28 of the paper.
    #[must_use]
    pub fn stick_ratio(&self) -> f64 {
        self.slip.stick * self.slip.stick
    }

    /// Returns the shift $`\delta_x`$ (a length): the rigid motion of body 2 relative to body 1, with the sign of the force.
    ///
    /// ```math
    /// \delta_x = \frac{3\mu W}{8a}\left[\frac{(2-\nu_1)(1+\nu_1)}{E_1} +
    /// \frac{(2-\nu_2)(1+\nu_2)}{E_2}\right]\left[1-(1-f)^{2/3}\right]
    /// ```
    ///
    /// See equation 30 of the paper; Johnson (1985), 7.41-7.44.
    #[must_use]
    pub fn shift(&self) -> f64 {
        self.gross_shift * self.slip.shift_fraction()
    }

    /// Returns the shift $`\delta_0`$ at which the whole contact starts to slide (a length, positive): the [`shift`](Self::shift)
    /// under $`\mu W`$.
    #[must_use]
    pub fn sliding_shift(&self) -> f64 {
        self.gross_shift
    }

    /// Returns the traction $`q`$ on body 1 along x (a pressure, with the sign of the force) at the distance $`r`$ from the
    /// centre. It is zero outside the contact. See equation 31 of the paper.
    ///
    /// In the stick disc the traction is evaluated as $`\mu p_0 (a^2-c^2)/a\,(\sqrt{a^2-r^2}+\sqrt{c^2-r^2})^{-1}`$,
    /// which avoids cancellation.
    #[must_use]
    pub fn traction(&self, r: f64) -> f64 {
        let rho = r.abs() / self.hertz.contact_radius();
        self.slip.held.friction * self.hertz.max_pressure() * self.slip.traction_fraction(rho)
    }

    /// Returns the tangential displacement $`u_x = u_{x1}-u_{x2}`$ (a length, with the sign of the force), anywhere in the plane.
    ///
    /// Inside the contact the displacement is [`shift`](Self::shift) + [`slip`](Self::slip). Outside, the traction
    /// $`q_0\sqrt{1-r^2/a^2}`$ displaces the surface by
    ///
    /// ```math
    /// u_x = \frac{q_0}{8Ga}\left\{(2-\nu)\left[(2a^2-r^2)\sigma + r^2 w\right] +
    /// \frac\nu2\left[r^2\sigma + (2a^2-r^2)w\right]\cos 2\theta\right\}, \qquad
    /// \sin\sigma = \frac ar, \quad w = \sin\sigma\cos\sigma
    /// ```
    ///
    /// and $`u_x`$ is the difference of two such terms, of radii $`a`$ and $`c`$. Johnson (1985), section 3.7 and 7.41-7.44.
    #[must_use]
    pub fn displacement(&self, x: f64, y: f64) -> f64 {
        let (xi, eta, rho) = self.relative(x, y);
        if rho > 1.0 {
            let whole = self.bracket(xi, eta, arc_sine(1.0, rho), 1.0);
            let stick = self.bracket(xi, eta, arc_sine(self.slip.stick, rho), 1.0);
            self.slip.held.direction * self.gross_shift * (whole - stick) / PI
        } else {
            self.shift() + self.slip(x, y)
        }
    }

    /// Returns the slip $`s_x = u_x - \delta_x`$ (a length, opposite to the force) in the ring $`c < r \le a`$. It is zero
    /// elsewhere.
    ///
    /// With $`\cos\varphi = c/r`$,
    ///
    /// ```math
    /// s_x = -\frac{\mu p_0 r^2}{16Ga}\left\{(2-\nu)\left[\sin 2\varphi - 2\varphi\cos 2\varphi\right]
    /// - \frac\nu4\left[4\varphi - \sin 4\varphi\right]\cos 2\theta\right\}
    /// ```
    ///
    /// which is the displacement in the ring minus the shift, written without cancellation. Johnson (1985), 7.41-7.44.
    #[must_use]
    pub fn slip(&self, x: f64, y: f64) -> f64 {
        let (xi, eta, rho) = self.relative(x, y);
        if rho > self.slip.stick && rho <= 1.0 {
            let angle = arc_cosine(self.slip.stick, rho);
            -self.slip.held.direction * self.gross_shift * self.bracket(xi, eta, angle, -1.0) / PI
        } else {
            0.0
        }
    }

    /// Returns the energy dissipated in the first quarter of a cycle, while the force grows from zero to $`F`$ (a force times a
    /// length, not negative).
    ///
    /// ```math
    /// -\int q\,s_x\,dA = \frac{\mu W\delta_0}{5}\left(1-\frac ca\right)^3
    /// \left(1+3\frac ca+\frac{c^2}{a^2}\right)
    /// ```
    ///
    /// where $`\delta_0`$ is the shift at gross sliding. For small forces the energy is $`\mu W\delta_0 f^3/27`$.
    /// Johnson (1985), 7.55-7.57.
    #[must_use]
    pub fn energy_of_first_quarter(&self) -> f64 {
        self.slip.held.limit * self.gross_shift * self.slip.dissipated_fraction()
    }

    /// Returns the energy dissipated in a full cycle of the force between $`\pm F`$ after the first loading (a force times a
    /// length). It is four times the [energy of the first quarter](Self::energy_of_first_quarter). Johnson (1985), 7.57.
    #[must_use]
    pub fn energy_per_cycle(&self) -> f64 {
        4.0 * self.energy_of_first_quarter()
    }

    /// Returns the coordinates of the point and its distance from the centre, in contact radii.
    fn relative(&self, x: f64, y: f64) -> (f64, f64, f64) {
        let a = self.hertz.contact_radius();
        let (xi, eta) = (x / a, y / a);
        (xi, eta, xi.hypot(eta))
    }

    /// Returns the expression in braces in the displacement outside a loaded circle, divided by $`2-\nu`$, for an angle
    /// $`\alpha`$ instead of $`\sigma`$:
    /// $`\tfrac12\rho^2(\sin 2\alpha - 2\alpha\cos 2\alpha) \pm \frac{\nu}{8(2-\nu)}(4\alpha-\sin 4\alpha)\,\rho^2\cos 2\theta`$.
    fn bracket(&self, xi: f64, eta: f64, angle: f64, sign: f64) -> f64 {
        let mean = 0.5 * (xi * xi + eta * eta) * sine_minus_arc_cosine(2.0 * angle);
        let lobes = (xi - eta) * (xi + eta) * arc_minus_sine(4.0 * angle);
        mean + sign * self.poisson_ratio / (8.0 * (2.0 - self.poisson_ratio)) * lobes
    }
}

/// An elliptic paraboloid in partial slip. Under a constant normal load, a tangential force along x increases monotonically.
///
/// The stick ellipse is the contact ellipse scaled by $`(1-f)^{1/3}`$. With $`\rho^2 = x^2/a_x^2 + y^2/a_y^2`$ and
/// $`\lambda = (1-f)^{1/3}`$
///
/// ```math
/// q = \mu p_0\left[\sqrt{1-\rho^2} - \sqrt{\lambda^2-\rho^2}\,H(\lambda-\rho)\right], \qquad
/// \delta_x = \frac{3\mu W}{2}\,\frac{(1-\nu)K+\nu N}{2\pi Ga}\left[1-\lambda^2\right]
/// ```
///
/// where $`a`$ is the longer semi-axis, and $`K`$ and $`D = (K-E)/m`$ are complete elliptic integrals of $`m = 1-b^2/a^2`$.
/// $`N = D`$ if the force is along the longer axis, and $`N = K-D`$ if it is along the shorter axis. The solution belongs to the
/// scalar model, with traction along x only. It is valid for every $`\nu`$. Mindlin (1949); Vermeulen and Johnson (1964).
///
/// ```
/// use stickslip::{ElasticPair, Material, analytical::{CattaneoMindlinEllipse, HertzEllipse}};
/// // Table 2 of the paper, in mm, N and MPa: equal radii make a ball.
/// let steel = Material::new(213e3, 0.29)?;
/// let pair = ElasticPair::new(steel, steel)?;
/// let ball = HertzEllipse::new(&pair, 3.5, 3.5, 100.0)?;
/// let shear = CattaneoMindlinEllipse::new(ball, 0.5, 20.0)?;
/// assert!((shear.stick_semi_axes()[0] - 0.84343 * 0.1311825).abs() < 1e-6);
/// assert!((shear.shift() - 0.8544566e-3).abs() < 1e-10);
/// # Ok::<(), stickslip::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct CattaneoMindlinEllipse {
    hertz: HertzEllipse,
    slip: PartialSlip,
    gross_shift: f64,
}

impl CattaneoMindlinEllipse {
    /// Creates the solution for the contact `hertz` with the coefficient of friction `friction`. The tangential force `force` acts
    /// on body 1 along x (a force, of either sign).
    ///
    /// A force equal to $`\mu W`$ to within rounding counts as the onset of gross sliding: the stick ellipse vanishes.
    /// Without friction the stick ellipse also vanishes. The coupling between pressure and traction of dissimilar
    /// bodies is neglected.
    ///
    /// # Errors
    /// - [`Error::NegativeOrNotFinite`](crate::Error::NegativeOrNotFinite) if the coefficient of friction is negative or not
    ///   finite.
    /// - [`Error::NotFinite`](crate::Error::NotFinite) if the force or a result is not finite.
    /// - [`Error::BeyondFrictionCapacity`](crate::Error::BeyondFrictionCapacity) if the force exceeds $`\mu W`$.
    pub fn new(hertz: HertzEllipse, friction: f64, force: f64) -> Result<Self> {
        let slip = PartialSlip::new(hertz.load(), friction, force)?;
        let [along, across] = hertz.semi_axes();
        let long = along.max(across);
        let Integrals { k, d } = Integrals::of_axis_ratio(along.min(across) / long);
        let n = if along >= across { d } else { k - d };
        let (pair, nu) = (hertz.pair(), hertz.pair().equivalent_poisson_ratio());
        let compliance =
            ((1.0 - nu) * k + nu * n) / (2.0 * PI * pair.equivalent_shear_modulus() * long);
        Ok(Self {
            hertz,
            slip,
            gross_shift: finite("shift at gross sliding", 1.5 * slip.held.limit * compliance)?,
        })
    }

    /// Returns the normal contact.
    #[must_use]
    pub fn hertz(&self) -> HertzEllipse {
        self.hertz
    }

    /// Returns the tangential force $`F`$ on body 1, positive along +x.
    #[must_use]
    pub fn force(&self) -> f64 {
        self.slip.held.force
    }

    /// Returns the semi-axes of the stick ellipse along x and along y (lengths): $`(1-f)^{1/3}`$ times the semi-axes of the
    /// contact. Vermeulen and Johnson (1964).
    #[must_use]
    pub fn stick_semi_axes(&self) -> [f64; 2] {
        self.hertz.semi_axes().map(|axis| self.slip.stick * axis)
    }

    /// Returns the fraction of the contact area that sticks, $`(1-f)^{2/3}`$. See equation 28 of the paper.
    #[must_use]
    pub fn stick_ratio(&self) -> f64 {
        self.slip.stick * self.slip.stick
    }

    /// Returns the shift $`\delta_x`$ (a length): the rigid motion of body 2 relative to body 1, with the sign of the force. The
    /// formula is given on the [type](Self); Mindlin (1949).
    #[must_use]
    pub fn shift(&self) -> f64 {
        self.gross_shift * self.slip.shift_fraction()
    }

    /// Returns the shift $`\delta_0`$ at which the whole contact starts to slide (a length, positive): the [`shift`](Self::shift)
    /// under $`\mu W`$.
    #[must_use]
    pub fn sliding_shift(&self) -> f64 {
        self.gross_shift
    }

    /// Returns the traction $`q`$ on body 1 along x (a pressure, with the sign of the force). It is zero outside the contact. The
    /// formula is given on the [type](Self); Vermeulen and Johnson (1964).
    #[must_use]
    pub fn traction(&self, x: f64, y: f64) -> f64 {
        let rho = self.hertz.relative_radius(x, y);
        self.slip.held.friction * self.hertz.max_pressure() * self.slip.traction_fraction(rho)
    }

    /// Returns the energy dissipated in the first quarter of a cycle, while the force grows from zero to $`F`$ (a force
    /// times a length, not negative). For the formula see [`CattaneoMindlin::energy_of_first_quarter`].
    #[must_use]
    pub fn energy_of_first_quarter(&self) -> f64 {
        self.slip.held.limit * self.gross_shift * self.slip.dissipated_fraction()
    }

    /// Returns the energy dissipated in a full cycle of the force between $`\pm F`$ after the first loading (a force times a
    /// length). It is four times the [energy of the first quarter](Self::energy_of_first_quarter).
    #[must_use]
    pub fn energy_per_cycle(&self) -> f64 {
        4.0 * self.energy_of_first_quarter()
    }
}
