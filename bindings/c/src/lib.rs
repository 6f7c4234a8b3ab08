//! C interface of the crate `stickslip`: opaque handles, plain structs and status codes. The header is generated from this
//! source, and `README.md` states the rules.
//!
//! Every exported function passes its body to [`call::call`] or a variant of it, which turns failures and panics into
//! codes. All access through pointers goes through `pointer` and `handle`.

#![allow(non_camel_case_types, reason = "names of types are those of C")]

pub mod adaptive;
pub mod analytical;
pub mod batch;
pub mod bulk_strain;
mod call;
pub mod coupled;
pub mod coupled_rolling;
pub mod creep;
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
pub mod stiffness_workspace;
pub mod stress;
pub mod surface;
pub mod tangential;
mod text_fields;
pub mod threads;
pub mod version;
pub mod wear;
