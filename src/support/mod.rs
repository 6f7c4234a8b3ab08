//! TODO

pub(crate) mod checksum;
pub(crate) mod clock;
pub(crate) mod debug;
pub(crate) mod fallible;
pub(crate) mod pool;
pub(crate) mod serialise;
