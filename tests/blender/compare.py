"""Run by Blender: blender --background --factory-startup --python compare.py -- FOLDER

Imports every FOLDER/NAME.glb and compares vertex positions at given times with FOLDER/NAME.json, which the program wrote:
{"size", "shape_keys": [...], "times": [s, ...], "parts": [{"name", "positions": [[[x, y, z], ...] a time]}, ...]} in glTF's axes.
Prints one line a file; exit status 1 if any vertex is off by over 1e-4 of the size or a shape key's name is lost."""
import json
import os
import sys

import numpy

numpy.bool = bool  # Debian's importer is older than its numpy
import bpy  # noqa: E402

TOLERANCE = 1e-4


def positions(obj, depsgraph):
    evaluated = obj.evaluated_get(depsgraph)
    mesh = evaluated.to_mesh()
    matrix = evaluated.matrix_world
    points = [matrix @ v.co for v in mesh.vertices]
    evaluated.to_mesh_clear()
    return [(p.x, p.z, -p.y) for p in points]  # Blender's z is up


def check(folder, name):
    bpy.ops.wm.read_factory_settings(use_empty=True)
    with open(os.path.join(folder, name + '.json'), encoding='utf-8') as f:
        wanted = json.load(f)
    bpy.context.scene.render.fps = 24
    bpy.ops.import_scene.gltf(filepath=os.path.join(folder, name + '.glb'), merge_vertices=False)
    objects = [o for o in bpy.data.objects if o.type == 'MESH' and o.name != 'Icosphere']
    names = {k.name for o in objects if o.data.shape_keys for k in o.data.shape_keys.key_blocks}
    lost = [n for n in wanted['shape_keys'] if n not in names]
    # Every part of the file is one object; parts are told apart by their vertex counts at the first time.
    scene = bpy.context.scene
    fps = scene.render.fps / scene.render.fps_base
    worst = 0.0
    for i, time in enumerate(wanted['times']):
        frame = time * fps
        scene.frame_set(int(frame), subframe=frame - int(frame))
        depsgraph = bpy.context.evaluated_depsgraph_get()
        left = list(wanted['parts'])
        for obj in objects:
            found = positions(obj, depsgraph)
            part = next((p for p in left if p['name'] == obj.name or p['name'] == obj.data.name), None)
            if part is None or len(part['positions'][i]) != len(found):
                print('%s: no part for %s of %d vertices' % (name, obj.name, len(found)))
                return False
            left.remove(part)
            for a, b in zip(found, part['positions'][i]):
                worst = max(worst, max(abs(x - y) for x, y in zip(a, b)))
    share = worst / wanted['size']
    good = share <= TOLERANCE and not lost
    print('%s: worst vertex %.2e of the size at %d times, %d shape keys, lost: %s%s' % (
        name, share, len(wanted['times']), len(names), lost or 'none', '' if good else ' WRONG'))
    return good


def main():
    folder = sys.argv[sys.argv.index('--') + 1]
    names = sorted(n[:-4] for n in os.listdir(folder) if n.endswith('.glb'))
    good = [check(folder, name) for name in names]
    sys.stdout.flush()
    os._exit(0 if good and all(good) else 1)


main()
