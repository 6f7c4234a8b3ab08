//! TODO

pub(crate) mod component;
pub(crate) mod coupling;
pub mod kernel;
pub mod layers;
pub(crate) mod material;
