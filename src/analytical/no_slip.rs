//! A rigid punch and a sphere pressed on a body that sticks to them.

use std::f64::consts::FRAC_1_PI;

use super::quadrature::integral;
use crate::bodies::material::ElasticPair;
use crate::error::{Result, positive};

/// Beyond this the integrand has vanished to the last digit.
const LENGTH: f64 = 20.0;

/// A flat-ended round punch pressed without any slip, as by friction without limit.
///
/// Where pressure and traction are coupled, sticking makes the contact stiffer:
///
/// ```math
/// \delta = \frac{W}{2aE^* f}, \qquad f = \frac{\operatorname{artanh}\beta}{\beta}
/// ```
///
/// For a body of Poisson's ratio $`\nu`$ on a rigid one $`f = (1-\nu)\ln(3-4\nu)/(1-2\nu)`$. V. I. Mossakovskii, *Prikl. Mat.
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
    /// The contact of a flat end of radius `radius` (a length) under the normal load `load` (a force).
    ///
    /// # Errors
    /// [`Error::NotPositive`](crate::Error::NotPositive) if radius, load or approach is not positive and finite.
    /// [`Error::UnsupportedForCoatings`](crate::Error::UnsupportedForCoatings) for coated bodies.
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

    /// Radius of the flat end, and of the contact circle, $`a`$ (a length).
    #[must_use]
    pub fn contact_radius(&self) -> f64 {
        self.radius
    }

    /// Normal load $`W`$ (a force).
    #[must_use]
    pub fn load(&self) -> f64 {
        self.load
    }

    /// Approach $`\delta`$ (a length).
    #[must_use]
    pub fn approach(&self) -> f64 {
        self.approach
    }
}

/// A sphere pressed by a growing load without any slip: a point that has come into contact sticks.
///
/// ```math
/// \delta = \frac{a^2}{2RI}, \qquad W = \frac{4E^*a^3}{3R}\,\frac{f}{2I}, \qquad
/// I = \int_0^1 t \cos\!\left(\vartheta \ln\frac{1-t}{1+t}\right) dt, \qquad
/// \vartheta = \frac1\pi \operatorname{artanh}\beta ,
/// ```
///
/// with $`f`$ that of the [punch](NoSlipPunch). Without coupling $`I = 1/2`$, the contact of Hertz. D. A. Spence, *Proc. R. Soc.
/// Lond. A* 305 (1968) 55-80, [doi:10.1098/rspa.1968.0105](https://doi.org/10.1098/rspa.1968.0105); Borodich & Keer as there.
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
    /// The contact of a sphere of radius `radius` (a length) under the normal load `load` (a force).
    ///
    /// # Errors
    /// [`Error::NotPositive`](crate::Error::NotPositive) if radius, load or a result is not positive and finite.
    /// [`Error::UnsupportedForCoatings`](crate::Error::UnsupportedForCoatings) for coated bodies.
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

    /// Radius of the sphere $`R`$ (a length).
    #[must_use]
    pub fn radius(&self) -> f64 {
        self.radius
    }

    /// Normal load $`W`$ (a force).
    #[must_use]
    pub fn load(&self) -> f64 {
        self.load
    }

    /// Radius of the contact circle $`a`$ (a length).
    #[must_use]
    pub fn contact_radius(&self) -> f64 {
        self.contact_radius
    }

    /// Approach $`\delta`$ (a length).
    #[must_use]
    pub fn approach(&self) -> f64 {
        self.approach
    }
}

/// $`f`$: how much stiffer sticking makes a punch.
fn factor(pair: &ElasticPair) -> f64 {
    let beta = pair.dundurs_beta();
    if beta == 0.0 {
        1.0
    } else {
        beta.atanh() / beta
    }
}

/// $`I`$, with $`t = \tanh s`$.
fn moment(pair: &ElasticPair) -> f64 {
    let theta = FRAC_1_PI * pair.dundurs_beta().atanh();
    integral(LENGTH, |s| {
        s.tanh() * (2.0 * theta * s).cos() / s.cosh().powi(2)
    })
}
