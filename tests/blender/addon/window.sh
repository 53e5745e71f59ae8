#!/bin/sh
# The add-on in a window that a mouse draws in: window.sh BLENDER ZIP MODEL
# Draws a smile on ict_face.glb under Xvfb, undoes and redoes it, leaves a stroke by Escape, holds the key for the pen over another tool,
# pulls a target and an arc, and takes the add-on away in mid-stroke. 77 without Xvfb or xdotool.
here=$(cd "$(dirname "$0")" && pwd)
for tool in Xvfb xdotool; do
    command -v "$tool" >/dev/null || { echo "$tool is not here"; exit 77; }
done
. "$here/desk.sh"
failed=0

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

values() {
    echo 'print([round(k.value, 4) for k in bpy.context.view_layer.objects.active.data.shape_keys.key_blocks])' | tell
}

place_of_frame() { # where on the screen an arc has a frame
    tell <<PYTHON
from penpose_blender import arcs, pen
obj = bpy.context.view_layer.objects.active
region = view()['region']
seen = pen.seen_in(region, view()['area'].spaces.active.region_3d, obj)
times = arcs.Times(obj)
arc = arcs.arcs_of(times, bpy.context.scene, bpy.context.window_manager.penpose)[-1]
x, y = seen.places(seen.view.project(times.space.from_world(arc.points)))[arc.frames.index($1)]
print(round(x + region.x), round(860 - y - region.y))
PYTHON
}

keyed() { # the frames that have keys
    tell <<'PYTHON'
from penpose_blender import drawing, moments
print([int(f) for f in moments.Moments(drawing.known(bpy.context.view_layer.objects.active).rig).keyed()])
PYTHON
}

open_window "$@"
mouth
lift
expect 'a reference is kept, and nothing moves' ' 1 0 0 True'
smile
[ "$(state | cut -d' ' -f1)" = '' ] && { echo 'FAILED: nothing follows the pen'; failed=1; }
lift
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
echo 'with bpy.context.temp_override(**view()): bpy.ops.wm.tool_set_by_id(name="builtin.cursor")' | tell
xdotool mousemove 540 330
sleep 0.5
xdotool keydown f
sleep 0.5
smile
lift
xdotool keyup f
expect 'the pen draws over another tool while the key is held' 'mouthSmile_L,mouthSmile_R 1 1 0 True'
echo 'with bpy.context.temp_override(**view()): bpy.ops.wm.tool_set_by_id(name="penpose.pen")' | tell
values >"$work/before"
press 570 429
move 570 432 570 436 570 440
lift
values >"$work/after"
cmp -s "$work/before" "$work/after" && { echo 'FAILED: the face does not follow a target that is pulled'; failed=1; }
expect 'a target that is pulled is no new curve' "$(state | cut -d' ' -f1) 1 1 0 True"
xdotool key ctrl+z
sleep 2
values >"$work/after"
cmp -s "$work/before" "$work/after" || { echo 'FAILED: a pull is more than one step of undo'; failed=1; }
tell <<'PYTHON'
keys = bpy.context.view_layer.objects.active.data.shape_keys.key_blocks
for frame, value in ((1, 0.0), (21, 1.0)):
    keys['jawOpen'].value = value
    keys['jawOpen'].keyframe_insert('value', frame=frame)
bpy.context.scene.frame_set(11)
bpy.ops.ed.undo_push(message='keys')
bpy.context.window_manager.penpose.arcs = True
PYTHON
sleep 1
set -- $(place_of_frame 15)
press "$1" "$2"
move "$1" $(($2 + 4)) "$1" $(($2 + 9)) "$1" $(($2 + 14))
lift
sleep 1
case $(keyed) in
    *1[456]*) echo 'ok: the frame below the pen, which is a px or two wide, is keyed' ;;
    *) echo "FAILED: the arc is pulled, and nothing is keyed there: $(keyed)"; failed=1 ;;
esac
xdotool key ctrl+z
sleep 2
xdotool key ctrl+z
sleep 1
xdotool key ctrl+z
sleep 1
echo 'bpy.context.window_manager.penpose.arcs = False' | tell
expect 'all of it is undone' ' 1 0 0 True'
smile
echo 'bpy.context.scene.frame_set(5)' | tell
move 560 400
expect 'another frame gives the stroke up' ' 1 0 0 True'
lift
smile
echo 'bpy.context.view_layer.objects.active.name = "Another"' | tell
move 560 400
lift
expect 'a new name in mid-stroke does not end the stroke' 'mouthSmile_L,mouthSmile_R 1 1 0 True'
xdotool key ctrl+z
sleep 1
tell <<'PYTHON'
obj = bpy.context.view_layer.objects.active
kept = bpy.data.collections.new('Character')
kept.objects.link(obj)
bpy.data.libraries.write(desk.SCRATCH + '/character.blend', {kept})
bpy.data.collections.remove(kept)
with bpy.data.libraries.load(desk.SCRATCH + '/character.blend', link=True) as (_, into):
    into.collections = ['Character']
empty = bpy.data.objects.new('Instance', None)
empty.instance_type, empty.instance_collection = 'COLLECTION', into.collections[0]
bpy.context.scene.collection.objects.link(empty)
obj.select_set(False)
obj.hide_set(True)
empty.select_set(True)
bpy.context.view_layer.objects.active = empty
bpy.ops.ed.undo_push(message='linked')
PYTHON
sleep 1
smile
move 640 300
lift
found=$(tell <<'PYTHON'
empty = bpy.context.view_layer.objects.active
print(empty.name, *empty.location)
bpy.data.objects.remove(empty)
obj = next(o for o in bpy.context.view_layer.objects if o.type == 'MESH')
obj.hide_set(False)
obj.select_set(True)
bpy.context.view_layer.objects.active = obj
PYTHON
)
if [ "$found" = 'Instance 0.0 0.0 0.0' ]; then echo 'ok: a linked character is not dragged about'; else echo "FAILED: linked: $found"; failed=1; fi
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
