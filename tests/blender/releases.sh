#!/usr/bin/env bash
# releases.sh ZIP FOLDER [RELEASE...]: the tests of the add-on in the Blenders of other releases of Debian (trixie: 4.3, sid: what is newest),
# each in a root of its own in FOLDER, made by debootstrap where it is not there. As root, over the network; 2 GB and ten minutes a release.
# Prints what holds; ends with 1 where something does not. MODELS names a folder of models, as PENPOSE_SHARED_DIR/meshes.
set -uo pipefail
source=$(cd "$(dirname "$0")/../.." && pwd)
zip=$(realpath "$1")
folder=$(mkdir -p "$2" && cd "$2" && pwd)
shift 2
[ $# -gt 0 ] || set -- trixie sid
mirror=$(apt-get indextargets --format '$(RELEASE) $(REPO_URI)' 'Created-By: Packages' | awk '$1 == "bookworm" {print $2; exit}')
failed=0
for release in "$@"; do
  root=$folder/$release
  if [ ! -e "$root/complete" ]; then
    # What its own tools need beside it is named: debootstrap knows no alternatives.
    debootstrap --variant=minbase --include=blender,python3-numpy,python3-cattr,python3-requests "$release" "$root" "$mirror" >"$root.log" 2>&1 ||
      { cp /etc/resolv.conf "$root/etc/" && chroot "$root" sh -c 'apt-get update -q -o Acquire::Check-Valid-Until=false && apt-get install -fqy' >>"$root.log" 2>&1; } ||
      { tail -n 3 "$root.log" >&2; exit 1; }
    touch "$root/complete"
  fi
  rm -rf "$root/penpose"
  mkdir -p "$root/penpose/tests/blender" "$root/penpose/ui" "$root/penpose/models"
  cp -r "$source/tests/blender/addon" "$root/penpose/tests/blender/"
  cp -r "$source"/ui/{blender,python} "$root/penpose/ui/"
  cp "$source/LICENSE" "$zip" "$root/penpose/"
  [ -z "${MODELS:-}" ] || cp "$MODELS"/* "$root/penpose/models/"
  mountpoint -q "$root/proc" || mount -t proc proc "$root/proc"
  chroot "$root" blender --version | head -n 1
  for test in "$source"/tests/blender/addon/*.py; do
    name=$(basename "$test" .py)
    case $name in desk|trial|made|face_rig|window|speed) continue ;; esac
    grep -q '^desk.install\|^ZIP' "$test" || continue
    mkdir -p "$root/penpose/home/$name"
    said=$(chroot "$root" env HOME="/penpose/home/$name" timeout 600 blender --background --factory-startup --python-exit-code 1 --python \
      "/penpose/tests/blender/addon/$name.py" -- "/penpose/$(basename "$zip")" /penpose/models 2>&1) || failed=1
    echo "$release, $name: $(grep -E 'tests, .* wrong' <<<"$said" || tail -n 1 <<<"$said")"
    grep WRONG <<<"$said"
  done
  umount "$root/proc"
done
exit $failed
