"""What is drawn on one side of a character on its other side, and the pose flipped. The sides are those of the mesh's own X."""
import bpy
from mathutils import Quaternion

from . import bones, curves, drawing, keys
from .controls import Refused
from .curve_list import WithCurves
from .library import Error
from .pen import mesh_of, redraw, tell_moved


def other_side(name):
    """A name with left for right; the same where it has no side."""
    return bpy.utils.flip_name(name)


def flip_pose(rig):
    """Gives each control what its partner on the other side has. The controls that moved."""
    kept = rig.kept()
    single = {c.name: getattr(c, 'control', c) for c, _, free in rig.parts if free and not _is_of_bone(c)}
    now = {name: control.get() for name, control in single.items()}
    turned = {}
    for armature in {id(b.id_data): b.id_data for b in _bones_of(rig)}.values():
        for bone in armature.pose.bones:
            turned[armature.name_full, bone.name] = bones.turn_of(bone), bone.location.copy(), bone.scale.copy()
    for name, control in single.items():
        if other_side(name) in now:
            control.set(now[other_side(name)])
    for bone, paths in _paths_of(rig).values():
        found = turned.get((bone.id_data.name_full, other_side(bone.name))) or turned[bone.id_data.name_full, bone.name]
        turn, place, size = found
        if any(path.startswith('rotation') for path in paths):
            bones.set_turn(bone, Quaternion((turn.w, turn.x, -turn.y, -turn.z)))
        if 'location' in paths:
            flipped = -place.x, place.y, place.z
            bone.location = [old if held else new for old, new, held in zip(bone.location, flipped, bone.lock_location)]
        if 'scale' in paths:
            bone.scale = [old if held else new for old, new, held in zip(bone.scale, size, bone.lock_scale)]
    return rig.changed_from(kept)


def _is_of_bone(control):
    block, path, *_ = control.channels()[0]
    return isinstance(block, bpy.types.PoseBone) and not path.startswith('[')


def _paths_of(rig):
    """{bone: (bone, the channels of it that may move)}."""
    out = {}
    for control, _, free in rig.parts:
        for block, path, *_ in control.channels() if free else ():
            if isinstance(block, bpy.types.PoseBone) and not path.startswith('['):
                out.setdefault(block.as_pointer(), (block, set()))[1].add(path)
    return out


def _bones_of(rig):
    return [bone for bone, _ in _paths_of(rig).values()]


class _Across(WithCurves):
    bl_options = {'REGISTER', 'UNDO'}

    def execute(self, context):
        obj = mesh_of(context)
        try:
            moved = self.across(obj)
        except (Refused, Error) as problem:
            self.report({'ERROR'}, str(problem))
            return {'CANCELLED'}
        redraw()
        tell_moved(self, obj, moved)
        return {'FINISHED'}


class PENPOSE_OT_mirror(_Across, bpy.types.Operator):
    """Draw the curves and targets on the other side, too"""
    bl_idname = 'penpose.mirror'
    bl_label = 'Mirror'

    curve: bpy.props.IntProperty(name='Curve', description='Its number; 0: all of them', default=0, min=0)

    def across(self, obj):
        """Mirrors the curve, or all; the controls that moved."""
        moved = []
        for curve in [c['id'] for c in curves.curves(obj)]:
            if self.curve in (0, curve):
                moved += [c for c in drawing.mirrored(obj, curve) if c not in moved]
        return moved


class PENPOSE_OT_flip(_Across, bpy.types.Operator):
    """Turn the pose and all that is drawn to the other side"""
    bl_idname = 'penpose.flip'
    bl_label = 'Flip'

    @classmethod
    def poll(cls, context):
        return mesh_of(context) is not None

    def across(self, obj):
        """Flips the pose and the curves; the controls that moved."""
        one = drawing.known(obj)
        one.rig.take_pose()
        moved = flip_pose(one.rig)
        for curve in [c['id'] for c in curves.curves(obj)]:
            moved += [c for c in drawing.mirrored(obj, curve, replace=True) if c not in moved]
        keys.key(moved, said=one.said)
        return moved


CLASSES = (PENPOSE_OT_mirror, PENPOSE_OT_flip)
