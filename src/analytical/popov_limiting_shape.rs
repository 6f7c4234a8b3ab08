//! Limiting shape of a paraboloid under fretting wear.

use std::f64::consts::{FRAC_2_PI, PI};

use super::hertz::{arc_cosine, dome};
use super::sines::{arc_minus_sine, sine_minus_arc_cosine};
use crate::bodies::material::ElasticPair;
use crate::error::{Result, at_least, non_negative, positive};

/// Limiting shape of a paraboloid of revolution worn by small oscillations at a constant approach, after wear has
/// ceased.
///
/// The stick disc of radius $`c`$ does not wear. The ring around the disc wears until it carries no pressure and the surfaces
/// just touch. With the initial gap $`r^2/2R`$ and the approach $`d`$, the gap without load is then
///
/// ```math
/// f(r) = \frac2\pi\left\{\frac1R\left[\frac{r^2}{2}\arcsin\frac cr -
/// \frac c2\sqrt{r^2-c^2}\right] + d\left[\frac\pi2-\arcsin\frac cr\right]\right\}
/// \qquad (c < r < b)
/// ```
///
/// and is unchanged elsewhere. The worn and the unworn profile meet at $`b`$. The wear law determines how fast the
/// shape is reached, but not the shape itself. Under a shift that oscillates between $`\pm\delta_x`$, $`c^2/a^2 =
/// 1-\delta_x/\delta_0`$, so c is the [`stick_radius`](super::CattaneoMindlin::stick_radius) of the unworn contact. The
/// solution is exact if [`dundurs_beta`](ElasticPair::dundurs_beta) is zero and the stick disc remains round during
/// wear.
///
/// # Accuracy of simulated wear
///
/// At a Poisson's ratio of zero, wear simulated on 192 x 192 cells reaches the load and the volume of this solution within
/// 1 %. At a Poisson's ratio above zero, slip is larger across the motion, and wear shortens the stick disc in this direction.
/// At a ratio of 0.29 the equivalent stick radius is 0.7 % smaller for c/a = 0.8, and 2 to 3 % smaller for c/a = 0.6. The worn
/// volume then exceeds the volume of this solution by 7 to 10 %, although the load is only 0.3 to 2 % smaller. The volume is more
/// sensitive: 1 % of the stick radius changes it by 9.6 % at c/a = 0.8.
///
/// A stick radius from counted cells is too inaccurate for a comparison of volumes. If $`c`$ is chosen such that this solution
/// has the simulated load, the volumes agree within 0.3 %. Under a constant normal force the approach increases during wear and
/// the stick disc grows. The comparison then requires the final approach.
///
/// Popov (2014).
///
/// ```
/// use stickslip::{ElasticPair, Material, analytical::PopovLimitingShape};
/// // In mm and MPa: a ball of radius 3.5 mm at an approach of 5 micrometres, stick radius half the contact radius.
/// let steel = Material::new(213e3, 0.29)?;
/// let pair = ElasticPair::new(steel, steel)?;
/// let a = (3.5_f64 * 5e-3).sqrt();
/// let worn = PopovLimitingShape::new(&pair, 3.5, 5e-3, 0.5 * a)?;
/// // Wear extends beyond the first contact, and removes the load where it acts.
/// assert!(worn.worn_radius() > a && worn.profile(0.8 * a) > 0.5 * (0.8 * a).powi(2) / 3.5);
/// assert!(worn.pressure(0.4 * a) > 0.0 && worn.pressure(0.6 * a) == 0.0);
/// # Ok::<(), stickslip::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct PopovLimitingShape {
    pair: ElasticPair,
    radius: f64,
    approach: f64,
    stick_radius: f64,
    /// $`1-c^2/a^2`$.
    ring: f64,
    /// $`2\arccos(c/b)`$.
    angle: f64,
    worn_radius: f64,
    load: f64,
}

impl PopovLimitingShape {
    /// Creates the limiting shape of a paraboloid of radius `radius` at the approach `approach`, with a stick disc of
    /// radius `stick_radius` (lengths). A stick radius of zero means gross sliding, under which no load remains.
    ///
    /// # Errors
    /// - [`Error::NotPositive`](crate::Error::NotPositive) if the radius, the approach or the contact radius $`a`$ is
    ///   not positive and finite.
    /// - [`Error::NegativeOrNotFinite`](crate::Error::NegativeOrNotFinite) if the stick radius or the load is negative or not
    ///   finite.
    /// - [`Error::BelowMinimum`](crate::Error::BelowMinimum) if the stick radius exceeds $`a`$.
    /// - [`Error::UnsupportedForCoatings`](crate::Error::UnsupportedForCoatings) if a body is coated.
    pub fn new(pair: &ElasticPair, radius: f64, approach: f64, stick_radius: f64) -> Result<Self> {
        pair.check_closed_form()?;
        positive("radius", radius)?;
        positive("approach", approach)?;
        let c = non_negative("stick radius", stick_radius)?;
        let a = positive("contact radius", radius.sqrt() * approach.sqrt())?;
        at_least("the stick radius", c, "contact radius", a)?;
        // A stick radius intended to equal the contact radius can exceed it by rounding.
        let stick = (c / a).min(1.0);
        let ring = (1.0 - stick) * (1.0 + stick);
        let angle = meeting_angle(stick, ring);
        let load = 2.0 * pair.contact_modulus() * approach * c * (1.0 - stick * stick / 3.0);
        Ok(Self {
            pair: *pair,
            radius,
            approach,
            stick_radius: c,
            ring,
            angle,
            worn_radius: a * (2.0 * angle / (angle + angle.sin())).sqrt(),
            load: non_negative("load", load)?,
        })
    }

    /// Returns the bodies.
    #[must_use]
    pub fn pair(&self) -> &ElasticPair {
        &self.pair
    }

    /// Returns the radius of the paraboloid $`R`$ before wear (a length).
    #[must_use]
    pub fn radius(&self) -> f64 {
        self.radius
    }

    /// Returns the approach of the bodies $`d`$ (a length), constant throughout.
    #[must_use]
    pub fn approach(&self) -> f64 {
        self.approach
    }

    /// Returns the radius of the stick disc, $`c`$ (a length).
    #[must_use]
    pub fn stick_radius(&self) -> f64 {
        self.stick_radius
    }

    /// Returns the radius $`b`$ within which the surfaces are worn (a length), where the profile meets $`r^2/2R`$. The
    /// radius $`b`$ is larger than the radius $`a = \sqrt{Rd}`$ of the contact before wear.
    ///
    /// With $`t = 2\arccos(c/b)`$,
    ///
    /// ```math
    /// 1-\frac{c^2}{a^2} = \frac{\sin t - t\cos t}{t+\sin t}, \qquad
    /// \frac{b^2}{a^2} = \frac{2t}{t+\sin t}
    /// ```
    #[must_use]
    pub fn worn_radius(&self) -> f64 {
        self.worn_radius
    }

    /// Returns the gap without load $`f(r)`$ (a length) at the distance $`r`$ from the centre. It is zero at the centre. The
    /// formula is given on the [type](Self); Popov (2014).
    #[must_use]
    pub fn profile(&self, r: f64) -> f64 {
        0.5 * r * r / self.radius + self.wear_depth(r)
    }

    /// Returns the wear depth $`f(r)-r^2/2R`$ (a length), summed over the bodies, at the distance $`r`$ from the
    /// centre: positive in the ring, zero elsewhere.
    ///
    /// The depth is evaluated as $`\frac2\pi\left[d\varphi - \frac{r^2}{2R}(\varphi+\sin\varphi\cos\varphi)\right]`$
    /// with $`\cos\varphi = c/r`$.
    #[must_use]
    pub fn wear_depth(&self, r: f64) -> f64 {
        let r = r.abs();
        if r <= self.stick_radius || r >= self.worn_radius {
            return 0.0;
        }
        let angle = arc_cosine(self.stick_radius, r);
        let before = 0.5 * r * r / self.radius * (angle + 0.5 * (2.0 * angle).sin());
        (FRAC_2_PI * (self.approach * angle - before)).max(0.0)
    }

    /// Returns the worn volume $`2\pi\int_c^b (f-r^2/2R)\,r\,dr`$ (a length cubed), summed over the bodies.
    ///
    /// With $`t = 2\arccos(c/b)`$ the volume is $`\frac{b^4}{4Rt}\left[t^2-\sin^2 t-\sin t\,(\sin t-t\cos t)\right]`$.
    #[must_use]
    pub fn worn_volume(&self) -> f64 {
        let t = self.angle;
        let sine = t.sin();
        let bracket = arc_minus_sine(t) * (t + sine) - sine * sine_minus_arc_cosine(t);
        let square = self.worn_radius * self.worn_radius;
        square * (square / self.radius) * bracket / (4.0 * t)
    }

    /// Returns the remaining pressure at the distance $`r`$ from the centre. It is zero outside the stick disc.
    ///
    /// ```math
    /// p = \frac{E^*}{\pi}\left[\frac{2}{R}\sqrt{c^2-r^2} +
    /// \left(d-\frac{c^2}{R}\right)\frac{1}{\sqrt{c^2-r^2}}\right]
    /// ```
    ///
    /// The first term is the pressure of a paraboloid. The second term is the pressure of a flat punch, because wear
    /// leaves an edge at $`c`$. This term grows without bound towards the edge.
    #[must_use]
    pub fn pressure(&self, r: f64) -> f64 {
        let rho = r.abs() / self.stick_radius;
        if rho < 1.0 {
            let root = self.stick_radius * dome(rho);
            let flat = self.approach * self.ring / root;
            self.pair.contact_modulus() / PI * (2.0 * root / self.radius + flat)
        } else {
            0.0
        }
    }

    /// Returns the remaining normal load, $`2E^*\left(dc-\frac{c^3}{3R}\right)`$ (a force).
    #[must_use]
    pub fn load(&self) -> f64 {
        self.load
    }
}

/// Computes the angle $`t`$ in $`[0, \pi]`$ at which $`2t\cos^2\frac t2/(t+\sin t)`$ equals $`c^2/a^2`$, the square of
/// `stick`. The function decreases from one to zero. `ring` is $`1-c^2/a^2`$.
fn meeting_angle(stick: f64, ring: f64) -> f64 {
    let lies_beyond = |t: f64| {
        let sum = t + t.sin();
        // Each branch compares the smaller quantity, which is accurate to round-off.
        if stick < 0.5 {
            2.0 * t * (0.5 * t).cos().powi(2) > stick * stick * sum
        } else {
            sine_minus_arc_cosine(t) < ring * sum
        }
    };
    let (mut low, mut high) = (0.0, PI);
    // The smallest angle, for a ring of one rounding error, is 2.6e-8. Its last bit is the 79th, so 80 bisections
    // resolve it.
    for _ in 0..80 {
        let middle = f64::midpoint(low, high);
        if lies_beyond(middle) {
            low = middle;
        } else {
            high = middle;
        }
    }
    f64::midpoint(low, high)
}
