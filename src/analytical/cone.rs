//! Normal contact and partial slip of a cone on a half-space.

use std::f64::consts::{FRAC_2_PI, FRAC_PI_2, PI};

use super::held_force::HeldForce;
use super::hertz::{arc_cosine, arc_sine, dome};
use super::sines::sine_minus_arc_cosine;
use crate::bodies::material::ElasticPair;
use crate::error::{Result, finite, positive};

/// A blunt cone pressed on a half-space.
///
/// The initial gap is $`r\tan\beta`$, where $`\beta`$ is the small angle between the flank and the surface:
///
/// ```math
/// W = \frac\pi2 E^* a^2\tan\beta, \qquad \delta = \frac\pi2\,a\tan\beta, \qquad
/// p = \frac{E^*\tan\beta}{2}\,\operatorname{arcosh}\frac ar
/// ```
///
/// The mean pressure is independent of the load, so the contact area is proportional to the load, as for a rough
/// surface. Sneddon (1965); Johnson (1985), section 5.2.
///
/// ```
/// use stickslip::{ElasticPair, Material, analytical::Cone};
/// let rubber = Material::new(3.0, 0.5)?;
/// let pair = ElasticPair::new(rubber, Material::rigid())?;
/// let (light, heavy) = (Cone::new(&pair, 0.05, 1.0)?, Cone::new(&pair, 0.05, 2.0)?);
/// assert!((heavy.contact_area() / light.contact_area() - 2.0).abs() < 1e-14);
/// // E* = 4 MPa: the mean pressure is E* tan(beta) / 2.
/// assert!((heavy.mean_pressure() - 0.1).abs() < 1e-15);
/// # Ok::<(), stickslip::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Cone {
    pair: ElasticPair,
    slope: f64,
    load: f64,
    contact_radius: f64,
    mean_pressure: f64,
    approach: f64,
}

impl Cone {
    /// Creates the contact of a cone of slope `slope` ($`\tan\beta`$, dimensionless) under the normal load `load` (a
    /// force).
    ///
    /// # Errors
    /// - [`Error::NotPositive`](crate::Error::NotPositive) if the slope, the load or a result is not positive and
    ///   finite.
    /// - [`Error::UnsupportedForCoatings`](crate::Error::UnsupportedForCoatings) if a body is coated.
    pub fn new(pair: &ElasticPair, slope: f64, load: f64) -> Result<Self> {
        pair.check_closed_form()?;
        positive("slope", slope)?;
        positive("load", load)?;
        let a = (FRAC_2_PI * (load / pair.contact_modulus()) / slope).sqrt();
        Ok(Self {
            pair: *pair,
            slope,
            load,
            contact_radius: positive("contact radius", a)?,
            mean_pressure: positive("mean pressure", 0.5 * pair.contact_modulus() * slope)?,
            approach: positive("approach", FRAC_PI_2 * a * slope)?,
        })
    }

    /// Returns the bodies.
    #[must_use]
    pub fn pair(&self) -> &ElasticPair {
        &self.pair
    }

    /// Returns the slope of the flank $`\tan\beta`$.
    #[must_use]
    pub fn slope(&self) -> f64 {
        self.slope
    }

    /// Returns the normal load $`W`$ (a force), positive in compression.
    #[must_use]
    pub fn load(&self) -> f64 {
        self.load
    }

    /// Returns the radius of the contact circle $`a = (2W/\pi E^*\tan\beta)^{1/2}`$ (a length). Sneddon (1965).
    #[must_use]
    pub fn contact_radius(&self) -> f64 {
        self.contact_radius
    }

    /// Returns the area of the contact circle $`\pi a^2`$ (a length squared).
    #[must_use]
    pub fn contact_area(&self) -> f64 {
        PI * self.contact_radius * self.contact_radius
    }

    /// Returns the mean pressure over the contact circle $`\frac12 E^*\tan\beta`$, independent of the load.
    #[must_use]
    pub fn mean_pressure(&self) -> f64 {
        self.mean_pressure
    }

    /// Returns the approach of the bodies $`\delta = \frac\pi2 a\tan\beta`$ (a length), positive. Sneddon (1965).
    #[must_use]
    pub fn approach(&self) -> f64 {
        self.approach
    }

    /// Returns the pressure $`p = \frac12 E^*\tan\beta\,\operatorname{arcosh}(a/r)`$ at the distance $`r`$ from the
    /// centre. It is infinite at the apex and zero outside the contact. Sneddon (1965).
    #[must_use]
    pub fn pressure(&self, r: f64) -> f64 {
        let rho = r.abs() / self.contact_radius;
        self.mean_pressure * (dome(rho) / rho).asinh()
    }

    /// Returns the normal displacement of the surfaces (a length) at the distance $`r`$ from the centre, inside and
    /// outside the contact. It is the sum over the bodies, positive into each body.
    ///
    /// ```math
    /// u_z = \delta - r\tan\beta \quad (r \le a), \qquad
    /// u_z = \left[a\arcsin\frac ar - r + \sqrt{r^2-a^2}\right]\tan\beta \quad (r > a)
    /// ```
    ///
    /// Sneddon (1965).
    #[must_use]
    pub fn displacement(&self, r: f64) -> f64 {
        let rho = r.abs() / self.contact_radius;
        let shape = if rho > 1.0 {
            arc_sine(1.0, rho) - 1.0 / (rho + rho * dome(1.0 / rho))
        } else {
            FRAC_PI_2 - rho
        };
        self.slope * self.contact_radius * shape
    }

    /// Returns the gap $`g = u_z + r\tan\beta - \delta`$ between the surfaces (a length) at the distance $`r`$ from the
    /// centre. It is zero in the contact and positive outside.
    ///
    /// The gap is evaluated as $`(\sin\varphi - \varphi\cos\varphi)\,r\tan\beta`$ with $`\cos\varphi = a/r`$, which
    /// avoids cancellation.
    #[must_use]
    pub fn gap(&self, r: f64) -> f64 {
        let rho = r.abs() / self.contact_radius;
        if rho > 1.0 {
            self.slope * r.abs() * sine_minus_arc_cosine(arc_cosine(1.0, rho))
        } else {
            0.0
        }
    }
}

/// A cone in partial slip. Under a constant normal load, a tangential force along x increases monotonically.
///
/// The traction is $`\mu`$ times the difference between the pressure under $`W`$ and the pressure under the reduced
/// load $`(1-f)W`$, $`f = |F|/\mu W`$. The contact circle under the reduced load is the stick disc, of radius $`c`$:
///
/// ```math
/// \frac{c^2}{a^2} = 1-f, \qquad
/// q = \frac{\mu E^*\tan\beta}{2}\left[\operatorname{arcosh}\frac ar -
/// \operatorname{arcosh}\frac cr\,H(c-r)\right], \qquad
/// \delta_x = \frac{2-\nu}{2(1-\nu)}\,\mu\delta\left[1-\sqrt{1-f}\right]
/// ```
///
/// The stick ratio decreases linearly with the force, as it does for a contact of many asperities. The solution belongs
/// to the scalar model, with traction along x only. It is valid for every $`\nu`$. Ciavarella (1998b); Jaeger (1998).
///
/// ```
/// use stickslip::{ElasticPair, Material, analytical::{Cone, ConePartialSlip}};
/// let rubber = Material::new(3.0, 0.5)?;
/// let cone = Cone::new(&ElasticPair::new(rubber, rubber)?, 0.05, 1.0)?;
/// let shear = ConePartialSlip::new(cone, 0.5, 0.2)?;
/// assert!((shear.stick_ratio() - 0.6).abs() < 1e-15);
/// // The pressure is singular at the apex; the traction there is finite.
/// assert!(cone.pressure(0.0).is_infinite() && shear.traction(0.0).is_finite());
/// # Ok::<(), stickslip::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct ConePartialSlip {
    cone: Cone,
    held: HeldForce,
    /// $`c/a = (1-f)^{1/2}`$.
    stick: f64,
    gross_shift: f64,
}

impl ConePartialSlip {
    /// Creates the contact `cone` with the coefficient of friction `friction`, under the tangential force `force` on
    /// body 1 along x (a force, of either sign).
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
    pub fn new(cone: Cone, friction: f64, force: f64) -> Result<Self> {
        let held = HeldForce::new(cone.load, friction, force)?;
        let nu = cone.pair.equivalent_poisson_ratio();
        let shift = (2.0 - nu) / (2.0 * (1.0 - nu)) * friction * cone.approach;
        Ok(Self {
            cone,
            held,
            stick: held.reserve.sqrt(),
            gross_shift: finite("shift at gross sliding", shift)?,
        })
    }

    /// Returns the normal contact.
    #[must_use]
    pub fn cone(&self) -> Cone {
        self.cone
    }

    /// Returns the tangential force $`F`$ on body 1, positive along +x.
    #[must_use]
    pub fn force(&self) -> f64 {
        self.held.force
    }

    /// Returns the radius of the stick disc $`c = a(1-f)^{1/2}`$ (a length).
    #[must_use]
    pub fn stick_radius(&self) -> f64 {
        self.stick * self.cone.contact_radius
    }

    /// Returns the fraction of the contact area that sticks, $`c^2/a^2 = 1-f`$.
    #[must_use]
    pub fn stick_ratio(&self) -> f64 {
        self.held.reserve
    }

    /// Returns the shift $`\delta_x`$ (a length): the rigid motion of body 2 relative to body 1, with the sign of the
    /// force. The formula is given on the [type](Self).
    #[must_use]
    pub fn shift(&self) -> f64 {
        self.gross_shift * self.held.direction * self.ring()
    }

    /// Returns the shift at which the whole contact starts to slide (a length, positive): the [`shift`](Self::shift)
    /// under $`\mu W`$.
    #[must_use]
    pub fn sliding_shift(&self) -> f64 {
        self.gross_shift
    }

    /// Returns the traction $`q`$ on body 1 along x (a pressure, with the sign of the force) at the distance $`r`$ from
    /// the centre. It is zero outside the contact. The formula is given on the [type](Self).
    ///
    /// In the stick disc the traction is evaluated as a single logarithm, which avoids cancellation. At the apex the
    /// traction is $`\frac12\mu E^*\tan\beta\,\ln(a/c)`$.
    #[must_use]
    pub fn traction(&self, r: f64) -> f64 {
        let rho = r.abs() / self.cone.contact_radius;
        let scale = self.held.direction * self.held.friction;
        if rho < self.stick && rho < 1.0 {
            let inner = ((self.stick - rho) * (self.stick + rho)).sqrt();
            // With 1 - c^2/a^2 = f, the argument of the logarithm minus one is (1 + dome) / (c/a + inner) - 1.
            let excess = self.ring() + self.held.fraction / (dome(rho) + inner);
            scale * self.cone.mean_pressure * (excess / (self.stick + inner)).ln_1p()
        } else if self.held.friction > 0.0 {
            scale * self.cone.pressure(r)
        } else {
            0.0
        }
    }

    /// Returns $`1-c/a`$ without cancellation at small forces.
    fn ring(&self) -> f64 {
        self.held.fraction / (1.0 + self.stick)
    }
}
