//! The bodies: elastic constants, layers, kernels of a user, and how pressure and traction are coupled.

pub(crate) mod component;
pub(crate) mod coupling;
pub mod kernel;
pub mod layers;
pub(crate) mod material;
