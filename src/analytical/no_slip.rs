//! Normal contact of a flat punch and of a sphere without slip.

use std::f64::consts::FRAC_1_PI;

use super::quadrature::integral;
use crate::bodies::material::ElasticPair;
use crate::error::{Result, positive};

/// Upper limit of the integration. The rest of the integral is below round-off.
const LENGTH: f64 = 20.0;

/// A flat-ended round punch pressed on a half-space without any slip: the limit of infinite friction.
///
/// If pressure and traction are coupled, sticking makes the contact stiffer:
///
/// ```math
/// \delta = \frac{W}{2aE^* f}, \qquad f = \frac{\operatorname{artanh}\beta}{\beta}
/// ```
///
/// For a body of Poisson's ratio $`\nu`$ on a rigid body, $`f = (1-\nu)\ln(3-4\nu)/(1-2\nu)`$. V. I. Mossakovskii, *Prikl. Mat.
/// Mekh.* 18 (1954) 187-196; F. M. Borodich & L. M. Keer, *Proc. R. Soc. Lond. A* 460 (2004) 507-514.
///
/// ```
/// use stickslip::{ElasticPair, Material, analytical::{FlatPunch, NoSlipPunch}};
/// let cork = ElasticPair::new(Material::new(1.0, 0.0)?, Material::rigid())?;
/// let (stuck, smooth) = (NoSlipPunch::new(&cork, 2.0, 1.0)?, FlatPunch::new(&cork, 2.0, 1.0)?);
/// assert!((smooth.approach() / stuck.approach() - 3.0_f64.ln()).abs() < 1e-14);
/// # Ok::<(), stickslip::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct NoSlipPunch {
    radius: f64,
    load: f64,
    approach: f64,
}

impl NoSlipPunch {
    /// Creates the contact of a flat end of radius `radius` (a length) under the normal load `load` (a force).
    ///
    /// # Errors
    /// - [`Error::NotPositive`](crate::Error::NotPositive) if the radius, the load or the approach is not positive and finite.
    /// - [`Error::UnsupportedForCoatings`](crate::Error::UnsupportedForCoatings) if a body is coated.
    pub fn new(pair: &ElasticPair, radius: f64, load: f64) -> Result<Self> {
        pair.check_closed_form()?;
        positive("radius", radius)?;
        positive("load", load)?;
        let approach = 0.5 * (load / pair.contact_modulus()) / radius / factor(pair);
        Ok(Self {
            radius,
            load,
            approach: positive("approach", approach)?,
        })
    }

    /// Returns the radius $`a`$ of the flat end and of the contact circle (a length).
    #[must_use]
    pub fn contact_radius(&self) -> f64 {
        self.radius
    }

    /// Returns the normal load $`W`$ (a force).
    #[must_use]
    pub fn load(&self) -> f64 {
        self.load
    }

    /// Returns the approach $`\delta`$ (a length).
    #[must_use]
    pub fn approach(&self) -> f64 {
        self.approach
    }
}

/// A sphere pressed on a half-space by a growing load without any slip: points stick as soon as they come into contact.
///
/// ```math
/// \delta = \frac{a^2}{2RI}, \qquad W = \frac{4E^*a^3}{3R}\,\frac{f}{2I}, \qquad
/// I = \int_0^1 t \cos\!\left(\vartheta \ln\frac{1-t}{1+t}\right) dt, \qquad
/// \vartheta = \frac1\pi \operatorname{artanh}\beta ,
/// ```
///
/// where $`f`$ is the factor of the [punch](NoSlipPunch). Without coupling $`I = 1/2`$, and the contact is a Hertz contact. D. A.
/// Spence, *Proc. R. Soc. Lond. A* 305 (1968) 55-80, [doi:10.1098/rspa.1968.0105](https://doi.org/10.1098/rspa.1968.0105);
/// Borodich & Keer (2004).
///
/// ```
/// use stickslip::{ElasticPair, Material, analytical::{HertzSphere, NoSlipSphere}};
/// let cork = ElasticPair::new(Material::new(1.0, 0.0)?, Material::rigid())?;
/// let (stuck, smooth) = (NoSlipSphere::new(&cork, 3.0, 0.1)?, HertzSphere::new(&cork, 3.0, 0.1)?);
/// assert!(stuck.contact_radius() < smooth.contact_radius() && stuck.approach() < smooth.approach());
/// # Ok::<(), stickslip::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct NoSlipSphere {
    radius: f64,
    load: f64,
    contact_radius: f64,
    approach: f64,
}

impl NoSlipSphere {
    /// Creates the contact of a sphere of radius `radius` (a length) under the normal load `load` (a force).
    ///
    /// # Errors
    /// - [`Error::NotPositive`](crate::Error::NotPositive) if the radius, the load or a result is not positive and finite.
    /// - [`Error::UnsupportedForCoatings`](crate::Error::UnsupportedForCoatings) if a body is coated.
    pub fn new(pair: &ElasticPair, radius: f64, load: f64) -> Result<Self> {
        pair.check_closed_form()?;
        positive("radius", radius)?;
        positive("load", load)?;
        let moment = moment(pair);
        let cubed = 1.5 * (load / pair.contact_modulus()) * radius * moment / factor(pair);
        let contact_radius = positive("contact radius", cubed.cbrt())?;
        let approach = 0.5 * contact_radius * (contact_radius / radius) / moment;
        Ok(Self {
            radius,
            load,
            contact_radius,
            approach: positive("approach", approach)?,
        })
    }

    /// Returns the radius of the sphere $`R`$ (a length).
    #[must_use]
    pub fn radius(&self) -> f64 {
        self.radius
    }

    /// Returns the normal load $`W`$ (a force).
    #[must_use]
    pub fn load(&self) -> f64 {
        self.load
    }

    /// Returns the radius of the contact circle $`a`$ (a length).
    #[must_use]
    pub fn contact_radius(&self) -> f64 {
        self.contact_radius
    }

    /// Returns the approach $`\delta`$ (a length).
    #[must_use]
    pub fn approach(&self) -> f64 {
        self.approach
    }
}

/// Returns $`f`$, the ratio of the stiffness of a punch without slip to its stiffness without friction.
fn factor(pair: &ElasticPair) -> f64 {
    let beta = pair.dundurs_beta();
    if beta == 0.0 {
        1.0
    } else {
        beta.atanh() / beta
    }
}

/// Computes $`I`$ with the substitution $`t = \tanh s`$.
fn moment(pair: &ElasticPair) -> f64 {
    let theta = FRAC_1_PI * pair.dundurs_beta().atanh();
    integral(LENGTH, |s| {
        s.tanh() * (2.0 * theta * s).cos() / s.cosh().powi(2)
    })
}
