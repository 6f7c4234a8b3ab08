//! Sensitivities of a contact: derivatives of functionals with respect to the gap of every cell, loads, friction and moduli.
//!
//! A program that optimises a surface needs the derivative of a result J with respect to each of its many inputs. Differences of
//! solves need one solve for each input. The adjoint of the [linear problem](crate::stiffness) at the final sets gives all
//! derivatives with one linear solve for each functional. [`Solver::sensitivity`](crate::Solver::sensitivity) computes them.

mod adjoint;
#[cfg(feature = "history")]
mod coupled;
mod functional;
mod normal;
mod shear;
mod solver;
mod tangential;

pub use functional::{Functional, Weights};
pub use solver::Sensitivity;
