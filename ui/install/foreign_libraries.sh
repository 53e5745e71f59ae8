#!/usr/bin/env bash
# foreign_libraries.sh [--tests] FOLDER [OPTION...]: archives of the libraries that penpose without window and tablets is built from, for a machine or a C
# library that Debian 12 has no packages of (riscv64, musl), from Debian's source packages in FOLDER. OPTIONs are those that
# CMake needs to compile for it, as -DCMAKE_TOOLCHAIN_FILE=... Libraries that are headers alone are this machine's. With --tests those
# of the tests of core and replay, too, GoogleTest from the package googletest.
set -euo pipefail
source=$(cd "$(dirname "$0")/../.." && pwd)
tests=
[ "$1" = --tests ] && tests=tinygltf && shift
folder=$(mkdir -p "$1" && cd "$1" && pwd)
shift
[ -e "$folder/complete" ] && exit 0
packages="zlib xxhash meshoptimizer draco pugixml libpng1.6 libjpeg-turbo libwebp $tests"
# shellcheck disable=SC2086
[ -e "$folder/sources/complete" ] || { "$source/ui/install/debian_source.sh" "$folder/sources" $packages && touch "$folder/sources/complete"; }

# [target=TARGET] build PACKAGE [OPTION...]
build() {
  local package=$1 tree=$folder/sources/$1-*
  shift
  # shellcheck disable=SC2086
  [ "$package" = xxhash ] && tree=$(echo $tree)/cmake_unofficial
  # shellcheck disable=SC2086
  cmake -S $tree -B "$folder/$package" -G Ninja -DCMAKE_BUILD_TYPE=Release -DBUILD_SHARED_LIBS=OFF -DCMAKE_POSITION_INDEPENDENT_CODE=ON \
    -DCMAKE_INSTALL_PREFIX="$folder/usr" -DCMAKE_INSTALL_LIBDIR=lib -DCMAKE_PREFIX_PATH="$folder/usr" "${options[@]}" "$@" >"$folder/$package.log" 2>&1 &&
    cmake --build "$folder/$package" -j "${PENPOSE_JOBS:-2}" --target "${target:-install}" >>"$folder/$package.log" 2>&1 || { tail -n 15 "$folder/$package.log" >&2; exit 1; }
}
options=("$@")
# Debian leaves out a file of another system that is named all the same.
for tree in "$folder"/sources/zlib-*/; do mkdir -p "$tree/win32" && touch "$tree/win32/zlib1.rc"; done
# All that it installs has a shared library beside the archive, which not every compiler makes.
target=zlibstatic build zlib
mkdir -p "$folder/usr/lib" "$folder/usr/include"
cp "$folder"/zlib/libz*.a "$folder/usr/lib/libz.a"
cp "$folder"/sources/zlib-*/zlib.h "$folder/zlib/zconf.h" "$folder/usr/include/"
build xxhash -DXXHASH_BUILD_XXHSUM=OFF
build meshoptimizer
build draco
build pugixml -DBUILD_TESTING=OFF
build libpng1.6 -DPNG_SHARED=OFF -DPNG_TESTS=OFF
build libjpeg-turbo -DCMAKE_INSTALL_LIBDIR="$folder/usr/lib" -DENABLE_SHARED=OFF -DWITH_SIMD=OFF -DWITH_TURBOJPEG=OFF
build libwebp -DWEBP_BUILD_ANIM_UTILS=OFF -DWEBP_BUILD_CWEBP=OFF -DWEBP_BUILD_DWEBP=OFF -DWEBP_BUILD_GIF2WEBP=OFF -DWEBP_BUILD_IMG2WEBP=OFF \
  -DWEBP_BUILD_VWEBP=OFF -DWEBP_BUILD_WEBPINFO=OFF -DWEBP_BUILD_WEBPMUX=OFF -DWEBP_BUILD_EXTRAS=OFF
mkdir -p "$folder/usr/lib/pkgconfig"
[ -e "$folder/usr/lib/pkgconfig/libwebp.pc" ] || cat >"$folder/usr/lib/pkgconfig/libwebp.pc" <<END
Name: libwebp
Description: pictures
Version: 1.2.4
Libs: -L$folder/usr/lib -lwebp
Cflags: -I$folder/usr/include
END
headers="glm CLI nlohmann stb"
[ -n "$tests" ] || headers="$headers tiny_gltf.h"
for header in $headers; do ln -sfn "/usr/include/$header" "$folder/usr/include/$header"; done
mkdir -p "$folder/usr/share/cmake"
cp -r /usr/share/cmake/glm /usr/share/cmake/CLI11 /usr/share/cmake/nlohmann_json "$folder/usr/share/cmake/"
if [ -n "$tests" ]; then
  ln -sfn /usr/src/googletest "$folder/sources/googletest-0"
  build googletest -DBUILD_GMOCK=OFF
  # Debian has an archive of stb; here stb becomes a part of the one file that asks for it, and any archive does in its place.
  build tinygltf -DTINYGLTF_BUILD_LOADER_EXAMPLE=OFF -DBUILD_TESTING=OFF -Dstb_LIBRARY="$folder/usr/lib/libz.a" \
    -DCMAKE_CXX_FLAGS="-DSTB_IMAGE_IMPLEMENTATION -DSTB_IMAGE_WRITE_IMPLEMENTATION"
fi
touch "$folder/complete"
