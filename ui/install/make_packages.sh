#!/usr/bin/env bash
# make_packages.sh FOLDER [ARCHITECTURE...]: the Debian packages of all components, for amd64, arm64 and armhf unless
# ARCHITECTURE says which, in FOLDER/packages. Everything is built in FOLDER; machines other than this one against a sysroot
# (sysroot.sh). PENPOSE_JOBS says how many compilers run at a time (one a core without it).
set -euo pipefail
source=$(cd "$(dirname "$0")/../.." && pwd)
folder=$(mkdir -p "$1" && cd "$1" && pwd)
shift
[ $# -gt 0 ] || set -- amd64 arm64 armhf
native=$(dpkg --print-architecture)
mkdir -p "$folder/packages"

# build ARCHITECTURE OPTION...: configures, builds and packs.
build() {
  local tree=$folder/$1
  shift
  cmake -S "$source" -B "$tree" -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_INSTALL_PREFIX=/usr -DPENPOSE_TESTS=OFF \
    -DPENPOSE_ZSH_FOLDER=share/zsh/vendor-completions "$@" >"$tree.log" 2>&1 &&
    cmake --build "$tree" ${PENPOSE_JOBS:+-j "$PENPOSE_JOBS"} >>"$tree.log" 2>&1 &&
    (cd "$tree" && rm -f ./*.deb && cpack >>"$tree.log" 2>&1 && mv ./*.deb "$folder/packages/")
}

for architecture in "$@"; do
  options=()
  if [ "$architecture" != "$native" ]; then
    case $architecture in
      arm64) export PENPOSE_TRIPLET=aarch64-linux-gnu ;;
      armhf) export PENPOSE_TRIPLET=arm-linux-gnueabihf ;;
      *) echo "no packages are made for $architecture on $native" >&2; exit 2 ;;
    esac
    export PENPOSE_SYSROOT=$folder/sysroot-$architecture
    "$source/ui/install/sysroot.sh" "$architecture" "$PENPOSE_SYSROOT"
    # Where a size has 32 bits the compiler warns of sizes that it would not warn of here.
    options=(-DCMAKE_TOOLCHAIN_FILE="$source/ui/install/cross.cmake" -DCMAKE_INSTALL_LIBDIR="lib/$PENPOSE_TRIPLET"
      -DPENPOSE_WERROR=OFF)
  fi
  if ! build "$architecture" ${options[@]+"${options[@]}"}; then
    echo "$architecture: FAILED, see $folder/$architecture.log" >&2
    tail -n 15 "$folder/$architecture.log" >&2
    exit 1
  fi
  echo "$architecture: $(ls "$folder"/packages/*_"$architecture".deb | wc -l) packages"
done
