#!/usr/bin/env bash
# Builds the program of the golden hashes in the ways that are promised to give the same bits, and runs it.
#   matrix.sh BUILD_FOLDER [WAY...]     ways: gcc-O0 gcc-O2 gcc-O3 clang-O0 clang-O2 clang-O3 asan-ubsan tsan aarch64 armhf riscv64
# Prints a line for each way and ends with 1 when any of them differs. `aarch64` and `armhf` (32 bits) make their sysroots from
# Debian's packages (as root, over the network), riscv64 its libraries from Debian's sources, since Debian 12 has none for it;
# where they cannot be had and no way fails, the end is 77.
set -uo pipefail
source=$(cd "$(dirname "$0")/../.." && pwd)
folder=$(mkdir -p "$1" && cd "$1" && pwd)
shift
[ $# -gt 0 ] || set -- gcc-O0 gcc-O2 gcc-O3 clang-O0 clang-O2 clang-O3 asan-ubsan tsan aarch64 armhf riscv64

sysroot_packages="libxxhash-dev zlib1g-dev libtinygltf-dev libmeshoptimizer-dev libdraco-dev libpugixml-dev nlohmann-json3-dev libglm-dev libhidapi-dev libgtest-dev libusb-1.0-0-dev libevdev-dev libpng-dev libjpeg62-turbo-dev libwebp-dev"

# cross WAY ARCHITECTURE TRIPLET EMULATOR: the other machine, built with Debian's cross compiler and run in emulation.
cross() {
  local way=$1 sysroot=$folder/sysroot-$2
  # shellcheck disable=SC2086
  if command -v "$3-g++-12" >/dev/null && command -v "$4" >/dev/null && "$source/ui/install/sysroot.sh" "$2" "$sysroot" $sysroot_packages; then
    PENPOSE_TRIPLET=$3 PENPOSE_SYSROOT=$sysroot run "$way" -DCMAKE_TOOLCHAIN_FILE="$source/ui/install/cross.cmake" -DCMAKE_CXX_FLAGS=-O1 -DPENPOSE_UNITY=ON || failed=1
  else
    echo "$way: left out, its compiler or the packages of its sysroot cannot be had"
    left_out=1
  fi
}

# from_sources: the same for riscv64, without tests of what reads tablets.
from_sources() {
  export PENPOSE_TRIPLET=riscv64-linux-gnu PENPOSE_SYSROOT=$folder/libraries-riscv64
  local toolchain=-DCMAKE_TOOLCHAIN_FILE=$source/ui/install/cross.cmake
  if command -v $PENPOSE_TRIPLET-g++-12 >/dev/null && command -v qemu-riscv64 >/dev/null && "$source/ui/install/foreign_libraries.sh" "$PENPOSE_SYSROOT" "$toolchain"; then
    run riscv64 "$toolchain" -DCMAKE_CXX_FLAGS=-O1 -DPENPOSE_UNITY=ON -DPENPOSE_DEVICES=OFF || failed=1
  else
    echo "riscv64: left out, its compiler or the sources of its libraries cannot be had"
    left_out=1
  fi
}

run() {
  local way=$1
  # One thread has no races to be found.
  local threads=1
  [ "$way" = tsan ] && threads=4
  shift
  local build=$folder/$way
  cmake -S "$source" -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=None -DPENPOSE_UI=OFF -DPENPOSE_GOLDEN=ON \
    -DPENPOSE_UNITY=OFF -DPENPOSE_PRECOMPILED=OFF "$@" >"$build.log" 2>&1 &&
    cmake --build "$build" --target golden >>"$build.log" 2>&1 &&
    ctest --test-dir "$build" --output-on-failure -R "^golden/${threads}_threads\$|^other_machine/" >>"$build.log" 2>&1
  local result=$?
  if [ $result = 0 ]; then
    echo "$way: equal"
  else
    echo "$way: FAILED, see $build.log"
    tail -n 15 "$build.log"
  fi
  return $result
}

failed=0
left_out=0
for way in "$@"; do
  case $way in
    gcc-O?) run "$way" -DCMAKE_CXX_COMPILER=g++ -DCMAKE_CXX_FLAGS="-${way#gcc-}" || failed=1 ;;
    clang-O?) run "$way" -DCMAKE_CXX_COMPILER=clang++-14 -DCMAKE_CXX_FLAGS="-${way#clang-}" || failed=1 ;;
    asan-ubsan) run "$way" -DCMAKE_CXX_COMPILER=g++ -DCMAKE_CXX_FLAGS=-O1 -DPENPOSE_SANITIZE=address,undefined || failed=1 ;;
    tsan) run "$way" -DCMAKE_CXX_COMPILER=g++ -DCMAKE_CXX_FLAGS=-O1 -DPENPOSE_SANITIZE=thread || failed=1 ;;
    aarch64) cross "$way" arm64 aarch64-linux-gnu qemu-aarch64 ;;
    armhf) cross "$way" armhf arm-linux-gnueabihf qemu-arm ;;
    riscv64) from_sources ;;
    *) echo "no way is called $way" && exit 2 ;;
  esac
done
[ $failed = 0 ] && [ $left_out = 1 ] && exit 77
exit $failed
