//! Steady rolling.

use crate::analytical::HertzLine;
use crate::analytical::closed_form::closed_form;

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
    /// Negative, NotFinite, CoupledMaterials
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
