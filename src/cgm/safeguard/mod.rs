//! Methods that lead on where the active sets cycle.

pub(super) mod projected_gradient;
pub(super) mod proximal_point;
