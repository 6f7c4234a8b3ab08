//! Flat punch with rounded edges in plane strain.

use std::f64::consts::{FRAC_PI_2, PI};

use crate::bodies::material::ElasticPair;
use crate::error::{Result, at_least, positive};

/// A flat punch with rounded edges pressed on a half-space along a line, in plane strain: the pad of fretting tests with
/// nearly complete contact.
///
/// The gap is zero for $`|x| \le b`$ and $`(|x|-b)^2/2R`$ beyond. Under the load P per unit length the half-width
/// $`a = b/\sin\varphi_0`$ of the contact follows from
///
/// ```math
/// \frac{4PR}{E^* b^2} = \frac{\pi - 2\varphi_0}{\sin^2\varphi_0} - 2\cot\varphi_0 ,
/// ```
///
/// and with $`x = a\sin\varphi`$ the pressure is
///
/// ```math
/// p = \frac{2P}{\pi a}\,\frac{1}{\pi - 2\varphi_0 - \sin 2\varphi_0}\left[(\pi - 2\varphi_0)\cos\varphi
/// + \sin\varphi\,\ln\left|\frac{\sin(\varphi+\varphi_0)}{\sin(\varphi-\varphi_0)}\right|
/// + \sin\varphi_0\,\ln\left|\tan\frac{\varphi+\varphi_0}{2}\tan\frac{\varphi-\varphi_0}{2}\right|\right] .
/// ```
///
/// Ciavarella, Hills & Monno, Proc. Inst. Mech. Eng. C 212 (1998) 319. The tests compare the formulas with a computed
/// contact.
///
/// ```
/// use stickslip::{ElasticPair, Material, analytical::{HertzLine, RoundedPunch}};
/// let steel = Material::new(210e3, 0.3)?;
/// let pair = ElasticPair::new(steel, steel)?;
/// let punch = RoundedPunch::new(&pair, 1.0, 10.0, 100.0)?;
/// // The pressure is highest near the ends; a narrow flat is nearly Hertz's cylinder.
/// assert!(punch.half_width() > 1.0 && punch.pressure(1.0) > 2.0 * punch.pressure(0.0));
/// let (narrow, hertz) = (RoundedPunch::new(&pair, 1e-6, 10.0, 100.0)?, HertzLine::new(&pair, 10.0, 100.0)?);
/// assert!((narrow.half_width() / hertz.half_width() - 1.0).abs() < 1e-4);
/// # Ok::<(), stickslip::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct RoundedPunch {
    load: f64,
    half_width: f64,
    /// $`\varphi_0`$.
    angle: f64,
}

/// Load, in units of $`E^* b^2/4R`$, below which the terms of the pressure cancel.
const LEAST: f64 = 1e-6;

impl RoundedPunch {
    /// Creates the contact of a punch under the normal load `load` (a force per length). The flat has the half-width `flat`, and
    /// the edges have the radius `radius` (lengths).
    ///
    /// # Errors
    /// - [`Error::NotPositive`](crate::Error::NotPositive) if an argument or a result is not positive and finite.
    /// - [`Error::BelowMinimum`](crate::Error::BelowMinimum) if the load is less than a millionth of $`E^* b^2/4R`$, where the
    ///   contact coincides with the flat.
    /// - [`Error::UnsupportedForCoatings`](crate::Error::UnsupportedForCoatings) if a body is coated.
    pub fn new(pair: &ElasticPair, flat: f64, radius: f64, load: f64) -> Result<Self> {
        pair.check_closed_form()?;
        positive("half-width of the flat", flat)?;
        positive("radius of the edges", radius)?;
        positive("load per length", load)?;
        let unit = 0.25 * pair.contact_modulus() * flat * (flat / radius);
        let least_is = "the smallest load of the closed form, 1e-6 E* b^2/4R";
        at_least(least_is, LEAST * unit, "load per length", load)?;
        let wanted = positive("load in units of E* b^2/4R", load / unit)?;
        // The load decreases with the angle. The bisection ends when no floating-point number lies between the bounds.
        let (mut low, mut high) = (0.0_f64, FRAC_PI_2);
        let angle = loop {
            let middle = 0.5 * (low + high);
            if middle <= low || middle >= high {
                break middle;
            }
            let sine = middle.sin();
            if width(middle) / (sine * sine) > wanted {
                low = middle;
            } else {
                high = middle;
            }
        };
        Ok(Self {
            load,
            half_width: positive("half-width of the contact", flat / angle.sin())?,
            angle,
        })
    }

    /// Returns the half-width a of the contact (a length).
    #[must_use]
    pub fn half_width(&self) -> f64 {
        self.half_width
    }

    /// Returns the pressure at the distance `x` from the middle. It is zero outside the contact.
    #[must_use]
    pub fn pressure(&self, x: f64) -> f64 {
        let ratio = x.abs() / self.half_width;
        if ratio >= 1.0 {
            return 0.0;
        }
        let (first, at) = (self.angle, ratio.asin());
        let (sum, difference) = (at + first, (at - first).abs());
        // Both logarithms are infinite at the end of the flat, where their infinite parts cancel.
        let near = (0.5 * difference).max(f64::MIN_POSITIVE);
        let [inner, outer] = [near.sin(), near.cos()];
        let by_place = ratio * (sum.sin() / (2.0 * inner * outer)).abs().ln();
        let by_flat = first.sin() * ((0.5 * sum).tan() * inner / outer).ln();
        let bracket = (PI - 2.0 * first) * at.cos() + by_place + by_flat;
        2.0 * self.load / (PI * self.half_width) * bracket / width(first)
    }
}

/// Returns $`\pi - 2\varphi - \sin 2\varphi`$.
fn width(angle: f64) -> f64 {
    PI - 2.0 * angle - (2.0 * angle).sin()
}
