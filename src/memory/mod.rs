//! Fallible memory allocation, and memory that several users share.

pub(crate) mod fallible;
pub(crate) mod pool;
