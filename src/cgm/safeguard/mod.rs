//! Fallback methods for active sets that cycle: projected gradients and proximal points.

pub(super) mod projected_gradient;
pub(super) mod proximal_point;
