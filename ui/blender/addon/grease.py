"""Strokes of Grease Pencil as curves: the last two of the active layer are a reference and its target, or layers are named so."""
import bpy
from mathutils import Vector

from . import drawing, versions
from .controls import Refused
from .library import Error
from .pen import mesh_of, seen_in, tell_moved


def pencil_of(context):
    """The Grease Pencil object that is meant: the active or a selected one, else the first that is seen."""
    found = [o for o in [context.active_object, *context.selected_objects, *context.view_layer.objects]
             if versions.is_grease_pencil(o) and o.visible_get()]
    return found[0] if found else None


def target_mesh(context):
    """The mesh that they are for: the active one, or the one that is selected beside the Grease Pencil."""
    obj = mesh_of(context)
    if obj is not None and obj.type == 'MESH':
        return obj
    meshes = [o for o in context.selected_objects if o.type == 'MESH']
    return meshes[0] if meshes else None


NAMED = ('reference', 'target', 'constraint')  # a layer with one of these in its name holds those
AT_REST = ('neutral', 'rest')  # and with one of these the same hand's drawing of the face at rest


def _named(name, words):
    return next((word for word in words if word in name.lower()), None)


def shown_on(frames, frame):
    """What of a layer is seen on a frame: the drawing of that frame or of the last one before it."""
    return next((lines for number, lines in reversed(frames) if number <= frame), [])


def strokes_of(pencil, frame=None):
    """The pairs (kind, points in the world) that the active layer means. Raises Refused."""
    frame = bpy.context.scene.frame_current if frame is None else frame
    name, frames = next(((name, frames) for name, active, frames in versions.pencil_layers(pencil) if active), ('', []))
    strokes = [[Vector(p) for p in s] for s in shown_on(frames, frame) if len(s) > 1]
    if not strokes:
        raise Refused('the active layer of %s has no stroke on this frame; draw a reference and a target' % pencil.name)
    kind = _named(name, NAMED)
    if kind:
        return [(kind, s) for s in (strokes[-1:] if kind == 'target' else strokes)]
    if len(strokes) < 2:
        raise Refused('the active layer of %s has one stroke; draw two, a reference and its target, or name the layer after what it holds' %
                      pencil.name)
    return [('reference', strokes[-2]), ('target', strokes[-1])]


def drawings_of(pencil):
    """Each drawing of the face that a Grease Pencil has: {frame: (lines, lines of the face at rest)}, lines (n, 3) in the world. All that
    is seen on a frame is one drawing."""
    layers = [(name, frames) for name, _, frames in versions.pencil_layers(pencil) if not _named(name, NAMED)]
    moving = [frames for name, frames in layers if not _named(name, AT_REST)]
    out = {}
    for frame in sorted({number for frames in moving for number, _ in frames}):
        lines = [line for frames in moving for line in shown_on(frames, frame) if len(line) > 1]
        if lines:
            rest = [line for name, frames in layers if _named(name, AT_REST) for line in shown_on(frames, frame) if len(line) > 1]
            out[frame] = lines, rest
    return out


def shown_on_frame(pencil, frame):
    """The drawing that is seen on a frame and that of the face at rest. Raises Refused."""
    shown = [drawn for number, drawn in drawings_of(pencil).items() if number <= frame]
    if not shown:
        raise Refused('%s has no drawing on this frame; draw the face with Grease Pencil' % pencil.name)
    return shown[-1]


def draw_strokes(obj, strokes, seen, to_region):
    """Draws them on the object as the pen would. `to_region`: the px of the region of a point of the world, or None."""
    moved, kept = [], obj.get(drawing.store.PROPERTY)
    try:
        for kind, points in strokes:
            stroke = drawing.Stroke(obj, kind, seen)
            for point in points:
                place = to_region(point)
                if place is not None:
                    stroke.add(place)
            moved = stroke.end(obj)
    except (Refused, Error):
        drawing.store.put_back(obj, kept)
        raise
    return moved


class PENPOSE_OT_grease_pencil(bpy.types.Operator):
    """Take strokes of Grease Pencil as curves: the last two of its active layer are a reference and its target;
    or a layer is called reference, target or constraint"""
    bl_idname = 'penpose.grease_pencil'
    bl_label = 'From Grease Pencil'
    bl_options = {'REGISTER', 'UNDO'}

    @classmethod
    def poll(cls, context):
        return context.area is not None and context.area.type == 'VIEW_3D' and pencil_of(context) is not None and \
            target_mesh(context) is not None

    def execute(self, context):
        from bpy_extras.view3d_utils import location_3d_to_region_2d
        region = next(r for r in context.area.regions if r.type == 'WINDOW')
        rv3d = context.space_data.region_3d
        obj = target_mesh(context)
        try:
            seen = seen_in(region, rv3d, obj)
            moved = draw_strokes(obj, strokes_of(pencil_of(context)), seen, lambda p: location_3d_to_region_2d(region, rv3d, p))
        except (Refused, Error) as problem:
            self.report({'ERROR'}, str(problem))
            return {'CANCELLED'}
        tell_moved(self, obj, moved)
        return {'FINISHED'}


CLASSES = (PENPOSE_OT_grease_pencil,)
