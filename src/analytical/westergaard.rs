//! Normal contact and partial slip of a wavy surface on a half-space.

use std::f64::consts::{FRAC_2_PI, FRAC_PI_2, PI};

use super::held_force::HeldForce;
use super::sines::hyperbolic_sine_minus_arc;
use crate::bodies::material::ElasticPair;
use crate::error::{Result, finite, positive};

/// A surface with waves along x, pressed on a half-space in plane strain.
///
/// The initial gap is $`\Delta(1-\cos(2\pi x/\lambda))`$, of amplitude $`\Delta`$ and wavelength $`\lambda`$. The
/// contact consists of strips of half-width $`a`$, one at every crest. With the pressure of full contact $`p^*`$ and
/// the mean pressure $`\bar p`$, the load per nominal area,
///
/// ```math
/// p^* = \frac{\pi E^*\Delta}{\lambda}, \qquad \sin^2\frac{\pi a}{\lambda} = \frac{\bar p}{p^*},
/// \qquad p = 2p^*\cos\frac{\pi x}{\lambda}
/// \sqrt{\sin^2\frac{\pi a}{\lambda} - \sin^2\frac{\pi x}{\lambda}}
/// ```
///
/// For $`\bar p \ge p^*`$ the contact is full, and $`p = \bar p + p^*\cos(2\pi x/\lambda)`$.
/// Westergaard (1939); Johnson (1985), section 13.2.
///
/// ```
/// use stickslip::{ElasticPair, Material, analytical::Westergaard};
/// let rubber = Material::new(18.75e6, 0.5)?;
/// let pair = ElasticPair::new(rubber, Material::rigid())?;
/// // E* = 25 MPa, amplitude 1 um, wavelength 100 um: full contact at a mean pressure of 0.785 MPa or more.
/// let waves = Westergaard::new(&pair, 1e-6, 1e-4, 0.25 * 0.7853981634e6)?;
/// assert!((waves.contact_fraction() - 1.0 / 3.0).abs() < 1e-9);
/// assert!((waves.max_pressure() / waves.full_contact_pressure() - 1.0).abs() < 1e-9);
/// # Ok::<(), stickslip::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Westergaard {
    pair: ElasticPair,
    amplitude: f64,
    wavelength: f64,
    mean_pressure: f64,
    full_contact_pressure: f64,
    /// $`\bar p/p^*`$.
    load_ratio: f64,
}

impl Westergaard {
    /// Creates the contact of waves of amplitude `amplitude` (half their height) and wavelength `wavelength` (lengths)
    /// under the mean pressure `mean_pressure`.
    ///
    /// # Errors
    /// - [`Error::NotPositive`](crate::Error::NotPositive) if an argument or a result is not positive and finite.
    /// - [`Error::UnsupportedForCoatings`](crate::Error::UnsupportedForCoatings) if a body is coated.
    pub fn new(
        pair: &ElasticPair,
        amplitude: f64,
        wavelength: f64,
        mean_pressure: f64,
    ) -> Result<Self> {
        pair.check_closed_form()?;
        positive("amplitude", amplitude)?;
        positive("wavelength", wavelength)?;
        positive("mean pressure", mean_pressure)?;
        let full = PI * pair.contact_modulus() * (amplitude / wavelength);
        positive("pressure of full contact", full)?;
        positive("maximum pressure", 2.0 * mean_pressure.max(full))?;
        Ok(Self {
            pair: *pair,
            amplitude,
            wavelength,
            mean_pressure,
            full_contact_pressure: full,
            load_ratio: positive("ratio to full contact", mean_pressure / full)?,
        })
    }

    /// Returns the bodies.
    #[must_use]
    pub fn pair(&self) -> &ElasticPair {
        &self.pair
    }

    /// Returns the amplitude of the waves $`\Delta`$ (a length).
    #[must_use]
    pub fn amplitude(&self) -> f64 {
        self.amplitude
    }

    /// Returns the wavelength $`\lambda`$ (a length).
    #[must_use]
    pub fn wavelength(&self) -> f64 {
        self.wavelength
    }

    /// Returns the mean pressure $`\bar p`$: the load divided by the nominal area.
    #[must_use]
    pub fn mean_pressure(&self) -> f64 {
        self.mean_pressure
    }

    /// Returns the lowest mean pressure of full contact, $`p^* = \pi E^*\Delta/\lambda`$. Johnson (1985), section 13.2.
    #[must_use]
    pub fn full_contact_pressure(&self) -> f64 {
        self.full_contact_pressure
    }

    /// Returns whether the surfaces touch everywhere, that is, $`\bar p \ge p^*`$.
    #[must_use]
    pub fn is_full_contact(&self) -> bool {
        self.load_ratio >= 1.0
    }

    /// Returns the half-width $`a = \frac\lambda\pi\arcsin\sqrt{\bar p/p^*}`$ of a contact strip (a length). In full
    /// contact it is half the wavelength.
    #[must_use]
    pub fn contact_half_width(&self) -> f64 {
        0.5 * self.wavelength * self.contact_fraction()
    }

    /// Returns the fraction of the nominal area in contact, $`2a/\lambda`$.
    #[must_use]
    pub fn contact_fraction(&self) -> f64 {
        FRAC_2_PI * edge(self.load_ratio)
    }

    /// Returns the pressure at the crests: $`2\sqrt{\bar p\,p^*}`$ in partial contact, $`\bar p + p^*`$ in full
    /// contact.
    #[must_use]
    pub fn max_pressure(&self) -> f64 {
        self.pressure(0.0)
    }

    /// Returns the pressure $`p`$ at the distance $`x`$ from a crest. It is zero outside the contact. The formula is
    /// given on the [type](Self); Johnson (1985), section 13.2.
    #[must_use]
    pub fn pressure(&self, x: f64) -> f64 {
        let psi = self.phase(x);
        let strips = 2.0 * psi.cos() * root(edge(self.load_ratio), psi);
        self.full_contact_pressure * (self.excess() + strips)
    }

    /// Returns the gap $`g`$ between the surfaces (a length) at the distance $`x`$ from a crest. It is zero in the
    /// contact and positive outside.
    ///
    /// ```math
    /// g = \Delta\,\frac{\bar p}{p^*}\left(\sinh w - w\right), \qquad
    /// \cosh\frac w2 = \frac{\sin(\pi x/\lambda)}{\sin(\pi a/\lambda)}
    /// ```
    ///
    /// The gap is the integral of the slope
    /// $`\frac{4p^*}{E^*}\cos\frac{\pi x}{\lambda} (\sin^2\frac{\pi x}{\lambda}-\sin^2\frac{\pi a}{\lambda})^{1/2}`$,
    /// the analytic continuation of the pressure beyond the edge.
    #[must_use]
    pub fn gap(&self, x: f64) -> f64 {
        if self.is_full_contact() {
            return 0.0;
        }
        let outside = root(self.phase(x), edge(self.load_ratio));
        let w = 2.0 * (outside / self.load_ratio.sqrt()).asinh();
        self.amplitude * self.load_ratio * hyperbolic_sine_minus_arc(w)
    }

    /// Returns the approach of the mean planes of the two surfaces from first touch (a length):
    ///
    /// ```math
    /// \delta = \Delta\,\frac{\bar p}{p^*}\left(1-\ln\frac{\bar p}{p^*}\right)
    /// ```
    ///
    /// and $`\Delta`$ in full contact. The mean [`gap`](Self::gap) is $`\Delta-\delta`$. The formula follows from
    /// $`d\delta/d\bar p = -\frac{2\lambda}{\pi E^*}\ln\sin\frac{\pi a}{\lambda}`$, the compliance of a row of flat
    /// strips of half-width $`a`$.
    #[must_use]
    pub fn approach(&self) -> f64 {
        let ratio = self.load_ratio.min(1.0);
        self.amplitude * ratio * (1.0 - ratio.ln())
    }

    /// Returns $`(\bar p-p^*)/p^*`$ in full contact, otherwise zero.
    fn excess(&self) -> f64 {
        (self.load_ratio - 1.0).max(0.0)
    }

    /// Returns $`\psi = \pi|x|/\lambda`$, with $`x`$ measured from the nearest crest.
    fn phase(&self, x: f64) -> f64 {
        let waves = x / self.wavelength;
        PI * (waves - waves.round()).abs()
    }
}

/// Returns $`\psi_a = \pi a/\lambda`$ under the load ratio $`\bar p/p^*`$.
fn edge(load_ratio: f64) -> f64 {
    if load_ratio < 1.0 {
        load_ratio.sqrt().atan2((1.0 - load_ratio).sqrt())
    } else {
        FRAC_PI_2
    }
}

/// Returns $`\sqrt{\sin^2\alpha - \sin^2\beta}`$ for $`\beta < \alpha`$, otherwise zero.
fn root(alpha: f64, beta: f64) -> f64 {
    if beta < alpha {
        ((alpha - beta).sin() * (alpha + beta).sin()).sqrt()
    } else {
        0.0
    }
}

/// A wavy surface in partial slip. Under a constant mean pressure, a traction along x increases monotonically.
///
/// With the mean traction $`\bar q`$ and $`f = |\bar q|/\mu\bar p`$, the traction is $`\mu`$ times the
/// difference between the pressure and the pressure under the reduced load:
///
/// ```math
/// q = \mu\,[\,p(\bar p) - p((1-f)\,\bar p)\,], \qquad
/// \sin^2\frac{\pi c}{\lambda} = (1-f)\,\frac{\bar p}{p^*}
/// ```
///
/// where $`c`$ is the half-width of a stick strip. A full contact sticks everywhere, under the uniform traction
/// $`\bar q`$, until $`(1-f)\,\bar p = p^*`$. The bodies are in plane strain and the traction acts along x, across the
/// crests, so the solution is exact for every $`\nu`$. Ciavarella (1998a); Jaeger (1998).
///
/// ```
/// use stickslip::{ElasticPair, Material, analytical::{Westergaard, WestergaardPartialSlip}};
/// let rubber = Material::new(3.0, 0.5)?;
/// let pair = ElasticPair::new(rubber, rubber)?;
/// let waves = Westergaard::new(&pair, 1e-3, 1.0, 1e-3)?;
/// let shear = WestergaardPartialSlip::new(waves, 0.5, 0.75 * 0.5e-3)?;
/// // The stick strips are the contact strips under a quarter of the load, half as wide at light loads.
/// assert!((shear.stick_ratio() - 0.5).abs() < 0.02);
/// # Ok::<(), stickslip::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct WestergaardPartialSlip {
    contact: Westergaard,
    held: HeldForce,
}

impl WestergaardPartialSlip {
    /// Creates the contact `contact` with the coefficient of friction `friction`. The mean traction `mean_traction` on
    /// body 1 along x is a tangential force divided by the nominal area, of either sign.
    ///
    /// A mean traction equal to $`\mu\bar p`$ to within rounding counts as the onset of gross sliding: the stick strips
    /// vanish. Without friction the stick strips also vanish. The coupling between pressure and traction of dissimilar
    /// bodies is neglected.
    ///
    /// # Errors
    /// - [`Error::NegativeOrNotFinite`](crate::Error::NegativeOrNotFinite) if the coefficient of friction is negative or not
    ///   finite.
    /// - [`Error::NotFinite`](crate::Error::NotFinite) if the traction or a result is not finite.
    /// - [`Error::BeyondFrictionCapacity`](crate::Error::BeyondFrictionCapacity), with forces per nominal area, if the
    ///   magnitude of the traction exceeds $`\mu\bar p`$.
    pub fn new(contact: Westergaard, friction: f64, mean_traction: f64) -> Result<Self> {
        let held = HeldForce::new(contact.mean_pressure, friction, mean_traction)?;
        finite("maximum traction", friction * contact.max_pressure())?;
        Ok(Self { contact, held })
    }

    /// Returns the normal contact.
    #[must_use]
    pub fn contact(&self) -> Westergaard {
        self.contact
    }

    /// Returns the mean traction $`\bar q`$ on body 1, positive along +x: the tangential force divided by the nominal
    /// area.
    #[must_use]
    pub fn mean_traction(&self) -> f64 {
        self.held.force
    }

    /// Returns the half-width of a stick strip $`c`$ (a length).
    #[must_use]
    pub fn stick_half_width(&self) -> f64 {
        0.5 * self.contact.wavelength * FRAC_2_PI * edge(self.stick_load_ratio())
    }

    /// Returns the fraction of the contact area that sticks, $`c/a`$.
    #[must_use]
    pub fn stick_ratio(&self) -> f64 {
        edge(self.stick_load_ratio()) / edge(self.contact.load_ratio)
    }

    /// Returns the traction $`q`$ on body 1 along x (a pressure, with the sign of the mean traction) at the distance
    /// $`x`$ from a crest. It is zero outside the contact. The formula is given on the [type](Self).
    ///
    /// In the stick strips the difference of the two roots is evaluated as the difference of their squares
    /// divided by their sum, which avoids cancellation.
    #[must_use]
    pub fn traction(&self, x: f64) -> f64 {
        let psi = self.contact.phase(x);
        let whole = edge(self.contact.load_ratio);
        let stick = edge(self.stick_load_ratio());
        // The tangential load reduces the load ratio: first the part above full contact, then the part that forms
        // strips.
        let taken = self.held.fraction * self.contact.load_ratio;
        let uniform = taken.min(self.contact.excess());
        let pressure = if self.stick_load_ratio() >= 1.0 {
            self.contact.full_contact_pressure * taken
        } else if psi < stick {
            let roots = root(whole, psi) + root(stick, psi);
            let strips = 2.0 * psi.cos() * (taken - uniform) / roots;
            self.contact.full_contact_pressure * (uniform + strips)
        } else {
            self.contact.pressure(x)
        };
        self.held.direction * self.held.friction * pressure
    }

    /// Returns $`(1-f)\,\bar p/p^*`$.
    fn stick_load_ratio(&self) -> f64 {
        self.held.reserve * self.contact.load_ratio
    }
}
