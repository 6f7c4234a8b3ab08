//! Cylinders in plane strain: pressed, sheared in partial slip, and stretched.

use std::f64::consts::PI;

use super::held_force::HeldForce;
use super::hertz::dome;
use crate::error::{Result, at_least, finite, positive};
use crate::material::ElasticPair;

/// A cylinder pressed on a half-space along a line, in plane strain.
///
/// For two cylinders $`1/R = 1/R_1 + 1/R_2`$. The initial gap is $`x^2/2R`$, and under the load P per unit length
///
/// ```math
/// a^2 = \frac{4PR}{\pi E^*}, \qquad p_0 = \frac{2P}{\pi a}, \qquad p = p_0\sqrt{1-\frac{x^2}{a^2}} .
/// ```
///
/// Exact for a parabola and elastic half-spaces. Johnson (1985), 4.43-4.45.
///
/// ```
/// use stickslip::analytical::HertzLine;
/// use stickslip::{Boundary, ElasticPair, Grid, HalfSpace, Material, NormalControl, NormalProblem, surface};
/// // A steel roller of radius 10 mm under 100 N/mm, in mm, N and MPa.
/// let steel = Material::new(210e3, 0.3)?;
/// let pair = ElasticPair::new(steel, steel)?;
/// let hertz = HertzLine::new(&pair, 10.0, 100.0)?;
/// assert!((hertz.half_width() - 0.10504).abs() < 1e-5 && (hertz.max_pressure() - 606.1).abs() < 0.1);
///
/// let grid = Grid::line(256, 0.0012)?;
/// let bodies = HalfSpace::with_boundary(grid, pair, Boundary::PeriodicAlongY { datum: 50.0 })?;
/// let roller = surface::cylinder(grid, 10.0)?;
/// let contact = NormalProblem::builder(&bodies, &roller, NormalControl::Force(100.0)).build()?.solve()?;
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
    displacement: f64,
}

impl HertzLine {
    /// The contact of a cylinder of radius `radius` (a length) under the normal load `load` (a force per length).
    ///
    /// # Errors
    /// [`Error::NotPositive`](crate::Error::NotPositive) if the radius, the load or a result is not positive and finite.
    pub fn new(pair: &ElasticPair, radius: f64, load: f64) -> Result<Self> {
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

    /// The bodies.
    #[must_use]
    pub fn pair(&self) -> &ElasticPair {
        &self.pair
    }

    /// Radius of the cylinder R (a length).
    #[must_use]
    pub fn radius(&self) -> f64 {
        self.radius
    }

    /// Normal load P (a force per length), positive in compression.
    #[must_use]
    pub fn load(&self) -> f64 {
        self.load
    }

    /// Half-width of the contact $`a = (4PR/\pi E^*)^{1/2}`$ (a length). Johnson (1985), 4.43.
    #[must_use]
    pub fn half_width(&self) -> f64 {
        self.half_width
    }

    /// Pressure at the middle $`p_0 = 2P/\pi a`$. Johnson (1985), 4.45.
    #[must_use]
    pub fn max_pressure(&self) -> f64 {
        self.max_pressure
    }

    /// Pressure at the distance `x` from the middle; zero outside the contact. Johnson (1985), 4.44.
    #[must_use]
    pub fn pressure(&self, x: f64) -> f64 {
        self.max_pressure * dome(x.abs() / self.half_width)
    }

    /// Approach of the bodies (a length) relative to the [datum](crate::Boundary::PeriodicAlongY) d, a length:
    ///
    /// ```math
    /// \delta = \frac{P}{\pi E^*}\left(2\ln\frac{2d}{a} + 1\right) .
    /// ```
    ///
    /// Positive for a datum d > 0 that is large beside a, as it must be. By integration of Johnson (1985), 2.24, over the
    /// pressure.
    #[must_use]
    pub fn approach(&self, datum: f64) -> f64 {
        self.displacement * (2.0 * (2.0 * datum / self.half_width).ln() + 1.0)
    }
}

/// A cylinder in partial slip in plane strain: a constant normal load, then a tangential force along x that increases
/// monotonically, with a bulk strain that increases in proportion to it.
///
/// With $`f = |Q|/\mu P`$, a strip of half-width c sticks; the rest slips, opposite to the traction:
///
/// ```math
/// \frac ca = (1-f)^{1/2}, \qquad
/// q = \pm\mu p_0\left[\sqrt{1-\frac{x^2}{a^2}} - \frac ca\sqrt{1-\frac{(x-e)^2}{c^2}}\,H(c-|x-e|)\right], \qquad
/// e = \pm\frac{a E^*}{2 \mu p_0}\,\varepsilon
/// ```
///
/// with the sign of Q, and the strain $`\varepsilon`$ of body 1 less that of body 2 (zero by default). Equal bodies, or
/// bodies of [`dundurs_beta`](ElasticPair::dundurs_beta) zero. Johnson (1985), section 7.2; with bulk strain Nowell &
/// Hills, Int. J. Mech. Sci. 29 (1987) 355.
///
/// ```
/// use stickslip::{ElasticPair, Material, analytical::{CattaneoMindlinLine, HertzLine}};
/// let steel = Material::new(210e3, 0.3)?;
/// let hertz = HertzLine::new(&ElasticPair::new(steel, steel)?, 10.0, 100.0)?;
/// let shear = CattaneoMindlinLine::new(hertz, 0.5, 37.5)?;
/// assert!((shear.stick_half_width() / hertz.half_width() - 0.5).abs() < 1e-15);
/// // A bulk stress of 100 MPa stretches body 1, and shifts the strip that sticks.
/// let strain = 100.0 * (1.0 - 0.3 * 0.3) / 210e3;
/// let stretched = shear.with_strain(strain)?;
/// let shift = hertz.half_width() * 100.0 / (4.0 * 0.5 * hertz.max_pressure());
/// assert!((stretched.stick_centre() - shift).abs() < 1e-15);
/// # Ok::<(), stickslip::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct CattaneoMindlinLine {
    hertz: HertzLine,
    held: HeldForce,
    /// Middle of the strip that sticks.
    centre: f64,
}

impl CattaneoMindlinLine {
    /// The contact `hertz`, with the coefficient of friction `friction`, under the tangential force `force` on body 1
    /// along x (a force per length, of either sign), without bulk strain.
    ///
    /// # Errors
    /// [`Error::Negative`](crate::Error::Negative) for the friction, [`Error::NotFinite`](crate::Error::NotFinite) for the force,
    /// [`Error::BeyondFrictionCapacity`](crate::Error::BeyondFrictionCapacity) if the force exceeds $`\mu P`$.
    pub fn new(hertz: HertzLine, friction: f64, force: f64) -> Result<Self> {
        Ok(Self {
            hertz,
            held: HeldForce::new(hertz.load, friction, force)?,
            centre: 0.0,
        })
    }

    /// With this strain of body 1 along x less that of body 2, positive where it is stretched. A bulk stress $`\sigma`$
    /// along x in one body strains it by $`\sigma (1 - \nu^2)/E`$ in plane strain.
    ///
    /// # Errors
    /// [`Error::NotFinite`](crate::Error::NotFinite); [`Error::NotPositive`](crate::Error::NotPositive) without friction, if there
    /// is strain; [`Error::Below`](crate::Error::Below) if the strip that sticks would leave the contact, $`|e| + c > a`$: slip
    /// then reverses at one end, and the formula does not hold.
    pub fn with_strain(mut self, strain: f64) -> Result<Self> {
        finite("bulk strain", strain)?;
        if strain == 0.0 {
            self.centre = 0.0;
            return Ok(self);
        }
        positive("coefficient of friction", self.held.friction)?;
        let HertzLine {
            pair,
            half_width,
            max_pressure,
            ..
        } = self.hertz;
        let slope = 2.0 * self.held.friction * max_pressure / pair.contact_modulus();
        self.centre = self.held.direction * half_width * strain / slope;
        let reach = self.centre.abs() + self.stick_half_width();
        let least_is = "the reach of the strip that sticks";
        at_least(least_is, reach, "half-width of the contact", half_width)?;
        Ok(self)
    }

    /// The normal contact.
    #[must_use]
    pub fn hertz(&self) -> HertzLine {
        self.hertz
    }

    /// Tangential force Q on body 1 (a force per length), positive along +x.
    #[must_use]
    pub fn force(&self) -> f64 {
        self.held.force
    }

    /// Half-width c of the strip that sticks (a length).
    #[must_use]
    pub fn stick_half_width(&self) -> f64 {
        self.hertz.half_width * self.held.reserve.sqrt()
    }

    /// Middle e of the strip that sticks (a length along x).
    #[must_use]
    pub fn stick_centre(&self) -> f64 {
        self.centre
    }

    /// Traction q on body 1 along x (a pressure) at `x`; zero outside the contact.
    #[must_use]
    pub fn traction(&self, x: f64) -> f64 {
        let (a, c) = (self.hertz.half_width, self.stick_half_width());
        let inner = if c > 0.0 {
            c / a * dome((x - self.centre).abs() / c)
        } else {
            0.0
        };
        let limit = self.held.friction * self.hertz.max_pressure;
        self.held.direction * limit * (dome(x.abs() / a) - inner)
    }

    /// Shift (a length): the rigid motion of body 2 relative to body 1 along x, of the sign of the force, relative to the
    /// [datum](crate::Boundary::PeriodicAlongY) d, a length, without bulk strain:
    ///
    /// ```math
    /// \delta_x = \pm\frac{\mu P}{\pi E^*}\left[f\left(2\ln\frac{2d}{a} + 1\right) + (1-f)\ln(1-f)\right] .
    /// ```
    ///
    /// By superposition of the [approaches](HertzLine::approach) of two pressures, which tractions along x in plane strain
    /// repeat.
    #[must_use]
    pub fn shift(&self, datum: f64) -> f64 {
        let HeldForce {
            friction,
            direction,
            fraction,
            reserve,
            ..
        } = self.held;
        let stick = if reserve > 0.0 {
            reserve * (-fraction).ln_1p()
        } else {
            0.0
        };
        let unit = friction * self.hertz.displacement;
        direction * (friction * fraction * self.hertz.approach(datum) + unit * stick)
    }

    /// Energy dissipated per length and cycle of a force between Q and -Q, without bulk strain:
    ///
    /// ```math
    /// \Delta E = \frac{(\mu P)^2}{\pi E^*}\left[4(1-f)\ln(1-f) + 4f - 2f^2\right] .
    /// ```
    ///
    /// The area of the loop of force and [shift](Self::shift), whose branches are the first one scaled by two.
    #[must_use]
    pub fn energy_per_cycle(&self) -> f64 {
        let HeldForce {
            force,
            fraction: f,
            reserve,
            ..
        } = self.held;
        // The bracket over the square of f, in terms that do not cancel.
        let bracket = if f > 0.5 {
            let logarithm = if reserve > 0.0 {
                reserve * reserve.ln()
            } else {
                0.0
            };
            (4.0 * logarithm + 2.0 * f * (2.0 - f)) / (f * f)
        } else {
            let terms = (3..60).map(|k| 4.0 * f.powi(k - 2) / f64::from(k * (k - 1)));
            terms.sum()
        };
        force * force * (self.hertz.displacement / self.hertz.load) * bracket
    }
}
