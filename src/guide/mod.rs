//! Guide: how to use the crate, and the corrections to the paper's formulas.
//!
//! | page | contents |
//! |---|---|
//! | [`first_steps`] | from an empty folder to a stick zone, and to a number that can be trusted |
//! | [`troubleshooting`] | symptoms, where to look, remedies: grid, load history, units, signs, tolerance |
//! | [`rough_surfaces`] | a surface, generated or measured, pressed and sheared |
//! | [`fretting_and_wear`] | cyclic loads, wear, cycle jumps |
//! | [`load_steps`] | contacts that grow while they are sheared: the entry rule, steps of a given error |
//! | [`rolling`] | creepage, spin, steady rolling: what it costs, how exact it is, which tool for which question |
//! | [`coatings`] | layers on a body: what they change, which grids they take |
//! | [`dissimilar_bodies`] | bodies of different materials: when their coupling matters, and in which steps to load them |
//! | [`subsurface_stress`] | stress below the surface, bulk stress, series for a fatigue criterion; what a half-space can say |
//! | [`studies`] | thousands of surfaces on one machine or over a cluster: shards, restart, merge |
//! | [`distributed`] | one surface on several processes or machines: memory, bytes and times measured, and what they come to on a cluster, calculated |
//! | [`embedding`] | contacts in a simulator: ownership, threads, allocation, states, errors |
//! | [`hard_cases`] | difficult scenes, each checked, and the results of random scenes |
//! | [`errata`] | the formulas of Wang et al. (2021) that are misprinted, and how each correction was checked |
//!
//! The module contains no code except the examples, which run as tests.

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
