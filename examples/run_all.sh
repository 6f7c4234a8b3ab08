#!/usr/bin/env bash
# Runs every example of the gallery; pictures and tables end up in target/gallery.
set -euo pipefail
cd "$(dirname "$0")/.."

cargo build --release --examples
for source in examples/*.rs examples/*/main.rs; do
    # A file, or the folder of a larger one.
    example=${source#examples/}
    example=${example%/main.rs}
    example=${example%.rs}
    # A campaign over random scenes lasts as long as one likes.
    [[ $example == campaign ]] && continue
    printf '\n== %s\n' "$example"
    cargo run --quiet --release --example "$example"
done
printf '\nall in %s s, pictures in target/gallery\n' "$SECONDS"
