//! Closed forms of rough, wavy and worn surfaces.

use crate::analytical::HertzSphere;
use crate::analytical::closed_form;
use crate::error::OrRaise;
use crate::material::ElasticPair;
use pyo3::prelude::*;

closed_form! {
    /// A nominally flat rough surface pressed on a half-space: the fraction of the area in real contact.
    ///
    /// Parameters
    /// ----------
    /// pair : ElasticPair
    /// rms_slope : float
    /// mean_pressure : float
    Persson(pair: &ElasticPair => &pair.0, rms_slope: f64 => rms_slope, mean_pressure: f64 => mean_pressure)
    objects {
        /// The bodies.
        pair: ElasticPair = |pair: &stickslip::ElasticPair| ElasticPair(*pair),
    }
    numbers {
        /// Areal root-mean-square slope g.
        rms_slope,
        /// Mean pressure bar p: the load divided by the nominal area.
        mean_pressure,
        /// Coefficient of the area kappa .
        area_coefficient,
        /// Reduced pressure P = bar p/E^*g (a number).
        reduced_pressure,
        /// Fraction of the nominal area in real contact, A/A_0 = erf(B).
        contact_fraction,
    }
    pairs {}
    along {}
    across {}
    also {
        /// The same contact with another coefficient kappa (a number).
        fn with_area_coefficient(&self, py: Python<'_>, area_coefficient: f64) -> PyResult<Self> {
            self.0.with_area_coefficient(area_coefficient).or_raise(py).map(Self)
        }

        /// Fraction of the real contact area that sticks under the mean traction ``mean_traction``, a tangential force
        /// per nominal area of either sign, with the coefficient of friction ``friction``.
        fn stick_ratio(&self, py: Python<'_>, friction: f64, mean_traction: f64) -> PyResult<f64> {
            self.0.stick_ratio(friction, mean_traction).or_raise(py)
        }

        /// The contact fraction A/A_0 of any surface at the reduced pressure ``reduced_pressure`` P, with the
        /// coefficient ``area_coefficient`` kappa .
        #[staticmethod]
        fn area_law(py: Python<'_>, reduced_pressure: f64, area_coefficient: f64) -> PyResult<f64> {
            stickslip::analytical::Persson::area_law(reduced_pressure, area_coefficient).or_raise(py)
        }
    }
}

closed_form! {
    /// A rough sphere pressed on a half-space: the fraction of the Hertz circle in real contact.
    ///
    /// Parameters
    /// ----------
    /// hertz : HertzSphere
    /// rms_slope : float
    RoughSphere(hertz: HertzSphere => hertz.0, rms_slope: f64 => rms_slope)
    objects {
        /// The contact of the smooth sphere.
        hertz: HertzSphere = HertzSphere,
    }
    numbers {
        /// Areal root-mean-square slope g.
        rms_slope,
        /// Coefficient of the area kappa .
        area_coefficient,
        /// Reduced pressure P = W/pi a^2E^*g (a number): the mean pressure of the smooth sphere over E^*g. The paper's
        /// equation 37.
        reduced_pressure,
        /// Area of real contact divided by that of the Hertz circle, A_r, between 0 and 1. The paper's equation 32.
        relative_contact_area,
        /// Area of real contact A_rpi a^2 (a length squared).
        contact_area,
    }
    pairs {}
    along {}
    across {}
    also {
        /// The same contact with another coefficient kappa (a number), for example one of those listed at Persson.
        fn with_area_coefficient(&self, py: Python<'_>, area_coefficient: f64) -> PyResult<Self> {
            self.0.with_area_coefficient(area_coefficient).or_raise(py).map(Self)
        }

        /// The relative area A_r of any rough sphere at the reduced pressure ``reduced_pressure`` P, with the
        /// coefficient ``area_coefficient`` kappa .
        #[staticmethod]
        fn area_law(py: Python<'_>, reduced_pressure: f64, area_coefficient: f64) -> PyResult<f64> {
            stickslip::analytical::RoughSphere::area_law(reduced_pressure, area_coefficient).or_raise(py)
        }
    }
}

closed_form! {
    /// The limiting shape of a paraboloid of revolution worn by small oscillations at a constant approach, when wear
    /// has ceased.
    ///
    /// Parameters
    /// ----------
    /// pair : ElasticPair
    /// radius : float
    /// approach : float
    /// stick_radius : float
    PopovLimitingShape(pair: &ElasticPair => &pair.0, radius: f64 => radius, approach: f64 => approach, stick_radius: f64 => stick_radius)
    objects {
        /// The bodies.
        pair: ElasticPair = |pair: &stickslip::ElasticPair| ElasticPair(*pair),
    }
    numbers {
        /// Radius of the paraboloid R before wear (a length).
        radius,
        /// Approach of the bodies d (a length), constant throughout.
        approach,
        /// Radius of the stick disc, c (a length).
        stick_radius,
        /// Radius b within which the surfaces are worn (a length), where the profile meets r^2/2R: larger than the
        /// first contact's a = sqrt(Rd).
        worn_radius,
        /// Worn volume 2pi int _c^b (f-r^2/2R) r dr (a length cubed), summed over the bodies.
        worn_volume,
        /// Remaining normal load, 2 E^* (d c - c^3/3R) (a force).
        load,
    }
    pairs {}
    along {
        /// Gap without load f(r) (a length) at the distance r from the centre; zero at the centre. Formula on the type;
        /// Popov (2014).
        profile(r),
        /// Wear depth f(r)-r^2/2R (a length), summed over the bodies, at the distance r from the centre: positive in
        /// the ring, zero elsewhere.
        wear_depth(r),
        /// Remaining pressure at the distance r from the centre; zero outside the stick disc.
        pressure(r),
    }
    across {}
}

closed_form! {
    /// A wavy surface pressed on a half-space: waves along x, plane strain.
    ///
    /// Parameters
    /// ----------
    /// pair : ElasticPair
    /// amplitude : float
    /// wavelength : float
    /// mean_pressure : float
    Westergaard(pair: &ElasticPair => &pair.0, amplitude: f64 => amplitude, wavelength: f64 => wavelength, mean_pressure: f64 => mean_pressure)
    objects {
        /// The bodies.
        pair: ElasticPair = |pair: &stickslip::ElasticPair| ElasticPair(*pair),
    }
    numbers {
        /// Amplitude of the waves Delta (a length).
        amplitude,
        /// Wavelength lambda (a length).
        wavelength,
        /// Mean pressure bar p: the load divided by the nominal area.
        mean_pressure,
        /// Lowest mean pressure of full contact, p^* = pi E^*Delta /lambda . Johnson (1985), section 13.2.
        full_contact_pressure,
        /// Half-width of a contact strip a = (lambda/pi) arcsin(sqrt(p_mean/p^*)) (a length); half the wavelength in
        /// full contact.
        contact_half_width,
        /// Fraction of the nominal area in contact, 2a/lambda .
        contact_fraction,
        /// Pressure at the crests: 2sqrt(bar p p^*), in full contact bar p + p^*.
        max_pressure,
        /// Approach of the mean planes of the two surfaces since first touch (a length):
        approach,
    }
    pairs {}
    along {
        /// Pressure p at the distance x from a crest; zero outside the contact. Formula on the type; Johnson (1985),
        /// section 13.2.
        pressure(x),
        /// Gap g between the surfaces (a length) at the distance x from a crest; zero in the contact, positive outside.
        gap(x),
    }
    across {}
    also {
        /// Whether the surfaces touch everywhere, that is bar p ge p^*.
        #[getter]
        fn is_full_contact(&self) -> bool {
            self.0.is_full_contact()
        }
    }
}

closed_form! {
    /// A wavy surface in partial slip: a constant mean pressure, then a traction along x that increases monotonically.
    ///
    /// Parameters
    /// ----------
    /// contact : Westergaard
    /// friction : float
    /// mean_traction : float
    WestergaardPartialSlip(contact: Westergaard => contact.0, friction: f64 => friction, mean_traction: f64 => mean_traction)
    objects {
        /// The normal contact.
        contact: Westergaard = Westergaard,
    }
    numbers {
        /// Mean traction bar q on body 1, positive along +x: the tangential force over the nominal area.
        mean_traction,
        /// Half-width of a stick strip c (a length).
        stick_half_width,
        /// Fraction of the contact area that sticks, c/a.
        stick_ratio,
    }
    pairs {}
    along {
        /// Traction q on body 1 along x (a pressure, of the sign of the mean traction) at the distance x from a crest;
        /// zero outside the contact. Formula on the type.
        traction(x),
    }
    across {}
}
