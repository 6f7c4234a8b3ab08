//! Partial slip under a tangential force that increases monotonically.

use pyo3::prelude::*;

use crate::analytical::closed_form::closed_form;
use crate::analytical::coordinates::{Coordinates, PlaneStrain, Values};
use crate::analytical::{Cone, HertzEllipse, HertzLine, HertzSphere};
use crate::conversion;
use crate::error::OrRaise;
use crate::real::Real;

closed_form! {
    /// A sphere in partial slip: a constant normal load, then a tangential force along x that increases monotonically.
    ///
    /// With f = |F| / (mu W) a disc of radius c = a (1 - f)^(1/3) sticks. The ring around it slips, opposite to the
    /// traction. This is the solution of the scalar model, with traction along x only; for tractions along both axes, it
    /// is exact for nu = 0. The coupling between pressure and traction of dissimilar bodies is neglected. Cattaneo
    /// (1938); Mindlin (1949); Johnson (1985), 7.41-7.44.
    ///
    /// Parameters
    /// ----------
    /// hertz : HertzSphere
    ///     The normal contact.
    /// friction : float
    ///     Coefficient of friction mu (dimensionless), not negative.
    /// force : float
    ///     Tangential force F on body 1 along x, of either sign, at most mu W.
    ///
    /// Raises
    /// ------
    /// NegativeOrNotFinite, NotFinite, BeyondFrictionCapacity
    CattaneoMindlin(hertz: HertzSphere => hertz.0, friction, force)
    objects {
        /// The normal contact.
        hertz: HertzSphere,
    }
    numbers {
        /// Tangential force F on body 1, positive along +x.
        force,
        /// Radius of the stick disc, c = a (1 - f)^(1/3) (a length).
        stick_radius,
        /// Fraction of the contact area that sticks, c^2/a^2 = (1 - f)^(2/3).
        stick_ratio,
        /// Shift delta_x (a length): the rigid motion of body 2 relative to body 1, with the sign of the force and the
        /// magnitude (3 mu W / 16 a) ((2 - nu)/G) (1 - (1 - f)^(2/3)).
        shift,
        /// Shift at which the whole contact begins to slide, delta_0 (a length, positive): the shift under mu W.
        sliding_shift,
        /// Energy dissipated while the force grows from zero to F (a force times a length, not negative): (mu W delta_0 /
        /// 5) (1 - c/a)^3 (1 + 3 c/a + c^2/a^2). This is the first quarter of a cycle.
        energy_of_first_quarter,
        /// Energy dissipated in one full cycle of the force between F and -F (a force times a length), four times the
        /// energy of the first quarter.
        energy_per_cycle,
    }
    along {
        /// Returns the traction on body 1 along x (a pressure, with the sign of the force) at the distance r from the
        /// centre: mu p_0 sqrt(1 - r^2/a^2), minus mu p_0 (c/a) sqrt(1 - r^2/c^2) in the stick disc. The traction is zero
        /// outside the contact.
        traction(r),
    }
    across {
        /// Returns the tangential displacement u_x of body 1 relative to body 2 (a length, with the sign of the force),
        /// anywhere in the plane: shift and slip inside the contact.
        displacement,
        /// Returns the slip u_x - delta_x (a length, opposite to the force) in the ring that slips; zero elsewhere.
        slip,
    }
}

closed_form! {
    /// An elliptic paraboloid in partial slip: a constant normal load, then a tangential force along x that increases
    /// monotonically.
    ///
    /// The stick ellipse is the contact ellipse scaled by s = (1 - f)^(1/3), with f = |F| / (mu W). This is the solution
    /// of the scalar model, with traction along x only. The coupling between pressure and traction of dissimilar bodies
    /// is neglected. Mindlin (1949); Vermeulen and Johnson (1964).
    ///
    /// Parameters
    /// ----------
    /// hertz : HertzEllipse
    ///     The normal contact.
    /// friction : float
    ///     Coefficient of friction mu (dimensionless), not negative.
    /// force : float
    ///     Tangential force F on body 1 along x, of either sign, at most mu W.
    ///
    /// Raises
    /// ------
    /// NegativeOrNotFinite, NotFinite, BeyondFrictionCapacity
    CattaneoMindlinEllipse(hertz: HertzEllipse => hertz.0, friction, force)
    objects {
        /// The normal contact.
        hertz: HertzEllipse,
    }
    numbers {
        /// Tangential force F on body 1, positive along +x.
        force,
        /// Fraction of the contact area that sticks, (1 - f)^(2/3).
        stick_ratio,
        /// Shift (a length): the rigid motion of body 2 relative to body 1, with the sign of the force. Its magnitude
        /// is 1 - s^2 times the shift at which the whole contact begins to slide.
        shift,
        /// Shift at which the whole contact begins to slide (a length, positive): the shift under mu W.
        sliding_shift,
        /// Energy dissipated while the force grows from zero to F (a force times a length, not negative); see
        /// :attr:`CattaneoMindlin.energy_of_first_quarter`.
        energy_of_first_quarter,
        /// Energy dissipated in one full cycle of the force between F and -F (a force times a length), four times the
        /// energy of the first quarter.
        energy_per_cycle,
    }
    pairs {
        /// Semi-axes of the stick ellipse along x and y (lengths): s times the semi-axes of the contact.
        stick_semi_axes,
    }
    across {
        /// Returns the traction on body 1 along x (a pressure, with the sign of the force), or zero outside the contact.
        /// With rho^2 = x^2/a_x^2 + y^2/a_y^2, it is mu p_0 sqrt(1 - rho^2), reduced in the stick ellipse by mu p_0
        /// sqrt(s^2 - rho^2).
        traction,
    }
}

closed_form! {
    /// A cylinder in partial slip in plane strain: a constant normal load, then a tangential force along x that
    /// increases monotonically, together with a proportional bulk strain.
    ///
    /// With f = |Q| / (mu P) a strip of half-width c = a sqrt(1 - f) sticks; the rest slips, opposite to the traction.
    /// The solution is valid for equal bodies and for bodies whose Dundurs' beta is zero. Johnson (1985), section 7.2;
    /// with bulk strain Nowell & Hills, Int. J. Mech. Sci. 29 (1987) 355.
    ///
    /// Parameters
    /// ----------
    /// hertz : HertzLine
    ///     The normal contact.
    /// friction : float
    ///     Coefficient of friction mu (dimensionless), not negative.
    /// force : float
    ///     Tangential force Q on body 1 along x (a force per length), of either sign, at most mu P.
    ///
    /// Raises
    /// ------
    /// NegativeOrNotFinite, NotFinite, BeyondFrictionCapacity, CoupledMaterials
    CattaneoMindlinLine(hertz: HertzLine => hertz.0, friction, force)
    objects {
        /// The normal contact.
        hertz: HertzLine,
    }
    numbers {
        /// Tangential force Q on body 1 (a force per length), positive along +x.
        force,
        /// Half-width of the strip that sticks, c = a sqrt(1 - f) (a length).
        stick_half_width,
        /// Middle of the strip that sticks (a length along x), with the magnitude a E* strain / (2 mu p_0); zero
        /// without strain.
        stick_centre,
        /// Energy dissipated per length while the force, and the strain with it, grow from zero: a quarter of the energy
        /// per cycle.
        energy_of_first_quarter,
        /// Energy dissipated per length in a cycle of the force between Q and -Q with the strain proportional to the
        /// force, ((mu P)^2 / (pi E*)) (4 (1 - f) ln(1 - f) + 4 f - 2 f^2 + 8 f e^2/a^2).
        energy_per_cycle,
    }
    along {
        /// Returns the traction on body 1 along x (a pressure) at x: with the sign of Q, mu p_0 sqrt(1 - x^2/a^2), minus
        /// mu p_0 (c/a) sqrt(1 - (x - e)^2/c^2) in the stick strip with the middle e. The traction is zero outside the
        /// contact.
        traction(x),
        /// Returns the shift (a length): the rigid motion of body 2 relative to body 1 along x, with the sign of the
        /// force, relative to the datum d (a length) of :meth:`Boundary.periodic_along_y`. The strain causes no
        /// displacement at x = 0. The magnitude of the shift is (mu P / (pi E*)) (f (2 ln(2d/a) + 1) + (1 - f) ln(1 -
        /// f) + 2 e^2/a^2). It is NaN if the datum is zero or negative.
        shift(datum),
    }
    also {
        /// Adds a strain along x: the strain of body 1 minus the strain of body 2, positive in tension. In plane strain,
        /// a bulk stress along x in one body causes the strain stress (1 - nu^2) / E; see
        /// :meth:`Material.plane_strain_under`.
        ///
        /// Raises
        /// ------
        /// NotFinite, NotPositive
        /// BelowMinimum
        ///     If the stick strip would extend beyond the contact. The slip then reverses at one end.
        fn with_strain(&self, py: Python<'_>, strain: Real) -> PyResult<Self> {
            self.0.with_strain(strain.0).or_raise(py).map(Self)
        }

        /// Adds bulk stresses along x in bodies 1 and 2 (pressures, positive in tension), which grow proportionally to
        /// the force and strain the bodies in plane strain.
        ///
        /// Raises
        /// ------
        /// Sample, NotFinite, NotPositive, BelowMinimum
        ///     See :meth:`with_strain`.
        fn with_bulk_stress(&self, py: Python<'_>, stress: conversion::BulkStress) -> PyResult<Self> {
            self.0.with_bulk_stress(stress.0).or_raise(py).map(Self)
        }

        /// Returns the stresses xx of the surfaces of body 1 and of body 2 at x (pressures, positive in tension),
        /// including the bulk stress. In body 1 the largest stress is at the trailing edge of the contact with respect
        /// to the traction, x = -a for a positive force, where the stress rises as a square root. Values on a row of
        /// cells therefore converge slowly to this maximum. Johnson (1985), 2.23 and 7.2; Nowell & Hills (1987).
        fn surface_stress(&self, x: Coordinates) -> (Values, Values) {
            x.all_along(|x| self.0.surface_stress(x)).into()
        }

        /// Returns the stresses xx, zz and xz of body 1 and of body 2 at x and at a depth below the surface of each body
        /// (a length, zero or more). Stresses are pressures, positive in tension, and include the bulk stress. Johnson
        /// (1985), 7.2.
        ///
        /// Raises
        /// ------
        /// ArgumentRange
        ///     If a depth is negative.
        fn stress(
            &self,
            py: Python<'_>,
            x: Coordinates,
            depth: Coordinates,
        ) -> PyResult<(PlaneStrain, PlaneStrain)> {
            let depth = depth.check_depth(py)?;
            let [xx, zz, xz, of_two @ ..] = x.all_across(depth, |x, depth| {
                let [one, two] = self.0.stress(x, depth);
                [one[0], one[1], one[2], two[0], two[1], two[2]]
            })?;
            Ok(((xx, zz, xz), of_two.into()))
        }
    }
}

closed_form! {
    /// A cone in partial slip: a constant normal load, then a tangential force along x that increases monotonically.
    ///
    /// The traction is mu times the difference between the pressure under W and the pressure under the reduced load (1 -
    /// f) W, with f = |F| / (mu W). The contact circle under the reduced load is the stick disc. This is the solution of
    /// the scalar model, with traction along x only. The coupling between pressure and traction of dissimilar bodies is
    /// neglected. Ciavarella, J. Appl. Mech. 65 (1998) 998; Jaeger, J. Tribology 120 (1998) 677.
    ///
    /// Parameters
    /// ----------
    /// cone : Cone
    ///     The normal contact.
    /// friction : float
    ///     Coefficient of friction mu (dimensionless), not negative.
    /// force : float
    ///     Tangential force F on body 1 along x, of either sign, at most mu W.
    ///
    /// Raises
    /// ------
    /// NegativeOrNotFinite, NotFinite, BeyondFrictionCapacity
    ConePartialSlip(cone: Cone => cone.0, friction, force)
    objects {
        /// The normal contact.
        cone: Cone,
    }
    numbers {
        /// Tangential force F on body 1, positive along +x.
        force,
        /// Radius of the stick disc, c = a sqrt(1 - f) (a length).
        stick_radius,
        /// Fraction of the contact area that sticks, c^2/a^2 = 1 - f.
        stick_ratio,
        /// Shift (a length): the rigid motion of body 2 relative to body 1, with the sign of the force and the
        /// magnitude mu delta (2 - nu) / (2 (1 - nu)) (1 - sqrt(1 - f)).
        shift,
        /// Shift at which the whole contact begins to slide (a length, positive): the shift under mu W.
        sliding_shift,
    }
    along {
        /// Returns the traction on body 1 along x (a pressure, with the sign of the force) at the distance r from the
        /// centre: (mu E* tan(beta) / 2) arcosh(a/r), minus the same expression with c instead of a in the stick disc.
        /// The traction is zero outside the contact.
        traction(r),
    }
}
