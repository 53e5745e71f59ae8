"""Control rigs for tests: a face of handles, mechanism and carriers on a plate, and Rigify's face on a head."""
import json
import math

import bpy
import desk
import made
import numpy as np
from mathutils import Matrix, Vector
from penpose_blender import space

CONTROLS, CARRIERS, MECHANISM = 0, 29, 30  # layers; from 4.0 on collections of these numbers
# Handles by their places (x, z), and the chains of carriers between them.
HANDLES = {'lips.L': (0.35, -0.4), 'lip.T.L.001': (0.18, -0.35), 'lip.T': (0, -0.33), 'lip.B.L.001': (0.18, -0.46), 'lip.B': (0, -0.48),
           'brow.T.L': (0.65, 0.5), 'brow.T.L.001': (0.5, 0.56), 'brow.T.L.002': (0.35, 0.57), 'brow.T.L.003': (0.2, 0.52),
           'lid.T.L': (0.62, 0.25), 'lid.T.L.001': (0.52, 0.31), 'lid.T.L.002': (0.42, 0.33), 'lid.T.L.003': (0.32, 0.31),
           'lid.B.L': (0.22, 0.25), 'lid.B.L.001': (0.32, 0.2), 'lid.B.L.002': (0.42, 0.18), 'lid.B.L.003': (0.52, 0.2)}
CHAINS = {'lip.T.L': ['lips.L', 'lip.T.L.001', 'lip.T'], 'lip.B.L': ['lips.L', 'lip.B.L.001', 'lip.B'],
          'brow.T.L': ['brow.T.L', 'brow.T.L.001', 'brow.T.L.002', 'brow.T.L.003'],
          'lid.T.L': ['lid.T.L', 'lid.T.L.001', 'lid.T.L.002', 'lid.T.L.003', 'lid.B.L'],
          'lid.B.L': ['lid.B.L', 'lid.B.L.001', 'lid.B.L.002', 'lid.B.L.003', 'lid.T.L']}
# Handles that follow others of their chain in part.
FOLLOW = {'lip.T.L.001': [('lips.L', 0.25), ('lip.T', 0.5)], 'lip.B.L.001': [('lips.L', 0.25), ('lip.B', 0.5)],
          'lid.T.L.001': [('lid.T.L.002', 0.6)], 'lid.T.L.003': [('lid.T.L.002', 0.6)],
          'lid.B.L.001': [('lid.B.L.002', 0.6)], 'lid.B.L.003': [('lid.B.L.002', 0.6)]}


def _other(name):
    return name.replace('.L', '.R')


HANDLES.update({_other(n): (-x, z) for n, (x, z) in list(HANDLES.items())})
CHAINS.update({_other(n): [_other(h) for h in chain] for n, chain in list(CHAINS.items())})
FOLLOW.update({_other(n): [(_other(h), share) for h, share in follow] for n, follow in list(FOLLOW.items())})
CHAINS['lip.T'] = CHAINS['lip.T.L'] + CHAINS['lip.T.R'][-2::-1]


def head():
    """A fine plate, with the back of the head behind it."""
    back = made.plate('Back', 48, (1.2, -3, 1.5))
    back.location.y = 0.3
    return made.plate('Head', 49)


def _depth(x, z):
    return -0.3 * (1 - x * x) * (1 - z * z)


def place(bone, way):
    """Moves a handle by a way of the armature's space."""
    bone.location = bone.bone.matrix_local.to_3x3().inverted() @ Vector(way)


def rest(armature):
    """All bones at rest."""
    for bone in armature.pose.bones:
        bone.location, bone.scale, bone.rotation_quaternion, bone.rotation_euler = (0, 0, 0), (1, 1, 1), (1, 0, 0, 0), (0, 0, 0)
    bpy.context.view_layer.update()


def along(obj, chain):
    """The vertices nearest to a chain of handles, from one end to the other."""
    points = np.array([HANDLES[h] for h in CHAINS[chain]])
    length = np.r_[0, np.cumsum(np.linalg.norm(np.diff(points, axis=0), axis=1))]
    at = np.linspace(0, length[-1], 15)
    line = np.column_stack([np.interp(at, length, points[:, i]) for i in (0, 1)])
    flat = np.array([(v.co.x, v.co.z) for v in obj.data.vertices])
    found = [int(np.linalg.norm(flat - p, axis=1).argmin()) for p in line]
    return [v for i, v in enumerate(found) if i == 0 or v != found[i - 1]]


def rig(obj):
    """The armature that carries the plate: handles on a layer that is seen, mechanism and carriers on others."""
    data = bpy.data.armatures.new('Face')
    armature = bpy.data.objects.new('Face', data)
    bpy.context.scene.collection.objects.link(armature)
    made.activate(armature)
    bpy.ops.object.mode_set(mode='EDIT')

    def bone(name, start, end, parent=None, layer=CONTROLS, carries=False):
        one = data.edit_bones.new(name)
        one.head, one.tail, one.use_deform = start, end, carries
        one.parent = data.edit_bones[parent] if parent else None
        if hasattr(one, 'layers'):
            one.layers = [i == layer for i in range(32)]
        else:
            (data.collections.get(str(layer)) or data.collections.new(str(layer))).assign(one)
    bone('torso', (0, 0.5, -8), (0, 0.5, -6))
    bone('DEF-torso', (0, 0.5, -8), (0, 0.5, -6), 'torso', CARRIERS, True)
    bone('head', (0, 0.5, -1.5), (0, 0.5, -0.5), 'torso')
    bone('DEF-head', (0, 0.5, -1.5), (0, 0.5, 1), 'head', CARRIERS, True)
    bone('jaw_master', (0, 0.3, -0.2), (0, -0.2, -0.8), 'head')
    bone('DEF-jaw', (0, -0.1, -0.6), (0, -0.1, -0.9), 'jaw_master', CARRIERS, True)
    for name in ('MCH-mouth', 'MCH-mouth.B'):
        bone(name, (0, 0.3, -0.2), (0, 0.1, -0.4), 'head', MECHANISM)
    for name, (x, z) in HANDLES.items():
        at = Vector((x, _depth(x, z), z))
        above = {'lips': 'MCH-mouth', 'lip.B': 'MCH-mouth.B'}.get(name[:5] if name.startswith('lip.B') else name[:4], 'head')
        bone('MCH-' + name, at, at + Vector((0, -0.05, 0)), above, MECHANISM)
        bone(name, at, at + Vector((0, -0.1, 0)), 'MCH-' + name)
    pieces = [(c, i, chain[i], chain[i + 1]) for c, chain in CHAINS.items() if c != 'lip.T' for i in range(len(chain) - 1)]
    for chain, i, a, b in pieces:
        ends = [Vector((HANDLES[n][0], _depth(*HANDLES[n]), HANDLES[n][1])) for n in (a, b)]
        bone('ORG-%s.%d' % (chain, i), *ends, 'head', MECHANISM)
        bone('DEF-%s.%d' % (chain, i), *ends, 'ORG-%s.%d' % (chain, i), CARRIERS, True)
    bpy.ops.object.mode_set(mode='OBJECT')
    if hasattr(data, 'layers'):
        data.layers = [i == CONTROLS for i in range(32)]
    else:
        for collection in data.collections:
            collection.is_visible = collection.name == str(CONTROLS)
    _constrain(armature, pieces)
    _weigh(obj, armature)
    obj.modifiers.new('Armature', 'ARMATURE').object = armature
    back = bpy.data.objects['Back']
    back.vertex_groups.new(name='DEF-head').add(range(len(back.data.vertices)), 1, 'REPLACE')
    back.modifiers.new('Armature', 'ARMATURE').object = armature
    made.activate(obj)
    bpy.context.view_layer.update()
    return armature


def _constrain(armature, pieces):
    shape = bpy.data.objects.new('Shape', None)
    bones = armature.pose.bones
    for bone in bones:
        if bone.name.split('-')[0] not in ('DEF', 'ORG', 'MCH'):
            bone.custom_shape = shape

    def add(bone, kind, target, **settings):
        one = bones[bone].constraints.new(kind)
        one.target, one.subtarget = armature, target
        for name, value in settings.items():
            setattr(one, name, value)
    for name, share in (('MCH-mouth', 0.5), ('MCH-mouth.B', 1.0)):
        one = bones[name].constraints.new('ARMATURE')
        for carrier, weight in (('jaw_master', share), ('head', 1 - share)):
            target = one.targets.new()
            target.target, target.subtarget, target.weight = armature, carrier, weight
    for name, follow in FOLLOW.items():
        for other, share in follow:
            add(name, 'COPY_LOCATION', other, influence=share, use_offset=True, target_space='LOCAL', owner_space='LOCAL')
    for chain, i, a, b in pieces:
        add('ORG-%s.%d' % (chain, i), 'COPY_LOCATION', a)
        add('ORG-%s.%d' % (chain, i), 'DAMPED_TRACK', b)
        add('ORG-%s.%d' % (chain, i), 'STRETCH_TO', b)


def weigh(obj, armature, sharp):
    """Weights by how near the carriers are."""
    names = [b.name for b in armature.data.bones if b.use_deform]
    heads, tails = (np.array([tuple(armature.matrix_world @ getattr(armature.data.bones[n], end)) for n in names])
                    for end in ('head_local', 'tail_local'))
    points = np.array([tuple(obj.matrix_world @ v.co) for v in obj.data.vertices])
    way = tails - heads
    share = np.clip(np.einsum('pbi,bi->pb', points[:, None] - heads, way) / ((way ** 2).sum(axis=1) + 1e-12), 0, 1)
    off = np.linalg.norm(points[:, None] - heads - share[..., None] * way, axis=2)
    weights = sharp(names, off)
    weights /= weights.sum(axis=1, keepdims=True)
    for i, name in enumerate(names):
        group = obj.vertex_groups.new(name=name)
        for vertex in np.flatnonzero(weights[:, i] > 0.005):
            group.add([int(vertex)], float(weights[vertex, i]), 'REPLACE')


def _weigh(obj, armature):
    def sharp(names, off):
        out = np.exp(-(off / 0.1) ** 2)
        out[:, names.index('DEF-torso')] = 0
        out[:, names.index('DEF-head')] = 0.08
        low = np.array([v.co.z for v in obj.data.vertices])
        out[:, names.index('DEF-jaw')] = 1.0 / (1 + np.exp((low + 0.55) / 0.04))
        return out
    weigh(obj, armature, sharp)


def seen(obj, rig):
    """A view in which one mesh of a character fills 1000 px."""
    corners = [obj.matrix_world @ Vector(c) for c in obj.bound_box]
    middle = sum(corners, Vector()) / 8
    distance = 1.1 * max((c - middle).length for c in corners) / math.tan(math.radians(15))
    camera = Matrix.Translation(middle) @ Matrix.Rotation(math.radians(90), 4, 'X') @ Matrix.Translation((0, 0, distance))
    f, near, far = 1 / math.tan(math.radians(15)), 0.1 * distance, 10 * distance
    window = Matrix(((f, 0, 0, 0), (0, f, 0, 0), (0, 0, (far + near) / (near - far), 2 * far * near / (near - far)), (0, 0, -1, 0)))
    return space.seen_by(camera.inverted(), window, 1000, 1000, rig.space(), middle)


def rigify(model, landmarks):
    """Rigify's own face, made on the head of an avatar without its keys and bones: (the face, the rig, vertices of curves by name)."""
    face = desk.opened(model)
    desk.addon_utils.enable('rigify', default_set=True)
    for one in [o for o in bpy.data.objects if o.name == 'body' or o.name.startswith('Icosphere')]:
        bpy.data.objects.remove(one)
    old = bpy.data.objects['Armature']
    meshes = [o for o in bpy.data.objects if o.type == 'MESH']
    for one in meshes:
        matrix = one.matrix_world.copy()
        one.parent, one.matrix_world = None, matrix
        one.modifiers.clear()
        one.vertex_groups.clear()
        if one.data.shape_keys:
            one.shape_key_clear()
    bpy.data.objects.remove(old)
    with open(landmarks, encoding='utf-8') as f:
        curves = {name: one['vertices'] for name, one in json.load(f)['curves'].items()}
    bpy.ops.object.armature_human_metarig_add()
    meta = bpy.context.object
    _fit(meta, face, curves)
    bpy.ops.pose.rigify_generate()
    armature = next(o for o in bpy.data.objects if o.type == 'ARMATURE' and o != meta)
    bpy.data.objects.remove(meta)
    weigh(face, armature, lambda names, off: 1 / (off + 0.003) ** 6)
    for one in meshes:
        if one != face:
            carrier = {'eye_L': 'MCH-eye.L', 'eye_R': 'MCH-eye.R'}.get(one.name, 'DEF-spine.006')
            one.vertex_groups.new(name=carrier).add(range(len(one.data.vertices)), 1, 'REPLACE')
            armature.data.bones[carrier].use_deform = True
        one.modifiers.new('Armature', 'ARMATURE').object = armature
        one.parent = armature
    made.activate(face)
    bpy.context.view_layer.update()
    return face, armature, curves


def _fit(meta, face, curves):
    """The face of the human meta-rig alone, where the face has its features."""
    points = {name: [face.matrix_world @ face.data.vertices[v].co for v in line] for name, line in curves.items()}
    bones = meta.data.bones
    ends = [('lip.T.L.001', 'tail', max(points['lip_upper_outer'], key=lambda p: p.x)),
            ('lip.T.L', 'head', min(points['lip_upper_outer'], key=lambda p: abs(p.x))),
            ('lip.B.L', 'head', min(points['lip_lower_outer'], key=lambda p: abs(p.x))),
            ('lid.T.L', 'head', max(points['eyelid_upper_L'], key=lambda p: p.x)),
            ('lid.T.L.003', 'tail', min(points['eyelid_upper_L'], key=lambda p: p.x)),
            ('lid.T.L.001', 'tail', max(points['eyelid_upper_L'], key=lambda p: p.z)),
            ('lid.B.L.001', 'tail', min(points['eyelid_lower_L'], key=lambda p: p.z)),
            ('brow.T.L', 'tail', max(points['brow_L'], key=lambda p: p.x)),
            ('brow.T.L.002', 'tail', min(points['brow_L'], key=lambda p: p.x)),
            ('chin', 'tail', min(points['chin'], key=lambda p: p.y)),
            ('nose.001', 'tail', min(points['nose_bridge'], key=lambda p: p.y))]
    here, there = [], []
    for name, end, goal in ends:
        start = getattr(bones[name], end + '_local')
        for side in (1, -1):
            here.append((side * start.x, start.y, start.z, 1))
            there.append((side * goal.x, goal.y, goal.z))
    fit = np.linalg.lstsq(np.array(here), np.array(there), rcond=None)[0]
    bpy.ops.object.mode_set(mode='EDIT')
    edit = meta.data.edit_bones
    below = {b.name for b in edit['spine.006'].children_recursive} | {'spine.006'}
    for one in [b for b in edit if b.name not in below]:
        edit.remove(one)
    moved = {b.name: (np.r_[b.head, 1] @ fit, np.r_[b.tail, 1] @ fit) for b in edit}
    for one in edit:
        one.head, one.tail = moved[one.name]
    bpy.ops.object.mode_set(mode='OBJECT')
    meta.pose.bones['spine.006'].rigify_type = 'basic.super_copy'
