//! Stress and displacement below the surface of each body, from the pressure and the tractions of a contact.
//!
//! A cell with a uniform traction causes stresses and displacements in the half-space below it, for which closed forms exist
//! (Love 1929; Ahmadi, Keer & Mura 1983). The effects of all cells are added,
//!
//! ```math
//! \sigma_{ij}(x, y, z) = \sum_{\text{cells}} \left[S^p_{ij}\,p + S^x_{ij}\,q_x + S^y_{ij}\,q_y\right] .
//! ```
//!
//! [`at_points`] computes the sum at any points. [`Planes`] computes it at the cell centres of planes at chosen depths, by
//! fast transforms. For [coated](crate::layers) bodies only planes can be computed, in the layers and below them. A uniform
//! stress that the contact does not cause, such as a bulk stress, can be [added](Tractions::with_uniform_stress).
//!
//! ```
//! use stickslip::subsurface::{self, Body};
//! use stickslip::*;
//! // A steel ball on steel: the largest shear stress is 0.310 p0, at the depth 0.481 a (nu = 0.3).
//! let grid = Grid::square(64, 0.4)?;
//! let steel = Material::new(210e3, 0.3)?;
//! let bodies = HalfSpace::new(grid, ElasticPair::new(steel, steel)?)?;
//! let load = NormalControl::Force(100.0);
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
//! Stresses are pressures, positive in tension; displacements are lengths. Depths are measured into the body and are
//! positive in both bodies. The axes x, y and z are common to both bodies, with z into body 1. Under the load both
//! bodies have `szz = -p`, `sxz = -qx` and `syz = -qy`. Displacements refer to the body itself, not to the motion
//! relative to the other body. They vanish at infinity; for periodic grids see [`Planes`]. Under a pressure `uz` is
//! positive in body 1 and negative in body 2.
//!
//! # On the surface
//!
//! The values at depth zero are the limits from inside the body. There `szz`, `sxz` and `syz` follow from the
//! tractions, and on an edge between cells from the mean of the tractions on both sides. `sxx`, `syy` and `sxy` jump or
//! are logarithmically infinite on an edge between cells of different tractions. There the value is the mean of both
//! sides without the infinite part, for which the longer half side of a cell replaces the distance to the edge. Planes
//! are computed at cell centres, where these singularities do not occur.
//!
//! # Sources
//!
//! A. E. H. Love, Phil. Trans. R. Soc. A 228 (1929) 377, <https://doi.org/10.1098/rsta.1929.0009>; N. Ahmadi, L. M.
//! Keer, T. Mura, Int. J. Solids Struct. 19 (1983) 357, <https://doi.org/10.1016/0020-7683(83)90032-X>; K. L.
//! Johnson, Contact Mechanics (1985), sections 3.1 and 3.2.
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
