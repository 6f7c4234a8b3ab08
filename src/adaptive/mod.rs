//! Contacts that are solved to a required accuracy. The solve chooses the grid.
//!
//! The input is a gap at any position, the load, the region where contact may occur, and a [target](Quantity) for the error of
//! each quantity of interest. In this example the region is a hundred times larger than the contact, and the solve chooses the
//! cells:
//!
//! ```
//! use stickslip::adaptive::{AdaptiveProblem, AdaptiveStatus, Quantity, Region};
//! use stickslip::analytical::HertzSphere;
//! use stickslip::{ElasticPair, Material, NormalLoad};
//!
//! let steel = Material::new(213e9, 0.29)?;
//! let pair = ElasticPair::new(steel, steel)?;
//! let (radius, force) = (3.5e-3, 100.0);
//! let ball = |x: f64, y: f64| (x * x + y * y) / (2.0 * radius);
//! let region = Region::rectangle([-1e-2, 1e-2], [-1e-2, 1e-2])?;
//! let problem = AdaptiveProblem::builder(pair, &ball, NormalLoad::Force(force), region)
//!     .target(Quantity::Pressure, 1e-2)
//!     .target(Quantity::Area, 1e-2)
//!     .build()?;
//! let contact = problem.solve()?;
//! assert_eq!(contact.status(), AdaptiveStatus::Reached);
//!
//! let hertz = HertzSphere::new(&pair, radius, force)?;
//! assert!((contact.area() / hertz.contact_area() - 1.0).abs() < 1e-2);
//! assert!((contact.normal().approach() / hertz.approach() - 1.0).abs() < 1e-3);
//! # Ok::<(), stickslip::Error>(())
//! ```
//!
//! # Method
//!
//! 1. Search: the contact is solved on grids of 24 x 24 cells. The first grid covers the whole region. The gap of a cell is the
//!    least gap of 64 points inside it. The extent of the grid shrinks to the contact, or widens if the contact reaches an end of
//!    the extent.
//! 2. Refinement: the contact is solved on finer grids over this extent, with [values at the centres](crate::CellValue::Centre)
//!    and [edges](crate::edges) inside the cells. The ratio of the numbers of cells along both axes balances the second
//!    differences of the pressure. The next grid has 1.5 to 4 times as many cells along a side. The estimated errors determine
//!    this factor.
//! 3. Check: the displacement due to the pressure is computed on a coarse grid over the whole region. If the bodies overlap
//!    outside the extent, the search continues with an extent that contains the overlap.
//!
//! A grid that is periodic along both axes always covers its region and is only refined. On a line the cells are refined
//! along x.
//!
//! # Estimates
//!
//! Let D be the difference of a quantity between two successive grids. The finer grid has r times as many cells along a side.
//! The estimated error of the finer grid is
//!
//! ```math
//! e = \frac{D}{r^{3/2} - 1} \quad\text{for fields}, \qquad e = \frac{D}{r - 1} \quad\text{for numbers.}
//! ```
//!
//! Fields are compared as means over the coarser cells. A number can agree on two grids by chance. After two grids its estimate
//! is therefore multiplied by three, and is at least a part of the estimate of a field. This part is 1 of the pressure for the area,
//! 0.2 of the pressure for approach and force, 0.5 of the traction for the stick ratio, and 0.05 of the traction for the shift.
//! Later estimates are at least the previous estimate divided by $`r^{1.7}`$.
//!
//! The error of the pressure is also at least the unresolved pressure
//!
//! ```math
//! \frac{\sum |h(x_i + s_i) - \tilde h(x_i + s_i)|}{c \sum p_i} ,
//! ```
//!
//! where $`\tilde h`$ is the cubic interpolation of the gap between the centres $`x_i`$. The offsets $`s_i`$ lie inside the cells
//! and differ from cell to cell. The compliance $`c`$ is the displacement of a cell under a unit pressure on it. The sums are
//! over the contact. Waves of the gap that are shorter than the cells therefore increase the estimate. The pressure of bumps inside
//! separated cells is added, if the search has points on these bumps and the bodies overlap there.
//!
//! The error of the area is also at least the area of the contact cells that the unresolved gap could separate. The pressure of such
//! a cell is below $`3\,|h - \tilde h| / c`$. Two contacts can thus be separated by a channel that the cells do not resolve.
//!
//! The errors of pressure, traction and stick ratio are also at least $`(\sum_{e} p_i / \sum p_i)^2`$. The sum in the numerator is
//! over contact cells with a neighbour that is not in contact. This error is one for spots that are at most two cells wide. Two grids
//! can have the same pressure in such spots.
//!
//! The estimates are not bounds. In a test with 1000 random contacts, one error exceeded its target, by a factor of 1.29. The page
//! on [accuracy](crate::guide::accuracy#contacts-with-a-required-accuracy) lists times, cells and errors.
//!
//! # Limits
//!
//! - The search evaluates the gap at 192 x 192 points of the region. It does not find a bump between these points.
//! - Bodies with coatings and kernels have no edges inside the cells. Their areas are [corrected
//!   counts](crate::NormalSolution::contact_area_corrected), which need more cells.
//! - A twist and rolling steps are rejected: a twist acts about the centre of the grid, and a rolling step has a length in cells. Moments
//!   of the solution also refer to the centre of the grid.
//! - The estimates for a flat punch are poor, because its pressure is infinite at the edge.
//! - A [`SampledGap`] limits the accuracy: cells smaller than the distance between the samples resolve only the
//!   interpolation. The solve then ends with [`AdaptiveStatus::SampleSpacing`].

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
