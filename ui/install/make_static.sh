#!/usr/bin/env bash
# make_static.sh FOLDER [OPTION...]: penpose without its window as one static program, FOLDER/penpose/ui/penpose, which runs on any
# Linux of this machine's kind. OPTIONs are those of CMake. Debian has archives of all libraries but meshoptimizer, which is built
# from its source package.
set -euo pipefail
source=$(cd "$(dirname "$0")/../.." && pwd)
folder=$(mkdir -p "$1" && cd "$1" && pwd)
shift
if [ ! -e "$folder/libraries/lib/libmeshoptimizer.a" ]; then
  "$source/ui/install/debian_source.sh" "$folder/sources" meshoptimizer
  cmake -S "$folder"/sources/meshoptimizer-* -B "$folder/meshoptimizer" -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_POSITION_INDEPENDENT_CODE=ON \
    -DCMAKE_INSTALL_LIBDIR=lib -DCMAKE_INSTALL_PREFIX="$folder/libraries" >"$folder/meshoptimizer.log"
  cmake --build "$folder/meshoptimizer" --target install >>"$folder/meshoptimizer.log"
fi
cmake -S "$source" -B "$folder/penpose" -G Ninja -DCMAKE_BUILD_TYPE=Release -DPENPOSE_STATIC=ON -DPENPOSE_TESTS=OFF \
  -DCMAKE_PREFIX_PATH="$folder/libraries" "$@" >"$folder/penpose.log"
cmake --build "$folder/penpose" >>"$folder/penpose.log"
strip -o "$folder/penpose-static" "$folder/penpose/ui/penpose"
echo "$folder/penpose-static: $(stat -c %s "$folder/penpose-static") bytes"
