//! A contact circle in full stick.

use std::f64::consts::{FRAC_2_PI, PI};

use super::hertz::{arc_sine, dome};
use crate::bodies::material::ElasticPair;
use crate::error::{Result, finite, positive};

/// A contact circle in full stick under a tangential force along x.
///
/// The traction on the circle of radius $`a`$ and the shift are
///
/// ```math
/// q = \frac{F}{2\pi a\sqrt{a^2-r^2}}, \qquad \delta_x = \frac{2-\nu}{8Ga}\,F
/// ```
///
/// No finite coefficient of friction supports this traction at the edge of a smooth contact. For a sphere the solution
/// is the limit $`\mu \to \infty`$ of [`CattaneoMindlin`](super::CattaneoMindlin). The compliance of the circle is the
/// compliance of the sphere under small forces. Under a [`FlatPunch`](super::FlatPunch) of bodies whose pressure and
/// traction are uncoupled, the solution is valid up to sliding. For every $`\nu`$ the circle moves along x only, so no
/// lateral traction is neglected. Mindlin (1949); Johnson (1985), 3.82 and section 7.2.
///
/// ```
/// use stickslip::{ElasticPair, Material};
/// use stickslip::analytical::{CattaneoMindlin, HertzSphere, MindlinFullStick};
/// let steel = Material::new(213e3, 0.29)?;
/// let pair = ElasticPair::new(steel, steel)?;
/// let ball = HertzSphere::new(&pair, 3.5, 100.0)?;
/// let stick = MindlinFullStick::new(&pair, ball.contact_radius(), 1e-6)?;
/// // A small force on a ball causes hardly any slip.
/// let slip = CattaneoMindlin::new(ball, 0.5, 1e-6)?;
/// assert!((slip.shift() / stick.shift() - 1.0).abs() < 1e-7);
/// # Ok::<(), stickslip::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct MindlinFullStick {
    pair: ElasticPair,
    contact_radius: f64,
    force: f64,
    shift: f64,
}

impl MindlinFullStick {
    /// Creates the contact circle of radius `contact_radius` (a length) under the tangential force `force` on body 1
    /// along x (a force, of either sign). The coupling between pressure and traction of dissimilar bodies is neglected.
    ///
    /// # Errors
    /// - [`Error::NotPositive`](crate::Error::NotPositive) if the radius is not positive and finite.
    /// - [`Error::NotFinite`](crate::Error::NotFinite) if the force or the shift is not finite.
    /// - [`Error::UnsupportedForCoatings`](crate::Error::UnsupportedForCoatings) if a body is coated.
    pub fn new(pair: &ElasticPair, contact_radius: f64, force: f64) -> Result<Self> {
        pair.check_closed_form()?;
        positive("contact radius", contact_radius)?;
        finite("tangential force", force)?;
        let compliance = (2.0 - pair.equivalent_poisson_ratio())
            / (8.0 * pair.equivalent_shear_modulus() * contact_radius);
        Ok(Self {
            pair: *pair,
            contact_radius,
            force,
            shift: finite("shift", compliance * force)?,
        })
    }

    /// Returns the bodies.
    #[must_use]
    pub fn pair(&self) -> &ElasticPair {
        &self.pair
    }

    /// Returns the radius of the contact circle $`a`$ (a length).
    #[must_use]
    pub fn contact_radius(&self) -> f64 {
        self.contact_radius
    }

    /// Returns the tangential force $`F`$ on body 1, positive along +x.
    #[must_use]
    pub fn force(&self) -> f64 {
        self.force
    }

    /// Returns the shift $`\delta_x = F(2-\nu)/8Ga`$ (a length): the rigid motion of body 2 relative to body 1, with
    /// the sign of the force. Mindlin (1949).
    #[must_use]
    pub fn shift(&self) -> f64 {
        self.shift
    }

    /// Returns the traction $`q = F/(2\pi a\sqrt{a^2-r^2})`$ on body 1 along x (a pressure, with the sign of the force)
    /// at the distance $`r`$ from the centre. The traction is unbounded towards the edge. At the edge and outside it
    /// the function returns zero. Johnson (1985), 3.82.
    #[must_use]
    pub fn traction(&self, r: f64) -> f64 {
        edge_pole(self.force, self.contact_radius, r)
    }

    /// Returns the tangential displacement $`u_x = u_{x1}-u_{x2}`$ (a length, with the sign of the force), anywhere in
    /// the plane: the [`shift`](Self::shift) inside the contact, and outside
    ///
    /// ```math
    /// u_x = \frac{F}{4\pi Ga}\left[(2-\nu)\,\sigma + \nu\sin\sigma\cos\sigma\cos 2\theta\right],
    /// \qquad \sin\sigma = \frac ar
    /// ```
    ///
    /// Johnson (1985), section 3.7.
    #[must_use]
    pub fn displacement(&self, x: f64, y: f64) -> f64 {
        let (xi, eta) = (x / self.contact_radius, y / self.contact_radius);
        let rho = xi.hypot(eta);
        if rho > 1.0 {
            let cosine = (xi - eta) / rho * ((xi + eta) / rho);
            let lobes = dome(1.0 / rho) / rho * cosine;
            let nu = self.pair.equivalent_poisson_ratio();
            self.shift * FRAC_2_PI * (arc_sine(1.0, rho) + nu / (2.0 - nu) * lobes)
        } else {
            self.shift
        }
    }
}

/// Returns $`P/(2\pi a\sqrt{a^2-r^2})`$ within the circle of radius $`a`$ and zero outside: the stress that displaces
/// the circle uniformly under the force $`P`$.
pub(super) fn edge_pole(force: f64, a: f64, r: f64) -> f64 {
    let rho = r.abs() / a;
    if rho < 1.0 {
        0.5 * force / PI / a / a / dome(rho)
    } else {
        0.0
    }
}
