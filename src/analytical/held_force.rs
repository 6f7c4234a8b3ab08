//! A tangential force carried by friction.

use crate::error::{Error, Result, finite, non_negative};

/// A tangential force on a contact, and its distance from the friction limit.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub(super) struct HeldForce {
    pub(super) friction: f64,
    pub(super) force: f64,
    /// $`\mu W`$.
    pub(super) limit: f64,
    /// Sign of the force.
    pub(super) direction: f64,
    /// Ratio $`f = |F|/\mu W`$. It is one at sliding and without friction.
    pub(super) fraction: f64,
    /// $`1-f`$, computed without cancellation near sliding.
    pub(super) reserve: f64,
}

/// Relative excess over the friction limit that still counts as sliding. The solvers use the same value.
const ROUNDED: f64 = 1e-12;

impl HeldForce {
    pub(super) fn new(load: f64, friction: f64, force: f64) -> Result<Self> {
        non_negative("coefficient of friction", friction)?;
        finite("tangential force", force)?;
        let limit = finite("friction limit", friction * load)?;
        let magnitude = force.abs();
        // A force that was intended to equal the limit can exceed it by a few rounding errors.
        if magnitude > limit * (1.0 + ROUNDED) {
            return Err(Error::BeyondFrictionCapacity {
                force: magnitude,
                limit,
                remedy: "lower the force, or raise the friction or the load",
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
