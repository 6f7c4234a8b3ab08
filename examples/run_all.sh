#!/usr/bin/env bash
# Runs every example of the gallery; pictures and tables end up in target/gallery.
set -euo pipefail
cd "$(dirname "$0")/.."

cargo build --release -p stickslip-examples --examples
for source in examples/*.rs examples/*/main.rs; do
    # A file, or the folder of a larger one.
    example=${source#examples/}
    example=${example%/main.rs}
    example=${example%.rs}
    printf '\n== %s\n' "$example"
    cargo run --quiet --release -p stickslip-examples --example "$example"
done
# Those that judge and time the library; a campaign over random scenes lasts as long as one likes.
for example in hard_cases speed_against_error grid_against_error; do
    printf '\n== %s\n' "$example"
    cargo run --quiet --release -p stickslip-testkit --example "$example"
done
printf '\nall in %s s, pictures in target/gallery\n' "$SECONDS"
