#!/usr/bin/env bash
# static.sh FOLDER: builds the static program (ui/install/make_static.sh) and runs it as root in a root that holds nothing else and cannot be
# written to: no /dev, /proc, /sys, /etc, no locale. Says how large it is and how much memory it takes. Minutes long.
set -euo pipefail
[ "$(id -u)" = 0 ] || { echo "left out: only root can make a root of its own"; exit 77; }
source=$(cd "$(dirname "$0")/../.." && pwd)
folder=$(mkdir -p "$1" && cd "$1" && pwd)
"$source/ui/install/make_static.sh" "$folder" -DPENPOSE_UNITY=ON
root=$folder/root
rm -rf "$root"
mkdir -p "$root/out"
cp "$folder/penpose-static" "$root/penpose"
cp "$source/ui/demo/demo.session" "$root"
golden=$(awk '$1 == "demo.session" {print $2}' "$source/tests/golden/hashes.txt")

unshare -m bash -s "$root" "$golden" <<'END'
set -euo pipefail
root=$1 golden=$2
mount --bind "$root" "$root"
mount -o remount,bind,ro "$root"
mount -t tmpfs -o size=64m none "$root/out"
trap 'cat "$root/out/said"' ERR
# penpose LIMIT_KB ARGUMENT...
penpose() {
  local limit=$1 peak
  shift
  peak=$(/usr/bin/time -f %M -o "$root/out/peak" env -i "$(command -v chroot)" "$root" /penpose "$@" >"$root/out/said" 2>&1 && cat "$root/out/peak")
  echo "penpose $*: $peak KB"
  [ "$peak" -le "$limit" ] || { echo "more than $limit KB"; return 1; }
}
penpose 32768 --help
penpose 32768 devices
penpose 32768 replay /demo.session -o /out/face.glb
grep -q "state $golden" "$root/out/said"
penpose 32768 demo -o /out/demo
penpose 49152 render builtin:head -o /out/head.png --size 800x480
[ -s "$root/out/demo/demo.png" ] && [ -s "$root/out/head.png" ]
# What cannot be written is said in one line.
if penpose 32768 replay /demo.session -o /face.glb; then exit 1; fi
grep -q 'Read-only file system' "$root/out/said"
END
