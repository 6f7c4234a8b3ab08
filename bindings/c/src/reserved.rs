//! Room in structs for future members. A new member replaces bytes of `reserved`, so that the size of the struct and
//! the offsets of its other members do not change. The value zero of a new member means the behaviour of earlier
//! versions.

use crate::call::Outcome;
use crate::error::Failure;
use crate::status::STICKSLIP_UNKNOWN_OPTION;

/// Returns an error if a struct of the caller has a member that this library does not support.
pub(crate) fn known(name: &str, reserved: &[u64]) -> Outcome {
    if reserved.iter().all(|&word| word == 0) {
        return Ok(());
    }
    let message = format!(
        "reserved of {name} must be zero: start from zeros or from the default, or use the library that belongs to the header"
    );
    Err(Failure::new(STICKSLIP_UNKNOWN_OPTION, message))
}
