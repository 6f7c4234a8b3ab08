//! The crate `stickslip` for C: opaque handles, plain structs, status codes. The header is made from this source, and
//! `README.md` has the rules.
//!
//! Every exported function is one call of [`call::call`], which turns failures and panics into codes; what it does with
//! pointers goes through `pointer` and `handle`.

#![allow(non_camel_case_types, reason = "names of types are those of C")]

pub mod adaptive;
pub mod analytical;
pub mod batch;
mod call;
pub mod coupled;
pub mod coupled_rolling;
pub mod cycle;
pub mod edges;
mod environment;
pub mod error;
pub mod fields;
pub mod half_space;
mod handle;
pub mod history;
pub mod history_reading;
pub mod inputs;
pub mod jump;
pub mod loads;
pub mod model;
pub mod normal;
pub mod observer;
pub mod planes;
mod pointer;
pub mod ranks;
mod reserved;
pub mod results;
pub mod rolling;
pub mod roughness;
mod scratch;
mod solver;
pub mod spots;
pub mod state;
pub mod status;
pub mod stiffness;
pub mod stress;
pub mod surface;
pub mod tangential;
mod text_fields;
pub mod threads;
pub mod version;
pub mod wear;
