//! A cylinder pressed on a plane along a line, in plane strain.

use std::f64::consts::PI;

use super::hertz::dome;
use super::line_stress;
use crate::bodies::material::ElasticPair;
use crate::error::{Result, positive};

/// A cylinder pressed on a half-space along a line, in plane strain.
///
/// For two cylinders $`1/R = 1/R_1 + 1/R_2`$. The initial gap is $`x^2/2R`$. Under the load P per unit length,
///
/// ```math
/// a^2 = \frac{4PR}{\pi E^*}, \qquad p_0 = \frac{2P}{\pi a}, \qquad p = p_0\sqrt{1-\frac{x^2}{a^2}} .
/// ```
///
/// The solution is exact for a parabola and elastic half-spaces. Johnson (1985), 4.43-4.45.
///
/// ```
/// use stickslip::analytical::HertzLine;
/// use stickslip::{Boundary, ElasticPair, Grid, HalfSpace, Material, NormalLoad, NormalProblem, surface};
/// // A steel roller of radius 10 mm under 100 N/mm, in mm, N and MPa.
/// let steel = Material::new(210e3, 0.3)?;
/// let pair = ElasticPair::new(steel, steel)?;
/// let hertz = HertzLine::new(&pair, 10.0, 100.0)?;
/// assert!((hertz.half_width() - 0.10504).abs() < 1e-5 && (hertz.max_pressure() - 606.1).abs() < 0.1);
///
/// let grid = Grid::line(256, 0.0012)?;
/// let bodies = HalfSpace::with_boundary(grid, pair, Boundary::PeriodicAlongY { datum: 50.0 })?;
/// let roller = surface::cylinder(grid, 10.0)?;
/// let contact = NormalProblem::builder(&bodies, &roller, NormalLoad::Force(100.0)).build()?.solve()?;
/// assert!((contact.pressure().max() / hertz.max_pressure() - 1.0).abs() < 1e-4);
/// assert!((contact.approach() / hertz.approach(50.0) - 1.0).abs() < 1e-5);
/// # Ok::<(), stickslip::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct HertzLine {
    pair: ElasticPair,
    radius: f64,
    load: f64,
    half_width: f64,
    max_pressure: f64,
    /// $`P/\pi E^*`$, the unit of displacements.
    pub(super) displacement: f64,
}

impl HertzLine {
    /// Creates the contact of a cylinder of radius `radius` (a length) under the normal load `load` (a force per
    /// length).
    ///
    /// # Errors
    /// - [`Error::NotPositive`](crate::Error::NotPositive) if the radius, the load or a result is not positive and
    ///   finite.
    /// - [`Error::UnsupportedForCoatings`](crate::Error::UnsupportedForCoatings) if a body is coated.
    pub fn new(pair: &ElasticPair, radius: f64, load: f64) -> Result<Self> {
        pair.check_closed_form()?;
        positive("radius", radius)?;
        positive("load per length", load)?;
        let displacement = load / pair.contact_modulus() / PI;
        let a = (4.0 * displacement * radius).sqrt();
        Ok(Self {
            pair: *pair,
            radius,
            load,
            half_width: positive("half-width of the contact", a)?,
            max_pressure: positive("maximum pressure", 2.0 * load / PI / a)?,
            displacement: positive("displacement", displacement)?,
        })
    }

    /// Returns the bodies.
    #[must_use]
    pub fn pair(&self) -> &ElasticPair {
        &self.pair
    }

    /// Returns the radius R of the cylinder (a length).
    #[must_use]
    pub fn radius(&self) -> f64 {
        self.radius
    }

    /// Returns the normal load P (a force per length), positive in compression.
    #[must_use]
    pub fn load(&self) -> f64 {
        self.load
    }

    /// Returns the half-width of the contact $`a = (4PR/\pi E^*)^{1/2}`$ (a length). Johnson (1985), 4.43.
    #[must_use]
    pub fn half_width(&self) -> f64 {
        self.half_width
    }

    /// Returns the pressure at the middle $`p_0 = 2P/\pi a`$. Johnson (1985), 4.45.
    #[must_use]
    pub fn max_pressure(&self) -> f64 {
        self.max_pressure
    }

    /// Returns the pressure at the distance `x` from the middle. It is zero outside the contact. Johnson (1985), 4.44.
    #[must_use]
    pub fn pressure(&self, x: f64) -> f64 {
        self.max_pressure * dome(x.abs() / self.half_width)
    }

    /// Returns the approach of the bodies (a length) relative to the [datum](crate::Boundary::PeriodicAlongY) d (a
    /// length):
    ///
    /// ```math
    /// \delta = \frac{P}{\pi E^*}\left(2\ln\frac{2d}{a} + 1\right) .
    /// ```
    ///
    /// The datum d > 0 must be large compared with a. The approach is then positive. It is NaN if the datum is zero or negative.
    /// The formula is the integral of Johnson (1985), 2.24, over the pressure.
    #[must_use]
    pub fn approach(&self, datum: f64) -> f64 {
        let datum = if datum > 0.0 { datum } else { f64::NAN };
        self.displacement * (2.0 * (2.0 * datum / self.half_width).ln() + 1.0)
    }

    /// Returns the stress $`\sigma_{xx}`$ of the surface of either body at `x` (a pressure, positive in tension):
    /// $`-p`$ in the contact, zero outside. The stress along y, in plane strain, is
    /// $`\nu (\sigma_{xx} + \sigma_{zz}) = -2 \nu p`$. Johnson (1985), section 4.2.
    #[must_use]
    pub fn surface_stress(&self, x: f64) -> f64 {
        -self.pressure(x)
    }

    /// Returns the stresses `[xx, zz, xz]` of body 1 (pressures, positive in tension) at `x` and at the depth `depth`
    /// below its surface (a length). They are NaN for a negative depth. The stresses of body 2 at the same depth differ by the sign of
    /// `xz`.
    ///
    /// With $`m^2 - n^2 = a^2 - x^2 + z^2`$ and $`mn = xz`$, $`m \ge 0`$:
    ///
    /// ```math
    /// \sigma_{xx} = -\frac{p_0}{a}\left[m\left(1 + \frac{z^2+n^2}{m^2+n^2}\right) - 2z\right], \quad
    /// \sigma_{zz} = -\frac{p_0}{a}\,m\left(1 - \frac{z^2+n^2}{m^2+n^2}\right), \quad
    /// \tau_{xz} = -\frac{p_0}{a}\,n\,\frac{m^2-z^2}{m^2+n^2} .
    /// ```
    ///
    /// M'Ewen (1949); Johnson (1985), 4.49.
    #[must_use]
    pub fn stress(&self, x: f64, depth: f64) -> [f64; 3] {
        if depth < 0.0 {
            return [f64::NAN; 3];
        }
        let a = self.half_width;
        line_stress::of_pressure(x / a, depth / a).map(|stress| self.max_pressure * stress)
    }
}
