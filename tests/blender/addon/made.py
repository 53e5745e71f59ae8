"""Small characters that tests make by bpy: a bulged plate that faces -y, with shape keys, and two bones one above the other."""
import unittest

import bpy
import desk
import numpy as np
from mathutils import Euler, Vector
from penpose_blender import bones as pose_bones
from penpose_blender import drawing, space

SIDE = 17
SHOWN, NEAR = 1e-5, 0.02  # shares of the mesh's size and of the drawing's


def empty_file():
    """A file with nothing in it, and keys that go wherever they are asked for: later versions begin with other preferences."""
    bpy.ops.wm.read_factory_settings(use_empty=True)
    edit = bpy.context.preferences.edit
    for name in ('use_keyframe_insert_available', 'use_keyframe_insert_needed', 'use_auto_keyframe_insert_needed'):
        if hasattr(edit, name):
            setattr(edit, name, False)
    desk.addon_utils.enable('penpose_blender', default_set=True)


def activate(obj):
    bpy.context.view_layer.update()
    for one in bpy.context.view_layer.objects:
        one.select_set(one == obj)
    bpy.context.view_layer.objects.active = obj


def plate(name='Plate', side=SIDE, scale=(1, 1, 1)):
    """The plate, active: side x side vertices from (-1, -1) to (1, 1) in x and z."""
    line = np.linspace(-1, 1, side)
    points = [(x, -0.3 * (1 - x * x) * (1 - z * z), z) for z in line for x in line]
    faces = [(r * side + c, r * side + c + 1, (r + 1) * side + c + 1, (r + 1) * side + c) for r in range(side - 1) for c in range(side - 1)]
    data = bpy.data.meshes.new(name)
    data.from_pydata(points, [], faces)
    data.update()
    obj = bpy.data.objects.new(name, data)
    bpy.context.scene.collection.objects.link(obj)
    obj.scale = scale
    activate(obj)
    bpy.context.view_layer.update()
    return obj


def add_key(obj, name, way, least=0.0, most=1.0, middle=(0.0, 0.0), width=0.5, **settings):
    """A shape key that shifts what is around a middle (x, z)."""
    if obj.data.shape_keys is None:
        obj.shape_key_add(name='Basis', from_mix=False)
    key = obj.shape_key_add(name=name, from_mix=False)
    for vertex, point in zip(obj.data.vertices, key.data):
        from_middle = ((vertex.co.x - middle[0]) ** 2 + (vertex.co.z - middle[1]) ** 2) / width ** 2
        point.co = vertex.co + Vector(way) * float(np.exp(-from_middle))
    key.slider_min, key.slider_max = least, most
    key.value = 0  # 5.x makes keys that act
    for setting, value in settings.items():
        setattr(key, setting, value)
    return key


def bones(obj, name='Rig'):
    """An armature of 'low' from z -1 to 0 and 'high' from 0 to 1, which carries the plate; as they lie in the world."""
    data = bpy.data.armatures.new(name)
    armature = bpy.data.objects.new(name, data)
    bpy.context.scene.collection.objects.link(armature)
    activate(armature)
    bpy.ops.object.mode_set(mode='EDIT')
    low = data.edit_bones.new('low')
    low.head, low.tail, low.roll = (0, 0, -1), (0, 0, 0), 0.3
    high = data.edit_bones.new('high')
    high.head, high.tail, high.roll, high.parent, high.use_connect = (0, 0, 0), (0.1, 0, 1), -0.4, low, True
    bpy.ops.object.mode_set(mode='OBJECT')
    for group in (obj.vertex_groups.new(name='low'), obj.vertex_groups.new(name='high')):
        for vertex in obj.data.vertices:
            share = min(1.0, max(0.0, 0.5 + 2 * vertex.co.z))
            weight = share if group.name == 'high' else 1 - share
            if weight > 0:
                group.add([vertex.index], weight, 'REPLACE')
    modifier = obj.modifiers.new('Armature', 'ARMATURE')
    modifier.object = armature
    activate(obj)
    bpy.context.view_layer.update()
    return armature


def row(obj, z=0.5, reach=0.6):
    """The vertices along a row of the plate."""
    found = [v.index for v in obj.data.vertices if abs(v.co.z - z) < 1e-4 and abs(v.co.x) <= reach]
    return sorted(found, key=lambda i: obj.data.vertices[i].co.x)


def shown_with(obj, change):
    """Where vertices are in the character's space after change(True), which change(False) takes back."""
    change(True)
    bpy.context.view_layer.update()
    there = desk.shown_positions(obj)
    change(False)
    bpy.context.view_layer.update()
    return there


class Drawn:
    """A reference along vertices and its target where they should be (n, 3): what moved, how far Blender is from the character
    (share of the size), and how far the curve is from its target (share of the drawing's size)."""

    def __init__(self, obj, vertices, target, yaw=0.0):
        shown = desk.seen(obj, yaw)
        here = desk.region_places(shown, desk.shown_positions(obj)[vertices])
        there = desk.region_places(shown, target)
        desk.draw(obj, 'reference', shown, here)
        self.moved = desk.draw(obj, 'target', shown, there)
        bpy.context.view_layer.update()
        self.said = drawing.said(obj)
        character = drawing.known(obj).rig.character
        drawing.known(obj).rig.take_pose()
        ours, seen = character.evaluate(), desk.shown_positions(obj)
        self.off = float(np.abs(ours - seen).max()) / desk.size_of(ours)
        self.size = desk.size_of(np.vstack([here, there]))
        self.start = _apart(here, there) / self.size
        self.end = _apart(curve_px(obj, shown), there) / self.size


def curve_px(obj, shown):
    """The last reference as Blender shows it, px of the region."""
    curve, points = [c for c in drawing.places(obj, bpy.context.evaluated_depsgraph_get()) if c[0]['role'] == 'reference'][-1]
    place = space.Space(obj.matrix_world)
    return desk.region_places(shown, [place.of_world(Vector(p)) for p in points])


def _apart(points, line):
    """The greatest distance of points from a line of px."""
    a, b = line[:-1], line[1:]
    along = b - a
    share = np.einsum('pij,ij->pi', points[:, None] - a, along) / np.maximum(1e-12, (along ** 2).sum(axis=1))
    nearest = a + np.clip(share, 0, 1)[..., None] * along
    return float(np.linalg.norm(points[:, None] - nearest, axis=2).min(axis=1).max())


def state_of(*blocks):
    """Values of keys, bones and custom properties, to the bit."""
    out = {}
    for block in blocks:
        if block.type == 'ARMATURE':
            for b in block.pose.bones:
                channels = (b.rotation_quaternion, b.rotation_euler, b.rotation_axis_angle, b.location, b.scale)
                out[b.name] = [tuple(channel) for channel in channels]
                out.update({(b.name, k): v for k, v in b.items() if isinstance(v, (int, float))})
        elif block.data.shape_keys:
            keys = block.data.shape_keys
            driven = [d.data_path for d in keys.animation_data.drivers] if keys.animation_data else []
            out.update({k.name: k.value for k in keys.key_blocks if 'key_blocks["%s"].value' % k.name not in driven})
        out.update({(block.name, k): v for k, v in block.items() if isinstance(v, (int, float))})
    return out


def drive(block, path, target, target_path, expression='x'):
    """A driver of a channel by a property of an object, x in the expression."""
    curve = block.driver_add(path)
    curve.driver.type = 'SCRIPTED'
    curve.driver.expression = expression
    variable = curve.driver.variables.new()
    variable.name = 'x'
    variable.targets[0].id_type = 'OBJECT'
    variable.targets[0].id = target
    variable.targets[0].data_path = target_path
    return curve


class Trial(unittest.TestCase):
    """Tests of rigs, each in an empty file."""
    figures = {'shown': 0.0, 'near': 0.0}

    def setUp(self):
        empty_file()

    @classmethod
    def tearDownClass(cls):
        print('worst: vertices %.1e of the size, curves %.2f %% of the drawing' % (cls.figures['shown'], 100 * cls.figures['near']))

    def good(self, drawn, near=True, shown=True):
        if shown:
            self.figures['shown'] = max(self.figures['shown'], drawn.off)
            self.assertLess(drawn.off, SHOWN, 'Blender shows other vertices than the character')
        self.assertTrue(drawn.moved, 'nothing moved')
        self.assertLess(drawn.end, drawn.start)
        if near:
            self.figures['near'] = max(self.figures['near'], drawn.end)
            self.assertLess(drawn.end, NEAR, 'the curve is far from its target (at first %.3f)' % drawn.start)

    def turned(self, armature, obj, angles, bone='high', order='XYZ'):
        """Where vertices are with a bone turned."""
        pose = armature.pose.bones[bone]
        kept = [tuple(pose.rotation_quaternion), tuple(pose.rotation_euler), tuple(pose.rotation_axis_angle)]

        def change(on):
            if on:
                pose_bones.set_turn(pose, Euler(angles, order).to_quaternion())
            else:
                pose.rotation_quaternion, pose.rotation_euler, pose.rotation_axis_angle = kept
        return shown_with(obj, change)

    def keys_drawn(self, obj, name, value, z=0.5, **settings):
        key = obj.data.shape_keys.key_blocks[name]
        kept = key.value

        def change(on):
            key.value = value if on else kept
        line = row(obj, z)
        there = shown_with(obj, change)
        return Drawn(obj, line, there[line], **settings)
