"""What is drawn on one side of a character on its other side, and the pose flipped. The sides are those of the mesh's own X."""
import bpy
import numpy as np
from mathutils import Quaternion

from . import across, bones, curves, drawing, keys, limits
from .bones import Channel
from .controls import TINY, KeyControl, Property, Refused
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


def flip_pose(rig, only=None):
    """Gives each control what its partner on the other side has. `only`: to these alone. The controls that moved."""
    controls = _controls(rig)
    before = [(control, None, control.get()) for control in controls]
    single = {_address(control): control for control in controls if not _is_of_bone(control)}
    now = {address: control.get() for address, control in single.items()}
    turned = {}
    for armature in {id(b.id_data): b.id_data for b, _ in _paths_of(controls).values()}.values():
        for bone in armature.pose.bones:
            turned[armature.name_full, bone.name] = bones.turn_of(bone), bone.location.copy(), bone.scale.copy()
    if only is not None:
        controls = only
    for address, control in single.items():
        if not any(control is one for one in controls):
            continue
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


def _way(control):
    """The address of a control; of bones, of the place, the turn or the scale."""
    if not _is_of_bone(control):
        return _address(control)
    block, path, *_ = control.channels()[0]
    return 'bone', block.id_data.name_full, block.name, path.split('_')[0]


def _partner_of(way):
    """That of the control on the other side."""
    return (*way[:2], other_side(way[2]), way[3]) if way[0] == 'bone' else _across(way)


def _is_off(control):
    """Whether a control is not at rest."""
    value = control.get()
    rest = 1.0 if getattr(control, 'path', '') == 'scale' else 0.0
    return any(abs(one - rest) > TINY for one in (value if isinstance(value, list) else [value]))


def _sides(one, drawn, other):
    """The controls that move the curve `drawn` more than `other`, and those that gain this one more than they cost that."""
    trial, pose, here, there = one.rig.character.copy(), one.rig.character.pose, [], []
    places = [trial.positions(one.numbers[number]) for number in (drawn, other)]
    for control, numbers, free in one.rig.parts:
        moved = np.zeros(2)
        for n in numbers if free else ():
            nudged = pose.copy()
            far = one.rig.most[n] if one.rig.most[n] - pose[n] > pose[n] - one.rig.least[n] else one.rig.least[n]
            nudged[n] = far
            trial.pose = nudged
            moved = np.maximum(moved, [np.abs(trial.positions(one.numbers[number]) - place).max() for number, place in zip((drawn, other), places)])
        if moved[0] > moved[1]:
            here.append(getattr(control, 'control', control))
        elif moved[1] - moved[0] > moved[0]:
            there.append(getattr(control, 'control', control))
    return here, there


def mirror_curve(obj, number):
    """Draws a curve and its target on the other side, too, and moves that side alone: what moved the drawn curve has partners by its
    name, which take its values; else it is solved. The controls that moved. Raises Refused."""
    one = drawing.known(obj, measured=False)
    curve = next((c for c in curves.curves(obj) if c['id'] == number), None)
    if curve is None:
        raise Refused('%s has no curve %s' % (obj.name, number))
    points, made = across.flipped(one.rig.surface, curve)
    added = curves.add(obj, one.rig.surface, points, made)
    if 'target' not in made:
        return []
    one = drawing.known(obj)
    one.rig.take_pose()
    if not {number, added} <= set(one.numbers):
        raise Refused('curve %d of %s cannot be brought onto the mesh; delete it and draw it again' % (number, obj.name))
    here, there = _sides(one, number, added)
    wanted = {_partner_of(_way(control)) for control in here if _is_off(control)} - {_way(control) for control in here}
    partners = [control for control in _controls(one.rig) if _way(control) in wanted]
    if partners:
        moved = flip_pose(one.rig, partners)
        keys.key(moved, said=one.said)
        return moved
    if not there:
        return []
    with limits.among(there):
        return drawing.solve_again(obj)


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
                moved += [c for c in mirror_curve(obj, curve) if c not in moved]
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
