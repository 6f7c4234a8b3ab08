//! Closed forms of shear.

use crate::analytical::closed_form;
use crate::analytical::{Cone, HertzEllipse, HertzLine, HertzSphere};
use crate::error::OrRaise;
use crate::material::ElasticPair;
use pyo3::prelude::*;

closed_form! {
    /// A sphere in partial slip: a constant normal load, then a tangential force along x that increases monotonically.
    ///
    /// Parameters
    /// ----------
    /// hertz : HertzSphere
    /// friction : float
    /// force : float
    CattaneoMindlin(hertz: HertzSphere => hertz.0, friction: f64 => friction, force: f64 => force)
    objects {
        /// The normal contact.
        hertz: HertzSphere = HertzSphere,
    }
    numbers {
        /// Tangential force F on body 1, positive along +x.
        force,
        /// Radius of the stick disc c = a(1-f)^(1/3) (a length). The paper's equation 27.
        stick_radius,
        /// Fraction of the contact area that sticks, c^2/a^2 = (1-f)^(2/3). The paper's equation 28.
        stick_ratio,
        /// Shift delta _x (a length): the rigid motion of body 2 relative to body 1, of the sign of the force.
        shift,
        /// Shift at which the whole contact begins to slide, delta _0 (a length, positive): the shift under mu W.
        sliding_shift,
        /// Energy dissipated while the force grows from zero to F (a force times a length), zero or positive.
        dissipated_energy,
    }
    pairs {}
    along {
        /// Traction q on body 1 along x (a pressure, of the sign of the force) at the distance r from the centre; zero
        /// outside the contact. The paper's equation 31.
        traction(r),
    }
    across {
        /// Tangential displacement u_x = u_x1 - u_x2 (a length, of the sign of the force), anywhere in the plane.
        displacement,
        /// Slip s_x = u_x - delta _x (a length, opposite to the force) in the ring c < r le a; zero elsewhere.
        slip,
    }
}

closed_form! {
    /// An elliptic paraboloid in partial slip: a constant normal load, then a tangential force along x that increases
    /// monotonically.
    ///
    /// Parameters
    /// ----------
    /// hertz : HertzEllipse
    /// friction : float
    /// force : float
    CattaneoMindlinEllipse(hertz: HertzEllipse => hertz.0, friction: f64 => friction, force: f64 => force)
    objects {
        /// The normal contact.
        hertz: HertzEllipse = HertzEllipse,
    }
    numbers {
        /// Tangential force F on body 1, positive along +x.
        force,
        /// Fraction of the contact area that sticks, (1-f)^(2/3). The paper's equation 28.
        stick_ratio,
        /// Shift delta _x (a length): the rigid motion of body 2 relative to body 1, of the sign of the force. Formula
        /// on the type; Mindlin (1949).
        shift,
        /// Shift at which the whole contact begins to slide, delta _0 (a length, positive): the shift under mu W.
        sliding_shift,
        /// Energy dissipated while the force grows from zero to F (a force times a length), zero or positive; as
        /// CattaneoMindlin::dissipated_energy.
        dissipated_energy,
    }
    pairs {
        /// Semi-axes of the stick ellipse (lengths), along x and along y: (1-f)^(1/3) of those of the contact.
        /// Vermeulen and Johnson (1964).
        stick_semi_axes,
    }
    along {}
    across {
        /// Traction q on body 1 along x (a pressure, of the sign of the force); zero outside the contact. Formula on
        /// the type; Vermeulen and Johnson (1964).
        traction,
    }
}

closed_form! {
    /// A cylinder in partial slip in plane strain: a constant normal load, then a tangential force along x that
    /// increases monotonically, with a bulk strain that increases in proportion to it.
    ///
    /// Parameters
    /// ----------
    /// hertz : HertzLine
    /// friction : float
    /// force : float
    CattaneoMindlinLine(hertz: HertzLine => hertz.0, friction: f64 => friction, force: f64 => force)
    objects {
        /// The normal contact.
        hertz: HertzLine = HertzLine,
    }
    numbers {
        /// Tangential force Q on body 1 (a force per length), positive along +x.
        force,
        /// Half-width c of the strip that sticks (a length).
        stick_half_width,
        /// Middle e of the strip that sticks (a length along x).
        stick_centre,
        /// Energy dissipated per length and cycle of a force between Q and -Q, without bulk strain:
        energy_per_cycle,
    }
    pairs {}
    along {
        /// Traction q on body 1 along x (a pressure) at ``x``; zero outside the contact.
        traction(x),
        /// Shift (a length): the rigid motion of body 2 relative to body 1 along x, of the sign of the force, relative
        /// to the datum d, a length, without bulk strain:
        shift(datum),
    }
    across {}
    also {
        /// With this strain of body 1 along x less that of body 2, positive where it is stretched. A bulk stress sigma
        /// along x in one body strains it by sigma (1 - nu ^2)/E in plane strain.
        fn with_strain(&self, py: Python<'_>, strain: f64) -> PyResult<Self> {
            self.0.with_strain(strain).or_raise(py).map(Self)
        }
    }
}

closed_form! {
    /// A cone in partial slip: a constant normal load, then a tangential force along x that increases monotonically.
    ///
    /// Parameters
    /// ----------
    /// cone : Cone
    /// friction : float
    /// force : float
    ConePartialSlip(cone: Cone => cone.0, friction: f64 => friction, force: f64 => force)
    objects {
        /// The normal contact.
        cone: Cone = Cone,
    }
    numbers {
        /// Tangential force F on body 1, positive along +x.
        force,
        /// Radius of the stick disc c = a(1-f)^(1/2) (a length).
        stick_radius,
        /// Fraction of the contact area that sticks, c^2/a^2 = 1-f.
        stick_ratio,
        /// Shift delta _x (a length): the rigid motion of body 2 relative to body 1, of the sign of the force. Formula
        /// on the type.
        shift,
        /// Shift at which the whole contact begins to slide (a length, positive): the shift under mu W.
        sliding_shift,
    }
    pairs {}
    along {
        /// Traction q on body 1 along x (a pressure, of the sign of the force) at the distance r from the centre; zero
        /// outside the contact. Formula on the type.
        traction(r),
    }
    across {}
}

closed_form! {
    /// A contact circle in full stick under a tangential force along x.
    ///
    /// Parameters
    /// ----------
    /// pair : ElasticPair
    /// contact_radius : float
    /// force : float
    MindlinFullStick(pair: &ElasticPair => &pair.0, contact_radius: f64 => contact_radius, force: f64 => force)
    objects {
        /// The bodies.
        pair: ElasticPair = |pair: &stickslip::ElasticPair| ElasticPair(*pair),
    }
    numbers {
        /// Radius of the contact circle a (a length).
        contact_radius,
        /// Tangential force F on body 1, positive along +x.
        force,
        /// Shift delta _x = F(2-nu )/8Ga (a length): the rigid motion of body 2 relative to body 1, of the sign of the
        /// force. Mindlin (1949).
        shift,
    }
    pairs {}
    along {
        /// Traction q = F/(2pi asqrt(a^2-r^2)) on body 1 along x (a pressure, of the sign of the force) at the
        /// distance r from the centre. It grows without bound towards the edge; at the edge and outside zero is
        /// returned. Johnson (1985), 3.82.
        traction(r),
    }
    across {
        /// Tangential displacement u_x = u_x1 - u_x2 (a length, of the sign of the force), anywhere in the plane: the
        /// shift inside the contact, and outside it
        displacement,
    }
}

closed_form! {
    /// A sphere in partial slip: a constant normal load, and a tangential force along x with any history.
    ///
    /// Parameters
    /// ----------
    /// hertz : HertzSphere
    /// friction : float
    /// path : sequence of float
    MindlinDeresiewicz(hertz: HertzSphere => hertz.0, friction: f64 => friction, path: Vec<f64> => &path)
    objects {
        /// The normal contact.
        hertz: HertzSphere = HertzSphere,
    }
    numbers {
        /// Tangential force F on body 1 at the end of the path, positive along +x.
        force,
        /// Largest magnitude F_0 of the force so far.
        amplitude,
        /// Radius of the disc that has not slipped since the last reversal of the force (a length).
        stick_radius,
        /// Shift delta _x (a length): the rigid motion of body 2 relative to body 1, measured from the state before the
        /// first loading. Formula on the type; Johnson (1985), 7.54.
        shift,
        /// Shift at which the whole contact begins to slide at the first loading, delta _0 (a length, positive).
        sliding_shift,
        /// Energy dissipated along the whole path (a force times a length), zero or positive.
        dissipated_energy,
        /// Energy that one full cycle of the force between pm F_0 dissipates (a force times a length), with F_0 the
        /// amplitude.
        energy_per_cycle,
    }
    pairs {}
    along {
        /// Traction q on body 1 along x (a pressure) at the distance r from the centre; zero outside the contact.
        /// Formula on the type; Johnson (1985), 7.53.
        traction(r),
    }
    across {
        /// Tangential displacement u_x = u_x1 - u_x2 (a length), anywhere in the plane: the same superposition of
        /// CattaneoMindlin::displacement as for the traction.
        displacement,
        /// Slip s_x = u_x - delta _x in the contact (a length): the motion of the surface of body 1 over that of body 2
        /// since before the first loading. It is zero elsewhere, and where the surfaces have never slipped.
        slip,
    }
}

closed_form! {
    /// A sphere in torsion: a constant normal load, then a twist about the normal that increases monotonically.
    ///
    /// Parameters
    /// ----------
    /// hertz : HertzSphere
    /// friction : float
    /// twist : float
    LubkinTorsion(hertz: HertzSphere => hertz.0, friction: f64 => friction, twist: f64 => twist)
    objects {
        /// The normal contact.
        hertz: HertzSphere = HertzSphere,
    }
    numbers {
        /// Twist beta (an angle): the rigid rotation of body 2 relative to body 1, positive from x to y.
        twist,
        /// Radius of the stick disc c (a length), positive. Formula on the type; Lubkin (1951).
        stick_radius,
        /// Fraction of the contact area that sticks, c^2/a^2.
        stick_ratio,
        /// Moment M about the normal on body 1 (a force times a length), of the sign of the twist. Formula on the type;
        /// (16/3) G a^3 beta for small twists. Lubkin (1951).
        moment,
        /// Moment at which the whole contact slides, (3 pi/16) mu W a (a force times a length, positive): the
        /// limit of the moment for large twists.
        sliding_moment,
    }
    pairs {}
    along {
        /// Traction q on body 1 (a pressure, of the sign of the twist) at the distance r from the centre, along the
        /// circle of that radius from x to y: q_x = -qy/r, q_y = qx/r. Zero outside the contact. Formula on the type;
        /// Lubkin (1951).
        traction(r),
    }
    across {}
}
