"""The rig tool: four strokes make a new shape key, as penpose's Articulate does: around all that may move, around what moves as a
whole, where the feature is, and where it is at value 1."""
import bpy
import numpy as np
from bpy.props import EnumProperty, StringProperty

from . import drawing, overlay
from .controls import Refused
from .library import Character, Error
from .pen import mesh_of
from .rig import Mesh, check
from .space import seen_by

STEPS = ('general', 'specific', 'reference', 'target')
SAID = {'general': 'Draw around all that may move', 'specific': 'Draw around what moves as a whole',
        'reference': 'Draw along the feature', 'target': 'Draw where the feature is at value 1'}
MODES = [('AUTO', 'Auto', 'Slides or turns: what distorts the surface less'), ('TRANSLATE', 'Slide', 'Moves along'), ('ROTATE', 'Turn', 'Turns')]
AT_REST = 1e-5  # of the mesh's size


class Line:
    """A stroke of the sketch as the overlay shows it."""
    kind = 'reference'

    def __init__(self, seen):
        self.seen, self.px = seen, []

    def add(self, place):
        self.px.append(self.seen.px([place])[0])

    def places(self):
        return self.seen.places(self.px)


def shown_at_rest(obj):
    """Whether Blender shows the mesh as it is at rest: a sketch is drawn on that."""
    mesh = Mesh(obj)
    positions = drawing.shown_positions(obj, bpy.context.evaluated_depsgraph_get())
    size = float(np.linalg.norm(mesh.rest.max(axis=0) - mesh.rest.min(axis=0)))
    return positions is None or float(np.abs(mesh.space.of_object(positions[:len(mesh.rest)]) - mesh.rest).max()) <= AT_REST * size


def make_key(obj, lines, views, name='', mode='AUTO'):
    """Makes the shape key. `lines`: px of the four strokes by step; `views`: View of each. The new key.

    Raises Refused or library.Error, with nothing changed."""
    check(obj)
    mesh = Mesh(obj)
    character = Character.from_arrays(mesh.rest, mesh.triangles)
    base = obj.data.shape_keys.key_blocks if obj.data.shape_keys else ()
    name = name or next('Drawn %d' % n for n in range(1, 10000) if 'Drawn %d' % n not in base)
    if any(views[step] is not None and views[step] != views['general'] for step in ('specific', 'reference')):
        raise Refused('the view changed between the first three strokes; draw them in one view, and turn it before the last alone')
    character.sketch(views['general'], lines['general'], lines['specific'], lines['target'], reference=lines.get('reference'), name=name,
                     target_view=views['target'], mode=mode.lower())
    moved = mesh.space.to_object(character.evaluate([1]) - mesh.rest)
    if obj.data.shape_keys is None:
        obj.shape_key_add(name='Basis', from_mix=False)
    key = obj.shape_key_add(name=name, from_mix=False)
    out = np.empty(3 * len(mesh.rest), dtype=np.float32)
    obj.data.shape_keys.reference_key.data.foreach_get('co', out)
    key.data.foreach_set('co', (out.reshape(-1, 3) + moved).astype(np.float32).ravel())
    key.slider_min, key.slider_max = 0, 1
    obj.data.update()
    drawing.forget(obj.name)
    return key


class PENPOSE_OT_rig(bpy.types.Operator):
    """Make a new shape key in four strokes. Views may be turned between them"""
    bl_idname = 'penpose.rig'
    bl_label = 'New Key by Drawing'
    bl_options = {'REGISTER', 'UNDO'}

    name: StringProperty(name='Name', description='Of the new shape key; empty: the next free one')
    mode: EnumProperty(name='Motion', items=MODES, default='AUTO')

    @classmethod
    def poll(cls, context):
        return context.area is not None and context.area.type == 'VIEW_3D' and mesh_of(context) is not None

    def invoke(self, context, event):
        obj = mesh_of(context)
        try:
            check(obj)
            if not shown_at_rest(obj):
                raise Refused('%s is posed; a new key is drawn on the mesh at rest: set its keys and bones to rest' % obj.name)
        except Refused as problem:
            self.report({'ERROR'}, str(problem))
            return {'CANCELLED'}
        self.object, self.lines, self.views, self.line = obj.name, {}, {}, None
        context.window_manager.modal_handler_add(self)
        self._say(context)
        return {'RUNNING_MODAL'}

    def _step(self):
        return STEPS[len(self.lines)]

    def _say(self, context):
        context.workspace.status_text_set('%d of 4: %s. Esc: give up%s' % (
            len(self.lines) + 1, SAID[self._step()], '; Return: let it be found' if self._step() == 'reference' else ''))

    def modal(self, context, event):
        obj = bpy.data.objects.get(self.object)
        if obj is None or mesh_of(context) != obj or context.area is None:
            return self._leave(context, {'CANCELLED'})
        if event.type == 'ESC' and event.value == 'PRESS':
            return self._leave(context, {'CANCELLED'})
        if self.line is None:
            return self._between(context, event, obj)
        if event.type in {'MOUSEMOVE', 'INBETWEEN_MOUSEMOVE'}:
            self.line.add((event.mouse_x - self.region.x, event.mouse_y - self.region.y))
            context.area.tag_redraw()
        elif event.type == 'LEFTMOUSE' and event.value == 'RELEASE':
            if len(self.line.px) > 2:
                self.lines[self._step()], self.views[self._step()] = np.array(self.line.px), self.line.seen.view
            self.line = None
            overlay.show_stroke(None)
            return self._next(context, obj)
        return {'RUNNING_MODAL'}

    def _between(self, context, event, obj):
        if event.type == 'LEFTMOUSE' and event.value == 'PRESS' and not event.alt:
            region = next((r for r in context.area.regions if r.type == 'WINDOW'
                           and 0 <= event.mouse_x - r.x < r.width and 0 <= event.mouse_y - r.y < r.height), None)
            if region is None:
                return {'PASS_THROUGH'}
            self.region = region
            rv3d = context.space_data.region_3d
            around = obj.matrix_world @ (sum((drawing.corner(c) for c in obj.bound_box), drawing.corner((0, 0, 0))) / 8)
            self.line = Line(seen_by(rv3d.view_matrix, rv3d.window_matrix, region.width, region.height, Mesh(obj).space, around))
            self.line.add((event.mouse_x - region.x, event.mouse_y - region.y))
            overlay.show_stroke(self.line)
            return {'RUNNING_MODAL'}
        if event.type in {'RET', 'NUMPAD_ENTER'} and event.value == 'PRESS' and self._step() == 'reference':
            self.lines['reference'], self.views['reference'] = None, None
            return self._next(context, obj)
        return {'PASS_THROUGH'}

    def _next(self, context, obj):
        context.area.tag_redraw()
        if len(self.lines) < len(STEPS):
            self._say(context)
            return {'RUNNING_MODAL'}
        try:
            key = make_key(obj, self.lines, self.views, self.name, self.mode)
        except (Refused, Error) as problem:
            self.report({'ERROR'}, str(problem))
            return self._leave(context, {'CANCELLED'})
        self.report({'INFO'}, 'the new shape key is %s' % key.name)
        return self._leave(context, {'FINISHED'})

    def cancel(self, context):
        self._leave(context, None)

    def _leave(self, context, result):
        overlay.show_stroke(None)
        context.workspace.status_text_set(None)
        return result


CLASSES = (PENPOSE_OT_rig,)
