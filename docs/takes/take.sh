#!/bin/sh
# take.sh FACE TAKE OUT: one take as one job. A track becomes a clip of FACE, a recorded session (.session) the project that
# it drew; both become pictures. In OUT are then NAME.glb, NAME/0001.png, ... (of a session NAME.png) and, written last,
# NAME.state.
#
# The job may be killed and run again at any time: every file is whole or not there, and the same take gives the same bytes. A
# take whose NAME.state is there is done and costs nothing. PICTURES=no leaves the pictures out.
set -eu
face=$1 take=$2 out=$3
name=$(basename "$take")
name=${name%.*}
[ ! -e "$out/$name.state" ] || exit 0
mkdir -p "$out"

said=$(mktemp)
trap 'rm -f "$said"' EXIT
case $take in
  *.session)
    penpose replay "$take" -o "$out/$name.glb" --json >"$said"
    [ "${PICTURES:-yes}" = no ] || penpose render "$out/$name.glb" --size 320x320 -o "$out/$name.png"
    ;;
  *)
    penpose animate "$face" --track "$take" -o "$out/$name.glb" --json >"$said"
    [ "${PICTURES:-yes}" = no ] || penpose render "$out/$name.glb" --frames --size 320x320 -o "$out/$name/"
    ;;
esac
sed -n 's/.*"state": *"\([0-9a-f]*\)".*/\1/p' "$said" >"$out/.$name.state"
mv "$out/.$name.state" "$out/$name.state"
