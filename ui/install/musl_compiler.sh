#!/usr/bin/env bash
# musl_compiler.sh FOLDER: a C++ compiler for static programs of musl, FOLDER/bin/musl-g++ and musl-gcc; cross.cmake takes
# it. Debian 12 has musl for C alone (musl-tools), so libstdc++ is built from gcc-12-source, unpatched, with the
# compiler that the machine has. Needs the packages g++-12, gcc-12-source, musl-tools, linux-libc-dev and make. Three minutes.
set -euo pipefail
source=$(cd "$(dirname "$0")" && pwd)
folder=$(mkdir -p "$1" && cd "$1" && pwd)
[ -e "$folder/complete" ] && exit 0
packed=$(echo /usr/src/gcc-12/gcc-12*.tar.xz)
musl=/usr/lib/$(uname -m)-linux-musl
for needed in "$packed" "$musl/libc.a" "/usr/include/$(uname -m)-linux-gnu/asm" /usr/bin/g++-12; do
  [ -e "$needed" ] || { echo "there is no $needed: install g++-12, gcc-12-source, musl-tools and linux-libc-dev" >&2; exit 1; }
done

# The kernel's headers, without glibc's beside them.
mkdir -p "$folder/kernel" "$folder/bin" "$folder/lib"
for name in linux asm-generic drm mtd misc; do ln -sfn "/usr/include/$name" "$folder/kernel/$name"; done
ln -sfn "/usr/include/$(uname -m)-linux-gnu/asm" "$folder/kernel/asm"

# How a static program of musl is linked. Debian's libgcc_eh is glibc's; the one thing that it asks glibc for is unwind_tables.o.
cat >"$folder/musl.specs" <<END
*link_libgcc:
-L$folder/lib -L$musl -L .%s

*libgcc:
libgcc.a%s libgcc_eh.a%s

*startfile:
$musl/rcrt1.o $musl/crti.o crtbeginS.o%s $folder/lib/unwind_tables.o

*endfile:
crtendS.o%s $musl/crtn.o

*link:
-nostdlib -static -pie --no-dynamic-linker -z text --eh-frame-hdr

END
headers="-nostdinc -isystem /usr/include/$(uname -m)-linux-musl -isystem $(dirname "$(g++-12 -print-libgcc-file-name)")/include -isystem $folder/kernel"
# compiler NAME COMMAND OPTION...
compiler() { printf '#!/bin/sh\nexec %s "$@"\n' "${*:2}" >"$folder/bin/$1" && chmod +x "$folder/bin/$1"; }
compiler musl-gcc gcc-12 -specs="$folder/musl.specs" "$headers"
compiler musl-g++-bare g++-12 -specs="$folder/musl.specs" -nostdinc++ "$headers"
"$folder/bin/musl-gcc" -O2 -c "$source/musl_unwind_tables.c" -o "$folder/lib/unwind_tables.o"

mkdir -p "$folder/gcc" "$folder/build" "$folder/libgcc"
tar -xf "$packed" -C "$folder/gcc" --strip-components 1 --exclude 'gcc-*/gcc/*/*' --exclude '*/testsuite/*/*'
# What a build of libgcc leaves there for libstdc++.
ln -sfn ../gcc/libgcc/gthr-posix.h "$folder/libgcc/gthr-default.h"
cd "$folder/build"
"$folder/gcc/libstdc++-v3/configure" --build="$(uname -m)-linux-gnu" --host="$(uname -m)-linux-musl" --prefix="$folder" --libdir="$folder/lib" \
  --disable-shared --disable-multilib --disable-nls --disable-libstdcxx-pch --disable-libstdcxx-verbose --with-gxx-include-dir="$folder/include/c++" \
  CC="$folder/bin/musl-gcc" CXX="$folder/bin/musl-g++-bare" CFLAGS="-O2 -fPIC" CXXFLAGS="-O2 -fPIC" >"$folder/libstdcxx.log" 2>&1 &&
  make -j"${PENPOSE_JOBS:-2}" >>"$folder/libstdcxx.log" 2>&1 && make install >>"$folder/libstdcxx.log" 2>&1 || { tail -n 15 "$folder/libstdcxx.log" >&2; exit 1; }
compiler musl-g++ g++-12 -specs="$folder/musl.specs" -nostdinc++ -isystem "$folder/include/c++" -isystem "$folder/include/c++/$(uname -m)-linux-musl" \
  -isystem "$folder/include/c++/backward" "$headers"
touch "$folder/complete"
