//! Normal and stick-slip (partial-slip) contact of smooth and rough elastic bodies, with error bounds.
//!
//! Two elastic bodies are pressed together and loaded tangentially. The crate computes pressure and contact area, then
//! shear traction, stick zone and slip zone under Coulomb friction, for one load or a history of loads. It is written
//! for tribologists and for authors of simulators of fretting, wear, joints and rolling. The page on
//! [theory](guide::theory) derives the equations and their solution on rectangular cells. The model is that of [Wang et
//! al. (2021)](https://doi.org/10.1016/j.triboint.2021.106947), with [errors corrected](guide::errata):
//! ```math
//! g = h + C_{zz}\,p - \delta \ge 0, \quad p \ge 0, \quad p\,g = 0,
//! ```
//! ```math
//! s = C_{xx}\,q - \delta_x, \quad |q| \le \mu p, \quad s = 0 \text{ where } |q| < \mu p, \quad q\,s \le 0 \text{ elsewhere.}
//! ```
//!
//! # Scope
//!
//! - Bodies are linear elastic half-spaces: homogeneous, [coated](guide::coatings) or described by a [`Kernel`].
//! - Slopes and strains are small. A solution contains a [`Warning`] if the contact radius exceeds 0.3 of the radius of
//!   curvature, or if the rms slope of the gap within the contact exceeds 0.5.
//! - Contacts are quasi-static and rate-independent. The static and the kinetic coefficient of friction are equal.
//! - A finite shift does not move the gap. Only wear, a permanent set or the program changes the gap.
//! - Adhesion, plasticity (except a [hardness](normal::Hardness)), junction growth, viscosity and heat are neglected.
//!
//! # Example
//!
//! ```
//! use stickslip::{
//!     ElasticPair, Friction, Grid, HalfSpace, Material, NormalLoad, NormalProblem,
//!     TangentialLoad, TangentialProblem, analytical, surface,
//! };
//! // A steel ball of radius 3.5 mm on steel, in SI units. The grid has 128 x 128 cells.
//! let grid = Grid::square(128, 0.40e-3)?;
//! let steel = Material::new(213e9, 0.29)?;
//! let bodies = HalfSpace::new(grid, ElasticPair::new(steel, steel)?)?;
//! let ball = surface::sphere(grid, 3.5e-3)?; // the gap before loading
//!
//! let load = NormalLoad::Force(100.0); // normal force, N
//! let normal = NormalProblem::builder(&bodies, &ball, load).build()?.solve()?;
//! let hertz = analytical::HertzSphere::new(bodies.pair(), 3.5e-3, 100.0)?;
//! assert!((normal.approach() / hertz.approach() - 1.0).abs() < 1e-4);
//! assert!((normal.pressure().max() / hertz.max_pressure() - 1.0).abs() < 1e-3);
//!
//! // A tangential force of 20 N, with a friction limit of 50 N: Cattaneo and Mindlin.
//! let (friction, load) = (Friction::coulomb(0.5)?, TangentialLoad::force([20.0, 0.0]));
//! let shear = TangentialProblem::builder(&bodies, &normal, friction, load).build()?.solve()?;
//! let exact = analytical::CattaneoMindlin::new(hertz, 0.5, 20.0)?;
//! assert!((shear.stick_ratio() - exact.stick_ratio()).abs() < 0.01);
//! assert!((shear.shift()[0] / exact.shift() - 1.0).abs() < 1e-3);
//! assert!(shear.report().energy_error_bound() < 1e-8);
//! # Ok::<(), stickslip::Error>(())
//! ```
//!
//! # Units and signs
//!
//! Any consistent units can be used, such as m, N and Pa, or mm, N and MPa. z points into body 1. Pressure is positive in
//! compression. A gap is positive if the surfaces are apart. The approach is positive if the bodies come together. Heights are
//! positive away from their body. Traction and tangential force act on body 1, and body 2 exerts them through the contact.
//! Displacements are relative: body 1 minus body 2. The shift is the rigid motion of body 2 relative to body 1, far from the
//! contact. If body 2 is dragged along +x, its shift is positive, and it pulls body 1 along with a positive force. Slip
//! `s = u - shift` is the motion of the surface of body 1 over the surface of body 2, opposite to the traction. Fields are
//! row-major with x fastest, like NumPy arrays of shape `(ny, nx)`. [Nomenclature](guide::nomenclature) lists all symbols.
#![cfg_attr(doc, doc = include_str!("pictures/signs.html"))]
//!
//! # Tasks
//!
//! | task | types | pages |
//! |---|---|---|
//! | solve a first contact | [`Grid`], [`Material`], [`HalfSpace`] | [first steps](guide::first_steps), [troubleshooting](guide::troubleshooting) |
//! | press bodies | [`NormalProblem`] | [which model](guide::which_model), [grids](guide::grids_and_steps), [validation](guide::validation) |
//! | require an accuracy instead of cells | [`AdaptiveProblem`](adaptive::AdaptiveProblem) | [accuracy](guide::accuracy) |
//! | shear a contact | [`TangentialProblem`], [`CoupledProblem`] | [which model](guide::which_model) |
//! | apply load steps with memory of slip, wear | [`History`] | [load steps](guide::load_steps), [fretting](guide::fretting_and_wear) |
//! | press rough or measured surfaces | [`surface`], [`io`] | [rough surfaces](guide::rough_surfaces) |
//! | compute stresses below the surface | [`subsurface`] | [subsurface stress](guide::subsurface_stress) |
//! | roll bodies | [`rolling`], [`LoadStep::roll`] | [rolling](guide::rolling) |
//! | optimise surfaces, calibrate models | [`sensitivity`] | [sensitivities](guide::sensitivities) |
//! | coat bodies | [`Material::coated`], [`layers`] | [coatings](guide::coatings) |
//! | study many surfaces and loads | [`NormalSolver`], [`TangentialSolver`] | [studies](guide::studies) |
//! | save, continue and embed histories | [`History::save`], [`History::load`], [`stiffness`] | [embedding](guide::embedding), [memory](guide::memory_and_errors) |
//!
//! # Accuracy
//!
//! A solve converges only if its residual and error bound (energy norm) are below the tolerance. Otherwise the [`Error`] contains
//! the [`Report`]. The [bound](cgm#the-certified-error) excludes the [discretisation error](guide::accuracy). A tolerance of 1e-3
//! [suffices](guide::accuracy#choice-of-the-tolerance) for a total error of 0.1 %. On a periodic grid with a prescribed approach
//! or shift, the bound is relative to the exact solution for the computed force. A [coupled contact](coupled::CoupledReport) has
//! a bound for each half, and for its whole error only under weak friction. On stiff coatings the bound may rely on an [estimated
//! eigenvalue](EigenvalueBound). A user-defined operator without an eigenvalue converges on its residual alone. The table lists
//! the largest errors of a sphere and a rough surface (2 to 40 % contact) on 256 x 256 cells. The force is 0.4 of the sliding
//! force. Pressure and traction have the same tolerance. A contact of the table has 1500 to 27 000 cells.
//!
//! | tolerance | approach, shift | contact and stick cells | pressure of one cell, relative to the largest | suitable for |
//! |---|---|---|---|---|
//! | 1e-2 | 1e-4, 5e-4 | 0.5 % | 1e-1 | an initial guess, a rough estimate |
//! | 1e-4 | 4e-7, 1e-6 | 0.1 % | 8e-3 | area, approach and stick ratio of any surface |
//! | 1e-6 | 2e-9, 7e-8 | none | 1e-5 | fields to 1e-5; load steps of a few per cent |
//! | 1e-8 (default) | 4e-11, 2e-10 | none | 9e-8 | histories, derivatives, comparison with other codes |
//!
//! # Features
//!
//! The default features are `parallel` and `full`, which enables the first seven rows.
//!
//! | feature | adds |
//! |---|---|
//! | `analytical` | closed forms ([`analytical`]) |
//! | `history`, `rolling` | [`history`] and [`coupled`], steady [`rolling`] |
//! | `adaptive` | contacts solved to a required accuracy on a grid that the solve chooses ([`adaptive`]) |
//! | `edges`, `spots` | [`edges`] inside the cells, connected parts of the contact ([`ContactSpots`]) |
//! | `stiffness`, `subsurface` | tangent [`stiffness`], stresses below the surface ([`subsurface`]) |
//! | `sensitivity` | derivatives of functionals of a solution ([`sensitivity`]) |
//! | `roughness`, `io` | rough and measured surfaces, files of surfaces and fields ([`io`]) |
//! | `parallel` | threads, in the caller's rayon pool; results are bitwise identical for any number of threads |
//! | `dense` | explicit matrices and direct solutions of small problems, through faer |
//! | `x3p`, `serde` | surfaces in X3P files, [serialisation](guide::embedding) of input and solutions |
//! | `mpi` | [`ranks`] that are processes of an MPI program; the build requires libclang and an MPI library |

#![cfg_attr(docsrs, feature(doc_cfg))]
// A private function may be unused if some features are off. The lints report dead code if all features are on.
#![cfg_attr(
    not(all(
        feature = "adaptive",
        feature = "analytical",
        feature = "edges",
        feature = "history",
        feature = "io",
        feature = "rolling",
        feature = "roughness",
        feature = "sensitivity",
        feature = "spots",
        feature = "stiffness",
        feature = "subsurface"
    )),
    allow(
        dead_code,
        unused_imports,
        unreachable_pub,
        reason = "some features are off, and with them the users of shared helpers"
    )
)]

#[cfg(feature = "adaptive")]
#[cfg_attr(docsrs, doc(cfg(feature = "adaptive")))]
pub mod adaptive;
#[cfg(feature = "analytical")]
#[cfg_attr(docsrs, doc(cfg(feature = "analytical")))]
pub mod analytical;
mod bodies;
pub mod cgm;
mod contact;
#[cfg(feature = "history")]
#[cfg_attr(docsrs, doc(cfg(feature = "history")))]
pub mod coupled;
#[cfg(feature = "dense")]
#[cfg_attr(docsrs, doc(cfg(feature = "dense")))]
pub mod dense;
#[cfg(feature = "edges")]
#[cfg_attr(docsrs, doc(cfg(feature = "edges")))]
pub mod edges;
mod error;
pub mod fft;
#[cfg(any(feature = "io", feature = "history"))]
mod files;
mod grid;
pub mod guide;
mod half_space;
#[cfg(feature = "history")]
#[cfg_attr(docsrs, doc(cfg(feature = "history")))]
pub mod history;
pub mod influence;
#[cfg(feature = "io")]
#[cfg_attr(docsrs, doc(cfg(feature = "io")))]
pub mod io;
mod memory;
pub mod normal;
mod numerics;
mod observer;
mod operator;
mod parallel;
mod report;
#[cfg(any(feature = "rolling", feature = "history"))]
#[cfg_attr(docsrs, doc(cfg(any(feature = "rolling", feature = "history"))))]
pub mod rolling;
#[cfg(feature = "sensitivity")]
#[cfg_attr(docsrs, doc(cfg(feature = "sensitivity")))]
pub mod sensitivity;
#[cfg(feature = "spots")]
mod spots;
#[cfg(feature = "stiffness")]
#[cfg_attr(docsrs, doc(cfg(feature = "stiffness")))]
pub mod stiffness;
#[cfg(feature = "subsurface")]
#[cfg_attr(docsrs, doc(cfg(feature = "subsurface")))]
pub mod subsurface;
mod support;
pub mod surface;
pub mod tangential;
mod warning;

pub use bodies::coupling::Coupling;
pub use bodies::kernel;
#[doc(no_inline)]
pub use bodies::kernel::Kernel;
pub use bodies::layers;
pub use bodies::material::{ElasticPair, Material};
pub use contact::{Contact, Solver};
#[cfg(feature = "history")]
#[cfg_attr(docsrs, doc(cfg(feature = "history")))]
pub use coupled::{CoupledProblem, CoupledSolution, CoupledSolver};
#[doc(no_inline)]
pub use error::Place;
pub use error::{Error, ErrorKind, Result, SystemError};
pub use grid::Grid;
pub use grid::boundary::Boundary;
pub use grid::cell_value::CellValue;
pub use grid::field::Field;
pub use half_space::{ElasticOperator, ElasticPreconditioner, HalfSpace};
#[cfg(feature = "history")]
#[cfg_attr(docsrs, doc(cfg(feature = "history")))]
pub use history::{History, LoadStep};
pub use memory::fallible::TryClone;
pub use normal::{NormalControl, NormalLoad, NormalProblem, NormalSolution, NormalSolver};
pub use operator::{Identity, Operator, Scratch};
pub use parallel::layout::Layout;
pub use parallel::{SERIAL_CELL_LIMIT, disable_global_pool, ranks};
pub use report::{EigenvalueBound, Iteration, Report, Status};
#[cfg(feature = "spots")]
#[cfg_attr(docsrs, doc(cfg(feature = "spots")))]
pub use spots::{ContactSpots, Spot};
pub use tangential::{
    Axis, Friction, PressureSource, TangentialControl, TangentialLoad, TangentialModel,
    TangentialProblem, TangentialSolution, TangentialSolver, Zone,
};
pub use warning::Warning;

/// The examples of the README also run as tests.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
