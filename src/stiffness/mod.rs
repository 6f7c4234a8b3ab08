//! The stiffness of a contact: how its forces change with its motions, at fixed sets of cells.
//!
//! A multi-body code or a Newton iteration around this crate needs $`dW/d\delta_z`$ and $`dF/d\delta`$. Differences of
//! solves give them with the noise of the sets, and one-sided ones mix loading with reversal. Here they follow from
//! linear solves with the operator on the cells of the contact:
//!
//! - **normal**: all cells that carry pressure follow a change of the approach;
//! - **loading**: cells that stick follow a change of the shift, cells that slip stay at their limit. In the scalar model
//!   that holds their traction; in the vector model it turns, against the stiffness $`|s|/m`$ that slip s under the limit m
//!   has;
//! - **reversal**: all cells of the contact stick, as they do at first when the shift goes back;
//! - **by approach**: the limit of cells that slip follows the pressure, and with it the tangential force, while slip
//!   continues: where the shift grows in the same step, or the approach decreases. If the bodies are pressed further at a
//!   held shift, the cells that slipped stick, and the force stays.
//!
//! All of that holds the pressure while the bodies are sheared, and the tractions while they are pressed. Histories have
//! more:
//!
//! - in steps in which the contact grows, cells that entered follow the motion by their [own
//!   compliance](crate::guide::load_steps): the stiffness is the derivative of the force of the step by the motion at
//!   its end. In the stiffness of the [next step](StiffnessWorkspace::next_step) these cells resist fully;
//! - cells that have reached the hardness carry no more, as long as the bodies are pressed further;
//! - where pressure moves the surfaces one way, pressing shears;
//! - where pressure and shear are found together ([coupled](crate::coupled)), they answer each motion together: the normal
//!   force has a [slope by the shift](ContactStiffness::normal_by_motion). That system is not symmetric, and its
//!   stiffness has no bound (an infinite one), but the residual of the tolerance.
//!
//! Each is a solution of the [linear problem](crate::cgm) of the engine at its last sets, by bases whose products are of
//! single precision, refined in double precision to a [tolerance](StiffnessWorkspace::tolerance). The bound is that of the
//! linear problem. The round-off of its double-precision products comes on top, and so do the errors of pressure and
//! tractions, which change the sets and the slips that it is of.
//!
//! The halves of a solution of [`CoupledProblem`](crate::CoupledProblem) are refused with
//! [`Error::CoupledMaterials`](crate::Error::CoupledMaterials): [the solution](crate::CoupledSolution::stiffness) has the
//! stiffness of both.
//!
//! The motions are shift along x, shift along y and twist; the loads are the forces and the moment about the origin of
//! the grid. What a model leaves out is `None`: in the scalar model the motion across its axis and the twist. The matrices
//! are symmetric.
//!
//! ```
//! use stickslip::*;
//! let grid = Grid::square(96, 0.30e-3)?;
//! let steel = Material::new(213e9, 0.29)?;
//! let bodies = HalfSpace::new(grid, ElasticPair::new(steel, steel)?)?;
//! let ball = surface::sphere(grid, 3.5e-3)?;
//! let mut history = History::builder(&bodies, &ball, Friction::coulomb(0.5)?).build()?;
//! history.step(&LoadStep::hold().normal(NormalControl::Force(100.0)))?;
//! history.step(&LoadStep::force([25.0, 0.0]))?;
//!
//! let stiffness = history.stiffness()?;
//! let hertz = analytical::HertzSphere::new(bodies.pair(), 3.5e-3, 100.0)?;
//! let closed_form = 2.0 * bodies.pair().contact_modulus() * hertz.contact_radius();
//! assert!((stiffness.normal.value / closed_form - 1.0).abs() < 0.01);
//! // Half of the load that slides: the slope falls with the radius of the stick zone, and is back at reversal.
//! let along_x = |matrix: [[Option<f64>; 3]; 3]| matrix[0][0].unwrap();
//! let tangential = stiffness.tangential;
//! let ratio = along_x(tangential.loading) / along_x(tangential.reversal);
//! assert!((ratio - 0.5_f64.cbrt()).abs() < 0.01);
//! // The scalar model along x knows nothing of y.
//! assert_eq!(tangential.loading[1][1], None);
//! // Pressure that grows while slip continues raises the force.
//! assert!(stiffness.by_approach[0] > Some(0.0));
//! # Ok::<(), Error>(())
//! ```

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

pub use contact_stiffness::{ContactStiffness, NormalStiffness, TangentialStiffness};
pub use workspace::StiffnessWorkspace;
