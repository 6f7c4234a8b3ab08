//! Room in structs for members to come. A member that is added takes the place of `reserved` bytes, so that the size of its
//! struct and the places of the others stay; zero there means what held before there was such a member.

use crate::call::Outcome;
use crate::error::Failure;
use crate::status::STICKSLIP_UNKNOWN_OPTION;

/// `Ok` if a struct of the caller has no member that this library does not know.
pub(crate) fn known(name: &str, reserved: &[u64]) -> Outcome {
    if reserved.iter().all(|&word| word == 0) {
        return Ok(());
    }
    let message = format!(
        "reserved of {name} is not zero: begin from zeros or from the default, or use the library of that header"
    );
    Err(Failure::new(STICKSLIP_UNKNOWN_OPTION, message))
}
