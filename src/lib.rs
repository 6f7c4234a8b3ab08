//! Normal and stick-slip contact of elastic half-spaces.

mod error;
mod field;
mod grid;
pub mod influence;
mod material;
mod operator;
mod parallel;
mod report;

pub use error::{Error, Result};
pub use field::Field;
pub use grid::Grid;
pub use material::{ElasticPair, Material};
pub use operator::{Identity, Operator};
pub use report::{Iteration, Report, Status};
