#!/bin/sh
# A test of the add-on with Blender's windows open, drawn as they are for a person: in_window.sh BLENDER TEST.py ZIP [FOLDER]
# Under Xvfb, whose colours are those of llvmpipe. 77 without it.
command -v Xvfb >/dev/null || { echo "Xvfb is not here"; exit 77; }
work=$(mktemp -d)
mkdir "$work/home"
Xvfb -displayfd 3 -screen 0 1380x860x24 3>"$work/display" 2>/dev/null &
server=$!
for _ in $(seq 50); do [ -s "$work/display" ] && break; sleep 0.2; done
DISPLAY=:$(cat "$work/display")
export DISPLAY HOME="$work/home" LIBGL_ALWAYS_SOFTWARE=1
unset WAYLAND_DISPLAY
blender=$1 test=$2
shift 2
"$blender" --factory-startup --window-geometry 0 0 1380 860 --python-exit-code 1 --python "$test" -- "$@" >"$work/log" 2>&1
ended=$?
cat "$work/log"
# Blender says there what goes wrong while it draws.
grep -qE 'Traceback|Error' "$work/log" && ended=1
kill "$server"
wait 2>/dev/null
rm -rf "$work"
exit "$ended"
