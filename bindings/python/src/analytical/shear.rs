//! Tangential loading without slip, with any load history, and by a twist.

use crate::analytical::HertzSphere;
use crate::analytical::closed_form::closed_form;
use crate::material::{ElasticPair, Pair};

closed_form! {
    /// A contact circle in full stick under a tangential force along x.
    ///
    /// For a sphere, this is the limit of :class:`CattaneoMindlin` for large friction. Under a :class:`FlatPunch` of bodies
    /// whose pressure and traction are uncoupled, it is valid up to sliding. The circle moves along x only, for any nu. The
    /// coupling between pressure and traction of dissimilar bodies is neglected. Mindlin (1949); Johnson (1985), 3.82 and
    /// section 7.2.
    ///
    /// Parameters
    /// ----------
    /// pair : ElasticPair or two Materials
    ///     The bodies.
    /// contact_radius : float
    ///     Radius a of the contact circle (a length), positive.
    /// force : float
    ///     Tangential force F on body 1 along x, of either sign.
    ///
    /// Raises
    /// ------
    /// NotPositive, NotFinite
    MindlinFullStick(pair: Pair => &pair.0, contact_radius, force)
    objects {
        /// The bodies.
        pair: ElasticPair,
    }
    numbers {
        /// Radius a of the contact circle (a length).
        contact_radius,
        /// Tangential force F on body 1, positive along +x.
        force,
        /// Shift F (2 - nu) / (8 G a) (a length): the rigid motion of body 2 relative to body 1, with the sign of the
        /// force.
        shift,
    }
    along {
        /// Returns the traction F / (2 pi a sqrt(a^2 - r^2)) on body 1 along x (a pressure, with the sign of the force)
        /// at the distance r from the centre. It grows without bound towards the edge; at the edge and outside, the
        /// function returns zero.
        traction(r),
    }
    across {
        /// Returns the tangential displacement of body 1 relative to body 2 along x (a length, with the sign of the
        /// force), anywhere in the plane. Inside the contact it is the shift. Outside, at the distance r and the angle
        /// theta, it is F / (4 pi G a) ((2 - nu) s + nu sin(s) cos(s) cos(2 theta)), with sin(s) = a/r.
        displacement,
    }
}

closed_form! {
    /// A sphere in partial slip: a constant normal load, and a tangential force along x with any history.
    ///
    /// From zero to the first reversal, the solution is :class:`CattaneoMindlin`. Every reversal adds twice that solution
    /// for half of the change of force since the reversal. When the force returns to the value of an earlier reversal, it
    /// closes a loop, and the contact continues as if the loop had not occurred. This is the solution of the scalar
    /// model, with traction along x only. The coupling between pressure and traction of dissimilar bodies is neglected.
    /// Mindlin and Deresiewicz (1953); Jaeger (1998); Johnson (1985), 7.52-7.57.
    ///
    /// Parameters
    /// ----------
    /// hertz : HertzSphere
    ///     The normal contact.
    /// friction : float
    ///     Coefficient of friction mu (dimensionless), not negative.
    /// path : sequence of float
    ///     Successive values of the tangential force on body 1 along x, starting from zero (forces, of either sign, at
    ///     most mu W). The force of an empty path is zero.
    ///
    /// Raises
    /// ------
    /// NegativeOrNotFinite, NotFinite, BeyondFrictionCapacity
    MindlinDeresiewicz(hertz: HertzSphere => hertz.0, friction; path: crate::conversion::ForcePath => &path.0)
    objects {
        /// The normal contact.
        hertz: HertzSphere,
    }
    numbers {
        /// Tangential force F on body 1 at the end of the path, positive along +x.
        force,
        /// Largest magnitude F_0 of the force so far.
        amplitude,
        /// Radius of the disc that has not slipped since the last reversal of the force (a length). It is a (1 - |F| /
        /// (mu W))^(1/3) during the first loading, and a (1 - |F - F_n| / (2 mu W))^(1/3) after a reversal at F_n.
        stick_radius,
        /// Shift delta_x (a length): the rigid motion of body 2 relative to body 1 since before the first loading.
        shift,
        /// Shift at which the whole contact begins to slide at the first loading, delta_0 (a length, positive).
        sliding_shift,
        /// Energy dissipated along the whole path (a force times a length, not negative).
        dissipated_energy,
        /// Energy dissipated in one full cycle of the force between F_0 and -F_0 (a force times a length), (4/5) mu W
        /// delta_0 (1 - c/a)^3 (1 + 3 c/a + c^2/a^2) with c = a (1 - F_0 / (mu W))^(1/3).
        energy_per_cycle,
    }
    along {
        /// Returns the traction on body 1 along x (a pressure) at the distance r from the centre, by the superposition of
        /// the class description. The traction is zero outside the contact.
        traction(r),
    }
    across {
        /// Returns the tangential displacement u_x of body 1 relative to body 2 (a length), anywhere in the plane, by the
        /// superposition of the class description.
        displacement,
        /// Returns the slip u_x - delta_x (a length): the motion of the surface of body 1 over that of body 2 since
        /// before the first loading; zero outside the contact and wherever the surfaces have never slipped.
        slip,
    }
}

closed_form! {
    /// A sphere in torsion: a constant normal load, then a twist about the normal that increases monotonically.
    ///
    /// A disc of radius c sticks and rotates rigidly; the ring around it slips. The traction is along circles about the
    /// centre and equals mu p in the ring. The coupling between pressure and traction of dissimilar bodies is neglected. Lubkin
    /// (1951); Johnson (1985), section 7.2.
    ///
    /// Parameters
    /// ----------
    /// hertz : HertzSphere
    ///     The normal contact.
    /// friction : float
    ///     Coefficient of friction mu (dimensionless), positive.
    /// twist : float
    ///     Rotation of body 2 relative to body 1 about the normal (radians), of either sign, positive from x to y.
    ///     The theory assumes small rotations. A twist in degrees is not detected, and gives almost the moment of sliding.
    ///
    /// Raises
    /// ------
    /// NotPositive, NotFinite
    LubkinTorsion(hertz: HertzSphere => hertz.0, friction, twist)
    objects {
        /// The normal contact.
        hertz: HertzSphere,
    }
    numbers {
        /// Twist beta: the rigid rotation of body 2 relative to body 1 (radians), positive from x to y.
        twist,
        /// Radius c of the stick disc (a length), positive, from beta = (mu p_0 / 2G) (K - E) with the complete elliptic
        /// integrals of the parameter 1 - c^2/a^2.
        stick_radius,
        /// Fraction of the contact area that sticks, c^2/a^2.
        stick_ratio,
        /// Moment about the normal on body 1 (a force times a length), with the sign of the twist; (16/3) G a^3 beta
        /// for small twists.
        moment,
        /// Moment at which the whole contact slides, (3 pi / 16) mu W a (a force times a length, positive): the limit of
        /// the moment for large twists.
        sliding_moment,
    }
    along {
        /// Returns the traction q on body 1 (a pressure, with the sign of the twist) at the distance r from the centre,
        /// along the circle of that radius from x to y: q_x = -q y/r, q_y = q x/r. The traction is zero outside the
        /// contact.
        traction(r),
    }
}
