#!/usr/bin/env bash
# machines.sh FOLDER [ARCHITECTURE...]: the packages of other machines (arm64 and armhf without ARCHITECTURE), built in FOLDER by
# Debian's cross compilers, looked at as those of this one are (packages_test.py), and put into a fresh Debian of that machine and
# taken out again (root_test.sh): the program with the libraries, and the program without a window. As root, over the network;
# half an hour and more a machine. Prints what holds; ends with 1 where something does not, with 77 where something could not be
# tried. PENPOSE_JOBS says how many compilers run at a time.
set -uo pipefail
source=$(cd "$(dirname "$0")/../.." && pwd)
folder=$(mkdir -p "$1" && cd "$1" && pwd)
shift
[ $# -gt 0 ] || set -- arm64 armhf
result=0

# hold NAME COMMAND...: prints what the command says, each line with NAME before it, and remembers how it ended.
hold() {
  local name=$1 ended
  shift
  "$@" > >(sed "s/^/$name: /") 2>&1
  ended=$?
  wait $!
  case $ended in
    0) ;;
    77) [ "$result" != 0 ] || result=77 ;;
    *) result=1 ;;
  esac
  return $ended
}

for architecture in "$@"; do
  hold "$architecture" "$source/ui/install/make_packages.sh" "$folder" "$architecture" || continue
  case $architecture in
    arm64) emulator=qemu-aarch64 ;;
    armhf) emulator=qemu-arm ;;
    *) echo "$architecture is not emulated" >&2; exit 2 ;;
  esac
  hold "$architecture, packages" /usr/bin/python3 "$source/tests/install/packages_test.py" "$folder/$architecture" \
    "$folder/looked-at-$architecture" "$emulator" -L "$folder/sysroot-$architecture"
  packed=$folder/packages
  hold "$architecture, penpose" "$source/tests/install/root_test.sh" "$folder/roots" "$architecture" "$source/tests/golden/hashes.txt" \
    "$packed"/{penpose,libpenpose0,libpenpose-dev}_*_"$architecture".deb "$packed"/python3-penpose_*_all.deb
  hold "$architecture, penpose-nogui" "$source/tests/install/root_test.sh" "$folder/roots" "$architecture" \
    "$source/tests/golden/hashes.txt" "$packed"/penpose-nogui_*_"$architecture".deb
done
exit $result
