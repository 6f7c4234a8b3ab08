//! Contact area and stick ratio of rough surfaces.

use pyo3::prelude::*;
use pyo3::types::PyTuple;

use crate::analytical::HertzSphere;
use crate::analytical::closed_form::{by_keyword, closed_form};
use crate::error::OrRaise;
use crate::material::{ElasticPair, Pair};
use crate::real::Real;

closed_form! {
    /// A nominally flat rough surface pressed on a half-space: the fraction of the area in real contact.
    ///
    /// The contact fraction is erf((sqrt(pi)/2) kappa P), where P = mean_pressure / (E* rms_slope) is the reduced
    /// pressure. For light loads it is kappa P. The coefficient kappa is sqrt(8/pi) in Persson's theory (the default) and
    /// sqrt(2 pi) in the theory of Bush, Gibson and Thomas; simulations give 2.0 to 2.2. The fraction is a mean over
    /// infinite surfaces whose shortest waves are resolved. Persson (2001); Bush, Gibson and Thomas (1975).
    ///
    /// Parameters
    /// ----------
    /// pair : ElasticPair or two Materials
    ///     The bodies.
    /// rms_slope : float
    ///     Root mean square of the gradient (Sdq, dimensionless), positive: for an isotropic surface, sqrt(2) times the
    ///     rms slope of profiles.
    /// mean_pressure : float
    ///     Ratio of the load to the nominal area, positive.
    ///
    /// Raises
    /// ------
    /// NotPositive
    Persson(pair: Pair => &pair.0, rms_slope, mean_pressure)
    objects {
        /// The bodies.
        pair: ElasticPair,
    }
    numbers {
        /// Root mean square of the gradient (dimensionless).
        rms_slope,
        /// Mean pressure, the ratio of the load to the nominal area.
        mean_pressure,
        /// Coefficient kappa of the area (dimensionless).
        area_coefficient,
        /// Reduced pressure P = mean_pressure / (E* rms_slope) (dimensionless).
        reduced_pressure,
        /// Fraction of the nominal area in real contact.
        contact_fraction,
    }
    also {
        /// Returns the same contact with a different coefficient kappa (dimensionless, positive).
        fn with_area_coefficient(&self, py: Python<'_>, area_coefficient: Real) -> PyResult<Self> {
            self.0.with_area_coefficient(area_coefficient.0).or_raise(py).map(Self)
        }

        /// Returns the fraction of the real contact area that sticks. It is the ratio of the contact area under 1 - f of
        /// the load to the contact area under the full load, with f = |mean_traction| / (mu mean_pressure). Ciavarella,
        /// J. Appl. Mech. 65 (1998) 998; Jaeger, J. Tribology 120 (1998) 677.
        ///
        /// Parameters
        /// ----------
        /// friction : float
        ///     Coefficient of friction mu (dimensionless), not negative.
        /// mean_traction : float
        ///     Ratio of the tangential force to the nominal area, of either sign.
        ///
        /// Raises
        /// ------
        /// NegativeOrNotFinite, NotFinite, BeyondFrictionCapacity
        fn stick_ratio(&self, py: Python<'_>, friction: Real, mean_traction: Real) -> PyResult<f64> {
            self.0.stick_ratio(friction.0, mean_traction.0).or_raise(py)
        }

        /// Returns the contact fraction of any surface at a reduced pressure P (not negative) for a coefficient kappa
        /// (positive; both dimensionless).
        #[staticmethod]
        fn area_law(py: Python<'_>, reduced_pressure: Real, area_coefficient: Real) -> PyResult<f64> {
            stickslip::analytical::Persson::area_law(reduced_pressure.0, area_coefficient.0).or_raise(py)
        }
    }
}

closed_form! {
    /// A rough sphere pressed on a half-space: the fraction of the Hertz circle in real contact.
    ///
    /// At a pressure p of the smooth sphere, the fraction erf((sqrt(pi)/2) kappa p / (E* rms_slope)) of the area is in
    /// contact; the result is the mean of this fraction over the Hertz circle. It is valid if the heights of the
    /// roughness are small compared with the approach and its wavelengths are small compared with the circle. The default
    /// of kappa is 2. The solution follows Müser (2016).
    ///
    /// Parameters
    /// ----------
    /// hertz : HertzSphere
    ///     The contact of the smooth sphere.
    /// rms_slope : float
    ///     Root mean square of the gradient (Sdq, dimensionless), positive.
    ///
    /// Raises
    /// ------
    /// NotPositive
    RoughSphere(hertz: HertzSphere => hertz.0, rms_slope)
    objects {
        /// The contact of the smooth sphere.
        hertz: HertzSphere,
    }
    numbers {
        /// Root mean square of the gradient (dimensionless).
        rms_slope,
        /// Coefficient kappa of the area (dimensionless).
        area_coefficient,
        /// Reduced pressure P = W / (pi a^2 E* rms_slope) (dimensionless), with the mean pressure of the smooth sphere.
        reduced_pressure,
        /// Ratio of the real contact area to the area of the Hertz circle, between 0 and 1.
        relative_contact_area,
        /// Area of real contact (a length squared).
        contact_area,
    }
    also {
        /// Returns the same contact with a different coefficient kappa (dimensionless, positive), for example one of the
        /// values listed in :class:`Persson`.
        fn with_area_coefficient(&self, py: Python<'_>, area_coefficient: Real) -> PyResult<Self> {
            self.0.with_area_coefficient(area_coefficient.0).or_raise(py).map(Self)
        }

        /// Returns the relative contact area of any rough sphere at a reduced pressure P (not negative) for a coefficient
        /// kappa (positive; both dimensionless).
        #[staticmethod]
        fn area_law(py: Python<'_>, reduced_pressure: Real, area_coefficient: Real) -> PyResult<f64> {
            stickslip::analytical::RoughSphere::area_law(reduced_pressure.0, area_coefficient.0).or_raise(py)
        }
    }
}

/// Returns the stick ratio of a nominally flat rough contact under light loads, 1 - |force| / (friction load), or zero
/// without friction.
///
/// Parameters
/// ----------
/// load : float
///     Normal load (a force), positive.
/// friction : float
///     Coefficient of friction (dimensionless), not negative.
/// force : float
///     Tangential force, of either sign.
///
/// Raises
/// ------
/// NotPositive, NegativeOrNotFinite, NotFinite, BeyondFrictionCapacity
#[pyfunction]
#[pyo3(signature = (*positional, load, friction, force), text_signature = "(*, load, friction, force)")]
pub(crate) fn linear_stick_ratio(
    py: Python<'_>,
    positional: &Bound<'_, PyTuple>,
    load: Real,
    friction: Real,
    force: Real,
) -> PyResult<f64> {
    let keywords = ["load", "friction", "force"];
    by_keyword("linear_stick_ratio", positional, &keywords)?;
    stickslip::analytical::linear_stick_ratio(load.0, friction.0, force.0).or_raise(py)
}
