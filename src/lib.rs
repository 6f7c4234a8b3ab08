#![doc = include_str!("../README.md")]
#![cfg_attr(docsrs, feature(doc_cfg))]

pub mod analytical;
mod boundary;
pub mod cgm;
mod contact_map;
#[cfg(feature = "dense")]
pub mod dense;
mod error;
pub mod fft;
mod field;
mod grid;
mod half_space;
pub mod history;
pub mod influence;
pub mod io;
mod material;
pub mod normal;
mod operator;
mod parallel;
mod report;
#[cfg(feature = "serde")]
mod serial;
mod stage;
pub mod surface;
pub mod tangential;
mod window;

pub use boundary::Boundary;
pub use contact_map::Warning;
pub use error::{Error, Result};
pub use field::Field;
pub use grid::Grid;
pub use half_space::HalfSpace;
pub use history::{History, LoadStep, NormalStep, TangentialStep};
pub use material::{ElasticPair, Material};
pub use normal::{NormalLoad, NormalProblem, NormalSolution, NormalSolver};
pub use operator::{Identity, Operator};
pub use report::{Iteration, Report, Status};
pub use tangential::{
    Axis, Friction, Lateral, Pressure, TangentialLoad, TangentialProblem, TangentialSolution,
    TangentialSolver, Zone,
};
