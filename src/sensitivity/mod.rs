//! Sensitivities of a contact: derivatives of functionals with respect to the gap of every cell, loads, friction and moduli.
//!
//! Differences of solves need one solve for each input. The transpose of the [linear problem](crate::stiffness) at the final sets
//! gives all derivatives with one linear solve for each [`Functional`]. [`Solver::sensitivity`](crate::Solver::sensitivity)
//! computes them for normal, tangential and coupled contacts. The [guide](crate::guide::sensitivities) describes functionals,
//! inputs, method and cost.
//!
//! The sets of the cells are constant in the derivatives: contact, hardness, stick and slip. If a cell is exactly on the boundary
//! of its set, the derivative is valid on one side only.
//!
//! ```
//! use stickslip::sensitivity::Functional;
//! use stickslip::*;
//! let grid = Grid::square(48, 3.0)?;
//! let bodies = HalfSpace::new(grid, ElasticPair::new(Material::new(1.0, 0.3)?, Material::rigid())?)?;
//! let (ball, load) = (surface::sphere(grid, 10.0)?, NormalLoad::Force(0.1));
//! let mut solver = NormalProblem::builder(&bodies, &ball, load).build()?.into_solver()?;
//! let mut contact = solver.new_solution();
//! solver.solve_into(&mut contact)?;
//! let found = solver.sensitivities(&contact, &[Functional::Approach, Functional::ElasticEnergy])?;
//!
//! // The approach of Hertz grows as the power 2/3 of the force and decreases as the power -2/3 of the modulus.
//! let power = |derivative: Option<f64>, input: f64| derivative.unwrap_or(0.0) * input / found[0].value;
//! assert!((power(found[0].normal_load, 0.1) - 2.0 / 3.0).abs() < 0.02);
//! let modulus = bodies.pair().contact_modulus();
//! assert!((power(found[0].contact_modulus, modulus) + 2.0 / 3.0).abs() < 0.02);
//! // The energy increases by the work of the force on the approach (Castigliano).
//! let slope = found[0].normal_load.unwrap_or(0.0);
//! assert!((found[1].normal_load.unwrap_or(0.0) / (0.1 * slope) - 1.0).abs() < 1e-6);
//! # Ok::<(), Error>(())
//! ```

mod adjoint;
#[cfg(feature = "history")]
mod coupled;
mod current;
mod functional;
#[cfg(feature = "history")]
mod history;
mod loads;
mod normal;
mod poisson;
mod shear;
mod solver;
mod tangential;

pub use functional::{Functional, Weights};
pub use solver::Sensitivity;
