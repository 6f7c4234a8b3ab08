//! Closed-form solutions for steady rolling.

use crate::analytical::closed_form::closed_form;
use crate::analytical::{HertzEllipse, HertzLine};
use crate::conversion;
use crate::real::Real;

closed_form! {
    /// A cylinder that rolls steadily with longitudinal creepage, in plane strain: Carter's solution.
    ///
    /// The leading edge is at x = a. A strip of half-width c = a (1 - |xi| / xi_s) that ends at the leading edge
    /// sticks; the rest slips, against the traction. For creepages of xi_s or more, the whole contact slips. The
    /// solution is valid for equal bodies and for bodies whose Dundurs' beta is zero. Carter (1926); Johnson (1985),
    /// section 8.3.
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
        /// Tangential force Q on body 1 (a force per length), with the sign of the creepage and the magnitude mu P (1 -
        /// c^2/a^2).
        force,
        /// Smallest creepage at which the whole contact slips (dimensionless), xi_s = 2 mu p_0 / E*.
        sliding_creepage,
        /// Half-width c of the stick strip at the leading edge (a length).
        stick_half_width,
    }
    along {
        /// Returns the traction on body 1 along x (a pressure) at x: with the sign of the creepage, mu p_0 sqrt(1 -
        /// x^2/a^2), minus mu p_0 (c/a) sqrt(1 - (x - a + c)^2/c^2) in the stick strip. The traction is zero outside the
        /// contact.
        traction(x),
    }
}

closed_form! {
    /// Cylinders of different materials that roll freely, without a tangential force and with little friction: the limit
    /// of Bentall and Johnson's solution for a friction coefficient much smaller than Dundurs' beta.
    ///
    /// The pressure stretches the surfaces by different amounts. Body 1 therefore slips over body 2, per unit length
    /// rolled, by s = 2 beta p / E* - xi, and the traction is mu p against the slip. There is no slip if beta is zero.
    /// The leading edge is at +x; if it is at -x, creepage and slip have the opposite sign. Bentall and Johnson (1967);
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
        /// Energy dissipated by slip per unit length rolled (a force per length), 0.1239 mu |beta| P a/R. It must be
        /// supplied to keep the cylinders rolling.
        dissipation,
    }
    along {
        /// Returns the slip of body 1 over body 2 at x per unit length rolled (dimensionless), or zero outside the
        /// contact.
        slip(x),
        /// Returns the traction on body 1 along x (a pressure) at x, mu p against the slip, or zero outside the contact.
        traction(x),
    }
}

closed_form! {
    /// Kalker's creepage and spin coefficients, which give the forces of an elliptic contact that rolls along x. The
    /// creepages are so small that the contact sticks everywhere except at its trailing edge.
    ///
    /// With the semi-axes a along x and b along y, c = sqrt(a b), and the shear modulus G of two equal bodies, creepages
    /// xi along x and eta along y and the spin phi cause on body 1 F_x = G c^2 C11 xi, F_y = G c^2 (C22 eta + c C23 phi)
    /// and M = G c^3 (C32 eta + c C33 phi). The values were computed with this package and are accurate to about 0.1 %
    /// (C33 to 0.3 %). Kalker (1990), table E.3.
    ///
    /// Parameters
    /// ----------
    /// ratio : float
    ///     a/b, from 1/16 to 16.
    /// poisson_ratio : float
    ///     Poisson's ratio of both bodies, from 0 to 1/2. For different bodies with zero Dundurs' beta, it is the ratio
    ///     of the single body with the same compliance, and G is twice the modulus of that body.
    ///
    /// Raises
    /// ------
    /// NotPositive, BelowMinimum, PoissonRatio
    KalkerCoefficients(ratio: Real => ratio.0, poisson_ratio)
    numbers {
        /// Coefficient of the force along x due to the creepage along x.
        c11,
        /// Coefficient of the force along y due to the creepage along y.
        c22,
        /// Coefficient of the force along y due to the spin.
        c23,
        /// Coefficient of the moment due to the creepage along y, -C23.
        c32,
        /// Coefficient of the moment due to the spin.
        c33,
    }
}

closed_form! {
    /// Creep forces of an elliptic contact that rolls along x without spin, from the creep curve of Vermeulen and Johnson
    /// with the initial slope of Kalker.
    ///
    /// Let f be the force without slip, from :class:`KalkerCoefficients`, and x = |f| / (mu P). The force along f has the
    /// magnitude mu P (1 - (1 - x/3)^3), and mu P for x of 3 or more. The force of this approximation is a few per cent
    /// below the computed force. The solution is valid for equal bodies and for bodies whose Dundurs' beta is zero. Vermeulen and
    /// Johnson (1964); Johnson (1985), section 8.4.
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
        /// Ratio x of the force without slip to the friction limit (dimensionless); 3 or more if the whole contact slips.
        relative_creepage,
    }
    pairs {
        /// Tangential force on body 1 along x and y.
        force,
    }
}
