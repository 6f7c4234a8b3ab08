//! Bytes are read as a state or rejected. A state that was read can be saved and read again.
#![no_main]

mod saved;

use stickslip::history::State;

libfuzzer_sys::fuzz_target!(|input: &[u8]| {
    let _ = State::from_bytes(input);
    if let Ok(state) = State::from_bytes(&saved::changed(input)) {
        let bytes = state.to_bytes();
        let again = State::from_bytes(&bytes).expect("a state that was read");
        assert!(again.to_bytes() == bytes);
    }
});
