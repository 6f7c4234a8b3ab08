//! Stress and displacement below the surface of each body, from the pressure and the tractions of a contact.
//!
//! A uniform traction on a cell causes stresses and displacements in the half-space. Closed forms are known for both (Love 1929
//! and Ahmadi, Keer & Mura 1983). The effects of all cells are added:
//!
//! ```math
//! \sigma_{ij}(x, y, z) = \sum_{\text{cells}} \left[S^p_{ij}\,p + S^x_{ij}\,q_x + S^y_{ij}\,q_y\right] .
//! ```
//!
//! [`at_points`] computes the sum at any points. [`Planes`] computes it at the cell centres of planes at chosen depths, by fast
//! transforms. For [coated](crate::layers) bodies only planes can be computed, both in the layers and in the base. A uniform
//! stress from a different source, such as a bulk stress, can be [added](Tractions::with_uniform_stress).
//!
//! ```
//! use stickslip::subsurface::{self, Body};
//! use stickslip::*;
//! // A steel ball on steel: the largest shear stress is 0.310 p0, at the depth 0.481 a (nu = 0.3).
//! let grid = Grid::square(64, 0.4)?;
//! let steel = Material::new(210e3, 0.3)?;
//! let bodies = HalfSpace::new(grid, ElasticPair::new(steel, steel)?)?;
//! let load = NormalLoad::Force(100.0);
//! let ball = surface::sphere(grid, 5.0)?;
//! let contact = NormalProblem::builder(&bodies, &ball, load).build()?.solve()?;
//! let hertz = analytical::HertzSphere::new(bodies.pair(), 5.0, 100.0)?;
//!
//! let depth = 0.481 * hertz.contact_radius();
//! let below = subsurface::at_points(&bodies, Body::One, &contact, &[[0.0, 0.0, depth]])?;
//! assert!((below[0].stress.max_shear() / hertz.max_pressure() - 0.310).abs() < 1e-3);
//! # Ok::<(), Error>(())
//! ```
//!
//! # Units and signs
//!
//! Stresses are pressures and positive in tension. Displacements are lengths. Depths are measured into the body and are positive
//! in both bodies. The axes x, y and z are common to both bodies, with z into body 1. Under the load both bodies have `szz = -p`,
//! `sxz = -qx` and `syz = -qy`. Displacements refer to the body itself, not to the motion relative to the other body. They vanish
//! at infinity. [`Planes`] describes the displacements for periodic grids. Under a pressure `uz` is positive in body 1 and
//! negative in body 2.
//!
//! # On the surface
//!
//! The values at depth zero are the limits from inside the body. On the surface, `szz`, `sxz` and `syz` follow from the
//! tractions. On an edge between cells, the mean of the tractions on both sides applies. `sxx`, `syy` and `sxy` jump or are
//! logarithmically infinite on an edge between cells of different tractions. On such an edge, the value is the mean of the finite
//! parts on both sides. The finite part contains the longer half side of a cell instead of the distance to the edge. Planes are
//! computed at cell centres, where these singularities do not occur.
//!
//! # Sources
//!
//! - A. E. H. Love, Phil. Trans. R. Soc. A 228 (1929) 377, <https://doi.org/10.1098/rsta.1929.0009>.
//! - N. Ahmadi, L. M. Keer, T. Mura, Int. J. Solids Struct. 19 (1983) 357,
//!   <https://doi.org/10.1016/0020-7683(83)90032-X>.
//! - K. L. Johnson, Contact Mechanics (1985), sections 3.1 and 3.2.
//!
//! The example `fretting_rig` plots:
#![cfg_attr(doc, doc = include_str!("../pictures/fretting_rig.html"))]

mod blocks;
mod body;
mod cardinal;
mod direct_sum;
mod distances;
mod kernel;
mod layered;
mod plane;
mod planes;
mod points;
mod spectra;
mod stress;
mod strip;
mod tractions;
#[cfg(feature = "io")]
mod volume;

pub use body::Body;
pub use plane::Plane;
pub use planes::Planes;
pub use points::{PointResult, at_points, at_points_observed};
pub use stress::{Principal, Stress};
pub use tractions::Tractions;
