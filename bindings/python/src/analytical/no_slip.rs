//! Bodies of different materials pressed together with friction.

use pyo3::prelude::*;

use crate::analytical::closed_form::closed_form;
use crate::error::OrRaise;
use crate::material::Pair;
use crate::pickle::picklable;
use crate::real::Real;

closed_form! {
    /// A flat-ended round punch pressed without any slip, as for infinite friction.
    ///
    /// If pressure and traction are coupled (Dundurs' beta is not zero), sticking makes the contact stiffer by the factor
    /// artanh(beta) / beta. Mossakovskii (1954); Borodich & Keer, Proc. R. Soc. Lond. A 460 (2004) 507.
    ///
    /// Parameters
    /// ----------
    /// pair : ElasticPair or two Materials
    ///     The bodies.
    /// radius : float
    ///     Radius a of the flat end (a length), positive.
    /// load : float
    ///     Normal load W (a force), positive.
    ///
    /// Raises
    /// ------
    /// NotPositive
    NoSlipPunch(pair: Pair => &pair.0, radius, load)
    numbers {
        /// Radius a of the flat end, and of the contact circle (a length).
        contact_radius,
        /// Normal load W (a force), positive in compression.
        load,
        /// Approach of the bodies, W beta / (2 a E* artanh(beta)) (a length), positive.
        approach,
    }
}

closed_form! {
    /// A sphere pressed by a growing load without any slip: every point that has come into contact sticks.
    ///
    /// Without coupling between pressure and traction, the solution is that of Hertz. Spence, Proc. R. Soc. Lond. A 305
    /// (1968) 55.
    ///
    /// Parameters
    /// ----------
    /// pair : ElasticPair or two Materials
    ///     The bodies.
    /// radius : float
    ///     Radius R of the sphere (a length), positive.
    /// load : float
    ///     Normal load W (a force), positive.
    ///
    /// Raises
    /// ------
    /// NotPositive
    NoSlipSphere(pair: Pair => &pair.0, radius, load)
    numbers {
        /// Radius R of the sphere (a length).
        radius,
        /// Normal load W (a force), positive in compression.
        load,
        /// Radius of the contact circle (a length).
        contact_radius,
        /// Approach of the bodies (a length), positive.
        approach,
    }
}

/// The stick zone of bodies of different materials that are pressed together by a growing load alone.
///
/// The surfaces slip inwards near the rim of the contact and stick within k times its radius or half-width. Shear does
/// not change the pressure here (one-way coupling). Spence, J. Elasticity 5 (1975) 297, and for plane
/// contacts Proc. Camb. Phil. Soc. 73 (1973) 249; Johnson (1985), section 5.4. The solution is created by :meth:`round` or
/// :meth:`plane`.
#[pyclass(frozen, eq, module = "stickslip.analytical")]
#[derive(Clone, PartialEq)]
pub(crate) struct SpencePressing(stickslip::analytical::SpencePressing);

picklable!(SpencePressing: stickslip::analytical::SpencePressing);

#[pymethods]
impl SpencePressing {
    /// Returns the solution for a body of revolution with this coefficient of friction (dimensionless, not negative).
    #[staticmethod]
    fn round(py: Python<'_>, pair: Pair, friction: Real) -> PyResult<Self> {
        stickslip::analytical::SpencePressing::round(&pair.0, friction.0)
            .or_raise(py)
            .map(Self)
    }

    /// Returns the solution for a cylinder or strip in plane strain with this coefficient of friction (dimensionless, not
    /// negative).
    #[staticmethod]
    fn plane(py: Python<'_>, pair: Pair, friction: Real) -> PyResult<Self> {
        stickslip::analytical::SpencePressing::plane(&pair.0, friction.0)
            .or_raise(py)
            .map(Self)
    }

    /// Ratio k of the radius or half-width of the stick zone to that of the contact, in [0, 1]: one without coupling,
    /// zero without friction.
    #[getter]
    fn stick_radius(&self) -> f64 {
        self.0.stick_radius()
    }

    fn __repr__(&self) -> String {
        format!(
            "SpencePressing(stick_radius={})",
            crate::digits::short(self.0.stick_radius())
        )
    }
}
