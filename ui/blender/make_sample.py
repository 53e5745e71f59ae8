"""Makes a file of Blender to try the add-on on: penpose's own head with its keys, curves drawn on it, and some frames keyed.

    blender --background --factory-startup --python ui/blender/make_sample.py -- penpose-blender-VERSION.zip sample.blend
"""
import importlib
import math
import os
import sys
import tempfile
import zipfile

import bpy
import numpy as np
from mathutils import Matrix, Vector

SIZE = 1000  # px of the view that is drawn in
SCALE = 10.0  # of the head, which is as large as a head in metres, so that Blender's view and lights fit it


def add_on(path):
    """The package of the add-on, from its zip where it is not enabled."""
    if 'penpose_blender' not in bpy.context.preferences.addons:
        folder = tempfile.mkdtemp()
        with zipfile.ZipFile(path) as packed:
            packed.extractall(folder)
        sys.path.insert(0, folder)
        importlib.import_module('penpose_blender').register()
    return importlib.import_module('penpose_blender')


def head_object(head):
    """The head as a mesh with a shape key for each of its parameters; z is up and it looks along -y."""
    def in_blender(points):
        return (SCALE * points[:, [0, 2, 1]] * (1, -1, 1)).astype(np.float32)
    rest = head.evaluate()
    data = bpy.data.meshes.new('Head')
    data.from_pydata(in_blender(rest).tolist(), [], head.triangles.tolist())
    data.polygons.foreach_set('use_smooth', [True] * len(data.polygons))
    data.update()
    obj = bpy.data.objects.new('Head', data)
    bpy.context.scene.collection.objects.link(obj)
    obj.shape_key_add(name='Basis', from_mix=False)
    for i, parameter in enumerate(head.parameters):
        pose = np.zeros(len(head.parameters))
        pose[i] = 1
        key = obj.shape_key_add(name=parameter.name, from_mix=False)
        key.data.foreach_set('co', in_blender(head.evaluate(pose)).ravel())
        key.slider_min, key.slider_max = parameter.minimum, parameter.maximum
    bpy.context.view_layer.objects.active = obj
    obj.select_set(True)
    bpy.context.view_layer.update()
    return obj


def front_view(space, obj):
    """A view of all of an object from the front."""
    corners = [obj.matrix_world @ Vector(c) for c in obj.bound_box]
    middle = sum(corners, Vector()) / 8
    away = 1.1 * max((c - middle).length for c in corners) / math.tan(math.radians(15))
    camera = Matrix.Translation(middle) @ Matrix.Rotation(math.radians(90), 4, 'X') @ Matrix.Translation((0, 0, away))
    f = 1 / math.tan(math.radians(15))
    window = Matrix(((f, 0, 0, 0), (0, f, 0, 0), (0, 0, -1, -1), (0, 0, -1, 0)))
    return space.seen_by(camera.inverted(), window, SIZE, SIZE, space.Space(obj.matrix_world), middle)


def draw(drawing, obj, kind, seen, points):
    """A stroke through points of the character."""
    stroke = drawing.Stroke(obj, kind, seen)
    for place in seen.places(seen.view.project(points)):
        stroke.add(place)
    stroke.end(obj)
    bpy.context.view_layer.update()


# Frame, the curve that is drawn, and the pose that its target is taken from.
MOMENTS = ((12, 'lip_upper', {'mouth_corner_L': 0.9, 'mouth_corner_R': 0.9}),
           (24, 'brow_L', {'brow_inner_L': 0.9, 'brow_outer_L': 0.9}),
           (36, 'lip_lower', {'jaw': 0.5}))


def make(path):
    """Writes the file."""
    from penpose_blender import drawing, keys, space
    from penpose_blender.library import Character
    head, scene = Character.built_in('builtin:demo'), bpy.context.scene
    for one in list(bpy.data.objects):
        bpy.data.objects.remove(one)
    obj = head_object(head)
    seen = front_view(space, obj)
    scene.frame_start, scene.frame_end = 1, 48
    rig = drawing.known(obj).rig
    rules = keys.Rules(scene).for_all()
    all_controls = [control for control, _, _ in rig.parts]
    keys.insert(all_controls, rules, 1)
    for frame, name, pose in MOMENTS:
        scene.frame_set(frame)
        for key in obj.data.shape_keys.key_blocks[1:]:
            key.value = 0
        head.reset()
        line = head.curve(name)
        draw(drawing, obj, 'reference', seen, SCALE * head.positions(line))
        for control, value in pose.items():
            head.set(control, value)
        draw(drawing, obj, 'target', seen, SCALE * head.positions(line))
        keys.insert(all_controls, rules, frame)
    for key in obj.data.shape_keys.key_blocks[1:]:
        key.value = 0
    keys.insert(all_controls, rules, 48)
    scene.frame_set(12)
    bpy.ops.wm.save_as_mainfile(filepath=os.path.abspath(path), compress=True)


if __name__ == '__main__':
    archive, out = sys.argv[sys.argv.index('--') + 1:]
    add_on(archive)
    make(out)
