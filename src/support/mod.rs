//! Utilities without physics: checksums, the clock, debug output and serialisation.

pub(crate) mod checksum;
pub(crate) mod clock;
pub(crate) mod debug;
#[cfg(feature = "serde")]
pub(crate) mod serialise;
