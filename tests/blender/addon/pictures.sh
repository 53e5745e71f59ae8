#!/bin/sh
# The pictures of docs/blender.md, taken in a window that a mouse draws in: pictures.sh BLENDER ZIP ict_face.glb PENPOSE FOLDER
here=$(cd "$(dirname "$0")" && pwd)
. "$here/desk.sh"
model=$3 penpose=$4 folder=$5

still() { # NAME WIDTHxHEIGHT+X+Y of the screen, as it is once Blender has drawn all
    sleep 2
    echo 'bpy.ops.wm.redraw_timer(type="DRAW_WIN_SWAP", iterations=2)' | tell >"$work/drawn"
    sleep 1
    import -window root "$work/shot.png"
    convert "$work/shot.png" -crop "$2" +repage -dither None -colors 128 -depth 8 "png8:$folder/$1.png"
}

shot() { # the same with the pen beside the face
    xdotool mousemove 860 600
    still "$1" "$2"
}

face=520x530+310+130
open_window "$1" "$2" "$model"
xdotool mousemove 1127 251 click 1
sleep 1
shot take_up 1140x730+0+30
mouth
still reference $face
lift
smile
still during $face
lift
shot after $face
press 570 429
move 570 432 570 436 570 440
still pull $face
lift
xdotool key ctrl+z
sleep 2
xdotool mousemove 570 330
xdotool key v
still pie $face
xdotool key Escape
sleep 2
tell <<'PYTHON'
keys = bpy.context.view_layer.objects.active.data.shape_keys.key_blocks
for frame, values in ((1, (0, 0)), (12, (0.5, 0.2)), (24, (0, 1))):
    for name, value in zip(('jawOpen', 'mouthSmile_L'), values):
        for key in (keys[name], keys[name.replace('_L', '_R')]):
            key.value = value
            key.keyframe_insert('value', frame=frame)
bpy.context.scene.frame_set(18)
pen = bpy.context.window_manager.penpose
pen.arcs = pen.ghosts = True
pen.ghost_count = 1
PYTHON
shot over_time 420x400+360+230
tell <<PYTHON
import re
import subprocess
import numpy as np
obj, pen = bpy.context.view_layer.objects.active, bpy.context.window_manager.penpose
pen.arcs = pen.ghosts = False
obj.data.shape_keys.animation_data_clear()
for key in obj.data.shape_keys.key_blocks:
    key.value = 0
del obj['penpose']
data = bpy.data.grease_pencils.new('Pencil')
pencil = bpy.data.objects.new('Pencil', data)
bpy.context.scene.collection.objects.link(pencil)
ink = bpy.data.materials.new('Ink')
bpy.data.materials.create_gpencil_data(ink)
data.materials.append(ink)
layer = data.layers.new('Face')
for number, pose in ((1, {}), (9, {'jawOpen': 0.7}), (17, {'mouthSmile_L': 0.9, 'mouthSmile_R': 0.9, 'jawOpen': 0.2})):
    settings = [word for item in pose.items() for word in ('--set', '%s=%s' % item)]
    subprocess.run(['$penpose', 'render', '$model', *settings, '--view', 'front', '--lines', '-o', '$work/lines.svg'], check=True)
    frame = layer.frames.new(number)
    with open('$work/lines.svg', encoding='utf-8') as f:
        found = re.findall(r'<path id="(\w+)" d="([^"]*)"', f.read())
    for name, line in found:
        if not name.startswith('silhouette'):
            px = np.array(re.findall(r'([\d.]+) ([\d.]+)', line), dtype=float) - 512
            stroke = frame.strokes.new()
            stroke.line_width = 60
            stroke.points.add(len(px))
            places = np.column_stack([0.035 * px[:, 0] - 22, np.full(len(px), -14.0), -0.035 * px[:, 1]])
            stroke.points.foreach_set('co', places.astype('f4').ravel())
bpy.context.scene.frame_set(17)
with bpy.context.temp_override(**view()):
    bpy.ops.penpose.pencil_film('EXEC_DEFAULT')
PYTHON
shot pencil 760x640+60+120
grep -E 'Traceback|Error' "$work/log" && end 1
end 0
