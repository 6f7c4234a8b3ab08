//! Cones and punches pressed on a half-space without friction.

use pyo3::prelude::*;

use crate::analytical::MindlinFullStick;
use crate::analytical::closed_form::closed_form;
use crate::error::OrRaise;
use crate::material::{ElasticPair, Pair};
use crate::real::Real;

closed_form! {
    /// A blunt cone pressed on a half-space.
    ///
    /// The gap is r tan(beta), with the small angle beta between flank and surface. The mean pressure is independent of
    /// the load, so that the contact area is proportional to the load, as for a rough surface. Sneddon (1965); Johnson
    /// (1985), section 5.2.
    ///
    /// Parameters
    /// ----------
    /// pair : ElasticPair or two Materials
    ///     The bodies.
    /// slope : float
    ///     Slope tan(beta) of the flank (dimensionless), positive.
    /// load : float
    ///     Normal load W (a force), positive.
    ///
    /// Raises
    /// ------
    /// NotPositive
    Cone(pair: Pair => &pair.0, slope, load)
    objects {
        /// The bodies.
        pair: ElasticPair,
    }
    numbers {
        /// Slope tan(beta) of the flank (dimensionless).
        slope,
        /// Normal load W (a force), positive in compression.
        load,
        /// Radius of the contact circle, a = sqrt(2 W / (pi E* tan(beta))) (a length).
        contact_radius,
        /// Area of the contact circle, pi a^2 (a length squared).
        contact_area,
        /// Mean pressure over the contact circle, E* tan(beta) / 2.
        mean_pressure,
        /// Approach of the bodies, delta = (pi/2) a tan(beta) (a length), positive.
        approach,
    }
    along {
        /// Returns the pressure (E* tan(beta) / 2) arcosh(a/r) at the distance r from the centre; infinite at the apex,
        /// zero outside the contact.
        pressure(r),
        /// Returns the normal displacement u_z of the surfaces (a length), summed over the bodies and positive into each,
        /// at the distance r from the centre: delta - r tan(beta) inside the contact, and outside it (a arcsin(a/r) - r +
        /// sqrt(r^2 - a^2)) tan(beta).
        displacement(r),
        /// Returns the gap u_z + r tan(beta) - delta between the surfaces (a length) at the distance r from the centre;
        /// zero in the contact, positive outside.
        gap(r),
    }
}

closed_form! {
    /// The flat end of a rigid round cylinder pressed on a half-space.
    ///
    /// The gap is zero within the radius a, and there is no contact outside it. For two elastic bodies this is the
    /// solution of half-spaces with that gap. Johnson (1985), section 3.4 and 3.36-3.37.
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
    FlatPunch(pair: Pair => &pair.0, radius, load)
    objects {
        /// The bodies.
        pair: ElasticPair,
    }
    numbers {
        /// Radius a of the flat end, and of the contact circle (a length).
        contact_radius,
        /// Area of the contact circle, pi a^2 (a length squared).
        contact_area,
        /// Normal load W (a force), positive in compression.
        load,
        /// Mean pressure over the contact circle, W / (pi a^2), twice the pressure at the centre.
        mean_pressure,
        /// Approach of the bodies, delta = W / (2 a E*) (a length), positive.
        approach,
    }
    along {
        /// Returns the pressure W / (2 pi a sqrt(a^2 - r^2)) at the distance r from the centre. It grows without bound
        /// towards the edge; at the edge and outside, the function returns zero.
        pressure(r),
        /// Returns the normal displacement of the surfaces (a length), summed over the bodies and positive into each, at
        /// the distance r from the centre: the approach inside the contact, and outside it (2 delta / pi) arcsin(a/r).
        displacement(r),
    }
    also {
        /// Returns the solution for the punch in full stick under a tangential force along x. Traction and pressure have
        /// the same distribution. The whole contact therefore sticks up to the force mu W and then slides. This is valid if
        /// pressure and traction are uncoupled: on a rigid punch, if Poisson's ratio is 1/2. Otherwise the edge of the
        /// contact slips under pressing alone (:class:`SpencePressing`).
        ///
        /// Parameters
        /// ----------
        /// friction : float
        ///     Coefficient of friction mu (dimensionless), not negative.
        /// force : float
        ///     Tangential force on body 1 along x, of either sign.
        ///
        /// Raises
        /// ------
        /// NegativeOrNotFinite, NotFinite, BeyondFrictionCapacity
        fn full_stick(&self, py: Python<'_>, friction: Real, force: Real) -> PyResult<MindlinFullStick> {
            self.0.full_stick(friction.0, force.0).or_raise(py).map(Into::into)
        }
    }
}

closed_form! {
    /// A flat punch with rounded edges pressed on a half-space along a line, in plane strain: the pad of fretting tests
    /// with nearly complete contact.
    ///
    /// The gap is zero for |x| <= b and (|x| - b)^2 / 2R beyond. Ciavarella, Hills & Monno, Proc. Inst. Mech. Eng. C 212
    /// (1998) 319.
    ///
    /// Parameters
    /// ----------
    /// pair : ElasticPair or two Materials
    ///     The bodies.
    /// flat : float
    ///     Half-width b of the flat (a length), positive.
    /// radius : float
    ///     Radius R of the edges (a length), positive.
    /// load : float
    ///     Normal load (a force per length), at least a millionth of E* b^2 / 4R.
    ///
    /// Raises
    /// ------
    /// NotPositive, BelowMinimum
    RoundedPunch(pair: Pair => &pair.0, flat, radius, load)
    numbers {
        /// Half-width of the contact (a length).
        half_width,
    }
    along {
        /// Returns the pressure at the distance x from the middle, or zero outside the contact.
        pressure(x),
    }
}
