#!/usr/bin/env bash
# Installs a build folder into a fresh prefix and builds programs with it: with CMake against the shared and the static
# library, as plug-ins, and, from a different folder, with pkg-config. An archive made by bindings/c/pack may replace the
# build folder.
#   installed.sh BUILD CMAKE CC CXX
set -euo pipefail
build=$1 cmake=$2 cc=$3 cxx=$4
here=$(cd "$(dirname "$0")" && pwd)
work=$(mktemp -d)
trap 'rm -r "$work"' EXIT

# The pkg-config file is valid in the installed folder only.
[[ ! -e $build/stickslip.pc ]]
if [[ -d $build ]]; then
    "$cmake" --install "$build" --prefix "$work/prefix" >/dev/null
else
    mkdir "$work/prefix"
    tar -C "$work/prefix" --strip-components=1 -xzf "$build"
fi
"$cmake" -S "$here/consumer" -B "$work/build" -DCMAKE_PREFIX_PATH="$work/prefix" -DCMAKE_C_COMPILER="$cc" \
    -DCMAKE_CXX_COMPILER="$cxx" >/dev/null
"$cmake" --build "$work/build" >/dev/null
"$work/build/shared" 32 >/dev/null
"$work/build/static" 32 >/dev/null
# Lists the symbols exported by a shared library that includes the static library. They must be its own symbols or symbols
# of the interface; Rust symbols are not allowed.
shown() {
    nm --dynamic --defined-only "$work/build/$1" | awk '{ print $3 }'
}
[[ $(shown libplugin.so) == plugin_modulus ]]
[[ $(shown libwithin.so | grep -vc '^stickslip_') == 0 && $(shown libwithin.so) == *stickslip_history_step* ]]
if command -v pkg-config >/dev/null; then
    # The folder is moved: the pkg-config file must determine its location without an environment variable.
    mv "$work/prefix" "$work/moved"
    PKG_CONFIG_PATH=$(dirname "$(find "$work/moved" -name stickslip.pc)")
    export PKG_CONFIG_PATH
    [[ $(realpath "$(pkg-config --variable=prefix stickslip)") == $(realpath "$work/moved") ]]
    read -ra flags < <(pkg-config --cflags --libs stickslip)
    lib=$(pkg-config --variable=libdir stickslip)
    "$cc" "$here/../examples/press_and_shear.c" "${flags[@]}" "-Wl,-rpath,$lib" -lm -o "$work/program"
    "$work/program" 32 >/dev/null
    [[ -f $(pkg-config --variable=fortrandir stickslip)/stickslip.f90 ]]
fi
