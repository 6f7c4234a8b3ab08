//! Surfaces worn by fretting.

use crate::analytical::closed_form::closed_form;
use crate::material::{ElasticPair, Pair};

closed_form! {
    /// The limiting shape of a paraboloid of revolution worn by small oscillations at a constant approach, when wear has
    /// ceased.
    ///
    /// The stick disc of radius c does not wear. The ring around it wears until it carries no pressure and the surfaces
    /// just touch there. The wear law determines how fast this shape is reached, but not the shape itself. The solution
    /// is exact if Dundurs' beta is zero and the stick disc remains round. Popov (2014).
    ///
    /// Parameters
    /// ----------
    /// pair : ElasticPair or two Materials
    ///     The bodies.
    /// radius : float
    ///     Radius R of the paraboloid before wear, whose gap is r^2 / 2R (a length), positive.
    /// approach : float
    ///     Approach d of the bodies (a length), positive.
    /// stick_radius : float
    ///     Radius c of the stick disc (a length), not negative, at most the contact radius sqrt(R d) before wear; zero
    ///     means gross sliding.
    ///
    /// Raises
    /// ------
    /// NotPositive, NegativeOrNotFinite, BelowMinimum
    PopovLimitingShape(pair: Pair => &pair.0, radius, approach, stick_radius)
    objects {
        /// The bodies.
        pair: ElasticPair,
    }
    numbers {
        /// Radius R of the paraboloid before wear (a length).
        radius,
        /// Approach d of the bodies (a length), constant throughout.
        approach,
        /// Radius c of the stick disc (a length).
        stick_radius,
        /// Radius within which the surfaces are worn (a length), larger than the contact radius before wear.
        worn_radius,
        /// Worn volume (a length cubed), summed over the bodies.
        worn_volume,
        /// Remaining normal load, 2 E* (d c - c^3 / 3R) (a force).
        load,
    }
    along {
        /// Returns the gap without load (a length) at the distance r from the centre, zero at the centre: in the ring
        /// (2/pi) ((r^2/2 arcsin(c/r) - c/2 sqrt(r^2 - c^2)) / R + d (pi/2 - arcsin(c/r))), elsewhere r^2 / 2R.
        profile(r),
        /// Returns the wear depth (a length), summed over the bodies, at the distance r from the centre: positive in the
        /// ring, zero elsewhere.
        wear_depth(r),
        /// Returns the remaining pressure (E*/pi) (2 s / R + (d - c^2/R) / s), with s = sqrt(c^2 - r^2), at the distance
        /// r from the centre, or zero outside the stick disc. The pressure grows without bound towards the edge of the
        /// disc.
        pressure(r),
    }
}
