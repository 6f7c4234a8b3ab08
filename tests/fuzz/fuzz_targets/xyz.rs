//! A file of this format is read as a topography or rejected.
#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| {
    let _ = stickslip::io::xyz::parse(bytes);
});
