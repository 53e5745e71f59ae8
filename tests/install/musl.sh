#!/usr/bin/env bash
# musl.sh FOLDER: builds the commands and the tests of core and replay against musl, with a compiler and libraries that are themselves built
# of Debian's sources (ui/install/musl_compiler.sh, foreign_libraries.sh), and runs both. Without patches. A quarter of an hour from nothing;
# ends with 77 where a package is missing.
set -euo pipefail
source=$(cd "$(dirname "$0")/../.." && pwd)
folder=$(mkdir -p "$1" && cd "$1" && pwd)
for package in g++-12 gcc-12-source musl-tools googletest; do
  dpkg-query -W "$package" >/dev/null 2>&1 || { echo "left out, the package $package is not installed"; exit 77; }
done
export PENPOSE_TRIPLET=x86_64-linux-musl PENPOSE_COMPILER=$folder/compiler PENPOSE_SYSROOT=$folder/libraries
toolchain=-DCMAKE_TOOLCHAIN_FILE=$source/ui/install/cross.cmake
"$source/ui/install/musl_compiler.sh" "$PENPOSE_COMPILER"
"$source/ui/install/foreign_libraries.sh" --tests "$PENPOSE_SYSROOT" "$toolchain"
cmake -S "$source" -B "$folder/penpose" -G Ninja "$toolchain" -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_FLAGS_RELEASE="-O1 -DNDEBUG" -DPENPOSE_WERROR=OFF -DPENPOSE_STATIC=ON -DPENPOSE_DEVICES=OFF -DPENPOSE_TESTS=OFF \
  -DPENPOSE_CORE_TESTS=ON -DPENPOSE_GOLDEN=ON -DPENPOSE_UNITY=ON >"$folder/penpose.log"
cmake --build "$folder/penpose" -j "${PENPOSE_JOBS:-2}" >>"$folder/penpose.log" || { tail -n 30 "$folder/penpose.log" >&2; exit 1; }

program=$folder/penpose/ui/penpose
# Nothing of glibc is in it.
if grep -aqE 'GLIBC_|GNU C Library' "$program"; then echo "$program holds parts of glibc" >&2 && exit 1; fi
golden=$(awk '$1 == "demo.session" {print $2}' "$source/tests/golden/hashes.txt")
"$program" replay "$source/ui/demo/demo.session" | grep -q "state $golden"
"$program" render builtin:head -o "$folder/head.png" --size 800x480
ctest --test-dir "$folder/penpose" -j "${PENPOSE_JOBS:-2}" --output-on-failure | tail -n 40
