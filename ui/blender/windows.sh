#!/usr/bin/env bash
# windows.sh FOLDER [OPTION...]: the add-on's library for Windows on x86-64, FOLDER/penpose.dll, cross compiled with MinGW-w64, with its
# libraries from Debian's source packages in it, and FOLDER/play_golden.exe, which tries it. OPTIONs are those of CMake. What is there
# already is not built again.
set -euo pipefail
source=$(cd "$(dirname "$0")/../.." && pwd)
folder=$(mkdir -p "$1" && cd "$1" && pwd)
shift
export PENPOSE_SYSROOT=$folder/libraries
toolchain=-DCMAKE_TOOLCHAIN_FILE=$source/ui/blender/windows.cmake
"$source/ui/install/foreign_libraries.sh" "$PENPOSE_SYSROOT" "$toolchain"
# The numbers of the kernel's events, which recordings of tablets hold everywhere.
mkdir -p "$PENPOSE_SYSROOT/usr/include/linux"
cp -u /usr/include/linux/input-event-codes.h "$PENPOSE_SYSROOT/usr/include/linux/"
cmake -S "$source" -B "$folder/penpose" -G Ninja "$toolchain" -DCMAKE_BUILD_TYPE=Release -DPENPOSE_UI=OFF -DPENPOSE_DEVICES=OFF \
  -DPENPOSE_LIBUSB=OFF -DPENPOSE_OPENMESH=OFF -DPENPOSE_SOUND=OFF "$@" >"$folder/penpose.log" 2>&1 &&
  cmake --build "$folder/penpose" -j "${PENPOSE_JOBS:-2}" --target penpose_windows play_golden >>"$folder/penpose.log" 2>&1 || { tail -n 20 "$folder/penpose.log" >&2; exit 1; }
cp -u "$folder"/penpose/ui/blender/{penpose.dll,play_golden.exe} "$folder/"
