//! Partial slip of any paraboloid: the part that does not depend on its shape.

use super::hertz::dome;
use crate::error::{Error, Result, finite, non_negative};

/// What sphere and ellipse share, in fractions of what gross sliding has.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct PartialSlip {
    pub(super) friction: f64,
    pub(super) force: f64,
    /// $`\mu W`$.
    pub(super) limit: f64,
    /// Sign of the force.
    pub(super) direction: f64,
    /// $`c/a = (1-f)^{1/3}`$.
    pub(super) stick: f64,
    /// $`1-c/a`$, with all its digits for small forces.
    ring: f64,
}

impl PartialSlip {
    pub(super) fn new(load: f64, friction: f64, force: f64) -> Result<Self> {
        non_negative("coefficient of friction", friction)?;
        finite("tangential force", force)?;
        let limit = finite("friction limit", friction * load)?;
        let magnitude = force.abs();
        // The product above is rounded: a force meant to equal it may be a rounding larger.
        if magnitude > limit * (1.0 + 4.0 * f64::EPSILON) {
            return Err(Error::BeyondSliding {
                force: magnitude,
                limit,
            });
        }
        let (stick, ring) = if magnitude < limit {
            (
                ((limit - magnitude) / limit).cbrt(),
                -((-magnitude / limit).ln_1p() / 3.0).exp_m1(),
            )
        } else {
            (0.0, 1.0)
        };
        Ok(Self {
            friction,
            force,
            limit,
            direction: force.signum(),
            stick,
            ring,
        })
    }

    /// $`\delta_x/\delta_0 = \pm(1-c^2/a^2)`$.
    pub(super) fn shift_fraction(&self) -> f64 {
        self.direction * self.ring * (1.0 + self.stick)
    }

    /// $`q/\mu p_0`$ at the relative radius $`\rho`$.
    pub(super) fn traction_fraction(&self, rho: f64) -> f64 {
        let whole = dome(rho);
        if rho < self.stick && rho < 1.0 {
            let stick = ((self.stick - rho) * (self.stick + rho)).sqrt();
            self.shift_fraction() / (whole + stick)
        } else {
            self.direction * whole
        }
    }

    /// Energy over $`\mu W\delta_0`$.
    pub(super) fn dissipated_fraction(&self) -> f64 {
        // 1 - 5 t^2 + 5 t^3 - t^5 has a triple root at t = c/a = 1, taken out here.
        self.ring.powi(3) * (1.0 + self.stick * (3.0 + self.stick)) / 5.0
    }
}
