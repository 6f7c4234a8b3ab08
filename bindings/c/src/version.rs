//! Versions, and the rule by which they change.

use std::ffi::c_char;

/// Major version of the library.
pub const STICKSLIP_VERSION_MAJOR: u32 = 0;
/// Minor version of the library.
pub const STICKSLIP_VERSION_MINOR: u32 = 1;
/// Patch version of the library.
pub const STICKSLIP_VERSION_PATCH: u32 = 0;

/// Version of the binary interface: of functions, layouts of structs and meanings of constants.
///
/// It goes up whenever a program compiled with an older header could go wrong, and is part of the SONAME. A patch never
/// changes it, a minor version may before 1.0; functions, constants and members in the place of reserved ones may be added
/// without. A host that loads the library at run time compares it with stickslip_abi_version() first.
pub const STICKSLIP_ABI_VERSION: u32 = 2;

const VERSION: &str = concat!(env!("CARGO_PKG_VERSION"), "\0");

// The three numbers are those of the package.
const _: () = assert!(matches!(VERSION.as_bytes(), b"0.1.0\0"));

/// The version of the library that is running, as "major.minor.patch"; it lives as long as the program.
#[unsafe(no_mangle)]
pub extern "C" fn stickslip_version() -> *const c_char {
    VERSION.as_ptr().cast()
}

/// STICKSLIP_ABI_VERSION of the library that is running.
#[unsafe(no_mangle)]
pub extern "C" fn stickslip_abi_version() -> u32 {
    STICKSLIP_ABI_VERSION
}
