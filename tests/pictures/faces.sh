#!/usr/bin/env bash
# faces.sh PROGRAM MODELS: makes faces.png beside this file: eight drawings of faces, and four rigs that have taken them.
# PROGRAM is penpose, MODELS the folder `meshes` of the shared data. It takes ImageMagick and half a minute.
set -euo pipefail
program=$(realpath "$1") models=$(realpath "$2")
here=$(cd "$(dirname "$0")" && pwd)
drawings=$here/../judges/drawing/sets/seen
shown=(anime_happy mouse_laugh notebook_sad emoji_angry pencil_surprised caricature_wink_R gesture_smirk_L notebook_kiss)
cell=150
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

cells=()
for name in "${shown[@]}"; do
  drawing=$drawings/${name%%_*}/$name.svg
  # Magnified first, for a small drawing has few pixels.
  convert -density 288 "$drawing" -background white -alpha remove -trim +repage -resize $((cell - 14))x$((cell - 14)) \
    -gravity center -extent ${cell}x$cell "$folder/$name.png"
  cells+=("$folder/$name.png")
done

# Cropped to the face, for what the README shows is small.
for model in builtin:demo "$models"/ict_face.glb "$models"/ict_avatar.glb "$models"/ict_face_narrow.glb; do
  pixels=300 top=42
  [ "$model" != builtin:demo ] || { pixels=340 top=20; }
  for name in "${shown[@]}"; do
    face=$folder/$(basename "$model" .glb)_$name
    "$program" draw "$model" "$drawings/${name%%_*}/$name.svg" -o "$face.glb" >"$folder/said" 2>&1 || { cat "$folder/said"; exit 1; }
    "$program" render "$face.glb" --view face --size ${pixels}x$pixels --draw cpu -o "$face.png"
    convert "$face.png" -gravity north -crop 240x240+0+$top +repage -resize ${cell}x$cell "$face.png"
    cells+=("$face.png")
  done
done
montage "${cells[@]}" -tile "${#shown[@]}x" -geometry +1+1 "$folder/sheet.png"
convert "$folder/sheet.png" -dither FloydSteinberg -colors 256 -depth 8 -strip -define png:compression-level=9 "PNG8:$here/faces.png"
