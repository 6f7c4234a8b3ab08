//! A saved history with modified bytes is rejected, or takes steps that end.
#![no_main]

mod saved;

use std::time::Duration;

use stickslip::cgm::Settings;
use stickslip::{History, LoadStep, NormalLoad};

libfuzzer_sys::fuzz_target!(|input: &[u8]| {
    let Ok(mut history) = History::from_bytes(&saved::BODIES, &saved::changed(input)) else {
        return;
    };
    let settings = Settings::default()
        .max_iterations(200)
        .time_limit(Duration::from_secs(2));
    if history.set_settings(settings).is_ok() {
        let _ = history.step(&LoadStep::force([0.02, 0.0]));
        let _ = history.step(&LoadStep::hold().normal(NormalLoad::Force(0.2)));
    }
});
