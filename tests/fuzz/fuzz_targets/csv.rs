//! A file of this format is a topography or refused.
#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| {
    let _ = stickslip::io::csv::parse(bytes, [0.5, 0.25]);
});
