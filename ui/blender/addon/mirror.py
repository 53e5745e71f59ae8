"""What is drawn on one side of a character on its other side, and the pose flipped. The sides are those of the mesh's own X."""
import bpy
from mathutils import Quaternion

from . import across, bones, curves, drawing, keys
from .bones import Channel
from .controls import KeyControl, Property, Refused
from .curve_list import WithCurves
from .library import Error
from .pen import mesh_of, redraw, tell_moved


def other_side(name):
    """A name with left for right; the same where it has no side."""
    return bpy.utils.flip_name(name)


def _controls(rig):
    """All controls of a rig that a person may touch, wherever curves lie."""
    if rig.measured:
        return [one.control for one in rig.candidates]
    return [control for control, _, free in rig.parts if free]


def flip_pose(rig):
    """Gives each control what its partner on the other side has. The controls that moved."""
    controls = _controls(rig)
    before = [(control, None, control.get()) for control in controls]
    single = {_address(control): control for control in controls if not _is_of_bone(control)}
    now = {address: control.get() for address, control in single.items()}
    turned = {}
    for armature in {id(b.id_data): b.id_data for b, _ in _paths_of(controls).values()}.values():
        for bone in armature.pose.bones:
            turned[armature.name_full, bone.name] = bones.turn_of(bone), bone.location.copy(), bone.scale.copy()
    for address, control in single.items():
        value = now.get(_across(address))
        if value is not None:
            control.set(-value if _is_turned_about(control) else value)
    for bone, paths in _paths_of(controls).values():
        found = turned.get((bone.id_data.name_full, other_side(bone.name))) or turned[bone.id_data.name_full, bone.name]
        turn, place, size = found
        if any(path.startswith('rotation') for path in paths):
            bones.set_turn(bone, Quaternion((turn.w, turn.x, -turn.y, -turn.z)))
        if 'location' in paths:
            flipped = -place.x, place.y, place.z
            bone.location = [old if held else new for old, new, held in zip(bone.location, flipped, bone.lock_location)]
        if 'scale' in paths:
            bone.scale = [old if held else new for old, new, held in zip(bone.scale, size, bone.lock_scale)]
    return rig.changed_from(before)


def _address(control):
    """What tells a key, a property or a channel of an object from all others: names, each of which may have a side."""
    if isinstance(control, KeyControl):
        return 'key', control.name
    if isinstance(control, Property):
        return 'property', control.held.name, control.bone.name if control.bone else control.owner_path, control.prop
    return 'channel', control.held.name, control.path, 'xyz'[control.axis]


def _across(address):
    """The address on the other side. A block that has no partner, as an armature, keeps its name."""
    kind, *names = address
    if kind == 'property' and not bpy.data.objects.get(other_side(names[0])):
        return (kind, names[0], *map(other_side, names[1:]))
    return (kind, *map(other_side, names))


def _is_turned_about(control):
    """Whether a channel of an object has the other sign on the other side: the way to the side, and turns about the other two."""
    return isinstance(control, Channel) and (control.path, control.axis) in {('location', 0), ('rotation_euler', 1), ('rotation_euler', 2)}


def _is_of_bone(control):
    block, path, *_ = control.channels()[0]
    return isinstance(block, bpy.types.PoseBone) and not path.startswith('[')


def _paths_of(controls):
    """{bone: (bone, the channels of it that may move)}."""
    out = {}
    for control in controls:
        for block, path, *_ in control.channels():
            if isinstance(block, bpy.types.PoseBone) and not path.startswith('['):
                out.setdefault(block.as_pointer(), (block, set()))[1].add(path)
    return out


def flip_curves(obj, surface):
    """Takes all curves and their targets to the other side; each stays the same curve. Raises Refused, with nothing changed."""
    flipped = [(curve, *across.flipped(surface, curve)) for curve in curves.curves(obj)]
    for curve, points, made in flipped:
        drawing.delete(obj, curve['id'])
        if curve.get('off'):
            made['off'] = True
        number = curves.add(obj, surface, points, made)
        drawing.change(obj, number, lambda kept, own=curve['id']: kept.update(id=own) or kept)


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
        self.tell(obj, moved)
        return {'FINISHED'}

    def tell(self, obj, moved):
        """Says what moved."""
        tell_moved(self, obj, moved)


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
        one = drawing.known(obj, measured=False)
        flip_curves(obj, one.rig.surface)
        moved = flip_pose(one.rig)
        keys.key(moved, said=one.said)
        return moved

    def tell(self, obj, moved):
        if moved:
            tell_moved(self, obj, moved)
        else:
            self.report({'INFO'}, 'Flipped: the pose is the same on both sides')


CLASSES = (PENPOSE_OT_mirror, PENPOSE_OT_flip)
