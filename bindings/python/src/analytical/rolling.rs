//! Steady rolling.

use crate::analytical::closed_form::closed_form;
use crate::analytical::{HertzEllipse, HertzLine};
use crate::conversion;
use crate::real::Real;

closed_form! {
    /// A cylinder that rolls steadily with longitudinal creepage, in plane strain: Carter's solution.
    ///
    /// The leading edge is at x = a. A strip of half-width c = a (1 - |xi| / xi_s) that ends there sticks, the rest slips,
    /// against the traction; from the creepage xi_s on all slips. For equal bodies, or bodies of which Dundurs' beta is
    /// zero. Carter (1926); Johnson (1985), section 8.3.
    ///
    /// Parameters
    /// ----------
    /// hertz : HertzLine
    ///     The normal contact.
    /// friction : float
    ///     Coefficient of friction mu (dimensionless), not negative.
    /// creepage : float
    ///     Creepage xi along x (dimensionless), of either sign.
    ///
    /// Raises
    /// ------
    /// NegativeOrNotFinite, NotFinite, CoupledMaterials
    Carter(hertz: HertzLine => hertz.0, friction, creepage)
    numbers {
        /// Tangential force Q on body 1 (a force per length), of the sign of the creepage, of size mu P (1 - c^2/a^2).
        force,
        /// The creepage from which on the whole contact slips (dimensionless), xi_s = 2 mu p_0 / E*.
        sliding_creepage,
        /// Half-width c of the strip that sticks, at the leading edge (a length).
        stick_half_width,
    }
    along {
        /// Traction on body 1 along x (a pressure) at x: with the sign of the creepage, mu p_0 sqrt(1 - x^2/a^2), less
        /// mu p_0 (c/a) sqrt(1 - (x - a + c)^2/c^2) in the strip that sticks; zero outside the contact.
        traction(x),
    }
}

closed_form! {
    /// Cylinders of different materials that roll freely, without a tangential force and with little friction: the limit of
    /// Bentall and Johnson's solution for a friction much less than Dundurs' beta.
    ///
    /// The pressure stretches the surfaces by different amounts: body 1 slips over body 2, for each length rolled, by
    /// s = 2 beta p / E* - xi, and the traction is mu p against the slip. Between bodies of which beta is zero nothing
    /// slips. The leading edge is at +x; with that at -x creepage and slip change their signs. Bentall and Johnson (1967);
    /// Johnson (1985), section 8.2.
    ///
    /// Parameters
    /// ----------
    /// hertz : HertzLine
    ///     The normal contact.
    /// friction : float
    ///     Coefficient of friction mu (dimensionless), not negative.
    ///
    /// Raises
    /// ------
    /// NegativeOrNotFinite, NotFinite
    BentallJohnson(hertz: HertzLine => hertz.0, friction)
    numbers {
        /// Creepage xi (dimensionless), 0.9148 beta a/R.
        creepage,
        /// Half-width of the middle strip (a length), at whose ends the slip reverses: 0.4040 a.
        reversal,
        /// Energy that slip dissipates for each length rolled (a force per length), 0.1239 mu |beta| P a/R: what keeps the
        /// cylinders rolling.
        dissipation,
    }
    along {
        /// Slip of body 1 over body 2 at x, for each length rolled (dimensionless); zero outside the contact.
        slip(x),
        /// Traction on body 1 along x (a pressure) at x, mu p against the slip; zero outside the contact.
        traction(x),
    }
}

closed_form! {
    /// Kalker's creepage and spin coefficients: the forces of an elliptic contact that rolls along x with creepages so
    /// small that it sticks but at its trailing edge.
    ///
    /// With the semi-axes a along x and b along y, c = sqrt(a b), and the shear modulus G of two equal bodies, creepages xi
    /// along x and eta along y and the spin phi cause on body 1 F_x = G c^2 C11 xi, F_y = G c^2 (C22 eta + c C23 phi) and
    /// M = G c^3 (C32 eta + c C33 phi). The values are those of solves of this package, right to about 0.1 % (C33 to
    /// 0.3 %). Kalker (1990), table E.3.
    ///
    /// Parameters
    /// ----------
    /// ratio : float
    ///     a/b, from 1/16 to 16.
    /// poisson_ratio : float
    ///     Poisson's ratio of both bodies, from 0 to 1/2; of bodies that differ with Dundurs' beta zero, that of the one
    ///     that is as compliant, and G is twice its modulus.
    ///
    /// Raises
    /// ------
    /// NotPositive, BelowMinimum, PoissonRatio
    KalkerCoefficients(ratio: Real => ratio.0, poisson_ratio)
    numbers {
        /// Force along x by the creepage along x.
        c11,
        /// Force along y by the creepage along y.
        c22,
        /// Force along y by the spin.
        c23,
        /// Moment by the creepage along y, -C23.
        c32,
        /// Moment by the spin.
        c33,
    }
}

closed_form! {
    /// Creep forces of an elliptic contact that rolls along x, without spin: the curve of Vermeulen and Johnson with
    /// Kalker's slope.
    ///
    /// With the force f without slip, by :class:`KalkerCoefficients`, and x = |f| / (mu P), the force has the size
    /// mu P (1 - (1 - x/3)^3) along f, and mu P from x = 3 on. An approximation, some per cent below the solved force. For
    /// equal bodies, or bodies of which Dundurs' beta is zero. Vermeulen and Johnson (1964); Johnson (1985), section 8.4.
    ///
    /// Parameters
    /// ----------
    /// hertz : HertzEllipse
    ///     The normal contact.
    /// friction : float
    ///     Coefficient of friction mu (dimensionless), positive.
    /// creepage : pair of float
    ///     Creepages along x and y (dimensionless), of either sign.
    ///
    /// Raises
    /// ------
    /// NotPositive, NotFinite, CoupledMaterials, BelowMinimum
    VermeulenJohnson(hertz: HertzEllipse => hertz.0, friction; creepage: conversion::Creepages => creepage.0)
    objects {
        /// The coefficients of the contact without slip.
        coefficients: KalkerCoefficients,
    }
    numbers {
        /// The force without slip over the friction limit, x (dimensionless): 3 or more where the whole contact slips.
        relative_creepage,
    }
    pairs {
        /// Tangential force on body 1 along x and y.
        force,
    }
}
