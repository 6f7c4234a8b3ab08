//! Normal and stick-slip (partial-slip) contact of smooth and rough elastic bodies: fast, with certified error bounds.
//!
//! Two elastic bodies are pressed together and loaded tangentially. This crate computes the pressure and the contact
//! area, then the shear traction, the stick zone and the slip zone under Coulomb friction, for one load or a history of
//! loads. The bodies are half-spaces whose surfaces are divided into rectangular cells. Influence coefficients and a
//! zero-padded FFT convolution map tractions to displacements. A constrained conjugate-gradient engine solves
//! ```math
//! g = h + C_{zz}\,p - \delta \ge 0, \quad p \ge 0, \quad p\,g = 0,
//! ```
//! ```math
//! s = C_{xx}\,q - \delta_x, \quad |q| \le \mu p, \quad
//! s = 0 \text{ where } |q| < \mu p, \quad q\,s \le 0 \text{ elsewhere,}
//! ```
//!
//! A certificate bounds the error of every solution. The model is that of Wang, De Boer, Neville & Ghanbarzadeh
//! (Tribology International 159 (2021) 106947, <https://doi.org/10.1016/j.triboint.2021.106947>), with [the errors in
//! its printed formulas corrected](guide::errata).
//!
//! ```
//! use stickslip::{
//!     ElasticPair, Friction, Grid, HalfSpace, Material, NormalControl, NormalProblem,
//!     TangentialLoad, TangentialProblem, analytical, surface,
//! };
//! // A steel ball of radius 3.5 mm on steel, in SI units:
//! // 128 x 128 cells on a square of side 0.40 mm.
//! let grid = Grid::square(128, 0.40e-3)?;
//! let steel = Material::new(213e9, 0.29)?;
//! let bodies = HalfSpace::new(grid, ElasticPair::new(steel, steel)?)?;
//! let ball = surface::sphere(grid, 3.5e-3)?; // the gap before loading
//!
//! // A normal force of 100 N: Hertz.
//! let load = NormalControl::Force(100.0);
//! let normal = NormalProblem::builder(&bodies, &ball, load)
//!     .build()?
//!     .solve()?;
//! let hertz = analytical::HertzSphere::new(bodies.pair(), 3.5e-3, 100.0)?;
//! assert!((normal.approach() / hertz.approach() - 1.0).abs() < 1e-4);
//! assert!((normal.pressure().max() / hertz.max_pressure() - 1.0).abs() < 1e-3);
//!
//! // A tangential force of 20 N, with a friction limit of 50 N: Cattaneo and Mindlin.
//! let (friction, load) = (Friction::coulomb(0.5)?, TangentialLoad::force([20.0, 0.0]));
//! let tangential = TangentialProblem::builder(&bodies, &normal, friction, load)
//!     .build()?
//!     .solve()?;
//! let exact = analytical::CattaneoMindlin::new(hertz, 0.5, 20.0)?;
//! assert!((tangential.stick_ratio() - exact.stick_ratio()).abs() < 0.01);
//! assert!((tangential.shift()[0] / exact.shift() - 1.0).abs() < 1e-3);
//! assert!(tangential.report().energy_error_bound() < 1e-8);
//! # Ok::<(), stickslip::Error>(())
//! ```
//!
//! # Choosing a type
//!
//! | task | type or page |
//! |---|---|
//! | solve normal contact | [`NormalProblem`] with [`NormalControl::Force`] or [`Approach`](NormalControl::Approach) |
//! | solve partial slip along x or y | [`TangentialProblem`] with [`TangentialLoad::force`] or [`Shift`](TangentialLoad::shift) |
//! | solve partial slip in any direction, with both components of the traction | [`TangentialProblem`] with [`TangentialModel::Vector`] |
//! | solve normal or tangential contact repeatedly | [`NormalSolver`], [`TangentialSolver`] |
//! | press bodies of different materials, in as many steps as a tolerance requires | [`History::press`], the page on [dissimilar bodies](guide::load_steps#dissimilar-bodies) |
//! | press and shear bodies of different materials | [`CoupledProblem`], [`History`]; [`coupled`] |
//! | apply loads step by step with memory of slip | [`History`], [`LoadStep`] |
//! | press and shear simultaneously, with step sizes that meet a tolerance | [`history::AdaptiveSteps`], the page on [growing contacts](guide::load_steps) |
//! | limit the pressure to the hardness | [`normal::Hardness`], in problems and [histories](history::HistoryBuilder::hardness) |
//! | compute the tangent stiffness | [`History::stiffness`], [`stiffness`] |
//! | compute moments, the centre of pressure, contact spots | [`NormalSolution::moments`], [`centre_of_pressure`](NormalSolution::centre_of_pressure), for a history through [`History::normal`]; [`ContactSpots`] |
//! | compute stresses and displacements below the surface: at points, on planes, as a volume for ParaView | [`subsurface`]: [`at_points`](subsurface::at_points), [`Planes`](subsurface::Planes) |
//! | store, restore and save the state of a history | [`history::State`] |
//! | apply cyclic loads, until steady or with wear | [`history::FrettingLoop`], [`history::LoadPath`], [`history::Cycle`], [`history::wear`] |
//! | solve one large contact on several processes or machines | [`HalfSpace::distributed`], [`ranks`], the page on [distributed contacts](guide::distributed) |
//! | solve the same contact for thousands of surfaces and loads | the page on [studies](guide::studies) |
//! | embed contacts in a simulator | the page on [embedding](guide::embedding) |
//! | start without experience of the crate | the page on [first steps](guide::first_steps) |
//! | assess the accuracy of a solution | its [`Report`], its [`discretisation_estimate`](NormalSolution::discretisation_estimate) and its [`Warning`]s |
//! | obtain more accuracy from the same cells: areas, stick ratio, pressure at the edge | [`HalfSpace::with_cell_value`], [`NormalSolution::edges`], [`TangentialSolution::edges`], [`History::edges`]; [`edges`] |
//! | find out why a number looks wrong | the page on [troubleshooting](guide::troubleshooting) |
//! | generate a rough surface or a smooth shape | [`surface::SelfAffine`]; [`surface::sphere`], [`cone`](surface::cone), [`sum`](surface::sum()) ... |
//! | characterise a surface, prepare a measured one | [`surface::Statistics`], [`GaussianFilter`](surface::GaussianFilter), [`fill_missing`](surface::fill_missing), [`gap_from_heights`](surface::gap_from_heights) ... and the page on [rough surfaces](guide::rough_surfaces) |
//! | read surfaces, write fields for other programs | [`io`] |
//! | press a cylinder along a line, smooth or rough | [`Grid::line`], [`Boundary::PeriodicAlongY`] |
//! | stretch a body by a bulk stress during shear | [`tangential::RelativeDisplacement`] |
//! | roll steadily with creepages, forces, spin or moment; creep curves | [`rolling::RollingProblem`], the page on [rolling](guide::rolling) |
//! | roll bodies of different materials steadily | [`rolling::CoupledRollingProblem`] |
//! | roll while loads, creepages or surfaces change | [`LoadStep::roll`] |
//! | model coated bodies or other linear bodies: a thin sheet, a graded half-space, coefficients or operators of a finite-element code | [`Material::coated`], [`layers`], [`Kernel`]; [the page on coatings](guide::coatings) |
//! | press nominally flat surfaces without edges | [`HalfSpace::with_boundary`], [`Boundary::Periodic`] |
//! | compare with a closed form: spheres, cones, punches, waves, rough surfaces | [`analytical`], [`tangential::JaegerSuperposition`] |
//! | use the engine with a user-defined operator | [`cgm`], with an [`Operator`] |
//! | compute influence coefficients only | [`influence::Rectangle`], [`influence::Table`] |
//! | check results with explicit matrices | `dense::DenseOperator`, with the feature `dense` |
//!
//! # Combinations
//!
//! | | pressure only | with traction along an axis | with traction in the plane | [one-way](Coupling::OneWay) coupling | [full](Coupling::Full) coupling |
//! |---|---|---|---|---|---|
//! | [problems](NormalProblem), [histories](History), wear, cycles | yes | yes | yes | yes | yes |
//! | grids periodic along one or both axes, [lines](Grid::line) | yes | yes | yes | yes | yes |
//! | [cells that come into contact](guide::load_steps) in a step | - | yes | yes | yes | yes |
//! | [hardness](normal::Hardness), permanent set in histories | yes | yes | yes | yes | yes |
//! | [stiffness](History::stiffness) of histories | yes | yes | yes | yes | yes, without a bound |
//! | stiffness of problems | yes, elastic contacts | yes | yes | yes, except for pressing | yes, elastic contacts |
//! | [`ranks`], including stiffnesses | yes | yes | yes | yes | yes |
//! | twist | - | - | yes | yes | yes |
//! | [steady rolling](rolling), its stiffness | - | - | yes | yes, with a warning | yes |
//! | [rolling steps](LoadStep::roll) | - | yes | yes | yes, with a warning | yes |
//!
//! The twist requires a grid that is not periodic. Steady rolling problems do not support a hardness, and rolling does
//! not support ranks.
//!
//! # Units and signs
//!
//! Any consistent system of units can be used; the code contains no dimensional constants.
//!
//! | length | force | pressure, modulus |
//! |---|---|---|
//! | m | N | Pa |
//! | mm | N | MPa |
//! | um | uN | MPa |
//!
//! z points into body 1. Pressure is positive in compression. A gap is positive if the surfaces are apart, and the
//! approach is positive if the bodies come together. Heights are positive away from their body. Traction and tangential
//! force act on body 1 and are exerted by body 2 through the contact; they are positive along the axis. Displacements are
//! relative: body 1 minus body 2. The shift is the rigid motion of body 2 relative to body 1, far from the contact. If
//! body 2 is dragged along +x, its shift is therefore positive, and it pulls body 1 along with a positive force. Slip is
//! `s = u - shift`, the motion of the surface of body 1 over the surface of body 2; its direction is opposite to the
//! traction. Fields are row-major with x fastest, the memory layout of a NumPy array of shape `(ny, nx)`.
//!
//! # Accuracy and cost
//!
//! A solve has the status [`Converged`](Status::Converged) only if two quantities, computed from a new product, are below
//! the tolerance: the largest complementarity residual, relative to the displacement of the contact, and a bound on the
//! error in the energy norm. Every other status is returned as an error that contains the report; the solution that the
//! caller passed in then contains the last feasible iterate. The bound is rigorous up to the round-off of the product. It
//! follows from the duality gap and from the smallest eigenvalue of the periodic continuation of the operator, which is
//! read from its spectrum, as derived on the page of [`cgm`]. (For a user-defined operator without such an eigenvalue,
//! only the residual is tested.)
//!
//! For the sphere of the example the error is due to the discretisation and not to the solver. The table is for 512 x
//! 512 cells and the default tolerance of 1e-8:
//!
//! | quantity | relative difference from the closed form |
//! |---|---|
//! | maximum pressure | -7.1e-6 |
//! | approach | -1.4e-6 |
//! | contact area, perimeter corrected | -1.7e-4 |
//! | shift | 9.9e-7 |
//! | stick ratio | -5.0e-5 |
//!
//! The discretisation error of the fields, summed over the cells, is 1e-4 in the pressure and 5e-4 in the shear traction
//! of the same sphere. It is far larger if the cells barely resolve the roughness;
//! [`discretisation_estimate`](NormalSolution::discretisation_estimate) estimates the discretisation error. Values at the
//! centres of the cells ([`CellValue::Centre`], at no extra cost), combined with edges located inside the cells
//! ([`edges`]), reach the same accuracy with a sixteenth of the cells. The table is for a grid whose side is three
//! contact radii, and lists means over 8 positions of the contact centre relative to the cells:
//!
//! | sphere, 40 % of the sliding force | uniform cells, counted: 128 x 128 | 512 x 512 | centre values, with edges: 128 x 128 |
//! |---|---|---|---|
//! | pressure, sum over the cells | 9e-4 | 1.2e-4 | 1.1e-4 |
//! | shear traction, sum over the cells | 4e-3 | 5e-4 | 5e-4 |
//! | contact area | 5e-3 | 1.4e-3 | 3e-5 |
//! | stick area | 6e-3 | 1.6e-3 | 8e-5 |
//! | largest shear traction | 7e-3 | 2e-3 | 2e-4 |
//! | approach | 2e-5 | 1.4e-6 | 1.2e-6 |
//!
//! The next table lists grids for an error of 0.1 %, with N x N cells on a square whose side is three contact radii, a
//! tolerance of 1e-3 and one thread. The times for "centres, edges" include the computation of the edges.
//!
//! | contact, 0.1 % | cells, counted: N, ms | error of field, area | centres, edges: N, ms | error of field, area |
//! |---|---|---|---|---|
//! | sphere, pressure | 128, 4.0 | 8.8e-4, 5.7e-3 | 32, 1.1 | 8.9e-4, 8.4e-4 |
//! | ellipse 2 : 1, pressure | 256, 11 | 6.2e-4, 4.1e-3 | 64, 2.1 | 6.5e-4, 5.9e-4 |
//! | cone, pressure | 128, 4.1 | 6.7e-4, 5.7e-3 | 64, 2.7 | 6.3e-4, 2.1e-4 |
//! | sphere, shear traction | 512, 42 | 5.0e-4, 1.6e-3 | 128, 7.8 | 5.6e-4, 8.9e-5 |
//!
//! An error of 1 % in all of these quantities requires N = 32 (11 cells per contact radius) with values at the centres
//! and edges. Uniform cells without edges need N = 64 to 128. At N = 32 the slip ring of the traction is 1.7 cells wide.
//! Narrower rings need more cells: at the same force and N = 32, a gap proportional to r^4 has a [slip ring one cell
//! wide](edges#narrow-slip-rings) and a traction error of 3 %. All of these results use a tolerance of 1e-3. A smaller
//! tolerance does not improve these results, and a tolerance of 1e-2 leaves an error of up to 1 % on any grid. The
//! example `grid_against_error` of the package `stickslip-testkit` measures these errors.
//!
//! A tolerance of less than a hundredth of the discretisation error brings no improvement, unless results of different
//! steps are subtracted, as in wear and friction histories. The table lists the remaining errors for each tolerance. They
//! are maxima over the sphere and the rough surface at 2, 10 and 40 % contact on 256 x 256 cells:
//!
//! | tolerance | approach, shift | contact and stick cells | pressure of one cell, relative to the largest | suitable for |
//! |---|---|---|---|---|
//! | 1e-2 | 2e-4 | 0.7 % | 8e-2 | an initial guess, a rough estimate |
//! | 1e-4 | 1e-6 | two cells | 4e-4 | area, approach and stick ratio of any surface |
//! | 1e-6 | 2e-9 | none | 1e-5 | fields; steps of a few per cent |
//! | 1e-8 (default) | 2e-11 | none | 2e-8 | histories, derivatives, comparison with other codes |
//!
//! Reducing the tolerance by a factor of 100 costs 10 to 30 % more time. A solve whose tolerance is below round-off ends
//! with the status [`Stalled`](Status::Stalled). The limit is about 1e-14 on spheres and rough surfaces, and 1e-12 on
//! flat surfaces (see the table on the page of [`cgm`]). The results for [hard cases](guide::hard_cases) are on a
//! separate page.
//!
//! The following times are for two shared cores, 512 x 512 cells and a cold start:
//!
//! | contact | tolerance | pressure | shear traction |
//! |---|---|---|---|
//! | sphere | 1e-4 | 26 ms | 22 ms |
//! | sphere | 1e-10 | 39 ms | 33 ms |
//! | rough surface, 10 % contact | 1e-4 | 65 ms | 53 ms |
//! | rough surface, 10 % contact | 1e-6 | 85 ms | 70 ms |
//!
//! The example `speed_against_error` of the package `stickslip-testkit` measures these times on the local machine.
//!
//! # Features
//!
//! | feature | default | adds |
//! |---|---|---|
//! | `full` | yes | the nine features below that are marked "model" |
//! | `analytical` | by `full` | model: closed forms ([`analytical`]), [`tangential::JaegerSuperposition`] |
//! | `history` | by `full` | model: histories, cycles and wear ([`history`]), coupled problems of dissimilar bodies ([`coupled`]) |
//! | `stiffness` | by `full` | model: tangent stiffness ([`stiffness`]) |
//! | `rolling` | by `full` | model: steady rolling ([`rolling`]) |
//! | `edges` | by `full` | model: edges inside the cells ([`edges`]); enables `spots` |
//! | `spots` | by `full` | model: connected parts of the contact ([`ContactSpots`]) |
//! | `subsurface` | by `full` | model: stresses below the surface ([`subsurface`]) |
//! | `roughness` | by `full` | model: rough and measured surfaces; without it [`surface`] contains shapes and gaps |
//! | `io` | by `full` | model: files of surfaces and fields ([`io`]) |
//! | `parallel` | yes | threads, in the caller's rayon pool; results are bitwise identical for any number of threads |
//! | `dense` | no | explicit matrices and the direct solution of small problems, through faer |
//! | `x3p` | no | surfaces in X3P files, through `miniz_oxide` and `quick-xml`; enables `io` |
//! | `serde` | no | grids, materials, friction, loads, options, fields and solutions in any format of `serde` |
//! | `mpi` | no | [`ranks`] that are processes of an MPI program, through `mpi`; the build requires libclang and an MPI library |
//!
//! A program that needs only normal and tangential contact, for any bodies, can depend on the crate with
//! `default-features = false, features = ["parallel"]`. A function that combines two subjects, such as the edges of a
//! history, requires the features of both.
//!
//! The table lists compile times from scratch for the program on the page on [embedding](guide::embedding) (seconds on
//! one core, rustc 1.95):
//!
//! | features | other crates | release | debug |
//! |---|---|---|---|
//! | none (`default-features = false`): transforms, normal and tangential problems, all bodies, ranks | 17 | 59 s | 30 s |
//! | `parallel` | 23 | 65 s | 35 s |
//! | `parallel`, `full` (default) | 23 | 110 s | 48 s |
//! | `parallel`, `full`, `dense` | 64 | 211 s | 128 s |
//! | all except `mpi` | 72 | 222 s | 137 s |
//!
//! The library alone takes 48 s with `parallel` and 91 s with the default features.
//!
//! With `serde`, deserialisation rejects the values that a constructor would reject, with the same message, and
//! preserves the bits of numbers. In human-readable formats such as JSON, non-finite numbers are strings: `"NaN"` (a
//! missing height), `"Infinity"` (the modulus of a rigid body) or `"-Infinity"`. A [`HalfSpace`] is rebuilt from grid,
//! pair and boundary, and a closed form from its parameters. A generated or levelled surface is saved as its heights. A
//! [`History`], which requires its bodies, has a separate byte format ([`History::to_bytes`]).
//!
//! # Scope of the model
//!
//! The model covers elastic half-spaces with small slopes and strains, free surroundings or a periodic grid, and any
//! history of load along one axis or in the plane, including twist. The model along one axis neglects the traction across
//! the load, as the paper does. On a sphere with Poisson's ratio 0.29 this changes the force by less than 0.1 %. The
//! vector model ([`TangentialModel::Vector`]) solves for both components and takes about three times as long as the model
//! along one axis. If the materials couple pressure and traction (Dundurs' beta is not zero), [`CoupledProblem`] and
//! [`History`] solve for both simultaneously and reproduce the results of CONTACT. A [`TangentialProblem`] has a given
//! pressure and solves for the tractions under this pressure. [`Coupling`] can select one-way coupling or no coupling.
//! The vector model reproduces the histories of CONTACT's test bench, among them 21 steps of a moving sphere, to 1e-9 of
//! the largest pressure (`tests/it/contact_reference_histories.rs`).
//!
//! Bodies are homogeneous, coated ([`layers`]), or given by a [`Kernel`]. Plasticity, adhesion, viscosity and heat are
//! not modelled.
//!
//! # Sources of the formulas
//!
//! | subject | source |
//! |---|---|
//! | model, influence coefficients, rough spheres | Wang, De Boer, Neville & Ghanbarzadeh (2021), <https://doi.org/10.1016/j.triboint.2021.106947>; [errata](guide::errata) |
//! | zero-padded convolution ([`fft`]) | Liu, Wang & Liu (2000), <https://doi.org/10.1016/S0043-1648(00)00427-0> |
//! | single-loop conjugate gradients ([`cgm`]) | Polonsky & Keer (1999), <https://doi.org/10.1016/S0043-1648(99)00113-1> |
//! | duality gap ([`cgm`]) | Frank & Wolfe (1956), <https://doi.org/10.1002/nav.3800030109> |
//! | stresses below the surface ([`subsurface`]) | Love (1929), <https://doi.org/10.1098/rsta.1929.0009> |
//! | transient shift ([`history`]) | Kalker (1990), <https://doi.org/10.1007/978-94-015-7889-9> |
//! | steady rolling ([`rolling`]) | Kalker (1990) |
//! | wear by dissipated energy ([`history::wear`]) | Fouvry, Kapsa & Vincent (1996), <https://doi.org/10.1016/S0043-1648(96)07306-1> |
//! | closed forms | cited on their pages, listed in [`analytical`] |
//!
//! The derivations are on the pages of the modules, in detail in [`cgm`], [`influence`], [`normal`], [`tangential`] and
//! [`history`].

#![cfg_attr(docsrs, feature(doc_cfg))]
// Without some of the features a private function may be unused. With all features enabled, the lints report dead code.
#![cfg_attr(
    not(all(
        feature = "analytical",
        feature = "edges",
        feature = "history",
        feature = "io",
        feature = "rolling",
        feature = "roughness",
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
pub use normal::{NormalControl, NormalProblem, NormalSolution, NormalSolver};
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
