"""Run by Blender: blender --background --factory-startup --python opened.py -- FOLDER...

Opens what roundtrip/kept.js left in each FOLDER (outputs.json): an output has the materials, images, objects and shape keys of its
input, and new ones behind them; what was not posed is where it was, and what was posed is where the program has it (an .obj
beside the output). Prints a line a file; exit status 1 if anything is lost or a vertex is off by over 1e-5 of the size."""
import json
import os
import shutil
import struct
import sys
import tempfile

import numpy

numpy.bool = bool  # Debian's importer is older than its numpy
import bpy  # noqa: E402
from mathutils import kdtree  # noqa: E402

TOLERANCE = 1e-5
SCRATCH = tempfile.mkdtemp()


def without_clips(path):
    """A copy of the file that has no animations, because Blender shows a moment of the first one. None: it has none."""
    with open(path, 'rb') as f:
        data = f.read()
    binary = data[:4] == b'glTF'
    end = 20 + struct.unpack('<I', data[12:16])[0] if binary else len(data)
    document = json.loads(data[20 if binary else 0:end])
    if 'animations' not in document:
        return None
    del document['animations']
    text = json.dumps(document).encode()
    text += b' ' * (-len(text) % 4)
    if binary:
        text = struct.pack('<4sIIII', b'glTF', 2, 20 + len(text) + len(data) - end, len(text), 0x4e4f534a) + text + data[end:]
    # A .gltf has its files beside it.
    copy = os.path.join(SCRATCH if binary else os.path.dirname(path), 'still.' + os.path.basename(path))
    with open(copy, 'wb') as f:
        f.write(text)
    return copy


class Opened:
    """What Blender has after an import."""

    def __init__(self, path):
        self.open(path)
        self.animations = sorted(a.name for a in bpy.data.actions)
        copy = without_clips(path)
        if copy:
            self.open(copy)

    def open(self, path):
        bpy.ops.wm.read_factory_settings(use_empty=True)
        bpy.ops.import_scene.gltf(filepath=path, merge_vertices=False)
        objects = [o for o in bpy.data.objects if o.type == 'MESH' and o.name != 'Icosphere']
        self.materials = sorted(m.name for m in bpy.data.materials)
        self.images = sorted((i.name, tuple(i.size), i.packed_file.size if i.packed_file else 0) for i in bpy.data.images)
        depsgraph = bpy.context.evaluated_depsgraph_get()
        self.objects = {o.name: self.object_of(o, depsgraph) for o in objects}

    @staticmethod
    def object_of(obj, depsgraph):
        mesh = obj.data
        keys = {}
        for key in mesh.shape_keys.key_blocks if mesh.shape_keys else []:
            flat = numpy.empty(3 * len(mesh.vertices), dtype=numpy.float32)
            key.data.foreach_get('co', flat)
            keys[key.name] = flat.reshape(-1, 3).astype(float)
        evaluated = obj.evaluated_get(depsgraph)
        seen = evaluated.to_mesh()
        flat = numpy.empty(3 * len(seen.vertices), dtype=numpy.float32)
        seen.vertices.foreach_get('co', flat)
        matrix = numpy.array(evaluated.matrix_world)
        world = flat.reshape(-1, 3).astype(float) @ matrix[:3, :3].T + matrix[:3, 3]
        evaluated.to_mesh_clear()
        return {'keys': keys, 'world': world[:, [0, 2, 1]] * [1, 1, -1],  # Blender's z is up
                'scale': abs(matrix[:3, :3]).max(), 'layers': sorted(u.name for u in mesh.uv_layers),
                'colours': sorted(c.name for c in mesh.color_attributes), 'slots': [s.name for s in obj.material_slots],
                'polygons': len(mesh.polygons), 'groups': sorted(g.name for g in obj.vertex_groups)}


def places_of(path):
    with open(path, encoding='utf-8') as f:
        return numpy.array([line.split()[1:4] for line in f if line.startswith('v ')], dtype=float)


def places_by(rest, program_rest, places, size):
    """For each vertex of Blender at rest, where the program may have it: the vertices that are at the same place at rest."""
    tree = kdtree.KDTree(len(program_rest))
    for i, p in enumerate(program_rest):
        tree.insert(p, i)
    tree.balance()
    return [[places[i] for _, i, _ in tree.find_range(p, TOLERANCE * size)] for p in rest]


def compare(was, now, output, program_rest, size):
    """Lines of what is wrong, and how far off vertices are, share of the size."""
    faults = []
    for what in ('materials', 'images'):
        if getattr(was, what) != getattr(now, what):
            faults.append('%s were %s and are %s' % (what, getattr(was, what), getattr(now, what)))
    lost = [a for a in was.animations if a not in now.animations]
    if lost:
        faults.append('animations %s are lost' % lost)
    if sorted(was.objects) != sorted(now.objects):
        return faults + ['objects were %s and are %s' % (sorted(was.objects), sorted(now.objects))], float('nan')
    off = 0.0
    fresh = set()
    for name, a in was.objects.items():
        b = now.objects[name]
        for what in ('layers', 'colours', 'slots', 'polygons', 'groups'):
            if a[what] != b[what]:
                faults.append('%s: %s were %s and are %s' % (name, what, a[what], b[what]))
        if len(a['world']) != len(b['world']):
            faults.append('%s: %d vertices are %d' % (name, len(a['world']), len(b['world'])))
            continue
        for key, points in a['keys'].items():
            if key not in b['keys']:
                faults.append('%s: the shape key %s is lost' % (name, key))
            else:
                off = max(off, abs(points - b['keys'][key]).max() * a['scale'] / size)
        fresh.update(k for k in b['keys'] if k not in a['keys'])
        if output['kind'] != 'posed':
            off = max(off, abs(a['world'] - b['world']).max() / size)
            continue
        places = places_of(output['places'])
        for point, may in zip(b['world'], places_by(a['world'], program_rest, places, size)):
            off = max(off, min((abs(point - p).max() for p in may), default=float('inf')) / size)
    unnamed = all(k == 'Basis' or k.startswith('target_') for o in was.objects.values() for k in o['keys'])  # or named in primitives
    if output['kind'] == 'drawn' and output['control'] not in fresh and not (unnamed and fresh):
        faults.append('no shape key is called %s' % output['control'])
    if output['kind'] == 'posed' and abs(program_rest - places_of(output['places'])).max() < 1e-3 * size:
        faults.append('nothing was posed')
    if output['kind'] == 'moved' and now.animations == was.animations:
        faults.append('no animation more')
    return faults, off


def check(folder, model):
    good = True
    program_rest = places_of(os.path.join(folder, model['name'] + '.rest.obj'))
    size = float(numpy.linalg.norm(program_rest.max(axis=0) - program_rest.min(axis=0)))
    try:
        opened = {model['file']: Opened(model['file'])}
    except RuntimeError as error:
        print('%s: Blender does not open the input: %s' % (model['name'], str(error).strip()))
        return True
    for output in model['outputs']:
        before = output.get('from', model['file'])
        if before not in opened:
            opened[before] = Opened(before)
        faults, off = compare(opened[before], Opened(output['file']), output, program_rest, size)
        fits = not faults and off <= TOLERANCE
        print('%s: vertices off by %.1e of the size%s' % (os.path.basename(output['file']), off, '' if fits else ' WRONG'))
        for fault in faults:
            print('  ' + fault)
        good = good and fits
    return good


def main():
    good = True
    for folder in sys.argv[sys.argv.index('--') + 1:]:
        with open(os.path.join(folder, 'outputs.json'), encoding='utf-8') as f:
            models = json.load(f)
        good = good and bool(models)
        for model in models:
            good = check(folder, model) and good
    shutil.rmtree(SCRATCH)
    sys.stdout.flush()
    os._exit(0 if good else 1)


main()
