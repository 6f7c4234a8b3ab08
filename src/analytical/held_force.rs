//! A tangential force carried by friction.

use crate::error::{Error, Result, finite, non_negative};

/// A tangential force on a contact, and its distance from the friction limit.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct HeldForce {
    pub(super) friction: f64,
    pub(super) force: f64,
    /// $`\mu W`$.
    pub(super) limit: f64,
    /// Sign of the force.
    pub(super) direction: f64,
    /// $`f = |F|/\mu W`$; one at sliding and without friction.
    pub(super) fraction: f64,
    /// $`1-f`$, accurate to all digits near sliding.
    pub(super) reserve: f64,
}

impl HeldForce {
    pub(super) fn new(load: f64, friction: f64, force: f64) -> Result<Self> {
        non_negative("coefficient of friction", friction)?;
        finite("tangential force", force)?;
        let limit = finite("friction limit", friction * load)?;
        let magnitude = force.abs();
        // The product above is rounded, so a force meant to equal it may exceed it by a rounding error.
        if magnitude > limit * (1.0 + 4.0 * f64::EPSILON) {
            return Err(Error::BeyondFrictionCapacity {
                force: magnitude,
                limit,
            });
        }
        let (fraction, reserve) = if magnitude < limit {
            (magnitude / limit, (limit - magnitude) / limit)
        } else {
            (1.0, 0.0)
        };
        Ok(Self {
            friction,
            force,
            limit,
            direction: force.signum(),
            fraction,
            reserve,
        })
    }
}
