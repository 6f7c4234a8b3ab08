//! Guide to the use of the crate, and corrections to the paper's formulas.
//!
//! | page | contents |
//! |---|---|
//! | [`first_steps`] | from an empty folder to a stick zone and a verified result |
//! | [`troubleshooting`] | results that look wrong: symptoms, causes and remedies (grid, load history, units, signs, tolerance) |
//! | [`rough_surfaces`] | generated or measured surfaces, pressed and sheared |
//! | [`fretting_and_wear`] | cyclic loads, wear, cycle jumps |
//! | [`load_steps`] | contacts that grow while they are sheared: the entry rule, load steps with a prescribed error |
//! | [`rolling`] | creepage, spin and steady rolling: cost, accuracy and the choice of a model |
//! | [`coatings`] | layers on a body: their effect and the grids that support them |
//! | [`dissimilar_bodies`] | bodies of different materials: when their coupling matters, and in which steps to load them |
//! | [`subsurface_stress`] | stress below the surface, bulk stress, stress histories for fatigue criteria; limits of the half-space model |
//! | [`studies`] | thousands of surfaces on one machine or a cluster: shards, restart, merge |
//! | [`distributed`] | one contact on several processes or machines: measured memory, communication and time, calculated times on a cluster |
//! | [`embedding`] | contacts in a simulator: ownership, threads, allocation, states, errors |
//! | [`hard_cases`] | difficult cases, each checked, and the results of random cases |
//! | [`errata`] | misprinted formulas of Wang et al. (2021), and the check of each correction |
//!
//! The module contains no code except for the examples, which run as tests.

#[doc = include_str!("first_steps.md")]
pub mod first_steps {}

#[doc = include_str!("troubleshooting.md")]
pub mod troubleshooting {}

#[doc = include_str!("rough_surfaces.md")]
pub mod rough_surfaces {}

#[doc = include_str!("fretting_and_wear.md")]
pub mod fretting_and_wear {}

#[doc = include_str!("load_steps.md")]
pub mod load_steps {}

#[doc = include_str!("rolling.md")]
#[cfg_attr(doc, doc = include_str!("../pictures/creep_curves.html"))]
pub mod rolling {}

#[doc = include_str!("coatings.md")]
pub mod coatings {}

#[doc = include_str!("dissimilar_bodies.md")]
pub mod dissimilar_bodies {}

#[doc = include_str!("subsurface_stress.md")]
pub mod subsurface_stress {}

#[doc = include_str!("studies.md")]
pub mod studies {}

#[doc = include_str!("distributed.md")]
pub mod distributed {}

#[doc = include_str!("embedding.md")]
pub mod embedding {}

#[doc = include_str!("hard_cases.md")]
pub mod hard_cases {}

#[doc = include_str!("errata.md")]
pub mod errata {}
