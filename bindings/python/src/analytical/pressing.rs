//! Closed forms of pressing.

use crate::analytical::closed_form;
use crate::error::OrRaise;
use crate::material::ElasticPair;
use pyo3::prelude::*;

closed_form! {
    /// A sphere pressed on a half-space, or a paraboloid of revolution.
    ///
    /// Parameters
    /// ----------
    /// pair : ElasticPair
    /// radius : float
    /// load : float
    HertzSphere(pair: &ElasticPair => &pair.0, radius: f64 => radius, load: f64 => load)
    objects {
        /// The bodies.
        pair: ElasticPair = |pair: &stickslip::ElasticPair| ElasticPair(*pair),
    }
    numbers {
        /// Radius of the sphere R (a length).
        radius,
        /// Normal load W (a force), positive in compression.
        load,
        /// Radius of the contact circle a = (3WR/4E^*)^(1/3) (a length). Johnson (1985), 4.22.
        contact_radius,
        /// Area of the contact circle pi a^2 (a length squared).
        contact_area,
        /// Pressure at the centre p_0 = 3W/2pi a^2. Johnson (1985), 4.24.
        max_pressure,
        /// Mean pressure over the contact circle W/pi a^2 = 2/3 p_0.
        mean_pressure,
        /// Approach of the bodies delta = a^2/R (a length), positive. Johnson (1985), 4.23.
        approach,
    }
    pairs {}
    along {
        /// Pressure p = p_0sqrt(1-r^2/a^2) at the distance r from the centre; zero outside the contact. Johnson
        /// (1985), 3.39.
        pressure(r),
        /// Normal displacement of the surfaces (a length), summed over the bodies and positive into each, at the
        /// distance r from the centre, inside and outside the contact.
        displacement(r),
        /// Gap g = u_z + r^2/2R - delta between the surfaces (a length) at the distance r from the centre; zero in the
        /// contact, positive outside.
        gap(r),
    }
    across {}
}

closed_form! {
    /// A paraboloid with two different curvatures pressed on a half-space.
    ///
    /// Parameters
    /// ----------
    /// pair : ElasticPair
    /// radius_x : float
    /// radius_y : float
    /// load : float
    HertzEllipse(pair: &ElasticPair => &pair.0, radius_x: f64 => radius_x, radius_y: f64 => radius_y, load: f64 => load)
    objects {
        /// The bodies.
        pair: ElasticPair = |pair: &stickslip::ElasticPair| ElasticPair(*pair),
    }
    numbers {
        /// Normal load W (a force), positive in compression.
        load,
        /// Area of the contact ellipse pi ab (a length squared).
        contact_area,
        /// Pressure at the centre p_0 = 3W/2pi ab. Johnson (1985), 4.27.
        max_pressure,
        /// Approach of the bodies delta = p_0 b K/E^* (a length), positive. Johnson (1985), 4.26c.
        approach,
    }
    pairs {
        /// Radii of curvature [R_x, R_y] (lengths).
        radii,
        /// Semi-axes of the contact ellipse (lengths), along x and along y. Johnson (1985), 4.28-4.31.
        semi_axes,
    }
    along {}
    across {
        /// Pressure p = p_0sqrt(1-x^2/a_x^2-y^2/a_y^2); zero outside the contact. Johnson (1985), 3.58.
        pressure,
    }
}

closed_form! {
    /// A cylinder pressed on a half-space along a line, in plane strain.
    ///
    /// Parameters
    /// ----------
    /// pair : ElasticPair
    /// radius : float
    /// load : float
    HertzLine(pair: &ElasticPair => &pair.0, radius: f64 => radius, load: f64 => load)
    objects {
        /// The bodies.
        pair: ElasticPair = |pair: &stickslip::ElasticPair| ElasticPair(*pair),
    }
    numbers {
        /// Radius of the cylinder R (a length).
        radius,
        /// Normal load P (a force per length), positive in compression.
        load,
        /// Half-width of the contact a = (4PR/pi E^*)^(1/2) (a length). Johnson (1985), 4.43.
        half_width,
        /// Pressure at the middle p_0 = 2P/pi a. Johnson (1985), 4.45.
        max_pressure,
    }
    pairs {}
    along {
        /// Pressure at the distance ``x`` from the middle; zero outside the contact. Johnson (1985), 4.44.
        pressure(x),
        /// Approach of the bodies (a length) relative to the datum d, a length:
        approach(datum),
    }
    across {}
}

closed_form! {
    /// A blunt cone pressed on a half-space.
    ///
    /// Parameters
    /// ----------
    /// pair : ElasticPair
    /// slope : float
    /// load : float
    Cone(pair: &ElasticPair => &pair.0, slope: f64 => slope, load: f64 => load)
    objects {
        /// The bodies.
        pair: ElasticPair = |pair: &stickslip::ElasticPair| ElasticPair(*pair),
    }
    numbers {
        /// Slope of the flank tan beta .
        slope,
        /// Normal load W (a force), positive in compression.
        load,
        /// Radius of the contact circle a = (2W/pi E^*tan beta )^(1/2) (a length). Sneddon (1965).
        contact_radius,
        /// Area of the contact circle pi a^2 (a length squared).
        contact_area,
        /// Mean pressure over the contact circle 1/2 E^*tan beta , independent of the load.
        mean_pressure,
        /// Approach of the bodies delta = frac pi 2 atan beta (a length), positive. Sneddon (1965).
        approach,
    }
    pairs {}
    along {
        /// Pressure p = (1/2) E^* tan(beta) arcosh(a/r) at the distance r from the centre; infinite at
        /// the apex, zero outside the contact. Sneddon (1965).
        pressure(r),
        /// Normal displacement of the surfaces (a length), summed over the bodies and positive into each, at the
        /// distance r from the centre, inside and outside the contact.
        displacement(r),
        /// Gap g = u_z + rtan beta - delta between the surfaces (a length) at the distance r from the centre; zero in
        /// the contact, positive outside.
        gap(r),
    }
    across {}
}

closed_form! {
    /// The flat end of a rigid round cylinder pressed on a half-space.
    ///
    /// Parameters
    /// ----------
    /// pair : ElasticPair
    /// radius : float
    /// load : float
    FlatPunch(pair: &ElasticPair => &pair.0, radius: f64 => radius, load: f64 => load)
    objects {
        /// The bodies.
        pair: ElasticPair = |pair: &stickslip::ElasticPair| ElasticPair(*pair),
    }
    numbers {
        /// Radius of the flat end, and of the contact circle, a (a length).
        contact_radius,
        /// Area of the contact circle pi a^2 (a length squared).
        contact_area,
        /// Normal load W (a force), positive in compression.
        load,
        /// Mean pressure over the contact circle W/pi a^2, twice the pressure at the centre.
        mean_pressure,
        /// Approach of the bodies delta = W/2aE^* (a length), positive. Johnson (1985), 3.36.
        approach,
    }
    pairs {}
    along {
        /// Pressure p = W/(2pi asqrt(a^2-r^2)) at the distance r from the centre. It grows without bound towards the
        /// edge; at the edge and outside zero is returned. Johnson (1985), section 3.4.
        pressure(r),
        /// Normal displacement of the surfaces (a length), summed over the bodies and positive into each, at the
        /// distance r from the centre: the approach inside the contact, and outside it u_z =
        /// (2 delta/pi) arcsin(a/r). Johnson (1985), 3.37.
        displacement(r),
    }
    across {}
    also {
        /// The punch in full stick under the tangential force ``force`` on body 1 along x (a force, of either sign),
        /// with the coefficient of friction ``friction``.
        fn full_stick(&self, py: Python<'_>, friction: f64, force: f64) -> PyResult<crate::analytical::MindlinFullStick> {
            let form = self.0.full_stick(friction, force).or_raise(py)?;
            Ok(crate::analytical::MindlinFullStick(form))
        }
    }
}

closed_form! {
    /// A flat-ended round punch pressed without any slip, as by friction without limit.
    ///
    /// Parameters
    /// ----------
    /// pair : ElasticPair
    /// radius : float
    /// load : float
    NoSlipPunch(pair: &ElasticPair => &pair.0, radius: f64 => radius, load: f64 => load)
    objects {}
    numbers {
        /// Radius of the flat end, and of the contact circle, a (a length).
        contact_radius,
        /// Normal load W (a force).
        load,
        /// Approach delta (a length).
        approach,
    }
    pairs {}
    along {}
    across {}
}

closed_form! {
    /// A sphere pressed by a growing load without any slip: a point that has come into contact sticks.
    ///
    /// Parameters
    /// ----------
    /// pair : ElasticPair
    /// radius : float
    /// load : float
    NoSlipSphere(pair: &ElasticPair => &pair.0, radius: f64 => radius, load: f64 => load)
    objects {}
    numbers {
        /// Radius of the sphere R (a length).
        radius,
        /// Normal load W (a force).
        load,
        /// Radius of the contact circle a (a length).
        contact_radius,
        /// Approach delta (a length).
        approach,
    }
    pairs {}
    along {}
    across {}
}

closed_form! {
    /// A flat punch with rounded edges pressed on a half-space along a line, in plane strain: the pad of fretting tests
    /// with nearly complete contact.
    ///
    /// Parameters
    /// ----------
    /// pair : ElasticPair
    /// flat : float
    /// radius : float
    /// load : float
    RoundedPunch(pair: &ElasticPair => &pair.0, flat: f64 => flat, radius: f64 => radius, load: f64 => load)
    objects {}
    numbers {
        /// Half-width a of the contact (a length).
        half_width,
    }
    pairs {}
    along {
        /// Pressure at the distance ``x`` from the middle; zero outside the contact.
        pressure(x),
    }
    across {}
}

/// How far bodies of different materials stick when they are pressed together by a growing load alone.
#[pyclass(frozen, eq, module = "stickslip.analytical")]
#[derive(Clone, PartialEq)]
pub(crate) struct SpencePressing(stickslip::analytical::SpencePressing);

#[pymethods]
impl SpencePressing {
    /// The contact of a body of revolution, with this coefficient of friction (dimensionless).
    #[staticmethod]
    fn round(py: Python<'_>, pair: &ElasticPair, friction: f64) -> PyResult<Self> {
        stickslip::analytical::SpencePressing::round(&pair.0, friction)
            .or_raise(py)
            .map(Self)
    }

    /// The contact of a cylinder or strip in plane strain.
    #[staticmethod]
    fn plane(py: Python<'_>, pair: &ElasticPair, friction: f64) -> PyResult<Self> {
        stickslip::analytical::SpencePressing::plane(&pair.0, friction)
            .or_raise(py)
            .map(Self)
    }

    /// Radius or half width of the stick zone over that of the contact, in ``[0, 1]``: one without coupling, zero without
    /// friction.
    #[getter]
    fn stick_radius(&self) -> f64 {
        self.0.stick_radius()
    }

    fn __repr__(&self) -> String {
        format!("SpencePressing(stick_radius={:.6e})", self.0.stick_radius())
    }
}
