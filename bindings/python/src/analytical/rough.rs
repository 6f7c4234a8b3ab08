//! Rough surfaces: the area in contact, and how much of it sticks.

use pyo3::prelude::*;

use crate::analytical::HertzSphere;
use crate::analytical::closed_form::closed_form;
use crate::error::OrRaise;
use crate::material::ElasticPair;
use crate::real::Real;

closed_form! {
    /// A nominally flat rough surface pressed on a half-space: the fraction of the area in real contact.
    ///
    /// It is erf((sqrt(pi)/2) kappa P) under the reduced pressure P = mean_pressure / (E* rms_slope), which is kappa P for
    /// light loads. kappa is sqrt(8/pi) in Persson's theory, the default, and sqrt(2 pi) in that of Bush, Gibson and Thomas;
    /// simulations give 2.0 to 2.2. A mean over infinite surfaces whose shortest waves are resolved. Persson (2001); Bush,
    /// Gibson and Thomas (1975).
    ///
    /// Parameters
    /// ----------
    /// pair : ElasticPair
    ///     The bodies.
    /// rms_slope : float
    ///     Root mean square of the gradient (Sdq, dimensionless), positive: sqrt(2) times the slope of profiles of an
    ///     isotropic surface.
    /// mean_pressure : float
    ///     Load over nominal area, positive.
    ///
    /// Raises
    /// ------
    /// NotPositive
    Persson(pair: &ElasticPair => &pair.0, rms_slope, mean_pressure)
    objects {
        /// The bodies.
        pair: ElasticPair,
    }
    numbers {
        /// Root mean square of the gradient (dimensionless).
        rms_slope,
        /// Mean pressure: the load over the nominal area.
        mean_pressure,
        /// Coefficient kappa of the area (dimensionless).
        area_coefficient,
        /// Reduced pressure P = mean_pressure / (E* rms_slope) (dimensionless).
        reduced_pressure,
        /// Fraction of the nominal area in real contact.
        contact_fraction,
    }
    also {
        /// The same contact with another coefficient kappa (dimensionless, positive).
        fn with_area_coefficient(&self, py: Python<'_>, area_coefficient: Real) -> PyResult<Self> {
            self.0.with_area_coefficient(area_coefficient.0).or_raise(py).map(Self)
        }

        /// Fraction of the real contact area that sticks: the contact area under 1 - f of the load over that under all of
        /// it, f = |mean_traction| / (mu mean_pressure). Ciavarella (1998); Jaeger (1998).
        ///
        /// Parameters
        /// ----------
        /// friction : float
        ///     Coefficient of friction mu (dimensionless), not negative.
        /// mean_traction : float
        ///     Tangential force over nominal area, of either sign.
        ///
        /// Raises
        /// ------
        /// NegativeOrNotFinite, NotFinite, BeyondFrictionCapacity
        fn stick_ratio(&self, py: Python<'_>, friction: Real, mean_traction: Real) -> PyResult<f64> {
            self.0.stick_ratio(friction.0, mean_traction.0).or_raise(py)
        }

        /// The contact fraction of any surface at a reduced pressure P (not negative), with a coefficient kappa (positive;
        /// both dimensionless).
        #[staticmethod]
        fn area_law(py: Python<'_>, reduced_pressure: Real, area_coefficient: Real) -> PyResult<f64> {
            stickslip::analytical::Persson::area_law(reduced_pressure.0, area_coefficient.0).or_raise(py)
        }
    }
}

closed_form! {
    /// A rough sphere pressed on a half-space: the fraction of the Hertz circle in real contact.
    ///
    /// Where the pressure of the smooth sphere is p, the fraction erf((sqrt(pi)/2) kappa p / (E* rms_slope)) of the area is
    /// in contact; the ratio is the mean over the Hertz circle. It holds where the roughness is small beside the approach and
    /// fine beside the circle. kappa is 2 by default. After Müser (2016).
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
        /// Area of real contact over that of the Hertz circle, between 0 and 1.
        relative_contact_area,
        /// Area of real contact (a length squared).
        contact_area,
    }
    also {
        /// The same contact with another coefficient kappa (dimensionless, positive), for example one of those that
        /// :class:`Persson` lists.
        fn with_area_coefficient(&self, py: Python<'_>, area_coefficient: Real) -> PyResult<Self> {
            self.0.with_area_coefficient(area_coefficient.0).or_raise(py).map(Self)
        }

        /// The relative area of any rough sphere at a reduced pressure P (not negative), with a coefficient kappa (positive;
        /// both dimensionless).
        #[staticmethod]
        fn area_law(py: Python<'_>, reduced_pressure: Real, area_coefficient: Real) -> PyResult<f64> {
            stickslip::analytical::RoughSphere::area_law(reduced_pressure.0, area_coefficient.0).or_raise(py)
        }
    }
}

/// Stick ratio of a nominally flat rough contact under light loads, 1 - |force| / (friction load); zero without friction.
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
pub(crate) fn linear_stick_ratio(
    py: Python<'_>,
    load: Real,
    friction: Real,
    force: Real,
) -> PyResult<f64> {
    stickslip::analytical::linear_stick_ratio(load.0, friction.0, force.0).or_raise(py)
}
