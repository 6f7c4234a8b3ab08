//! Guide to the use of the crate, and corrections to the paper's formulas.
//!
//! # Start
//!
//! | page | contents |
//! |---|---|
//! | [`first_steps`] | from an empty folder to a stick zone and a verified result |
//! | [`which_model`] | choice of a model and of a type; combinations and their cost |
//! | [`nomenclature`] | symbols, units and signs, with the terms of the literature |
//! | [`troubleshooting`] | results that look wrong: symptoms, causes and remedies |
//!
//! # Theory and accuracy
//!
//! | page | contents |
//! |---|---|
//! | [`theory`] | half-space, influence coefficients, laws of contact, discretisation, algorithm, certificate |
//! | [`grids_and_steps`] | cells, size of the grid and load steps for a given accuracy |
//! | [`accuracy`] | discretisation error, tolerance and time of a solve |
//! | [`validation`] | comparison with closed forms and other codes |
//! | [`hard_cases`] | difficult cases and random cases |
//! | [`errata`] | misprinted formulas of Wang et al. (2021), and the check of each correction |
//!
//! # Applications
//!
//! | page | contents |
//! |---|---|
//! | [`rough_surfaces`] | generated and measured surfaces, pressed and sheared |
//! | [`load_steps`] | growing contacts and dissimilar bodies: the choice of load steps |
//! | [`fretting_and_wear`] | cyclic loads, wear and cycle jumps |
//! | [`rolling`] | creepage, spin and steady rolling |
//! | [`coatings`] | layers on a body: their effect and the grids that support them |
//! | [`sensitivities`] | derivatives of a result with respect to gap, loads, friction and moduli |
//! | [`subsurface_stress`] | stress below the surface, bulk stress, stress histories for fatigue criteria |
//!
//! # Programs
//!
//! | page | contents |
//! |---|---|
//! | [`embedding`] | contacts in a simulator: ownership, threads, warm starts, states |
//! | [`memory_and_errors`] | memory and time by number of cells, allocation, errors |
//! | [`studies`] | thousands of surfaces on one machine or a cluster |
//! | [`distributed`] | one contact on several processes or machines |
//!
//! The module contains no code except for the examples, which run as tests.

#[doc = include_str!("first_steps.md")]
#[cfg_attr(doc, doc = include_str!("../pictures/sphere.html"))]
pub mod first_steps {}

/// Choice of a model and of a type: a decision figure, costs and errors, types by task, and combinations.
///
#[cfg_attr(doc, doc = include_str!("../pictures/which_model.html"))]
///
#[doc = include_str!("which_model.md")]
pub mod which_model {}

/// Symbols, units and signs, with the terms of the literature.
///
#[cfg_attr(doc, doc = include_str!("../pictures/signs.html"))]
///
#[doc = include_str!("nomenclature.md")]
pub mod nomenclature {}

#[doc = include_str!("troubleshooting.md")]
pub mod troubleshooting {}

#[doc = include_str!("theory.md")]
pub mod theory {}

#[doc = include_str!("grids_and_steps.md")]
pub mod grids_and_steps {}

#[doc = include_str!("accuracy.md")]
pub mod accuracy {}

#[doc = include_str!("validation.md")]
pub mod validation {}

#[doc = include_str!("hard_cases.md")]
pub mod hard_cases {}

#[doc = include_str!("errata.md")]
pub mod errata {}

#[doc = include_str!("rough_surfaces.md")]
pub mod rough_surfaces {}

#[doc = include_str!("load_steps.md")]
pub mod load_steps {}

#[doc = include_str!("fretting_and_wear.md")]
pub mod fretting_and_wear {}

#[doc = include_str!("rolling.md")]
#[cfg_attr(doc, doc = include_str!("../pictures/creep_curves.html"))]
pub mod rolling {}

#[doc = include_str!("coatings.md")]
pub mod coatings {}

#[doc = include_str!("sensitivities.md")]
pub mod sensitivities {}

#[doc = include_str!("subsurface_stress.md")]
pub mod subsurface_stress {}

#[doc = include_str!("embedding.md")]
pub mod embedding {}

#[doc = include_str!("memory_and_errors.md")]
pub mod memory_and_errors {}

#[doc = include_str!("studies.md")]
pub mod studies {}

#[doc = include_str!("distributed.md")]
pub mod distributed {}
