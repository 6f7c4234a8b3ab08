#!/usr/bin/env bash
# Runs every example of the gallery and writes pictures and tables to target/gallery.
set -euo pipefail
cd "$(dirname "$0")/.."

cargo build --release -p stickslip-examples --examples
printf '\n== sphere\n'
cargo run --release -p stickslip-sphere
for source in examples/*.rs examples/{distributed,study}/main.rs; do
    # An example is a file, or a folder with main.rs.
    example=${source#examples/}
    example=${example%/main.rs}
    example=${example%.rs}
    printf '\n== %s\n' "$example"
    cargo run --quiet --release -p stickslip-examples --example "$example"
done
# Examples that test and time the library. The campaign over random problems is omitted, because its duration is
# arbitrary.
for example in validation hard_cases speed_against_error grid_against_error; do
    printf '\n== %s\n' "$example"
    cargo run --quiet --release -p stickslip-testkit --example "$example"
done
printf '\nall in %s s, pictures in target/gallery\n' "$SECONDS"
