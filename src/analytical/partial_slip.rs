//! Partial slip of any paraboloid: the relations that do not depend on its shape.

use super::held_force::HeldForce;
use super::hertz::dome;
use crate::error::Result;

/// Relations common to the sphere and the ellipse, as fractions of the values at gross sliding.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub(super) struct PartialSlip {
    pub(super) held: HeldForce,
    /// $`c/a = (1-f)^{1/3}`$.
    pub(super) stick: f64,
    /// $`1-c/a`$, accurate to round-off for small forces.
    ring: f64,
}

impl PartialSlip {
    pub(super) fn new(load: f64, friction: f64, force: f64) -> Result<Self> {
        let held = HeldForce::new(load, friction, force)?;
        Ok(Self {
            held,
            stick: held.reserve.cbrt(),
            ring: -((-held.fraction).ln_1p() / 3.0).exp_m1(),
        })
    }

    /// Returns $`\delta_x/\delta_0 = \pm(1-c^2/a^2)`$.
    pub(super) fn shift_fraction(&self) -> f64 {
        self.held.direction * self.ring * (1.0 + self.stick)
    }

    /// Returns $`q/\mu p_0`$ at the relative radius $`\rho`$.
    pub(super) fn traction_fraction(&self, rho: f64) -> f64 {
        let whole = dome(rho);
        if rho < self.stick && rho < 1.0 {
            let stick = ((self.stick - rho) * (self.stick + rho)).sqrt();
            self.shift_fraction() / (whole + stick)
        } else {
            self.held.direction * whole
        }
    }

    /// Returns the dissipated energy divided by $`\mu W\delta_0`$.
    pub(super) fn dissipated_fraction(&self) -> f64 {
        // 1 - 5 t^2 + 5 t^3 - t^5 has a triple root at t = c/a = 1, factored out here.
        self.ring.powi(3) * (1.0 + self.stick * (3.0 + self.stick)) / 5.0
    }
}
