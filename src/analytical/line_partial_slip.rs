//! A cylinder on a plane in partial slip, in plane strain, with or without bulk stress.

use super::held_force::HeldForce;
use super::hertz::dome;
use super::line::HertzLine;
use super::line_stress;
use crate::error::{Error, Result, all_finite, at_least, finite, positive};

/// A cylinder in partial slip in plane strain. Under a constant normal load, a tangential force along x increases monotonically.
/// A bulk strain increases in proportion to the force.
///
/// A strip of half-width c around x = e sticks. The rest of the contact slips, opposite to the traction. With $`f = |Q|/\mu P`$:
///
/// ```math
/// \frac ca = (1-f)^{1/2}, \qquad
/// q = \pm\mu p_0\left[\sqrt{1-\frac{x^2}{a^2}} - \frac ca\sqrt{1-\frac{(x-e)^2}{c^2}}\,H(c-|x-e|)\right], \qquad
/// e = \pm\frac{a E^*}{2 \mu p_0}\,\varepsilon
/// ```
///
/// with the sign of Q and the strain $`\varepsilon`$ of body 1 minus the strain of body 2 (default zero). The bodies must be
/// equal or have a [`dundurs_beta`](crate::ElasticPair::dundurs_beta) of zero. Sources: Johnson (1985), section 7.2, and for
/// bulk strain Nowell & Hills, Int. J. Mech. Sci. 29 (1987) 355.
///
/// ```
/// use stickslip::{ElasticPair, Material, analytical::{CattaneoMindlinLine, HertzLine}};
/// let steel = Material::new(210e3, 0.3)?;
/// let hertz = HertzLine::new(&ElasticPair::new(steel, steel)?, 10.0, 100.0)?;
/// let shear = CattaneoMindlinLine::new(hertz, 0.5, 37.5)?;
/// assert!((shear.stick_half_width() / hertz.half_width() - 0.5).abs() < 1e-15);
/// // A bulk stress of 100 MPa stretches body 1, and shifts the strip that sticks.
/// let stretched = shear.with_bulk_stress([100.0, 0.0])?;
/// let moved = hertz.half_width() * 100.0 / (4.0 * 0.5 * hertz.max_pressure());
/// assert!((stretched.stick_centre() - moved).abs() < 1e-15);
/// // A crack starts in body 1 at the trailing edge.
/// let [tension, _] = stretched.surface_stress(-hertz.half_width());
/// assert!(tension > 100.0 + 0.5 * hertz.max_pressure());
/// # Ok::<(), stickslip::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct CattaneoMindlinLine {
    hertz: HertzLine,
    held: HeldForce,
    /// Centre of the stick strip.
    centre: f64,
    /// Bulk stresses along x of bodies 1 and 2.
    bulk: [f64; 2],
}

impl CattaneoMindlinLine {
    /// Creates the contact `hertz` with the coefficient of friction `friction`, without bulk strain. The tangential force `force`
    /// acts on body 1 along x (a force per length, of either sign).
    ///
    /// # Errors
    /// - [`Error::NegativeOrNotFinite`] if the coefficient of friction is negative or not finite.
    /// - [`Error::NotFinite`] if the force is not finite.
    /// - [`Error::BeyondFrictionCapacity`] if the force exceeds $`\mu P`$.
    /// - [`Error::CoupledMaterials`] if the [`dundurs_beta`](crate::ElasticPair::dundurs_beta) of the bodies is not zero.
    pub fn new(hertz: HertzLine, friction: f64, force: f64) -> Result<Self> {
        let held = HeldForce::new(hertz.load(), friction, force)?;
        if hertz.pair().is_coupled() {
            let beta = hertz.pair().dundurs_beta();
            return Err(Error::CoupledMaterials { beta });
        }
        Ok(Self {
            hertz,
            held,
            centre: 0.0,
            bulk: [0.0; 2],
        })
    }

    /// Sets the bulk stresses along x in bodies 1 and 2 (pressures, positive in tension; default zero). The stresses
    /// grow in proportion to the force. In plane strain they stretch body 1 by $`\sigma_1 (1 - \nu_1^2)/E_1 - \sigma_2
    /// (1 - \nu_2^2)/E_2`$ more than body 2.
    ///
    /// # Errors
    /// - [`Error::Sample`] if a stress is not finite.
    /// - The errors of [`with_strain`](Self::with_strain).
    pub fn with_bulk_stress(self, stress: [f64; 2]) -> Result<Self> {
        all_finite("bulk stress", &stress)?;
        let [one, two] = self.hertz.pair().bodies();
        let strain = one.plane_strain_under(stress[0]) - two.plane_strain_under(stress[1]);
        let mut strained = self.with_strain(strain)?;
        strained.bulk = stress;
        Ok(strained)
    }

    /// Sets the strain of body 1 along x minus the strain of body 2 (positive in tension; default zero). The strain
    /// grows in proportion to the force. Its cause is not a stress along x but, for example, thermal expansion. If a
    /// stress causes the strain, use [`with_bulk_stress`](Self::with_bulk_stress).
    ///
    /// If $`|e| > fa/2`$, the first small loads reverse the slip at one end. Under the growing load this region then slips back.
    /// The remaining effect on the energy is less than 1e-4.
    ///
    /// # Errors
    /// - [`Error::NotFinite`] if the strain is not finite.
    /// - [`Error::NotPositive`] if the strain is not zero and the coefficient of friction is zero.
    /// - [`Error::BelowMinimum`] if the stick strip would leave the contact, $`|e| + c > a`$. Slip then reverses at one end, and
    ///   the formulas are not valid.
    pub fn with_strain(mut self, strain: f64) -> Result<Self> {
        finite("bulk strain", strain)?;
        (self.centre, self.bulk) = (0.0, [0.0; 2]);
        if strain == 0.0 {
            return Ok(self);
        }
        positive("coefficient of friction", self.held.friction)?;
        let (a, modulus) = (self.hertz.half_width(), self.hertz.pair().contact_modulus());
        let slope = 2.0 * self.held.friction * self.hertz.max_pressure() / modulus;
        self.centre = self.held.direction * a * strain / slope;
        let reach = self.centre.abs() + self.stick_half_width();
        let least_is = "the distance of the farther end of the stick strip from the centre";
        at_least(least_is, reach, "half-width of the contact", a)?;
        Ok(self)
    }

    /// Returns the normal contact.
    #[must_use]
    pub fn hertz(&self) -> HertzLine {
        self.hertz
    }

    /// Returns the tangential force Q on body 1 (a force per length), positive along +x.
    #[must_use]
    pub fn force(&self) -> f64 {
        self.held.force
    }

    /// Returns the half-width c of the stick strip (a length).
    #[must_use]
    pub fn stick_half_width(&self) -> f64 {
        self.hertz.half_width() * self.held.reserve.sqrt()
    }

    /// Returns the centre e of the stick strip (a length along x).
    #[must_use]
    pub fn stick_centre(&self) -> f64 {
        self.centre
    }

    /// Returns the traction q on body 1 along x (a pressure) at `x`. It is zero outside the contact.
    #[must_use]
    pub fn traction(&self, x: f64) -> f64 {
        let (a, c) = (self.hertz.half_width(), self.stick_half_width());
        let inner = if c > 0.0 {
            c / a * dome((x - self.centre).abs() / c)
        } else {
            0.0
        };
        let limit = self.held.friction * self.hertz.max_pressure();
        self.held.direction * limit * (dome(x.abs() / a) - inner)
    }

    /// Returns the shift (a length), which is the rigid motion of body 2 relative to body 1 along x. It refers to the
    /// [datum](crate::Boundary::PeriodicAlongY) d (a length), and is NaN if d is zero or negative. The displacement due to the strain
    /// is zero at x = 0:
    ///
    /// ```math
    /// \delta_x = \pm\frac{\mu P}{\pi E^*}\left[f\left(2\ln\frac{2d}{a} + 1\right) + (1-f)\ln(1-f)
    ///   + \frac{2e^2}{a^2}\right] .
    /// ```
    ///
    /// The formula superposes the [approaches](HertzLine::approach) of two pressures, one of them moved by e. Tractions along x
    /// in plane strain cause the same displacements along x as pressures cause along z.
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
        let moved = self.centre / self.hertz.half_width();
        let unit = friction * self.hertz.displacement;
        let approach = friction * fraction * self.hertz.approach(datum);
        direction * (approach + unit * (stick + 2.0 * moved * moved))
    }

    /// Returns the energy dissipated per length while the force and the strain grow from zero: a quarter of the [energy of a
    /// cycle](Self::energy_per_cycle).
    #[must_use]
    pub fn energy_of_first_quarter(&self) -> f64 {
        0.25 * self.energy_per_cycle()
    }

    /// Returns the energy dissipated per length and cycle of a force between Q and -Q, with a strain proportional to the force:
    ///
    /// ```math
    /// \Delta E = \frac{(\mu P)^2}{\pi E^*}\left[4(1-f)\ln(1-f) + 4f - 2f^2 + 8f\,\frac{e^2}{a^2}\right] .
    /// ```
    ///
    /// In each half of a cycle the contact slips twice as far as in the first loading, which dissipates the energy
    /// $`-\mu\int p\,s\,dx`$. By Betti's theorem $`\int p\,u = \int q\,w`$, where w is the displacement due to the
    /// pressure, a parabola where q acts. Without strain the energy is the area of the loop of force and
    /// [shift](Self::shift). With strain the bulk stress does part of the work.
    #[must_use]
    pub fn energy_per_cycle(&self) -> f64 {
        let HeldForce {
            force,
            fraction: f,
            reserve,
            ..
        } = self.held;
        // The bracket divided by the square of f, in terms that do not cancel.
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
        let moved = if self.centre == 0.0 {
            0.0
        } else {
            self.centre / self.hertz.half_width() / f
        };
        let unit = self.hertz.displacement / self.hertz.load();
        force * force * unit * (bracket + 8.0 * f * moved * moved)
    }

    /// Returns the stress $`\sigma_{xx}`$ of the surfaces of body 1 and of body 2 at `x` (pressures, positive in
    /// tension), the [bulk stress](Self::with_bulk_stress) included:
    ///
    /// ```math
    /// \sigma_{xx} = \sigma - p \mp 2\mu p_0\left[\varphi\!\left(\frac xa\right) -
    ///   \frac ca\,\varphi\!\left(\frac{x-e}c\right)\right], \qquad
    /// \varphi(t) = t - \operatorname{sgn}(t)\,\sqrt{t^2-1}\;H(|t|-1)
    /// ```
    ///
    /// for body 1 under a positive force, and with the opposite sign of the bracket for body 2. The stress of body 1 is largest
    /// at the trailing edge, x = -a under a positive force. There it rises as a square root, so the stress on a grid converges
    /// slowly with the cell size. Johnson (1985), 2.23 and 7.2; Nowell & Hills (1987).
    #[must_use]
    pub fn surface_stress(&self, x: f64) -> [f64; 2] {
        self.stress(x, 0.0).map(|[along, ..]| along)
    }

    /// Returns the stresses `[xx, zz, xz]` of body 1 and of body 2 (pressures, positive in tension) at `x` and at the
    /// depth `depth` below their surfaces (a length). They are NaN for a negative depth. The stresses include the [bulk
    /// stress](Self::with_bulk_stress).
    ///
    /// With m and n as defined in [`HertzLine::stress`], the traction $`q_0 \sqrt{1 -
    /// x^2/a^2}`$ on body 1 adds
    ///
    /// ```math
    /// \sigma_{xx} = \frac{q_0}{a}\left[n\left(2 - \frac{z^2-m^2}{m^2+n^2}\right) - 2x\right], \quad
    /// \sigma_{zz} = -\frac{q_0}{a}\,n\,\frac{m^2-z^2}{m^2+n^2}, \quad
    /// \tau_{xz} = -\frac{q_0}{a}\left[m\left(1 + \frac{z^2+n^2}{m^2+n^2}\right) - 2z\right]
    /// ```
    ///
    /// and the stick strip adds the same terms with its own amplitude, half-width and centre. Johnson (1985), 7.2.
    #[must_use]
    pub fn stress(&self, x: f64, depth: f64) -> [[f64; 3]; 2] {
        if depth < 0.0 {
            return [[f64::NAN; 3]; 2];
        }
        let (a, c) = (self.hertz.half_width(), self.stick_half_width());
        let limit = self.held.direction * self.held.friction * self.hertz.max_pressure();
        let mut shear = line_stress::of_traction(x / a, depth / a);
        if c > 0.0 {
            let inner = line_stress::of_traction((x - self.centre) / c, depth / c);
            for (sum, part) in shear.iter_mut().zip(inner) {
                *sum -= c / a * part;
            }
        }
        let press = self.hertz.stress(x, depth);
        let sum = |[side, press_xz, shear_xz]: [f64; 3], bulk: f64| {
            [
                bulk + press[0] + side * limit * shear[0],
                press[1] + side * limit * shear[1],
                press_xz * press[2] + shear_xz * limit * shear[2],
            ]
        };
        let [one, two] = self.bulk;
        [sum([1.0, 1.0, 1.0], one), sum([-1.0, -1.0, 1.0], two)]
    }
}
