//! Gives the shared library its SONAME, which changes only with `STICKSLIP_ABI_VERSION`.

use std::env;
use std::fs;

fn main() {
    let source = fs::read_to_string("src/version.rs").expect("the file of versions");
    let (_, value) = source
        .split_once("STICKSLIP_ABI_VERSION: u32 = ")
        .expect("the version of the interface");
    let (version, _) = value.split_once(';').expect("its end");
    if env::var("CARGO_CFG_TARGET_OS").as_deref() == Ok("linux") {
        println!("cargo:rustc-cdylib-link-arg=-Wl,-soname,libstickslip.so.{version}");
    }
    println!("cargo:rerun-if-changed=src/version.rs");
}
