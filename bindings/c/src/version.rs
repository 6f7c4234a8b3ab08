//! Versions, and the rule by which they change.

use std::ffi::c_char;

/// Major version of the library.
pub const STICKSLIP_VERSION_MAJOR: u32 = 0;
/// Minor version of the library.
pub const STICKSLIP_VERSION_MINOR: u32 = 1;
/// Patch version of the library.
pub const STICKSLIP_VERSION_PATCH: u32 = 0;

/// Version of the binary interface: functions, layouts of structs and meanings of constants.
///
/// This version increases whenever a program compiled with an older header could malfunction, and it is part of the SONAME.
/// A patch release never changes it; before 1.0, a minor release may change it. New functions, new constants and members
/// that replace reserved bytes do not change it. A program that loads the library at run time should first compare this
/// constant with stickslip_abi_version().
pub const STICKSLIP_ABI_VERSION: u32 = 2;

const VERSION: &str = concat!(env!("CARGO_PKG_VERSION"), "\0");

// The string must agree with the version of the package.
const _: () = assert!(matches!(VERSION.as_bytes(), b"0.1.0\0"));

/// Returns the version of the running library as "major.minor.patch"; the string is valid as long as the program runs.
#[unsafe(no_mangle)]
pub extern "C" fn stickslip_version() -> *const c_char {
    VERSION.as_ptr().cast()
}

/// Returns STICKSLIP_ABI_VERSION of the running library.
#[unsafe(no_mangle)]
pub extern "C" fn stickslip_abi_version() -> u32 {
    STICKSLIP_ABI_VERSION
}
