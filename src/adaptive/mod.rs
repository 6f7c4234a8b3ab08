//! Contacts that are solved to a required accuracy on grids that the solve chooses.

mod gap;
mod measures;
mod problem;
mod refine;
mod region;
mod search;
mod solution;

pub use gap::GapFunction;
#[cfg(feature = "roughness")]
#[cfg_attr(docsrs, doc(cfg(feature = "roughness")))]
pub use gap::SampledGap;
pub use measures::Quantity;
pub use problem::{AdaptiveProblem, AdaptiveProblemBuilder};
pub use region::Region;
pub use solution::{AdaptiveSolution, AdaptiveStatus, Estimate, GridRecord};
