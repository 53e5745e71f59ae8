#!/usr/bin/env bash
# options.sh FOLDER: configures what a board may leave out in every way that makes sense, and some that make none, which end with
# an error that says what to set. Seconds each; nothing is compiled.
set -uo pipefail
source=$(cd "$(dirname "$0")/../.." && pwd)
folder=$(mkdir -p "$1" && cd "$1" && pwd)
failed=0

# configure NAME OPTION...: its log is NAME.log.
configure() {
  local name=$1
  shift
  rm -rf "${folder:?}/$name"
  cmake -S "$source" -B "$folder/$name" -G Ninja -DPENPOSE_TESTS=OFF "$@" >"$folder/$name.log" 2>&1
}

# works NAME NOT-NEEDED OPTION...: NOT-NEEDED is a pattern of libraries that such a build does not even look for.
works() {
  local name=$1 absent=$2
  shift 2
  if ! configure "$name" "$@"; then
    echo "$name: FAILED, see $folder/$name.log" && tail -n 5 "$folder/$name.log" && failed=1
  elif grep -qE "^($absent)_(FOUND|DIR|LIBRARY)[:_]" "$folder/$name/CMakeCache.txt"; then
    echo "$name: FAILED, it looks for what it does not need:" && failed=1
    grep -E "^($absent)_(FOUND|DIR|LIBRARY)[:_]" "$folder/$name/CMakeCache.txt"
  else
    echo "$name: configured"
  fi
}

# refused NAME WORDS OPTION...: the error has the words.
refused() {
  local name=$1 words=$2
  shift 2
  if configure "$name" "$@"; then
    echo "$name: FAILED, it is configured" && failed=1
  elif ! grep -q -- "$words" "$folder/$name.log"; then
    echo "$name: FAILED, its error does not say \"$words\", see $folder/$name.log" && failed=1
  else
    echo "$name: refused"
  fi
}

works whole none
works no_window 'DBUS|SDL2|EPOXY|IMGUI|FONTCONFIG' -DPENPOSE_WINDOW=OFF
works no_window_gl 'IMGUI|FONTCONFIG' -DPENPOSE_WINDOW=OFF -DPENPOSE_GL=ON
works no_gl EPOXY -DPENPOSE_GL=OFF
works no_devices 'HIDAPI|LIBUSB|LIBEVDEV' -DPENPOSE_DEVICES=OFF
works no_libusb 'HIDAPI|LIBUSB' -DPENPOSE_LIBUSB=OFF
works no_openmesh OpenMesh -DPENPOSE_OPENMESH=OFF
works no_sound SNDFILE -DPENPOSE_SOUND=OFF
works no_speech POCKETSPHINX -DPENPOSE_SPEECH=OFF
works no_portal DBUS -DPENPOSE_PORTAL=OFF
works least 'SNDFILE|POCKETSPHINX|DBUS|SDL2|EPOXY|IMGUI|FONTCONFIG|HIDAPI|LIBUSB|LIBEVDEV|OpenMesh' -DPENPOSE_WINDOW=OFF -DPENPOSE_DEVICES=OFF -DPENPOSE_OPENMESH=OFF -DPENPOSE_SOUND=OFF -DPENPOSE_SPEECH=OFF
works library_alone 'SDL2|EPOXY|IMGUI|FONTCONFIG|CLI11' -DPENPOSE_UI=OFF -DPENPOSE_WINDOW=OFF

refused static_window PENPOSE_WINDOW=OFF -DPENPOSE_STATIC=ON -DPENPOSE_WINDOW=ON
refused static_sanitized PENPOSE_SANITIZE -DPENPOSE_STATIC=ON -DPENPOSE_SANITIZE=address
refused libusb_alone PENPOSE_DEVICES=ON -DPENPOSE_DEVICES=OFF -DPENPOSE_LIBUSB=ON
refused no_such_choice 'AUTO, ON or OFF' -DPENPOSE_OPENMESH=perhaps
refused tests_alone PENPOSE_TESTS=OFF -DPENPOSE_TESTS=ON -DPENPOSE_GL=OFF
exit $failed
