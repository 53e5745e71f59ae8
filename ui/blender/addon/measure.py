"""What each control of a rig does, found by moving it a little and looking at the mesh that Blender evaluates.

Drivers and constraints make any rig possible; near the pose as it is, each of its controls moves the vertices along straight ways.
"""
import time

import bpy
import numpy as np

from .controls import TINY
from .library import Shape

STEP = 0.05  # of a control's range, and radians of a bone's angle
REACH = 0.6  # radians to either side that a bone may turn before it is measured again
MOST_BONES = 120


class BoneAngle:
    """One angle of a pose bone as a control of its own."""

    def __init__(self, turn, axis):
        self.turn, self.axis = turn, axis
        self.name = turn.names[axis]

    def get(self):
        return self.turn.get()[self.axis]

    def set(self, value):
        angles = self.turn.get()
        angles[self.axis] = value
        self.turn.set(angles)

    def range(self):
        now, (least, most) = self.get(), self.turn.range(self.axis)
        return min(0.0, max(least, now - REACH)), max(0.0, min(most, now + REACH))


def bones_to_measure(obj, armature):
    """Bones that a person sees and may turn: not hidden, not driven by constraints, not locked."""
    visible = [b for b in armature.pose.bones if not b.bone.hide and not all(b.lock_rotation) and
               not any(not c.mute and c.influence > 0 and c.type not in ('LIMIT_ROTATION', 'LIMIT_LOCATION', 'LIMIT_SCALE') for c in b.constraints)]
    return visible[:MOST_BONES]


def evaluated(obj, count):
    """Where Blender shows the vertices of an object, in its own space (n, 3); None where modifiers change their number."""
    depsgraph = bpy.context.evaluated_depsgraph_get()
    mesh = obj.evaluated_get(depsgraph).data
    if len(mesh.vertices) != count:
        return None
    out = np.empty(3 * count, dtype=np.float32)
    mesh.vertices.foreach_get('co', out)
    return out.reshape(-1, 3).astype(np.float64)


def measured(obj, space, controls):
    """The character's positions at value 0 of all controls, a shape for each, and how long it took, s."""
    begin = time.perf_counter()
    count = len(obj.data.vertices)
    suspended = [m for m in obj.modifiers if m.show_viewport and m.type not in ('ARMATURE', 'LATTICE', 'SURFACE_DEFORM', 'MESH_DEFORM',
                                                                              'CORRECTIVE_SMOOTH', 'SMOOTH', 'SHRINKWRAP', 'CAST', 'HOOK', 'WARP')]
    for modifier in suspended:
        modifier.show_viewport = False
    try:
        now = _look(obj, count)
        base, shapes = now.copy(), []
        for control in controls:
            value = control.get()
            least, most = control.range()
            step = STEP if isinstance(control, BoneAngle) else STEP * (most - least)
            if value + step > most:
                step = -step
            control.set(value + step)
            ways = (_look(obj, count) - now) / step
            control.set(value)
            base -= value * ways
            shapes.append((control, ways, min(least, value), max(most, value)))
        _look(obj, count)
    finally:
        for modifier in suspended:
            modifier.show_viewport = True
    used, out = set(), []
    for control, ways, least, most in shapes:
        name = control.name
        while name in used:
            name += ' '
        used.add(name)
        ways = space.of_object(ways)
        ways[np.abs(ways).max(axis=1) < TINY * max(1e-9, np.abs(base).max())] = 0
        out.append(Shape(name, ways.astype(np.float32), None, least, most))
    return space.of_object(base), out, time.perf_counter() - begin


def _look(obj, count):
    bpy.context.view_layer.update()
    return evaluated(obj, count)
