#!/usr/bin/env bash
# Installs what was built in a folder into a fresh prefix, and builds programs on it: by CMake against the shared and the
# static library, as plug-ins, and, from another folder, by pkg-config. In the place of the folder there may be an archive, as
# bindings/c/pack makes them. installed.sh BUILD CMAKE CC CXX
set -euo pipefail
build=$1 cmake=$2 cc=$3 cxx=$4
here=$(cd "$(dirname "$0")" && pwd)
work=$(mktemp -d)
trap 'rm -r "$work"' EXIT

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
# Names that shared libraries with the static library within show: their own, or those of the interface; none of Rust.
shown() {
    nm --dynamic --defined-only "$work/build/$1" | awk '{ print $3 }'
}
[[ $(shown libplugin.so) == plugin_modulus ]]
[[ $(shown libwithin.so | grep -vc '^stickslip_') == 0 && $(shown libwithin.so) == *stickslip_history_step* ]]
if command -v pkg-config >/dev/null; then
    # The folder is moved: the file tells where it lies, without a variable that is set from outside.
    mv "$work/prefix" "$work/moved"
    PKG_CONFIG_PATH=$(dirname "$(find "$work/moved" -name stickslip.pc)")
    export PKG_CONFIG_PATH
    read -ra flags < <(pkg-config --cflags --libs stickslip)
    lib=$(pkg-config --variable=libdir stickslip)
    "$cc" "$here/../examples/press_and_shear.c" "${flags[@]}" -lm -o "$work/program"
    LD_LIBRARY_PATH=$lib "$work/program" 32 >/dev/null
    [[ -f $(pkg-config --variable=fortrandir stickslip)/stickslip.f90 ]]
fi
