#!/usr/bin/env bash
# Builds the program of the golden hashes in the ways that are promised to give the same bits, and runs it.
#   matrix.sh BUILD_FOLDER [WAY...]     ways: gcc-O0 gcc-O2 gcc-O3 clang-O0 clang-O2 clang-O3 asan-ubsan tsan aarch64
# Prints a line for each way and ends with 1 when any of them differs. `aarch64` makes its sysroot from Debian's packages (as
# root, over the network); where they cannot be had and no way fails, the end is 77.
set -uo pipefail
source=$(cd "$(dirname "$0")/../.." && pwd)
folder=$(mkdir -p "$1" && cd "$1" && pwd)
shift
[ $# -gt 0 ] || set -- gcc-O0 gcc-O2 gcc-O3 clang-O0 clang-O2 clang-O3 asan-ubsan tsan aarch64

sysroot_packages="libxxhash-dev libxxhash0 libopenmesh-dev libopenmesh1 libtinygltf-dev libtinygltf2d nlohmann-json3-dev libglm-dev
  libhidapi-dev libhidapi-hidraw0 libhidapi-libusb0 libgtest-dev libusb-1.0-0-dev libusb-1.0-0 libudev-dev libudev1 libcap2"

make_sysroot() {
  command -v aarch64-linux-gnu-g++-12 >/dev/null && command -v qemu-aarch64 >/dev/null || return 1
  local complete
  complete=$folder/sysroot/complete-$(cksum <<<"$sysroot_packages" | cut -d ' ' -f 1)
  [ -e "$complete" ] && return 0
  rm -rf "$folder/sysroot" "$folder/packages"
  mkdir -p "$folder/sysroot" "$folder/packages"
  local foreign
  foreign=$(dpkg --print-foreign-architectures)
  dpkg --add-architecture arm64 && apt-get update -qq >/dev/null || return 1
  local result=0
  (cd "$folder/packages" && for package in $sysroot_packages; do
    apt-get download -qq "$package:arm64" 2>/dev/null || apt-get download -qq "$package" 2>/dev/null || exit 1
  done) || result=1
  # The machine is left as it was found.
  case " $foreign " in *arm64*) ;; *) dpkg --remove-architecture arm64; apt-get update -qq >/dev/null ;; esac
  [ $result = 0 ] || return 1
  for package in "$folder"/packages/*.deb; do dpkg -x "$package" "$folder/sysroot" || return 1; done
  touch "$complete"
}

run() {
  local way=$1
  # One thread has no races to be found.
  local threads=1
  [ "$way" = tsan ] && threads=4
  shift
  local build=$folder/$way
  cmake -S "$source" -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=None -DPENPOSE_WERROR=OFF -DPENPOSE_UI=OFF -DPENPOSE_TESTS=OFF \
    -DPENPOSE_GOLDEN=ON "$@" >"$build.log" 2>&1 &&
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
    aarch64)
      if make_sysroot; then
        PENPOSE_SYSROOT=$folder/sysroot run "$way" -DCMAKE_TOOLCHAIN_FILE="$source/tests/golden/aarch64.cmake" \
          -DCMAKE_CXX_FLAGS=-O1 || failed=1
      else
        echo "aarch64: left out, the packages of the sysroot cannot be had"
        left_out=1
      fi
      ;;
    *) echo "no way is called $way" && exit 2 ;;
  esac
done
[ $failed = 0 ] && [ $left_out = 1 ] && exit 77
exit $failed
