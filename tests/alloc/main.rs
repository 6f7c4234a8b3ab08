//! Tests of memory use, in a separate program whose allocator counts the allocations.

#![allow(
    clippy::unwrap_used,
    clippy::float_cmp,
    clippy::too_many_lines,
    clippy::format_collect,
    reason = "tests panic on failure, compare exact results, and list many cases"
)]

mod damaged_files;
#[cfg(feature = "parallel")]
mod history_allocations;
#[cfg(feature = "parallel")]
mod history_memory;
#[cfg(feature = "parallel")]
mod rank_memory;
#[cfg(feature = "parallel")]
mod repeated_solves;
mod state_memory;
#[cfg(feature = "parallel")]
mod subsurface_memory;
