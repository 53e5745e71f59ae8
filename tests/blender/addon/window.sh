#!/bin/sh
# The add-on in a window that a mouse draws in: window.sh BLENDER ZIP MODEL [FOLDER]
# Draws a smile on ict_face.glb under Xvfb, undoes and redoes it, leaves a stroke by Escape, and takes the add-on away in mid-stroke.
# Screenshots before, during and after land in FOLDER as .xwd, where it is given. 77 without Xvfb or xdotool.
here=$(cd "$(dirname "$0")" && pwd)
for tool in Xvfb xdotool ${4:+xwd}; do
    command -v "$tool" >/dev/null || { echo "$tool is not here"; exit 77; }
done
work=$(mktemp -d)
shots=${4:-}
mkdir "$work/commands" "$work/home"
Xvfb -displayfd 3 -screen 0 1380x860x24 3>"$work/display" 2>/dev/null &
server=$!
for _ in $(seq 50); do [ -s "$work/display" ] && break; sleep 0.2; done
DISPLAY=:$(cat "$work/display")
export DISPLAY HOME="$work/home" LIBGL_ALWAYS_SOFTWARE=1
unset WAYLAND_DISPLAY
"$1" --window-geometry 0 0 1380 860 --python "$here/window.py" -- "$2" "$3" "$work/commands" >"$work/log" 2>&1 &
blender=$!
failed=0

end() {
    kill "$blender" "$server" 2>/dev/null
    wait 2>/dev/null
    rm -rf "$work"
    exit "$1"
}

tell() { # runs Python in Blender and prints what it does
    rm -f "$work"/commands/c.out
    cat >"$work/commands/c.new"
    mv "$work/commands/c.new" "$work/commands/c.py"
    for _ in $(seq 300); do [ -f "$work/commands/c.out" ] && break; sleep 0.1; done
    cat "$work/commands/c.out"
}

state() { # the keys that moved, the curves, the strokes that are being drawn
    tell <<'PYTHON'
import json
import sys
obj = bpy.context.view_layer.objects.active
pen = sys.modules.get('penpose_blender.pen')
moved = [k.name for k in obj.data.shape_keys.key_blocks if abs(k.value) > 1e-6]
curves = json.loads(obj.get('penpose', '{"curves": []}'))['curves']
print(','.join(moved), len(curves), sum('target' in c for c in curves), len(pen._running), obj.data.use_auto_smooth)
PYTHON
}

expect() { # what, the state it should be
    for _ in $(seq 20); do
        found=$(state)
        [ "$found" = "$2" ] && { echo "ok: $1"; return; }
        sleep 0.5
    done
    echo "FAILED: $1: '$found', not '$2'"
    failed=1
}

press() { xdotool mousemove "$1" "$2"; sleep 0.4; xdotool mousedown 1; sleep 0.2; }
move() { while [ $# -gt 1 ]; do xdotool mousemove "$1" "$2"; sleep 0.1; shift 2; done; sleep 0.5; }
lift() { xdotool mouseup 1; sleep 1; }
shot() { [ -d "$shots" ] || return 0; sleep 1; xwd -root -silent >"$shots/$1.xwd"; }
mouth() { press 532 431; move 545 429 558 428 570 427 582 428 594 429 606 431; }
smile() { press 520 415; move 532 420 545 425 558 428 570 429 582 428 594 425 606 420 619 415; }

for _ in $(seq 600); do
    grep -q '^ready' "$work/log" && break
    kill -0 "$blender" 2>/dev/null || { cat "$work/log"; end 1; }
    sleep 0.2
done
sleep 3
xdotool windowfocus "$(xdotool search --onlyvisible --name Blender | head -1)"
shot before
mouth
lift
expect 'a reference is kept, and nothing moves' ' 1 0 0 True'
smile
shot during
[ "$(state | cut -d' ' -f1)" = '' ] && { echo 'FAILED: nothing follows the pen'; failed=1; }
lift
shot after
expect 'the corners of the mouth move' 'mouthSmile_L,mouthSmile_R 1 1 0 True'
xdotool key ctrl+z
expect 'one step of undo takes the target and the pose back' ' 1 0 0 True'
xdotool key ctrl+z
expect 'another the reference' ' 0 0 0 True'
xdotool key ctrl+shift+z
expect 'redo brings the reference' ' 1 0 0 True'
xdotool key ctrl+shift+z
expect 'redo brings the pose' 'mouthSmile_L,mouthSmile_R 1 1 0 True'
xdotool key ctrl+z
smile
xdotool key Escape
expect 'Escape leaves no trace' ' 1 0 0 True'
lift
smile
echo 'bpy.context.scene.frame_set(5)' | tell
move 560 400
expect 'another frame gives the stroke up' ' 1 0 0 True'
lift
smile
echo "bpy.ops.preferences.addon_disable(module='penpose_blender')" | tell >/dev/null
move 560 400
lift
expect 'so does disabling the add-on' ' 1 0 0 True'
if grep -E 'Traceback|Error' "$work/log"; then
    echo 'FAILED: errors in the console'
    failed=1
fi
end "$failed"
