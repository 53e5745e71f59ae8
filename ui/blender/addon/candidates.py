"""The controls of a character that an animator may touch, each with what it may move: free keys, properties and objects that drive, and
the bones that are seen, are not locked and, where a rig has bones with shapes of their own, have one."""
import bpy
import numpy as np

from . import versions
from .bones import BoneAngle, BoneTurn, Channel, may_turn, order_of_locks
from .controls import KeyControl, Property, drivers_of
from .reach import LIMITS, key_of
from .taken import key_controls

STEP_OF_BONE, STEP_OF_SIZE, STEP_OF_SCALE = 0.05, 0.01, 0.02


class Candidate:
    """A control, the nodes of the graph that it sets, where it is seen (None: nowhere), and whether drivers look at it."""

    def __init__(self, control, starts, place, fed):
        self.control, self.starts, self.place, self.fed = control, starts, place, fed
        self.mask = None

    @property
    def owner(self):
        """What tells its bone or object."""
        return self.starts[0][1:-2]

    @property
    def late(self):
        """Scales are tried last."""
        return getattr(self.control, 'path', '') == 'scale'


def touchable(armature):
    """The pose bones that an animator sees and may take hold of."""
    seen = [b for b in armature.pose.bones if versions.bone_seen(armature, b)]
    shaped = [b for b in seen if b.custom_shape is not None]
    return shaped or [b for b in seen if all(c.mute or c.influence == 0 or c.type in LIMITS for c in b.constraints)]


def _driven_channels(owner_id, head):
    return {(d.data_path[len(head):], d.array_index) for d in drivers_of(owner_id) if d.data_path.startswith(head)}


def _of_bone(graph, armature, bone, shaped):
    own, name = key_of(armature), bone.name
    driven = _driven_channels(armature, 'pose.bones["%s"].' % bpy.utils.escape_identifier(name))
    place = armature.matrix_world @ bone.head
    out = []
    if may_turn(bone) and not any(path.startswith('rotation') for path, _ in driven):
        turn = BoneTurn(armature, bone, order_of_locks(bone))
        starts = [('channel', own, name, 'rotation', axis) for axis in range(3)]
        out += [(BoneAngle(turn, axis), starts) for axis in range(3) if not bone.lock_rotation[axis]]
    for path, locks, step in (('location', bone.lock_location, STEP_OF_BONE * bone.length), ('scale', bone.lock_scale, STEP_OF_SCALE)):
        if path == 'location' and bone.bone.use_connect:
            continue
        for axis in range(3):
            starts = [('channel', own, name, path, axis)]
            # Bones that only carry are turned; others are moved by what they are made for.
            wanted = shaped or graph.feeds([*starts, ('placed', own, name)]) or path == 'location' and graph.is_followed(own, name)
            if wanted and not locks[axis] and (path, axis) not in driven:
                out.append((Channel(bone, path, axis, step, armature), starts))
    ends = [('local', own, name), ('placed', own, name)]
    return [Candidate(control, starts, place, graph.feeds(starts + ends)) for control, starts in out]


def _of_object(graph, obj, size):
    own, driven = key_of(obj), _driven_channels(obj, '')
    if obj.library is not None or not obj.visible_get() or any(not c.mute and c.influence > 0 and c.type not in LIMITS for c in obj.constraints):
        return []
    out = []
    for path, locks, step in (('location', obj.lock_location, STEP_OF_SIZE * size), ('rotation_euler', obj.lock_rotation, BoneAngle.STEP),
                              ('scale', obj.lock_scale, STEP_OF_SCALE)):
        if path == 'rotation_euler' and obj.rotation_mode in ('QUATERNION', 'AXIS_ANGLE'):
            continue
        for axis in range(3):
            starts = [('channel', own, path, axis)]
            fed = graph.feeds([*starts, ('local', own), ('placed', own)])
            if not locks[axis] and (path, axis) not in driven and (fed or path != 'scale' and graph.is_followed(own)):
                out.append(Candidate(Channel(obj, path, axis, step), starts, obj.matrix_world.to_translation(), fed))
    return out


def _properties(graph):
    out, seen = [], set()
    for block, head, name in graph.properties:
        path = '%s["%s"]' % (head, bpy.utils.escape_identifier(name))
        if (key_of(block), path) in seen or any(d.data_path == path for d in drivers_of(block)) or block.library is not None:
            continue
        seen.add((key_of(block), path))
        try:
            owner = block.path_resolve(head) if head else block
            if isinstance(owner[name], (float, int)) and not isinstance(owner[name], bool):
                out.append(Candidate(Property(block, head, name, name), [('value', key_of(block), path)], None, True))
        except (KeyError, ValueError, AttributeError, TypeError):
            continue
    return out


def candidates(graph, objects, size):
    """All controls that may move some vertex, each with the vertices that it may move."""
    out = []
    for control in key_controls(objects):
        starts = [('value', key_of(obj.data.shape_keys), 'key_blocks["%s"].value' % bpy.utils.escape_identifier(key.name))
                  for obj, key in ((held.get(), member) for held, member in control.keys)]
        out.append(Candidate(control, starts, None, False))
    out += _properties(graph)
    for armature in graph.armatures:
        for bone in touchable(armature) if armature.library is None else ():
            out += _of_bone(graph, armature, bone, bone.custom_shape is not None)
    for obj in graph.others:
        if graph.surface.part_of(obj) is None:
            out += _of_object(graph, obj, size)
    masks, space = {}, graph.surface.space
    for one in out:
        one.place = None if one.place is None else np.array(space.of_world(one.place))
        key = tuple(sorted(one.starts, key=repr))
        if key not in masks:
            masks[key] = graph.vertices(one.starts)
        one.mask = masks[key]
    return [one for one in out if one.mask.any()]


def selected(candidate_or_control, bones, keys):
    """Whether a control is one of those that were chosen: `bones`: pairs of armature's and bone's names, `keys`: names of shape keys."""
    control = getattr(candidate_or_control, 'control', candidate_or_control)
    control = getattr(control, 'control', control)
    if isinstance(control, KeyControl):
        return control.key in keys
    of = getattr(control, 'turn', None) or getattr(control, 'of_bone', None) or control
    return (getattr(of, 'object', None), getattr(of, 'bone', None)) in bones


def extent(points):
    """The diagonal of the box of points (n, 3)."""
    return float(np.linalg.norm(points.max(axis=0) - points.min(axis=0))) if len(points) else 0.0
