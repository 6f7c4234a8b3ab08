//! Stiffness of a contact: derivatives of its forces with respect to its motions, at fixed sets of cells.
//!
//! A multi-body code or a Newton iteration around this crate needs $`dW/d\delta_z`$ and $`dF/d\delta`$. Finite differences of
//! solves contain noise from changes of the sets, and one-sided differences mix loading with reversal. This module computes the
//! derivatives from linear solves with the operator on the cells of the contact:
//!
//! - **normal**: All cells that carry pressure follow a change of the approach.
//! - **loading**: Sticking cells follow a change of the shift, and slipping cells stay at their limit. In the scalar model the
//!   traction of slipping cells is constant. In the vector model their traction turns with the slip. This rotation has the
//!   additional compliance $`|s|/m`$, with the slip s and the limit m.
//! - **reversal**: All cells of the contact stick, as they do initially when the shift reverses.
//! - **by approach**: The limit of slipping cells follows the pressure while slip continues, and the tangential force follows the
//!   limit. The derivative is valid if the shift grows in the same step or if the approach decreases. If the bodies are pressed
//!   further at a constant shift, the cells that slipped stick, and the force stays constant.
//!
//! The pressure is constant while the bodies are sheared. In the normal stiffness, the tractions are constant while the bodies
//! are pressed. Histories add the following:
//!
//! - In steps in which the contact grows, cells that came into contact follow the motion with their [entry
//!   compliance](crate::guide::load_steps). The stiffness is the derivative of the force of the step with respect to the motion
//!   at the end of the step. In the stiffness of the [next step](StiffnessWorkspace::next_step) these cells have no entry
//!   compliance.
//! - Cells at the hardness carry no additional pressure while the bodies are pressed further.
//! - With one-way coupling, pressing also shears the contact.
//! - If pressure and shear are [coupled](crate::coupled), both respond to each motion. The normal force then has a [derivative
//!   with respect to the shift](ContactStiffness::normal_by_motion), and the system is not symmetric. The stiffness of a coupled
//!   contact has no error bound (the bound is infinite). Only the residual satisfies the tolerance.
//!
//! Each stiffness is a solution of the [linear problem](crate::cgm) of the solver at its final sets. GMRES solves it with
//! products in single precision, refined in double precision to a [tolerance](StiffnessWorkspace::tolerance). The bound applies
//! to the linear problem. The bound does not include the round-off of the double-precision products. It does not include the
//! errors of pressure and tractions either, which change the sets and the slips.
//!
//! The stiffness functions of the two halves of a solution of [`CoupledProblem`](crate::CoupledProblem) return
//! [`Error::CoupledMaterials`](crate::Error::CoupledMaterials). Use the stiffness of [the whole
//! solution](crate::CoupledSolution::stiffness) instead.
//!
//! The motions are the shift along x, the shift along y and the twist. The loads are the forces and the moment about the origin
//! of the grid. Entries that a model does not have are `None`. In the scalar model these are the entries for the motion across
//! its axis and for the twist. The matrices are symmetric unless pressure and shear are coupled.
//!
//! ```
//! use stickslip::*;
//! let grid = Grid::square(96, 0.30e-3)?;
//! let steel = Material::new(213e9, 0.29)?;
//! let bodies = HalfSpace::new(grid, ElasticPair::new(steel, steel)?)?;
//! let ball = surface::sphere(grid, 3.5e-3)?;
//! let mut history = History::builder(&bodies, &ball, Friction::coulomb(0.5)?).build()?;
//! history.step(&LoadStep::hold().normal(NormalLoad::Force(100.0)))?;
//! history.step(&LoadStep::force([25.0, 0.0]))?;
//!
//! let stiffness = history.stiffness()?;
//! let hertz = analytical::HertzSphere::new(bodies.pair(), 3.5e-3, 100.0)?;
//! let closed_form = 2.0 * bodies.pair().contact_modulus() * hertz.contact_radius();
//! assert!((stiffness.normal.value / closed_form - 1.0).abs() < 0.01);
//! // At half of the sliding load the slope falls with the radius of the stick zone, and recovers at reversal.
//! let along_x = |matrix: [[Option<f64>; 3]; 3]| matrix[0][0].unwrap();
//! let tangential = stiffness.tangential;
//! let ratio = along_x(tangential.loading) / along_x(tangential.reversal);
//! assert!((ratio - 0.5_f64.cbrt()).abs() < 0.01);
//! // The scalar model along x has no entries for y.
//! assert_eq!(tangential.loading[1][1], None);
//! // Pressure that grows while slip continues raises the force.
//! assert!(stiffness.by_approach[0] > Some(0.0));
//! # Ok::<(), Error>(())
//! ```

mod contact;
mod contact_stiffness;
#[cfg(feature = "history")]
mod coupled;
#[cfg(feature = "history")]
mod history;
mod motions;
mod normal;
mod system;
mod tangential;
mod workspace;

pub(crate) use contact::{ContactCells, SolvedContact, check_open};
pub use contact_stiffness::{ContactStiffness, NormalStiffness, TangentialStiffness};
#[cfg(feature = "history")]
pub(crate) use coupled::joint_system;
pub(crate) use system::System;
pub(crate) use tangential::BallOf;
pub use workspace::StiffnessWorkspace;
pub(crate) use workspace::{SystemBuffers, SystemOf};
