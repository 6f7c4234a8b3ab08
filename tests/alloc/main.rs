//! The promises about memory: a program of their own, whose allocator counts.

#![allow(
    clippy::unwrap_used,
    clippy::float_cmp,
    clippy::too_many_lines,
    clippy::format_collect,
    reason = "a test fails loudly, compares exact results, and lists many cases"
)]

#[cfg(feature = "parallel")]
mod a_repeated_solve_allocates_nothing;
mod damaged_files_are_refused;
#[cfg(feature = "parallel")]
mod histories_allocate_nothing;
#[cfg(feature = "parallel")]
mod histories_take_the_memory_they_say;
#[cfg(feature = "parallel")]
mod ranks_hold_their_part;
mod states_take_no_more_than_they_are;
#[cfg(feature = "parallel")]
mod stresses_below_the_surface_take_the_memory_they_say;
