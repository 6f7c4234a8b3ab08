//! Contact area of a rough sphere.

use std::f64::consts::{FRAC_2_SQRT_PI, PI};

use super::hertz::HertzSphere;
use crate::error::{Result, non_negative, positive};

/// A rough sphere pressed on a half-space: the fraction of the Hertz circle in real contact.
///
/// Let $`p`$ be the pressure of the smooth sphere at a point, and $`g`$ the root mean square of the slope. At this
/// point the fraction $`\operatorname{erf}(\frac{\sqrt\pi}{2}\kappa\,p/E^*g)`$ of the area is in contact. The average
/// of this fraction over the Hertz circle is, with the reduced pressure $`P`$,
///
/// ```math
/// A_r = \int_0^1 \operatorname{erf}(B\sqrt t)\,dt =
/// \left(1-\frac{1}{2B^2}\right)\operatorname{erf}B + \frac{e^{-B^2}}{\sqrt\pi\,B}, \qquad
/// B = \kappa\tilde p = \frac{3\sqrt\pi}{4}\,\kappa P, \qquad P = \frac{W}{\pi a^2E^*g}
/// ```
///
/// For light loads $`A_r \to \kappa P`$: the [`AREA_COEFFICIENT`](Self::AREA_COEFFICIENT) $`\kappa`$, written $`k`$ in
/// the paper, is the initial slope of this law. The slope $`g`$ is the areal slope $`\langle z_x^2+z_y^2\rangle^{1/2}`$
/// (Sdq), $`\sqrt2`$ times the slope of a profile of an isotropic surface.
///
/// The law is valid for small and fine roughness. The height of the roughness must be well below the approach $`a^2/R`$ of the
/// smooth sphere, and many asperities must lie within the circle. If the load is too light for these conditions, contact spreads
/// beyond the Hertz circle and the area is less certain. The law is given by equations 32, 33 and 37 of the paper, after Müser
/// (2016), without the mean-field approximation of Pastewka and Robbins (2016). Greenwood and Tripp (1967) treat the rough sphere
/// as independent asperities.
///
/// ```
/// use stickslip::{ElasticPair, Material, analytical::{HertzSphere, RoughSphere}};
/// // Table 3 of the paper: E* = 25 MPa, the heaviest load, in um, uN and MPa.
/// let rubber = Material::new(18.75, 0.5)?;
/// let pair = ElasticPair::new(rubber, Material::rigid())?;
/// let smooth = HertzSphere::new(&pair, 3500.0, 0.15e6)?;
/// let rough = RoughSphere::new(smooth, 0.7518)?;
/// assert!((rough.reduced_pressure() - 0.0404308).abs() < 1e-6);
/// assert!((rough.relative_contact_area() - 0.0806751).abs() < 1e-6);
/// # Ok::<(), stickslip::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct RoughSphere {
    hertz: HertzSphere,
    rms_slope: f64,
    area_coefficient: f64,
    reduced_pressure: f64,
}

impl RoughSphere {
    /// Coefficient $`\kappa`$ of the area. Simulations of self-affine surfaces give 2.0 to 2.2, which the paper rounds
    /// to 2.
    pub const AREA_COEFFICIENT: f64 = 2.0;

    /// Creates the contact `hertz` of the smooth sphere with a roughness of areal root-mean-square slope `rms_slope`
    /// (dimensionless), with $`\kappa`$ = [`AREA_COEFFICIENT`](Self::AREA_COEFFICIENT).
    ///
    /// # Errors
    /// - [`Error::NotPositive`](crate::Error::NotPositive) if the slope or the reduced pressure is not positive and
    ///   finite.
    pub fn new(hertz: HertzSphere, rms_slope: f64) -> Result<Self> {
        positive("root-mean-square slope", rms_slope)?;
        let reduced = hertz.mean_pressure() / hertz.pair().contact_modulus() / rms_slope;
        Ok(Self {
            hertz,
            rms_slope,
            area_coefficient: Self::AREA_COEFFICIENT,
            reduced_pressure: positive("reduced pressure", reduced)?,
        })
    }

    /// Sets the coefficient $`\kappa`$ of the area (dimensionless; default
    /// [`AREA_COEFFICIENT`](Self::AREA_COEFFICIENT)). The documentation of [`Persson`](super::Persson) lists values of other
    /// theories.
    ///
    /// # Errors
    /// - [`Error::NotPositive`](crate::Error::NotPositive) if the coefficient is not positive and finite.
    pub fn with_area_coefficient(self, area_coefficient: f64) -> Result<Self> {
        Ok(Self {
            area_coefficient: positive("area coefficient", area_coefficient)?,
            ..self
        })
    }

    /// Returns the contact of the smooth sphere.
    #[must_use]
    pub fn hertz(&self) -> HertzSphere {
        self.hertz
    }

    /// Returns the areal root-mean-square slope $`g`$.
    #[must_use]
    pub fn rms_slope(&self) -> f64 {
        self.rms_slope
    }

    /// Returns the coefficient of the area $`\kappa`$.
    #[must_use]
    pub fn area_coefficient(&self) -> f64 {
        self.area_coefficient
    }

    /// Returns the reduced pressure $`P = W/\pi a^2E^*g`$ (dimensionless): the mean pressure of the smooth sphere
    /// divided by $`E^*g`$. See equation 37 of the paper.
    #[must_use]
    pub fn reduced_pressure(&self) -> f64 {
        self.reduced_pressure
    }

    /// Returns the area of real contact divided by the area of the Hertz circle, $`A_r`$, between 0 and 1. See equation
    /// 32 of the paper.
    #[must_use]
    pub fn relative_contact_area(&self) -> f64 {
        mean_erf(argument(self.reduced_pressure, self.area_coefficient))
    }

    /// Returns the area of real contact $`A_r\pi a^2`$ (a length squared).
    #[must_use]
    pub fn contact_area(&self) -> f64 {
        self.relative_contact_area() * self.hertz.contact_area()
    }

    /// Computes the relative area $`A_r`$ of any rough sphere at the reduced pressure `reduced_pressure` $`P`$, with
    /// the coefficient `area_coefficient` $`\kappa`$.
    ///
    /// # Errors
    /// - [`Error::NegativeOrNotFinite`](crate::Error::NegativeOrNotFinite) if the pressure is negative or not finite.
    /// - [`Error::NotPositive`](crate::Error::NotPositive) if the coefficient is not positive and finite.
    ///
    /// ```
    /// use stickslip::analytical::RoughSphere;
    /// // The area is proportional to the load under light loads, and equals the whole circle under heavy loads.
    /// assert!((RoughSphere::area_law(1e-6, 2.0)? / 2e-6 - 1.0).abs() < 1e-11);
    /// assert!(RoughSphere::area_law(100.0, 2.0)? > 0.99998);
    /// # Ok::<(), stickslip::Error>(())
    /// ```
    pub fn area_law(reduced_pressure: f64, area_coefficient: f64) -> Result<f64> {
        non_negative("reduced pressure", reduced_pressure)?;
        positive("area coefficient", area_coefficient)?;
        Ok(mean_erf(argument(reduced_pressure, area_coefficient)))
    }
}

/// Returns $`B = \frac{3\sqrt\pi}{4}\kappa P`$.
fn argument(reduced_pressure: f64, area_coefficient: f64) -> f64 {
    0.75 * PI.sqrt() * area_coefficient * reduced_pressure
}

/// Computes $`\int_0^1 \operatorname{erf}(b\sqrt t)\,dt`$ for $`b \ge 0`$.
fn mean_erf(b: f64) -> f64 {
    if b < SERIES_BELOW {
        series(b)
    } else {
        let gauss = 0.5 * FRAC_2_SQRT_PI * (-b * b).exp() / b;
        (1.0 - 0.5 / (b * b)) * libm::erf(b) + gauss
    }
}

/// Argument below which the series converges to round-off within [`TERMS`] terms. Above this argument the closed form
/// has no cancellation.
const SERIES_BELOW: f64 = 1.0;
const TERMS: u32 = 18;

/// Sums the series $`\frac{2}{\sqrt\pi}\sum_n \frac{(-1)^n\,b^{2n+1}}{n!\,(2n+1)(n+\frac32)}`$.
fn series(b: f64) -> f64 {
    let nested = (0..TERMS).rev().map(f64::from).fold(0.0, |sum, n| {
        1.0 / ((2.0 * n + 1.0) * (n + 1.5)) - b * b / (n + 1.0) * sum
    });
    FRAC_2_SQRT_PI * b * nested
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    /// Pairs of argument and integral, computed with 60 digits.
    #[expect(clippy::approx_constant, reason = "it is an argument like the others")]
    const VALUES: [[f64; 2]; 20] = [
        [1e-300, 7.52252778063675e-301],
        [1e-8, 7.52252778063675e-09],
        [1e-3, 0.0007522526276131517],
        [0.05, 0.03759384265388374],
        [0.1, 0.075075149048725],
        [0.3, 0.22169072294002456],
        [0.5, 0.35828270112239824],
        [0.7071, 0.48393763702221304],
        [0.9, 0.5838609929126435],
        [0.99, 0.6246055593951677],
        [1.0, 0.6289041451851548],
        [1.01, 0.6331574752453646],
        [1.2, 0.705626213706931],
        [1.7, 0.8320289205724184],
        [2.5, 0.9200612609900212],
        [4.0, 0.9687500009373248],
        [7.0, 0.9897959183673469],
        [30.0, 0.9994444444444445],
        [1e4, 0.999999995],
        [1e9, 1.0],
    ];

    #[test]
    fn series_meets_closed_form() {
        for b in [0.8, 0.9, 0.999_999_f64] {
            let gauss = (-b * b).exp() / (PI.sqrt() * b);
            let expected = (1.0 - 0.5 / (b * b)) * libm::erf(b) + gauss;
            assert_relative_eq!(mean_erf(b), expected, max_relative = 1e-15);
        }
    }

    #[test]
    fn every_argument_keeps_its_digits() {
        for [b, expected] in VALUES {
            assert_relative_eq!(mean_erf(b), expected, max_relative = 4e-16, epsilon = 0.0);
        }
        assert!(mean_erf(0.0).abs() <= 0.0);
        assert!((mean_erf(f64::INFINITY) - 1.0).abs() <= 0.0);
    }
}
