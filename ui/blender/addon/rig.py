"""An object of Blender as a character of penpose: its mesh, its shape keys, and the bones that carry it.

Keys and bones that nothing else acts upon are taken as they are, so that penpose and Blender agree to rounding. Where drivers,
constraints or modifiers act between, what each control does is measured instead (measure.py).
"""
import hashlib

import bpy
import numpy as np
from mathutils import Matrix

from . import measure
from .bones import BoneTurn, limit_of, may_turn, seen_turn
from .controls import TINY, KeyControl, Refused, curves_that_act, drivers_of
from .library import Character, Joint, Shape
from .space import Space

MOST_VERTICES = 1000000


def armature_modifiers(obj):
    """The Armature modifiers that are seen."""
    return [m for m in obj.modifiers if m.type == 'ARMATURE' and m.show_viewport and m.object is not None]


def armature_of(obj):
    """The armature that carries a mesh, or None."""
    for modifier in armature_modifiers(obj):
        return modifier.object
    if obj.parent is not None and obj.parent.type == 'ARMATURE' and obj.parent_type == 'ARMATURE':
        return obj.parent
    return None


LINKED = 'make a library override of the whole character (Object > Library Override > Make)'


def _check_armature(obj):
    armature = armature_of(obj)
    if armature is None:
        return
    if armature.library is not None:
        raise Refused('%s, which carries %s, is linked; %s' % (armature.name, obj.name, LINKED))
    if armature.data.pose_position == 'REST':
        raise Refused('%s, which carries %s, is shown at rest; set it to Pose Position in the properties of the armature' % (
            armature.name, obj.name))
    if abs(armature.matrix_world.determinant()) < 1e-30:
        raise Refused('%s, which carries %s, has a scale of 0; give it another' % (armature.name, obj.name))


def check(obj):
    """Refuses what cannot be drawn on."""
    if obj is None or obj.type != 'MESH':
        raise Refused('%s is no mesh; select the mesh that is to be drawn on' % (obj.name if obj is not None else 'what is active'))
    if obj.mode not in ('OBJECT', 'POSE'):
        raise Refused('%s is in %s mode; go to Object or Pose mode' % (obj.name, obj.mode.lower().replace('_', ' ')))
    if obj.library is not None:
        raise Refused('%s is linked; %s' % (obj.name, LINKED))
    if any(m.type == 'MULTIRES' and m.show_viewport and m.levels > 0 for m in obj.modifiers):
        raise Refused('%s has Multires levels in the viewport; set its Level Viewport to 0' % obj.name)
    if len(obj.data.vertices) > MOST_VERTICES:
        raise Refused('%s has %d vertices, more than %d; draw on a lighter copy that the same rig moves' %
                      (obj.name, len(obj.data.vertices), MOST_VERTICES))
    if not obj.data.polygons:
        raise Refused('%s has no faces to draw on' % obj.name)
    keys = obj.data.shape_keys
    if keys is not None and not keys.use_relative:
        raise Refused('the shape keys of %s are not relative; tick Relative in the panel Shape Keys' % obj.name)
    if keys is not None and obj.show_only_shape_key:
        raise Refused('%s shows a single shape key alone; turn off the pin in the panel Shape Keys' % obj.name)
    if abs(obj.matrix_world.determinant()) < 1e-30:
        raise Refused('%s has a scale of 0; give it another' % obj.name)
    _check_armature(obj)


def _coordinates(points, count):
    out = np.empty(3 * count, dtype=np.float32)
    points.foreach_get('co', out)
    return out.reshape(-1, 3)


def _finite(array, what):
    if not np.isfinite(array).all():
        raise Refused('%s has a vertex that is not finite (NaN); mend or delete it' % what)
    return array


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


class Mesh:
    """The mesh at rest, in the character's space."""

    def __init__(self, obj):
        data, count = obj.data, len(obj.data.vertices)
        self.space = Space(obj.matrix_world)
        keys = data.shape_keys
        points = keys.reference_key.data if keys else data.vertices
        self.rest = self.space.of_object(_finite(_coordinates(points, count), obj.name))
        self.lifted = self.rest.copy()  # where keys are at the value that the character has as 0
        data.calc_loop_triangles()
        corners = np.empty(3 * len(data.loop_triangles), dtype=np.int32)
        data.loop_triangles.foreach_get('vertices', corners)
        self.triangles = corners.reshape(-1, 3)
        if self.space.mirrored:
            self.triangles = self.triangles[:, ::-1]
        self.topology = hashlib.sha256(np.ascontiguousarray(self.triangles).tobytes() + b'%d' % count).hexdigest()[:16]


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


def shapes_of(obj, mesh):
    """All keys that are seen, as shapes, and which of them may move. Those that cannot be 0 lift the mesh."""
    keys = obj.data.shape_keys
    if keys is None:
        return [], []
    count, free = len(obj.data.vertices), {k.name for k in free_keys(obj)}
    shapes, movable = [], []
    for key in keys.key_blocks:
        if key == keys.reference_key or key.mute:
            continue
        deltas = _coordinates(key.data, count).astype(np.float64) - _coordinates(key.relative_key.data, count)
        deltas = mesh.space.of_object(_finite(deltas, 'the shape key %s of %s' % (key.name, obj.name)))
        weights = _group_weights(obj, key.vertex_group)
        if weights is not None:
            deltas *= weights[:, None]
        control = KeyControl(obj, key)
        least, most = control.range()
        rest = control.rest()
        mesh.lifted += rest * deltas
        shapes.append(Shape(control.name, deltas.astype(np.float32), None, min(least, key.value) - rest, max(most, key.value) - rest))
        movable.append((control, key.name in free))
    return shapes, movable


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


class Skin:
    """The bones that carry a mesh, as joints."""

    def __init__(self, obj, armature, mesh):
        to_object = armature.matrix_world.inverted() @ obj.matrix_world
        from_character = to_object @ mesh.space.linear.inverted().to_4x4()
        self.joints = _affine_joints('armature', from_character.inverted(), np.eye(4))
        self.joints[-1].inverse_bind = np.array(from_character)  # of the vertices that no bone carries
        self.ground = len(self.joints) - 1
        bones = _ordered(armature.data.bones)
        moving = self._moving(obj, armature, bones)
        self.turns, number = [], {}
        for bone in bones:
            pose = armature.pose.bones[bone.name]
            parent = number[bone.parent.name] if bone.parent else self.ground
            turn = BoneTurn(armature, pose) if bone.name in moving and may_turn(pose) else None
            self._add(bone, pose, parent, turn, np.array(bone.matrix_local.inverted() @ from_character))
            number[bone.name] = len(self.joints) - 1
            if turn is not None:
                self.turns.append(turn)
        self.joint_of, self.weight_of = self._weights(obj, armature, number)

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

    def _weights(self, obj, armature, number):
        groups = {g.index: number[g.name] for g in obj.vertex_groups if g.name in number and armature.data.bones[g.name].use_deform}
        rows = [[(groups[e.group], e.weight) for e in v.groups if e.group in groups and e.weight > 0] for v in obj.data.vertices]
        width = max(1, max(map(len, rows)))
        joint_of, weight_of = np.zeros((len(rows), width), dtype=np.uint32), np.zeros((len(rows), width))
        for v, row in enumerate(rows):
            for i, (joint, weight) in enumerate(row or [(self.ground, 1.0)]):
                joint_of[v, i], weight_of[v, i] = joint, weight
        return joint_of, weight_of

    def _moving(self, obj, armature, bones):
        """Bones that may carry vertices, or whose children do."""
        groups = {g.index: g.name for g in obj.vertex_groups if g.name in armature.data.bones}
        used = {groups[e.group] for v in obj.data.vertices for e in v.groups if e.group in groups and e.weight > 0}
        moving = set()
        for bone in reversed(bones):
            if bone.name in used and bone.use_deform or any(c.name in moving for c in bone.children):
                moving.add(bone.name)
        return moving


def acts_between(obj, armature):
    """Why controls have to be measured, in a few words; empty: keys and bones alone make what is seen."""
    if curves_that_act(obj, armature):
        return 'drivers'
    for modifier in obj.modifiers:
        if modifier.type in measure.DEFORMING and modifier.type != 'ARMATURE' and modifier.show_viewport:
            return 'the modifier ' + modifier.name
    if armature is None:
        return ''
    carriers = armature_modifiers(obj)
    if len(carriers) > 1:
        return 'several Armature modifiers'
    if any(m.use_deform_preserve_volume or m.use_bone_envelopes or m.vertex_group or not m.use_vertex_groups for m in carriers):
        return 'options of the Armature modifier'
    names = {g.name for g in obj.vertex_groups}
    carrying = [b for b in armature.pose.bones if b.name in names and b.bone.use_deform]
    above = {p.name: p for bone in carrying for p in [bone, *bone.parent_recursive]}
    return '' if all(is_plain(b) for b in above.values()) else 'constraints of bones'


class Rig:
    """A character and what of Blender each of its parameters is.

    `character`: penpose's; `controls`: pairs of (control, parameters), in the order of the pose; `measured`: why controls were
    measured, or an empty text; `took_s`: how long that took."""

    def __init__(self, obj, depsgraph=None):
        check(obj)
        self.object = obj.name
        self.mesh = Mesh(obj)
        armature = armature_of(obj)
        self.armature = armature.name if armature else None
        self.measured, self.took_s, self.shown = acts_between(obj, armature), 0.0, None
        if self.measured:
            self._measure(obj, armature)
        else:
            self._take(obj, armature)
        if not any(free for _, _, free in self.parts):
            keys = obj.data.shape_keys
            if keys is not None and keys.library is not None:
                raise Refused('the shape keys of %s are linked, and nothing else moves it; make a library override of its mesh too' %
                              obj.name)
            raise Refused('%s has nothing to pose: no shape key and no bone that moves it; New Key by Drawing makes one' % obj.name)
        self.offsets = np.array([value for control, _, _ in self.parts for value in _listed(control.rest())])
        limits = self.character.parameters
        self.least, self.most = np.array([p.minimum for p in limits]), np.array([p.maximum for p in limits])
        self._lock()
        self.take_pose()

    def _take(self, obj, armature):
        shapes, keys = shapes_of(obj, self.mesh)
        skin = Skin(obj, armature, self.mesh) if armature else None
        joints = {} if skin is None else {'joints': skin.joints, 'joint_of': skin.joint_of, 'weight_of': skin.weight_of}
        self.character = Character.from_arrays(self.mesh.lifted, self.mesh.triangles, shapes, **joints)
        self.parts = [(control, [i], free) for i, (control, free) in enumerate(keys)]
        first = len(keys)
        for turn in skin.turns if skin else []:
            count = len(turn.rest())
            self.parts.append((turn, list(range(first, first + count)), True))
            first += count

    def _measure(self, obj, armature):
        controls = measure.controls_of(obj, armature, free_keys(obj))
        base, shapes, self.took_s = measure.measured(obj, self.mesh.space, controls)
        self.shown = measure.evaluated(obj, len(base))
        self.character = Character.from_arrays(base, self.mesh.triangles, shapes)
        self.parts = [(control, [i], True) for i, control in enumerate(controls)]

    def holds(self, obj):
        """Whether what was measured, or the ranges that were taken, are those of what Blender has now."""
        if self.measured:
            bpy.context.view_layer.update()
            shown = measure.evaluated(obj, len(self.mesh.rest))
            return shown is None and self.shown is None or \
                shown is not None and self.shown is not None and np.array_equal(shown, self.shown)
        values = self.pose() - self.offsets
        return bool((values >= self.least - TINY).all() and (values <= self.most + TINY).all())

    def _lock(self):
        names = [p.name for p in self.character.parameters]
        for control, numbers, free in self.parts:
            held = [not free] * len(numbers) if len(numbers) == 1 else control.locked()
            for number, locked in zip(numbers, held):
                if locked:
                    self.character.lock(names[number])

    def answers_otherwise(self):
        """Whether Blender may show another pose than the one that is solved for, so that it is solved again from there."""
        return bool(self.measured) or any(getattr(control, 'is_held', bool)() for control, _, _ in self.parts)

    def become_file(self):
        """Makes the character what its own file holds, to the bit, for a file rounds joints and weights. The file, .glb."""
        data = b''
        for _ in range(4):
            before, data = data, self.character.write('.glb')
            if data == before:
                break
            self.character = Character.read(data, 'model.glb')
            self._lock()
        return data

    def pose(self):
        """What Blender has now, one value a parameter: of keys and properties their values, of bones angles."""
        return np.array([value for control, _, _ in self.parts for value in _listed(control.get())])

    def take_pose(self):
        """Tells the character what Blender has, where that differs."""
        now = self.pose() - self.offsets
        if np.abs(now - self.character.pose).max(initial=0.0) > TINY:
            self.character.pose = np.clip(now, self.least, self.most)

    def apply(self, values, since=None):
        """Sets Blender's controls to a pose of the character; those that it leaves alone are not touched. `since`: a pose that they
        were set to; only what differs is looked at. The controls that moved."""
        moved = []
        changed = None if since is None else np.abs(values - since) > TINY
        for control, numbers, free in self.parts:
            if not free or changed is not None and not changed[numbers].any():
                continue
            new = [float(values[n] + self.offsets[n]) for n in numbers]
            if max(abs(a - b) for a, b in zip(new, _listed(control.get()))) <= TINY:
                continue
            control.set(new[0] if len(numbers) == 1 else new)
            moved.append(control)
        return moved

    def kept(self):
        """What give_back() brings back to the bit."""
        return [(control, control.kept()) for control, _, free in self.parts if free]

    def moved_from(self, pose):
        """The controls that differ from an earlier pose()."""
        now = self.pose()
        return [control for control, numbers, _ in self.parts if np.abs(now[numbers] - pose[numbers]).max() > TINY]


def _listed(value):
    return value if isinstance(value, list) else [value]


def give_back(kept):
    """Brings back what Rig.kept() had of what is still there."""
    for control, value in kept:
        try:
            if control.kept() != value:
                control.give_back(value)
        except (Refused, ReferenceError, KeyError, AttributeError):
            continue
