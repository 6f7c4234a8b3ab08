#!/usr/bin/env bash
# Random calls with the whole library under AddressSanitizer, including the Rust code. A stable compiler instruments Rust
# only if RUSTC_BOOTSTRAP is set. The script recompiles everything (minutes) and is not part of ci.
#   instrumented.sh [calls, default 100000]
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
