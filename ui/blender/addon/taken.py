"""Shape keys and bones that nothing else acts upon, taken as they are: penpose and Blender agree to rounding."""
import bpy
import numpy as np
from mathutils import Matrix

from .bones import BoneTurn, limit_of, may_turn, seen_turn
from .character import armature_modifiers, armature_of, bone_above
from .controls import KeyControl, drivers_of
from .library import Joint, Shape
from .space import Space
from .surface import DEFORMING, coordinates, corners_of, finite, making


class Mesh:
    """A mesh alone at rest, in the space of its own character."""

    def __init__(self, obj):
        data, keys = obj.data, obj.data.shape_keys
        self.space = Space(obj.matrix_world)
        points = keys.reference_key.data if keys else data.vertices
        self.rest = self.space.of_object(finite(coordinates(points, len(data.vertices)), obj.name))
        self.triangles = corners_of(data)
        if self.space.mirrored:
            self.triangles = self.triangles[:, ::-1]


def _is_driven(block, path):
    return any(d.data_path == path for d in drivers_of(block))


def free_keys(obj):
    """The shape keys that a person may move: relative to another, not muted, not driven, not linked, not at a range of nothing."""
    keys = obj.data.shape_keys
    if keys is None or keys.library is not None:
        return []
    return [k for k in keys.key_blocks
            if k != keys.reference_key and not k.mute and k.slider_max > k.slider_min
            and not _is_driven(keys, 'key_blocks["%s"].value' % bpy.utils.escape_identifier(k.name))]


def key_controls(objects):
    """The free keys of a character's meshes, equal names together, as controls."""
    named = {}
    for obj in objects:
        for key in free_keys(obj):
            named.setdefault(key.name, []).append((obj, key))
    return [KeyControl(keys) for keys in named.values()]


def _group_weights(obj, name):
    group = obj.vertex_groups.get(name) if name else None
    if group is None:
        return None
    out = np.zeros(len(obj.data.vertices))
    for vertex in obj.data.vertices:
        for entry in vertex.groups:
            if entry.group == group.index:
                out[vertex.index] = entry.weight
    return out


def shapes_of(surface, hidden):
    """All keys that are seen, as shapes, which of them may move, and the surface where all are 0: those that cannot be 0 lift it.
    `hidden`: meshes whose keys of the same names move along."""
    lifted, named = surface.rest.copy(), {}
    for part in surface.parts:
        obj = part.object()
        keys = obj.data.shape_keys
        for key in keys.key_blocks if keys else ():
            if key != keys.reference_key and not key.mute:
                named.setdefault(key.name, []).append((part, obj, key))
    shapes, movable = [], []
    for name, found in named.items():
        free = [(o, k) for _, o, k in found if k.name in {f.name for f in free_keys(o)}]
        unseen = [(o, o.data.shape_keys.key_blocks[name]) for o in hidden if name in {f.name for f in free_keys(o)}]
        control = KeyControl(free + unseen if free else [(o, k) for _, o, k in found])
        rest, (least, most) = control.rest(), control.range()
        moved, vertices = [], []
        for part, obj, key in found:
            deltas = _deltas(surface, part, obj, key)
            lifted[part.first:part.first + part.count] += rest * deltas
            moved.append(deltas.astype(np.float32))
            vertices.append(np.arange(part.first, part.first + part.count, dtype=np.uint32))
        value = found[0][2].value
        alone = len(surface.parts) == 1
        shapes.append(Shape(name, moved[0] if alone else np.concatenate(moved), None if alone else np.concatenate(vertices),
                            min(least, value) - rest, max(most, value) - rest))
        movable.append((control, bool(free)))
    return shapes, movable, lifted


def _deltas(surface, part, obj, key):
    deltas = coordinates(key.data, part.count).astype(np.float64) - coordinates(key.relative_key.data, part.count)
    finite(deltas, 'the shape key %s of %s' % (key.name, obj.name))
    origin = surface.of_part(obj, np.zeros((1, 3)))
    deltas = surface.of_part(obj, deltas) - origin if obj != surface.anchor.get() else surface.of_part(obj, deltas)
    weights = _group_weights(obj, key.vertex_group)
    return deltas if weights is None else deltas * weights[:, None]


def _ordered(bones):
    """Parents before children."""
    out, waiting = [], [b for b in bones if b.parent is None]
    while waiting:
        bone = waiting.pop(0)
        out.append(bone)
        waiting.extend(bone.children)
    return out


def _affine_joints(name, matrix, inverse_bind):
    """Joints whose product is any matrix without perspective: two, for the scale may lie between two turns."""
    linear, place = np.array(matrix.to_3x3()), list(matrix.to_translation())
    lengths = np.linalg.norm(linear, axis=0)
    turn = linear / lengths
    if np.allclose(turn.T @ turn, np.eye(3), atol=1e-6) and np.linalg.det(turn) > 0:
        return [Joint(name, -1, place, _xyzw(Matrix(turn.tolist())), list(lengths), inverse_bind, False)]
    u, s, vt = np.linalg.svd(linear)
    if np.linalg.det(u) < 0:
        u, s = u * (1, 1, -1), s * (1, 1, -1)
    if np.linalg.det(vt) < 0:
        vt, s = (vt.T * (1, 1, -1)).T, s * (1, 1, -1)
    return [Joint(name, -1, place, _xyzw(Matrix(u.tolist())), list(s), inverse_bind, False),
            Joint(name + ' turned', 0, (0, 0, 0), _xyzw(Matrix(vt.tolist())), (1, 1, 1), inverse_bind, False)]


def _xyzw(matrix):
    q = matrix.to_quaternion().normalized()
    return [q.x, q.y, q.z, q.w]


def is_plain(bone):
    """Whether the bone goes by its own turn alone: no constraint but its limit, and it takes all of its parent along."""
    others = [c for c in bone.constraints if not c.mute and c.influence > 0 and c != limit_of(bone)]
    own = bone.bone
    return not others and own.use_inherit_rotation and own.inherit_scale == 'FULL' and own.use_local_location and own.bbone_segments == 1


def carriers_of(obj, armature):
    """Names of the bones that carry a mesh: by its weights, or the one that takes all of it along."""
    above = bone_above(obj)
    if above is not None:
        return {above[1].name}
    if armature_of(obj) != armature:
        return set()
    groups = {g.index: g.name for g in obj.vertex_groups if g.name in armature.data.bones and armature.data.bones[g.name].use_deform}
    return {groups[e.group] for v in obj.data.vertices for e in v.groups if e.group in groups and e.weight > 0}


class Skin:
    """The bones that carry the meshes of a character, as joints."""

    def __init__(self, surface, armature):
        to_armature = armature.matrix_world.inverted() @ surface.anchor.get().matrix_world
        from_character = to_armature @ surface.space.linear.inverted().to_4x4()
        self.joints = _affine_joints('armature', from_character.inverted(), np.eye(4))
        self.joints[-1].inverse_bind = np.array(from_character)  # of the vertices that no bone carries
        self.ground = len(self.joints) - 1
        bones = _ordered(armature.data.bones)
        moving = self._moving(surface, armature, bones)
        self.turns, number = [], {}
        for bone in bones:
            pose = armature.pose.bones[bone.name]
            parent = number[bone.parent.name] if bone.parent else self.ground
            turn = BoneTurn(armature, pose) if bone.name in moving and may_turn(pose) else None
            self._add(bone, pose, parent, turn, np.array(bone.matrix_local.inverted() @ from_character))
            number[bone.name] = len(self.joints) - 1
            if turn is not None:
                self.turns.append(turn)
        self._weigh(surface, armature, number)

    def _add(self, bone, pose, parent, turn, inverse_bind):
        rest = bone.parent.matrix_local.inverted() @ bone.matrix_local if bone.parent else bone.matrix_local
        place, rotation = list(rest.to_translation() + rest.to_3x3() @ pose.location), rest.to_3x3()
        if turn is None:
            fixed = _xyzw(rotation @ seen_turn(pose).to_matrix())
            self.joints.append(Joint(bone.name, parent, place, fixed, list(pose.scale), inverse_bind, False))
            return
        ranges = [turn.range(axis) for axis in range(3)]
        self.joints.append(Joint(bone.name, parent, place, _xyzw(rotation), list(pose.scale), inverse_bind, True,
                                 [r[0] for r in ranges], [r[1] for r in ranges]))

    def _weigh(self, surface, armature, number):
        rows = []
        for part in surface.parts:
            rows += self._rows(part.object(), armature, number)
        width = max(1, max(map(len, rows)))
        self.joint_of, self.weight_of = np.zeros((len(rows), width), dtype=np.uint32), np.zeros((len(rows), width))
        for v, row in enumerate(rows):
            for i, (joint, weight) in enumerate(row or [(self.ground, 1.0)]):
                self.joint_of[v, i], self.weight_of[v, i] = joint, weight

    def _rows(self, obj, armature, number):
        above = bone_above(obj)
        if above is not None or armature_of(obj) != armature:
            return [[(number[above[1].name] if above is not None else self.ground, 1.0)]] * len(obj.data.vertices)
        groups = {g.index: number[g.name] for g in obj.vertex_groups if g.name in number and armature.data.bones[g.name].use_deform}
        return [[(groups[e.group], e.weight) for e in v.groups if e.group in groups and e.weight > 0] for v in obj.data.vertices]

    def _moving(self, surface, armature, bones):
        """Bones that may carry vertices, or whose children do."""
        used, moving = set(), set()
        for part in surface.parts:
            used |= carriers_of(part.object(), armature)
        for bone in reversed(bones):
            if bone.name in used or any(c.name in moving for c in bone.children):
                moving.add(bone.name)
        return moving


def acts_between(surface, armatures, driven):
    """Why controls have to be measured, in a few words; empty: keys and bones alone make what is seen. `driven`: whether drivers act."""
    if driven:
        return 'drivers'
    objects = [p.object() for p in surface.parts]
    for part, obj in zip(surface.parts, objects):
        for modifier in obj.modifiers:
            if modifier.show_viewport and modifier.type != 'ARMATURE' and (modifier.type in DEFORMING or part.shown and modifier in making(obj)):
                return 'the modifier ' + modifier.name
        above = bone_above(obj)
        if above is not None and armature_modifiers(obj):
            return 'bones that take a mesh along twice'
        if any(not c.mute and c.influence > 0 for o in _hung_on(obj) for c in o.constraints):
            return 'constraints of objects'
    if len(armatures) > 1:
        return 'several armatures'
    for obj in objects:
        carriers = armature_modifiers(obj)
        if len(carriers) > 1:
            return 'several Armature modifiers'
        if any(m.use_deform_preserve_volume or m.use_bone_envelopes or m.vertex_group or not m.use_vertex_groups for m in carriers):
            return 'options of the Armature modifier'
    for armature in armatures:
        carrying = [armature.pose.bones[n] for n in set().union(*(carriers_of(o, armature) for o in objects))]
        above = {p.name: p for bone in carrying for p in [bone, *bone.parent_recursive]}
        if not all(is_plain(b) for b in above.values()):
            return 'constraints of bones'
    return ''


def _hung_on(obj):
    out = []
    while obj is not None:
        if obj.type != 'ARMATURE':
            out.append(obj)
        obj = obj.parent
    return out
