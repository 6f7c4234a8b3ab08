//! Bodies: elastic constants, layers, user-defined kernels, and the coupling between pressure and traction.

pub(crate) mod component;
pub(crate) mod coupling;
pub mod kernel;
pub mod layers;
pub(crate) mod material;
mod strength;
