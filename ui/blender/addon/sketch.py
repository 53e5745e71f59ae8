"""The rig tool: four strokes make a new shape key, as penpose's Articulate does: around all that may move, around what moves as a
whole, where the feature is, and where it is at value 1."""
import bpy
import numpy as np
from bpy.props import EnumProperty, StringProperty

from . import drawing, overlay, versions
from .controls import Refused
from .library import Character, Error
from .pen import begin, ended, mesh_of, redraw, region_below, running, why_not
from .rig import Mesh, check
from .space import Space, seen_by

STEPS = ('general', 'specific', 'reference', 'target')
SAID = {'general': 'Draw around all that may move', 'specific': 'Draw around what moves as a whole',
        'reference': 'Draw along the feature', 'target': 'Draw where the feature is at value 1'}
MODES = [('AUTO', 'Auto', 'Slides or turns: what distorts the surface less'), ('TRANSLATE', 'Slide', 'Moves along'),
         ('ROTATE', 'Turn', 'Turns')]
AT_REST = 1e-5  # of the mesh's size


class Line:
    """A stroke of the sketch as the overlay shows it."""

    def __init__(self, seen, kind):
        self.seen, self.kind, self.px = seen, kind, []

    def add(self, place):
        self.px.append(self.seen.px([place])[0])

    def places(self):
        return self.seen.places(self.px)


def seen_of(region, rv3d, obj):
    """How a region shows an object that need not be a rig yet."""
    around = obj.matrix_world @ (sum((drawing.corner(c) for c in obj.bound_box), drawing.corner((0, 0, 0))) / 8)
    return seen_by(rv3d.view_matrix, rv3d.window_matrix, region.width, region.height, Space(obj.matrix_world), around)


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
        versions.new_key(obj, 'Basis')
    key = versions.new_key(obj, name)
    out = np.empty(3 * len(mesh.rest), dtype=np.float32)
    obj.data.shape_keys.reference_key.data.foreach_get('co', out)
    key.data.foreach_set('co', (out.reshape(-1, 3) + moved).astype(np.float32).ravel())
    key.slider_min, key.slider_max = 0, 1
    obj.active_shape_key_index = len(obj.data.shape_keys.key_blocks) - 1
    obj.data.update()
    drawing.forget(obj.name)
    return key


class PENPOSE_OT_rig(bpy.types.Operator):
    """Make a new shape key in four strokes, on the mesh at rest. The view may be turned before the last"""
    bl_idname = 'penpose.rig'
    bl_label = 'New Key by Drawing'
    bl_options = {'REGISTER', 'UNDO'}

    name: StringProperty(name='Name', description='Of the new shape key; empty: the next free one')
    mode: EnumProperty(name='Motion', items=MODES, default='AUTO')

    @classmethod
    def poll(cls, context):
        problem = why_not(context) if context.area is not None and context.area.type == 'VIEW_3D' else 'Keys are drawn in a 3D Viewport'
        if problem:
            cls.poll_message_set(problem)
        return not problem

    def invoke(self, context, event):
        obj = mesh_of(context)
        try:
            check(obj)
            if not shown_at_rest(obj):
                raise Refused('%s is posed, and a new key is drawn on the mesh at rest: clear its keys (Object Data, Clear Shape Keys) '
                              'and set its armature to Rest Position' % obj.name)
        except Refused as problem:
            self.report({'ERROR'}, str(problem))
            return {'CANCELLED'}
        self.object, self.lines, self.line, self.region = obj.name, {}, None, None
        begin(self)
        context.window_manager.modal_handler_add(self)
        self._say(context)
        return {'RUNNING_MODAL'}

    def _step(self):
        return STEPS[len(self.lines)]

    def _say(self, context):
        again = '; Backspace: the last stroke again'
        more = {'general': '', 'reference': '; Return: let it be found' + again}.get(self._step(), again)
        context.workspace.status_text_set('%d of 4: %s. Esc: give up%s' % (len(self.lines) + 1, SAID[self._step()], more))

    def _show(self):
        """The stroke that is being drawn and those before it, as far as they were drawn in this view."""
        view = seen_of(self.region, self.region.data, bpy.data.objects[self.object]).view
        overlay.show_stroke(self.line, self.region, [line for line in self.lines.values() if line is not None and line.seen.view == view])
        redraw()

    def modal(self, context, event):
        if not running(self):
            return {'CANCELLED'}
        obj = bpy.data.objects.get(self.object)
        try:
            if obj is None or context.area is None or mesh_of(context) != obj or obj.mode not in ('OBJECT', 'POSE'):
                self.report({'WARNING'}, 'the object or its mode changed; the new key is given up')
            elif event.type != 'ESC' or event.value != 'PRESS':
                return self._between(context, event, obj) if self.line is None else self._drawing(context, event, obj)
        except (ReferenceError, KeyError, AttributeError):
            self.report({'WARNING'}, 'what was drawn on is gone; the new key is given up')
        self.leave()
        return {'CANCELLED'}

    def _drawing(self, context, event, obj):
        if event.type in {'MOUSEMOVE', 'INBETWEEN_MOUSEMOVE'}:
            self.line.add((event.mouse_x - self.corner[0], event.mouse_y - self.corner[1]))
            redraw()
        elif event.type == 'LEFTMOUSE' and event.value == 'RELEASE':
            line, self.line = self.line, None
            first = self.lines.get('general')
            if line.kind in ('specific', 'reference') and line.seen.view != first.seen.view:
                self.report({'WARNING'}, 'the view was turned: the first three strokes are of one view (Backspace: the last again)')
                self._show()
            elif len(line.px) > 2:
                self.lines[line.kind] = line
                return self._next(context, obj)
        return {'RUNNING_MODAL'}

    def _between(self, context, event, obj):
        region = region_below(context, event)
        if region is None:
            return {'PASS_THROUGH'}
        if event.type == 'LEFTMOUSE' and event.value == 'PRESS' and not event.alt:
            self.region, self.corner = region, (region.x, region.y)
            self.line = Line(seen_of(region, region.data, obj), self._step())
            self.line.add((event.mouse_x - region.x, event.mouse_y - region.y))
            self._show()
            return {'RUNNING_MODAL'}
        if event.type in {'RET', 'NUMPAD_ENTER'} and event.value == 'PRESS' and self._step() == 'reference':
            self.lines['reference'] = None
            return self._next(context, obj)
        if event.type == 'BACK_SPACE' and event.value == 'PRESS' and self.lines:
            self.lines.popitem()
            return self._next(context, obj)
        return {'PASS_THROUGH'}

    def _next(self, context, obj):
        if len(self.lines) < len(STEPS):
            self._say(context)
            self._show()
            return {'RUNNING_MODAL'}
        drawn = {step: line for step, line in self.lines.items() if line is not None}
        lines = {step: np.array(line.px) for step, line in drawn.items()}
        views = {step: drawn[step].seen.view if step in drawn else None for step in STEPS}
        self.leave()
        try:
            key = make_key(obj, lines, views, self.name, self.mode)
        except (Refused, Error) as problem:
            self.report({'ERROR'}, str(problem))
            return {'CANCELLED'}
        key.value = 1
        self.report({'INFO'}, 'the new shape key is %s; it is shown at 1' % key.name)
        return {'FINISHED'}

    def cancel(self, context):
        self.leave()

    def leave(self):
        """Gives up what was drawn."""
        self.line, self.lines = None, {}
        ended(self)


CLASSES = (PENPOSE_OT_rig,)
