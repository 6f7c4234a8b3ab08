#!/usr/bin/env bash
# Random calls with the whole of the library under AddressSanitizer, the Rust code too, which a stable compiler instruments
# only when told that it may. Compiles everything anew (minutes): not part of ci. instrumented.sh [calls, default 100000]
set -euo pipefail
cd "$(dirname "$0")/.."
calls=${1:-100000}
target=$(rustc -vV | sed -n 's/^host: //p')
folder=${CARGO_TARGET_DIR:-$PWD/../../target}/instrumented
RUSTC_BOOTSTRAP=1 RUSTFLAGS=-Zsanitizer=address \
    cargo build --release --package stickslip-c --lib --target "$target" --target-dir "$folder"
runtime=$(find "$(rustc --print sysroot)/lib/rustlib/$target/lib" -name 'librustc*_rt.asan.a')
cc -std=c11 -g -O1 -Iinclude tests/fuzz/*.c "$folder/$target/release/libstickslip.a" \
    -Wl,--whole-archive "$runtime" -Wl,--no-whole-archive -lm -lpthread -ldl -lrt -lstdc++ -o "$folder/fuzz"
"$folder/fuzz" "$calls" 4
