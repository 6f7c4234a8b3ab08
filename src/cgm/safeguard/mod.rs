//! TODO

pub(super) mod projected_gradient;
pub(super) mod proximal_point;
