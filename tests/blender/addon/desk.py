"""What the tests of the add-on share, in Blender: the add-on from its zip, models, views and strokes."""
import math
import os
import re
import subprocess
import sys
import tempfile
import zipfile

import numpy

if numpy.__version__ < '2':
    numpy.bool = bool  # Debian's importer is older than its numpy
import addon_utils  # noqa: E402
import bpy  # noqa: E402
from mathutils import Matrix, Vector  # noqa: E402

ARGUMENTS = sys.argv[sys.argv.index('--') + 1:]
SCRATCH = tempfile.mkdtemp()


def install(path):
    """The add-on of a zip, installed as a user does and enabled; its package."""
    bpy.ops.preferences.addon_install(overwrite=True, filepath=path)
    addon_utils.enable('penpose_blender', default_set=True)
    return sys.modules['penpose_blender']


def another(path, version):
    """A zip of the same add-on with another version and another library than that of a zip."""
    root = os.path.dirname(os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__)))))
    command = ['python3', os.path.join(root, 'ui', 'blender', 'pack.py'), '--version', version]
    with zipfile.ZipFile(path) as packed:
        for name in packed.namelist():
            found = re.match(r'penpose_blender/library/([a-z]+-[a-z0-9]+)-[^/]+/(.*)$', name)
            if found and found.group(2):
                copy = os.path.join(SCRATCH, version + found.group(2))
                with open(copy, 'wb') as f:
                    f.write(packed.read(name) + version.encode())
                command += ['--library', '%s=%s' % (found.group(1), copy)]
    out = os.path.join(SCRATCH, 'another-%s.zip' % version)
    subprocess.run(command + ['--output', out], check=True)
    return out


def imported(path):
    """The mesh with the most vertices of a glTF file, active."""
    bpy.ops.import_scene.gltf(filepath=path, merge_vertices=False)
    meshes = [o for o in bpy.data.objects if o.type == 'MESH' and o.name != 'Icosphere']
    obj = max(meshes, key=lambda o: len(o.data.vertices))
    for one in bpy.data.objects:
        one.select_set(one == obj)
    bpy.context.view_layer.objects.active = obj
    return obj


def opened(path):
    """The same in a file of its own."""
    bpy.ops.wm.read_factory_settings(use_empty=True)
    addon_utils.enable('penpose_blender', default_set=True)
    return imported(path)


def seen(obj, yaw=0.0, size=1000, addon=sys.modules.get('penpose_blender')):
    """A view of the whole object from the front (glTF's +z), turned about its height by degrees."""
    from penpose_blender import space
    corners = [obj.matrix_world @ Vector(c) for c in obj.bound_box]
    middle = sum(corners, Vector()) / 8
    radius = max((c - middle).length for c in corners)
    distance = radius / math.tan(math.radians(15)) * 1.1
    camera = Matrix.Translation(middle) @ Matrix.Rotation(math.radians(yaw), 4, 'Z') @ Matrix.Rotation(math.radians(90), 4, 'X') \
        @ Matrix.Translation((0, 0, distance))
    f = 1 / math.tan(math.radians(15))
    near, far = 0.1 * distance, 10 * distance
    window = Matrix(((f, 0, 0, 0), (0, f, 0, 0), (0, 0, (far + near) / (near - far), 2 * far * near / (near - far)), (0, 0, -1, 0)))
    return space.seen_by(camera.inverted(), window, size, size, space.Space(obj.matrix_world), middle)


def pencil(layers):
    """An object of Grease Pencil, moved and scaled, with layers [(name, {frame: lines (n, 3) in the world})]; the last is active."""
    new = hasattr(bpy.types, 'GreasePencilDrawing')  # since 4.3
    data = getattr(bpy.data, 'grease_pencils_v3', bpy.data.grease_pencils).new('Pencil')
    obj = bpy.data.objects.new('Pencil', data)
    obj.location, obj.scale = (0.5, 0, 0.1), (2, 2, 2)
    bpy.context.scene.collection.objects.link(obj)
    bpy.context.view_layer.update()
    back = numpy.array(obj.matrix_world.inverted())
    for name, frames in layers:
        layer = data.layers.new(name)
        for number, lines in frames.items():
            frame = layer.frames.new(number)
            for line in lines:
                places = (numpy.asarray(line) @ back[:3, :3].T + back[:3, 3]).astype(numpy.float32)
                if new:
                    frame.drawing.add_strokes([len(places)])
                    for point, place in zip(frame.drawing.strokes[-1].points, places):
                        point.position = place
                else:
                    stroke = frame.strokes.new()
                    stroke.points.add(len(places))
                    stroke.points.foreach_set('co', places.ravel())
        data.layers.active = layer
    return obj


def region_places(shown, points):
    """Where a view shows points of the character, as px of the region."""
    return shown.places(shown.view.project(points))


def draw(obj, kind, shown, places, of=None):
    """A whole stroke, with following; the controls that moved."""
    from penpose_blender import drawing
    stroke = drawing.Stroke(obj, kind, shown, of)
    for place in places:
        stroke.add(place)
        stroke.follow()
    return stroke.end(obj)


def shown_positions(obj):
    """Vertices as Blender shows them, in the character's space; of a character of several meshes all, the first mesh first."""
    from penpose_blender import drawing, space
    depsgraph = bpy.context.evaluated_depsgraph_get()
    meshes = [o for o in drawing.parts(obj, anew=True) if o.visible_get()]
    own = space.Space(meshes[0].matrix_world)
    out = [own.of_object(drawing.shown_positions(meshes[0], depsgraph))]
    for one in meshes[1:]:
        matrix = numpy.array(one.evaluated_get(depsgraph).matrix_world)
        out.append(own.from_world(drawing.shown_positions(one, depsgraph) @ matrix[:3, :3].T + matrix[:3, 3]))
    return numpy.concatenate(out)


def of_file(obj, points):
    """Places (n, 3) of a glTF file in the character's space of an object that came from it."""
    from penpose_blender import space
    placed = space.Space(obj.matrix_world)
    return numpy.array([tuple(placed.of_world(Vector((x, -z, y)))) for x, y, z in points])


def size_of(points):
    """The diagonal of their box."""
    return float(numpy.linalg.norm(points.max(axis=0) - points.min(axis=0)))
