//! Stresses and displacements below the surface.

mod planes;
mod points;
mod stress;
mod tractions;

pub(crate) use planes::{Plane, Planes};
pub(crate) use points::{PointResult, PointResults, at_points};
pub(crate) use stress::{Principal, Stress};
pub(crate) use tractions::Loaded;
