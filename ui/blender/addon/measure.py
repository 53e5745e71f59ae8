"""What each control of a rig does, found by moving it a little and looking at the mesh that Blender evaluates.

Drivers and constraints make any rig possible; near the pose as it is, each of its controls moves the vertices along straight ways.
"""
import time

import bpy
import numpy as np

from .bones import BoneAngle, BonePlace, BoneTurn, may_turn, order_of_locks
from .controls import TINY, KeyControl, Refused, curves_that_act, drivers_of, properties_that_drive
from .library import Shape

STEP = 0.05  # of a control's range
MOST_BONES = 120
NEAR = 1e-6  # of the size: what Blender shows is what was computed
# Modifiers that leave the vertices what they are; others are put aside while controls are measured.
DEFORMING = ('ARMATURE', 'CAST', 'CORRECTIVE_SMOOTH', 'CURVE', 'DISPLACE', 'HOOK', 'LAPLACIANDEFORM', 'LATTICE', 'MESH_DEFORM',
             'SHRINKWRAP', 'SIMPLE_DEFORM', 'SMOOTH', 'LAPLACIANSMOOTH', 'SURFACE_DEFORM', 'WARP', 'WAVE')
LIMITS = ('LIMIT_ROTATION', 'LIMIT_LOCATION', 'LIMIT_SCALE')


def _followed(armature):
    """Names of the bones that constraints of others follow."""
    return {c.subtarget for b in armature.pose.bones for c in b.constraints
            if not c.mute and c.influence > 0 and getattr(c, 'target', None) == armature and getattr(c, 'subtarget', '')}


def _bone_controls(armature):
    """What a person sees and may move: not hidden, not moved by constraints or drivers, not locked."""
    out, driven, followed = [], [d.data_path for d in drivers_of(armature)], _followed(armature)
    corners = [armature.data.bones[b.name].head_local for b in armature.pose.bones]
    reach = 0.5 * max([(a - corners[0]).length for a in corners] + [b.length for b in armature.data.bones])
    bones = [b for b in armature.pose.bones if not b.bone.hide and
             not any(not c.mute and c.influence > 0 and c.type not in LIMITS for c in b.constraints)]
    for bone in bones[:MOST_BONES]:
        head = 'pose.bones["%s"].' % bpy.utils.escape_identifier(bone.name)
        if may_turn(bone) and not any(p.startswith(head + 'rotation') for p in driven):
            turn = BoneTurn(armature, bone, order_of_locks(bone))
            out += [BoneAngle(turn, axis) for axis in range(3) if not bone.lock_rotation[axis]]
        if bone.name in followed and not bone.bone.use_connect and head + 'location' not in driven:
            out += [BonePlace(armature, bone, axis, reach) for axis in range(3) if not bone.lock_location[axis]]
    return out


def controls_of(obj, armature, keys):
    """All controls that are measured; `keys`: the shape keys that are free."""
    controls = [KeyControl(obj, k) for k in keys]
    controls += properties_that_drive(curves_that_act(obj, armature))
    return controls + (_bone_controls(armature) if armature is not None else [])


def evaluated(obj, count):
    """Where Blender shows the vertices of an object, in its own space (n, 3); None where modifiers change their number."""
    depsgraph = bpy.context.evaluated_depsgraph_get()
    mesh = obj.evaluated_get(depsgraph).data
    if len(mesh.vertices) != count:
        return None
    out = np.empty(3 * count, dtype=np.float32)
    mesh.vertices.foreach_get('co', out)
    return out.reshape(-1, 3).astype(np.float64)


def shows(obj, rig):
    """Whether Blender shows the vertices where the character has them at its pose: what was measured then holds there, too."""
    bpy.context.view_layer.update()
    wanted = rig.character.evaluate()
    shown = evaluated(obj, len(wanted))
    if shown is None:
        return False
    size = np.linalg.norm(wanted.max(axis=0) - wanted.min(axis=0))
    return bool(np.abs(rig.mesh.space.of_object(shown) - wanted).max() <= NEAR * size)


def measured(obj, space, controls):
    """The character's positions where all controls have what is their rest, a shape for each, and how long it took, s."""
    begin = time.perf_counter()
    count = len(obj.data.vertices)
    suspended = [m for m in obj.modifiers if m.show_viewport and m.type not in DEFORMING]
    for modifier in suspended:
        modifier.show_viewport = False
    try:
        now = _look(obj, count)
        base, found = now.copy(), []
        for control in controls:
            way = _way(obj, control, now)
            base -= (control.get() - control.rest()) * way
            found.append((control, way))
        _look(obj, count)
    finally:
        for modifier in suspended:
            modifier.show_viewport = True
    out, used = [], set()
    for control, way in found:
        name = control.name
        while name in used:
            name += ' '
        used.add(name)
        way = space.of_object(way)
        way[np.abs(way).max(axis=1) < TINY * max(1e-9, np.abs(base).max())] = 0
        least, most = (end - control.rest() for end in control.range())
        out.append(Shape(name, way.astype(np.float32), None, min(0.0, least), max(0.0, most)))
    return space.of_object(base), out, time.perf_counter() - begin


def _way(obj, control, now):
    """Where a unit of a control moves the vertices, from a small step of it; the control has then what it had, to the bit."""
    kept, value = control.kept(), control.get()
    least, most = control.range()
    step = getattr(control, 'STEP', STEP * (most - least))
    if getattr(control, 'whole', False):
        step = max(1.0, round(step))
    if value + step > most:
        step = -step
    try:
        control.set(value + step)
        moved = control.get() - value
        return (_look(obj, len(now)) - now) / moved if abs(moved) > TINY else np.zeros_like(now)
    finally:
        control.give_back(kept)


def _look(obj, count):
    bpy.context.view_layer.update()
    seen = evaluated(obj, count)
    if seen is None:
        raise Refused('a modifier changes the number of vertices of %s; turn it off in the viewport while you draw' % obj.name)
    if not np.isfinite(seen).all():
        raise Refused('%s shows a vertex that is not finite (NaN); mend its keys, bones or drivers' % obj.name)
    return seen
