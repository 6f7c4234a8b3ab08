//! A flat-ended punch pressed on a half-space.

use std::f64::consts::{FRAC_2_PI, PI};

use super::full_stick::{MindlinFullStick, edge_pole};
use super::held_force::HeldForce;
use super::hertz::arc_sine;
use crate::bodies::material::ElasticPair;
use crate::error::{Result, positive};

/// The flat end of a rigid round cylinder pressed on a half-space.
///
/// The initial gap is zero within the radius $`a`$, and there is no contact outside it:
///
/// ```math
/// p = \frac{W}{2\pi a\sqrt{a^2-r^2}}, \qquad \delta = \frac{W}{2aE^*}
/// ```
///
/// The solution describes a real punch only if body 2 is rigid. For two elastic bodies it is the half-space solution
/// for this gap. Johnson (1985), section 3.4 and 3.36-3.37.
///
/// The coupling of pressure and traction is neglected. A body on a rigid punch is uncoupled only if its Poisson's ratio is
/// 1/2. For other bodies, pressing alone causes tractions, and the edge of the contact slips
/// ([`SpencePressing`](super::SpencePressing), and [`NoSlipPunch`](super::NoSlipPunch) for infinite friction).
///
/// ```
/// use stickslip::{ElasticPair, Material, analytical::FlatPunch};
/// let rubber = Material::new(3.0, 0.5)?;
/// let punch = FlatPunch::new(&ElasticPair::new(rubber, Material::rigid())?, 2.0, 8.0)?;
/// // E* = 4 MPa: 8 N sink a punch of radius 2 mm by half a millimetre.
/// assert!((punch.approach() - 0.5).abs() < 1e-15);
/// assert!((punch.pressure(0.0) / punch.mean_pressure() - 0.5).abs() < 1e-15);
/// # Ok::<(), stickslip::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct FlatPunch {
    pair: ElasticPair,
    radius: f64,
    load: f64,
    mean_pressure: f64,
    approach: f64,
}

impl FlatPunch {
    /// Creates the contact of a flat end of radius `radius` (a length) under the normal load `load` (a force).
    ///
    /// # Errors
    /// - [`Error::NotPositive`](crate::Error::NotPositive) if the radius, the load or a result is not positive and
    ///   finite.
    /// - [`Error::UnsupportedForCoatings`](crate::Error::UnsupportedForCoatings) if a body is coated.
    pub fn new(pair: &ElasticPair, radius: f64, load: f64) -> Result<Self> {
        pair.check_closed_form()?;
        positive("radius", radius)?;
        positive("load", load)?;
        Ok(Self {
            pair: *pair,
            radius,
            load,
            mean_pressure: positive("mean pressure", load / PI / radius / radius)?,
            approach: positive("approach", 0.5 * (load / pair.contact_modulus()) / radius)?,
        })
    }

    /// Returns the bodies.
    #[must_use]
    pub fn pair(&self) -> &ElasticPair {
        &self.pair
    }

    /// Returns the radius $`a`$ of the flat end and of the contact circle (a length).
    #[must_use]
    pub fn contact_radius(&self) -> f64 {
        self.radius
    }

    /// Returns the area of the contact circle $`\pi a^2`$ (a length squared).
    #[must_use]
    pub fn contact_area(&self) -> f64 {
        PI * self.radius * self.radius
    }

    /// Returns the normal load $`W`$ (a force), positive in compression.
    #[must_use]
    pub fn load(&self) -> f64 {
        self.load
    }

    /// Returns the mean pressure over the contact circle $`W/\pi a^2`$, twice the pressure at the centre.
    #[must_use]
    pub fn mean_pressure(&self) -> f64 {
        self.mean_pressure
    }

    /// Returns the approach of the bodies $`\delta = W/2aE^*`$ (a length), positive. Johnson (1985), 3.36.
    #[must_use]
    pub fn approach(&self) -> f64 {
        self.approach
    }

    /// Returns the pressure $`p = W/(2\pi a\sqrt{a^2-r^2})`$ at the distance $`r`$ from the centre. The pressure is
    /// unbounded towards the edge. At the edge and outside it the function returns zero. Johnson (1985), section 3.4.
    #[must_use]
    pub fn pressure(&self, r: f64) -> f64 {
        edge_pole(self.load, self.radius, r)
    }

    /// Returns the normal displacement of the surfaces (a length) at the distance $`r`$ from the centre. It is the sum over the
    /// bodies, positive into each body. The displacement is the approach inside the contact, and
    /// $`u_z = \frac{2\delta}{\pi}\arcsin\frac ar`$ outside. Johnson (1985), 3.37.
    #[must_use]
    pub fn displacement(&self, r: f64) -> f64 {
        let rho = r.abs() / self.radius;
        if rho > 1.0 {
            self.approach * FRAC_2_PI * arc_sine(1.0, rho)
        } else {
            self.approach
        }
    }

    /// Creates the punch in full stick under the tangential force `force`, with the coefficient of friction `friction`. The force
    /// acts on body 1 along x (a force, of either sign).
    ///
    /// Traction and pressure have the same distribution, $`q/p = F/W`$. The whole contact therefore sticks until
    /// $`|F| = \mu W`$, and then slides everywhere simultaneously.
    ///
    /// The solution is valid if pressure and traction are uncoupled. A rigid punch requires a Poisson's ratio of 1/2 for this.
    /// Otherwise tractions caused by pressing add to $`q`$, and slip spreads from the edge. For $`\nu = 0.3`$ and $`\mu = 0.3`$,
    /// a [history](crate::History) with full coupling on 64 x 64 cells slips on 20 % of the contact under pressing alone. Its
    /// shift exceeds the shift of this solution by 3 % at 0.3 of the sliding force, by 8 % at 0.6 and by 27 % at 0.9.
    ///
    /// # Errors
    /// - [`Error::NegativeOrNotFinite`](crate::Error::NegativeOrNotFinite) if the coefficient of friction is negative or not
    ///   finite.
    /// - [`Error::NotFinite`](crate::Error::NotFinite) if the force or a result is not finite.
    /// - [`Error::BeyondFrictionCapacity`](crate::Error::BeyondFrictionCapacity) if the force exceeds $`\mu W`$.
    pub fn full_stick(&self, friction: f64, force: f64) -> Result<MindlinFullStick> {
        HeldForce::new(self.load, friction, force)?;
        MindlinFullStick::new(&self.pair, self.radius, force)
    }
}
