//! Contact area and stick ratio of nominally flat rough surfaces.

use std::f64::consts::FRAC_2_SQRT_PI;

use super::held_force::HeldForce;
use crate::bodies::material::ElasticPair;
use crate::error::{Result, non_negative, positive};

/// A nominally flat rough surface pressed on a half-space: the fraction of the area in real contact.
///
/// Under the mean pressure $`\bar p`$, with $`g`$ the root mean square of the slope,
///
/// ```math
/// \frac{A}{A_0} = \operatorname{erf}B, \qquad B = \frac{\sqrt\pi}{2}\,\kappa P, \qquad
/// P = \frac{\bar p}{E^*g}
/// ```
///
/// For light loads $`A/A_0 \to \kappa P`$: the area is proportional to the load. Persson's theory gives
/// $`\kappa = \sqrt{8/\pi}`$, the [`AREA_COEFFICIENT`](Self::AREA_COEFFICIENT). The theory of Bush, Gibson and Thomas for light
/// loads gives $`\sqrt{2\pi}`$. Simulations give values of 2.0 to 2.2. The slope $`g`$ is the areal slope
/// $`\langle z_x^2+z_y^2\rangle^{1/2}`$ (Sdq), $`\sqrt2`$ times the slope of a profile of an isotropic surface.
///
/// The fraction is a mean over infinite surfaces whose shortest waves are resolved. A single sample on a coarse mesh
/// can have far more cells in contact. Persson (2001); Bush, Gibson and Thomas (1975).
///
/// ```
/// use stickslip::{ElasticPair, Material, analytical::Persson};
/// let rubber = Material::new(18.75e6, 0.5)?;
/// let pair = ElasticPair::new(rubber, Material::rigid())?;
/// let surface = Persson::new(&pair, 0.1, 0.25e6)?; // P = 0.1
/// assert!((surface.contact_fraction() - 0.158519).abs() < 1e-6);
/// // At half the friction limit, slightly more than half of the area sticks.
/// let ratio = surface.stick_ratio(0.4, 0.05e6)?;
/// assert!(ratio > 0.5 && ratio < 0.51);
/// # Ok::<(), stickslip::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Persson {
    pair: ElasticPair,
    rms_slope: f64,
    mean_pressure: f64,
    area_coefficient: f64,
    reduced_pressure: f64,
}

impl Persson {
    /// Coefficient $`\kappa = \sqrt{8/\pi}`$ of the area in Persson's theory.
    pub const AREA_COEFFICIENT: f64 = 1.5957691216057308;

    /// Creates the contact of a surface of areal root-mean-square slope `rms_slope` (dimensionless) under the mean
    /// pressure `mean_pressure`, with $`\kappa`$ = [`AREA_COEFFICIENT`](Self::AREA_COEFFICIENT).
    ///
    /// # Errors
    /// - [`Error::NotPositive`](crate::Error::NotPositive) if an argument or the reduced pressure is not positive and
    ///   finite.
    /// - [`Error::UnsupportedForCoatings`](crate::Error::UnsupportedForCoatings) if a body is coated.
    pub fn new(pair: &ElasticPair, rms_slope: f64, mean_pressure: f64) -> Result<Self> {
        pair.check_closed_form()?;
        positive("root-mean-square slope", rms_slope)?;
        positive("mean pressure", mean_pressure)?;
        let reduced = mean_pressure / pair.contact_modulus() / rms_slope;
        Ok(Self {
            pair: *pair,
            rms_slope,
            mean_pressure,
            area_coefficient: Self::AREA_COEFFICIENT,
            reduced_pressure: positive("reduced pressure", reduced)?,
        })
    }

    /// Sets the coefficient $`\kappa`$ of the area (dimensionless; default
    /// [`AREA_COEFFICIENT`](Self::AREA_COEFFICIENT)).
    ///
    /// # Errors
    /// - [`Error::NotPositive`](crate::Error::NotPositive) if the coefficient is not positive and finite.
    pub fn with_area_coefficient(self, area_coefficient: f64) -> Result<Self> {
        Ok(Self {
            area_coefficient: positive("area coefficient", area_coefficient)?,
            ..self
        })
    }

    /// Returns the bodies.
    #[must_use]
    pub fn pair(&self) -> &ElasticPair {
        &self.pair
    }

    /// Returns the areal root-mean-square slope $`g`$.
    #[must_use]
    pub fn rms_slope(&self) -> f64 {
        self.rms_slope
    }

    /// Returns the mean pressure $`\bar p`$: the load divided by the nominal area.
    #[must_use]
    pub fn mean_pressure(&self) -> f64 {
        self.mean_pressure
    }

    /// Returns the coefficient of the area $`\kappa`$.
    #[must_use]
    pub fn area_coefficient(&self) -> f64 {
        self.area_coefficient
    }

    /// Returns the reduced pressure $`P = \bar p/E^*g`$ (dimensionless).
    #[must_use]
    pub fn reduced_pressure(&self) -> f64 {
        self.reduced_pressure
    }

    /// Returns the fraction of the nominal area in real contact, $`A/A_0 = \operatorname{erf}B`$.
    #[must_use]
    pub fn contact_fraction(&self) -> f64 {
        libm::erf(argument(self.reduced_pressure, self.area_coefficient))
    }

    /// Returns the fraction of the real contact area that sticks, with the coefficient of friction `friction`. The mean
    /// traction `mean_traction` is a tangential force per nominal area, of either sign.
    ///
    /// ```math
    /// \frac{A_{stick}}{A} = \frac{\operatorname{erf}((1-f)B)}{\operatorname{erf}B}, \qquad
    /// f = \frac{|\bar q|}{\mu\bar p}
    /// ```
    ///
    /// The stick area is the contact area under $`1-f`$ of the load. The ratio tends to [`linear_stick_ratio`] for
    /// light loads and is never smaller. Superposition after Ciavarella (1998b) and Jaeger (1998).
    ///
    /// # Errors
    /// - [`Error::NegativeOrNotFinite`](crate::Error::NegativeOrNotFinite) if the coefficient of friction is negative or not
    ///   finite.
    /// - [`Error::NotFinite`](crate::Error::NotFinite) if the traction or the limit is not finite.
    /// - [`Error::BeyondFrictionCapacity`](crate::Error::BeyondFrictionCapacity), with forces per nominal area, if the
    ///   magnitude of the traction exceeds $`\mu\bar p`$.
    pub fn stick_ratio(&self, friction: f64, mean_traction: f64) -> Result<f64> {
        let held = HeldForce::new(self.mean_pressure, friction, mean_traction)?;
        let b = argument(self.reduced_pressure, self.area_coefficient);
        Ok(if b < PROPORTIONAL_BELOW {
            held.reserve
        } else {
            libm::erf(held.reserve * b) / libm::erf(b)
        })
    }

    /// Computes the contact fraction $`A/A_0`$ of any surface at the reduced pressure `reduced_pressure` $`P`$, with
    /// the coefficient `area_coefficient` $`\kappa`$.
    ///
    /// # Errors
    /// - [`Error::NegativeOrNotFinite`](crate::Error::NegativeOrNotFinite) if the pressure is negative or not finite.
    /// - [`Error::NotPositive`](crate::Error::NotPositive) if the coefficient is not positive and finite.
    pub fn area_law(reduced_pressure: f64, area_coefficient: f64) -> Result<f64> {
        non_negative("reduced pressure", reduced_pressure)?;
        positive("area coefficient", area_coefficient)?;
        Ok(libm::erf(argument(reduced_pressure, area_coefficient)))
    }
}

/// Argument below which $`\operatorname{erf}`$ is proportional to the argument to within round-off.
const PROPORTIONAL_BELOW: f64 = 1e-9;

/// Returns $`B = \frac{\sqrt\pi}{2}\kappa P`$.
fn argument(reduced_pressure: f64, area_coefficient: f64) -> f64 {
    // The argument is kept finite because zero times an infinite argument would be undefined.
    (area_coefficient * reduced_pressure / FRAC_2_SQRT_PI).min(f64::MAX)
}

/// Computes the fraction $`A_{stick}/A = 1-F/\mu W`$ of the contact area of a rough surface that sticks. The surface
/// carries the normal load `load` (a force) and the tangential force `force` (of either sign), with the coefficient of
/// friction `friction`.
///
/// The stick area is the contact area under the load $`W-F/\mu`$. The real area of a rough surface is proportional to
/// the load while it is a small fraction of the nominal area. This ratio is the straight line in figures 25 and 26 of
/// the paper. The line is exact for a [`Cone`](super::Cone); for a smooth sphere the ratio is $`(1-F/\mu W)^{2/3}`$
/// ([`CattaneoMindlin`](super::CattaneoMindlin)). Without friction the function returns zero. The ratio computed for a
/// single surface is within about 0.05 of the line. Paggi, Pohrt and Popov (2014); Ciavarella (1998b).
///
/// # Errors
/// - [`Error::NotPositive`](crate::Error::NotPositive) if the load is not positive and finite.
/// - [`Error::NegativeOrNotFinite`](crate::Error::NegativeOrNotFinite) if the coefficient of friction is negative or not finite.
/// - [`Error::NotFinite`](crate::Error::NotFinite) if the force or the limit is not finite.
/// - [`Error::BeyondFrictionCapacity`](crate::Error::BeyondFrictionCapacity) if the force exceeds $`\mu W`$.
///
/// ```
/// use stickslip::{Error, analytical::linear_stick_ratio};
/// assert!((linear_stick_ratio(100.0, 0.5, 20.0)? - 0.6).abs() < 1e-15);
/// assert!(matches!(linear_stick_ratio(100.0, 0.5, 51.0), Err(Error::BeyondFrictionCapacity { .. })));
/// # Ok::<(), Error>(())
/// ```
pub fn linear_stick_ratio(load: f64, friction: f64, force: f64) -> Result<f64> {
    positive("load", load)?;
    Ok(HeldForce::new(load, friction, force)?.reserve)
}
