#!/usr/bin/env bash
# looks.sh PROGRAM THREE_FOLDER CHROMIUM OUT.png MODEL...: the heads of models as penpose, three.js, Blender's Workbench and its Eevee draw
# them, a row a model, for whoever changes how models look. THREE_FOLDER is that of tests/three. It takes Blender, Xvfb and ImageMagick.
set -euo pipefail
program=$(realpath "$1") three=$(realpath "$2") chromium=$3 out=$4
shift 4
here=$(cd "$(dirname "$0")" && pwd)
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
node "$here/../three/looks.js" "$three" "$chromium" "$folder" "$@"
xvfb-run -a blender -b -P "$here/looks_blender.py" -- "$folder" "$@" >"$folder/said" 2>&1 || { cat "$folder/said"; exit 1; }
cells=()
for model in "$@"; do
  name=$(basename "${model%.*}")
  "$program" render "$model" --camera "$folder/${name}_camera.json" --size 512x512 --shadows -o "$folder/${name}_penpose.png"
  for by in penpose three workbench eevee; do cells+=(-label "$name: $by" "$folder/${name}_$by.png"); done
done
montage "${cells[@]}" -tile 4x -geometry 512x512+2+2 "$out"
