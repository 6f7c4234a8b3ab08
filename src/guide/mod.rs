//! Pages to read: how the crate is used at length, and what the paper should have printed.
//!
//! | page | for whom |
//! |---|---|
//! | [`rough_surfaces`] | a surface, generated or measured, pressed and sheared |
//! | [`fretting_and_wear`] | load to and fro, wear, cycle jumps |
//! | [`embedding`] | a simulator that takes contacts in: ownership, threads, allocation, states, errors |
//! | [`hard_cases`] | scenes that break solvers, each judged, and what random ones came to |
//! | [`errata`] | the formulas of Wang et al. (2021) that are not as printed, and how each was checked |
//!
//! There is no code in here but the examples, which run as tests.

#[doc = include_str!("rough_surfaces.md")]
pub mod rough_surfaces {}

#[doc = include_str!("fretting_and_wear.md")]
pub mod fretting_and_wear {}

#[doc = include_str!("embedding.md")]
pub mod embedding {}

#[doc = include_str!("hard_cases.md")]
pub mod hard_cases {}

#[doc = include_str!("errata.md")]
pub mod errata {}
