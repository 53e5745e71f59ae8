"""What of a rig in Blender penpose may move: shape keys, angles of pose bones, custom properties.

A control is found again by names at each use, because undo and file loads leave no reference to a bone or key valid.
"""
import math

import bpy
from mathutils import Euler, Quaternion

TINY = 1e-6
RIGHT_ANGLE = 0.5 * math.pi


class Refused(Exception):
    """What is asked for cannot be done; the text is one line for a person, with the remedy."""


class KeyControl:
    """The value of a shape key."""

    def __init__(self, obj, key):
        self.object = obj.name
        self.key = key.name
        self.name = key.name
        self.least, self.most = key.slider_min, key.slider_max

    def _key(self):
        return bpy.data.objects[self.object].data.shape_keys.key_blocks[self.key]

    def range(self):
        """Rest lies in it, as penpose wants."""
        return min(0.0, self.least), max(0.0, self.most)

    def get(self):
        return self._key().value

    def set(self, value):
        self._key().value = min(self.most, max(self.least, value))

    def path(self):
        """The block that a keyframe goes into, its path and index."""
        return self._key(), 'value', -1


class BoneTurn:
    """The turn of a pose bone: three angles, Rx Ry Rz about its own axes, as a joint of penpose has them."""

    def __init__(self, armature, bone):
        self.object = armature.name
        self.bone = bone.name
        self.names = ['%s.r%s' % (bone.name, axis) for axis in 'xyz']
        self.limits = _limits(bone)

    def pose_bone(self):
        return bpy.data.objects[self.object].pose.bones[self.bone]

    def get(self):
        return list(turn_of(self.pose_bone()).to_matrix().to_euler('ZYX'))

    def set(self, angles):
        set_turn(self.pose_bone(), Euler(angles, 'ZYX').to_quaternion())

    def locked(self):
        """Which of the three the bone's own locks hold."""
        return list(self.pose_bone().lock_rotation)

    def range(self, axis):
        least, most = self.limits[axis]
        now = self.get()[axis]
        return min(least, now, 0.0), max(most, now, 0.0)


class Property:
    """A custom property that drives what is seen."""

    def __init__(self, owner_path, owner, prop, name):
        self.owner_path = owner_path  # of bpy.data, evaluated at each use
        self.prop = prop
        self.name = name
        ui = owner.id_properties_ui(prop).as_dict()
        self.least = max(-1e4, float(ui.get('soft_min', ui.get('min', 0.0))))
        self.most = min(1e4, float(ui.get('soft_max', ui.get('max', 1.0))))

    def owner(self):
        return resolve(self.owner_path)

    def range(self):
        now = self.get()
        return min(0.0, self.least, now), max(0.0, self.most, now)

    def get(self):
        return float(self.owner()[self.prop])

    def set(self, value):
        owner = self.owner()
        owner[self.prop] = min(self.most, max(self.least, float(value)))
        owner.id_data.update_tag()

    def path(self):
        return self.owner(), '["%s"]' % bpy.utils.escape_identifier(self.prop), -1


def resolve(path):
    """The block that a path such as ('objects', 'Rig', 'pose.bones["face"]') names."""
    block = getattr(bpy.data, path[0])[path[1]]
    return block.path_resolve(path[2]) if path[2] else block


def turn_of(bone):
    """The rotation that a pose bone has, whatever its mode."""
    if bone.rotation_mode == 'QUATERNION':
        return bone.rotation_quaternion.normalized()
    if bone.rotation_mode == 'AXIS_ANGLE':
        angle, *axis = bone.rotation_axis_angle
        return Quaternion(axis, angle)
    return bone.rotation_euler.to_quaternion()


def set_turn(bone, turn):
    """Turns a pose bone in its own mode; what is locked stays."""
    lock = bone.lock_rotation
    if bone.rotation_mode == 'QUATERNION':
        old = bone.rotation_quaternion.copy()
        new = turn.copy()
        if old.dot(new) < 0:
            new.negate()
        for axis in range(3):
            if lock[axis]:
                new[axis + 1] = old[axis + 1]
        if bone.lock_rotations_4d and bone.lock_rotation_w:
            new[0] = old[0]
        bone.rotation_quaternion = new
    elif bone.rotation_mode == 'AXIS_ANGLE':
        if not any(lock):
            axis, angle = turn.to_axis_angle()
            bone.rotation_axis_angle = (angle, *axis)
    else:
        old = bone.rotation_euler.copy()
        new = turn.to_euler(bone.rotation_mode, old)
        for axis in range(3):
            if lock[axis]:
                new[axis] = old[axis]
        bone.rotation_euler = new


def rotation_path(bone):
    """The channel that holds a bone's rotation."""
    return {'QUATERNION': 'rotation_quaternion', 'AXIS_ANGLE': 'rotation_axis_angle'}.get(bone.rotation_mode, 'rotation_euler')


def limit_of(bone):
    """The bone's own limit of rotation that is in force, or None."""
    for constraint in bone.constraints:
        if constraint.type == 'LIMIT_ROTATION' and not constraint.mute and constraint.owner_space == 'LOCAL' and constraint.influence == 1:
            return constraint
    return None


def _limits(bone):
    limits = [(-RIGHT_ANGLE, RIGHT_ANGLE)] * 3
    constraint = limit_of(bone)
    if constraint is not None:
        for axis, letter in enumerate('xyz'):
            if getattr(constraint, 'use_limit_' + letter):
                limits[axis] = (getattr(constraint, 'min_' + letter), getattr(constraint, 'max_' + letter))
    return limits


def drivers_of(block):
    """The drivers in force of a data-block."""
    data = block.animation_data if block is not None else None
    return [d for d in data.drivers if not d.mute] if data else []


def properties_that_drive(blocks):
    """The custom properties of float or int that drivers of these blocks look at, as controls, each once."""
    found = {}
    for block in blocks:
        for curve in drivers_of(block):
            for variable in curve.driver.variables:
                if variable.type != 'SINGLE_PROP' or variable.targets[0].id is None:
                    continue
                target = variable.targets[0]
                head, bracket, tail = target.data_path.rpartition('["')
                if not bracket or not tail.endswith('"]'):
                    continue
                name = bpy.utils.unescape_identifier(tail[:-2])
                collection = _collection_of(target.id)
                if collection is None:
                    continue
                path = (collection, target.id.name, head)
                if (path, name) in found:
                    continue
                try:
                    owner = resolve(path)
                    if isinstance(owner[name], (float, int)) and not isinstance(owner[name], bool):
                        found[path, name] = Property(path, owner, name, name)
                except (KeyError, ValueError, AttributeError, TypeError):
                    continue
    return list(found.values())


def _collection_of(block):
    for name in ('objects', 'armatures', 'meshes', 'shape_keys'):
        if getattr(bpy.data, name).get(block.name) == block:
            return name
    return None
