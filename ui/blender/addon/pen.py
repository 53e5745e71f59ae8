"""The pen in the viewport: one stroke is one operator and one step of undo."""
from types import SimpleNamespace

import bpy
from bpy.props import BoolProperty, EnumProperty, IntProperty, PointerProperty

from . import arcs, curves, drawing, overlay, preferences, pull, recording
from .controls import Refused
from .held import Held
from .library import Error
from .lines import redraw
from .moment_stroke import stroke_at
from .rig import check
from .space import seen_by
from .tools import in_hand

KINDS = [('AUTO', 'Draw', 'A reference where the feature is, then its target where it should be, in turn', 'GREASEPENCIL', 0),
         ('reference', 'Reference', 'Where the feature is, on the mesh', 'CURVE_DATA', 1),
         ('target', 'Target', 'Where the reference should be: the face follows', 'FORWARD', 2),
         ('constraint', 'Constraint', 'What stays where it is', 'PINNED', 3)]

_running = []  # operators that wait for a stroke or draw one
_touches = []  # the press that a stroke begins with, where another operator saw it


def running(operator):
    """Whether an operator still does; stop() ends it from outside."""
    return operator in _running


def begin(operator):
    """An operator waits for strokes from now on."""
    _running.append(operator)


def ended(operator):
    """It waits no more: what it shows goes."""
    if operator in _running:
        _running.remove(operator)
    overlay.show_stroke(None)
    if bpy.context.workspace is not None:
        bpy.context.workspace.status_text_set(None)
    redraw()


def stop():
    """Ends the strokes that are being drawn, without a trace: the add-on goes, a file is loaded, or an undo comes."""
    for operator in list(_running):
        operator.leave()


def begin_stroke(context, region, event, kind):
    """Begins a stroke from within another operator, at the press that this one saw: Blender would hand on whatever came last. Why it does
    not begin, or an empty text."""
    _touches[:] = [SimpleNamespace(type=event.type, value=event.value, mouse_x=event.mouse_x, mouse_y=event.mouse_y,
                                   is_tablet=getattr(event, 'is_tablet', False), pressure=getattr(event, 'pressure', 1.0))]
    try:
        with bpy.context.temp_override(area=context.area, region=region):
            bpy.ops.penpose.draw('INVOKE_DEFAULT', True, kind=kind)
    except RuntimeError as problem:
        return str(problem).strip().splitlines()[0].replace('Error: ', '', 1)
    finally:
        _touches.clear()
    return ''


def mesh_of(context):
    """The mesh that is drawn on: the active object, or the largest of the character that the active one is part of."""
    return drawing.character_of(context)


def why_not(context):
    """Why nothing can be drawn on now, in a line with the remedy; empty: it can."""
    obj = mesh_of(context)
    if obj is None:
        linked = drawing.overridable(context)
        return '%s is linked; make an override of it to draw on it' % linked.name if linked else 'Select the mesh to draw on'
    try:
        check(obj)
    except Refused as problem:
        return str(problem)
    return ''


class PENPOSE_PG_pen(bpy.types.PropertyGroup):
    """What the pen draws next. It belongs to the session, not to the file."""
    kind: EnumProperty(name='Next Stroke', description='What the next stroke of the pen is', items=KINDS, default='AUTO')
    curve: IntProperty(name='Curve', description='The reference that the next stroke is the target of; 0: in turn', default=0, min=0)
    selected_only: BoolProperty(name='Selected Only', default=False, description='Only selected bones move; of a mesh its active shape key')
    arcs: BoolProperty(name='Arcs', default=False, update=lambda self, context: redraw(),
                       description='Show the way of each reference over time. Drag a frame of it to pull the face there')
    ghosts: BoolProperty(name='Ghosts', default=False, update=lambda self, context: redraw(),
                         description='Show the face before (violet) and after (cyan). Draw over a line of one to pose it')
    arc_frames: IntProperty(name='Frames', default=12, min=1, max=100, description='Of an arc, on either side of now')
    ghost_count: IntProperty(name='Ghosts', default=2, min=1, max=9, description='On either side of now')
    ghost_at: EnumProperty(name='At', items=[('KEYS', 'Keys', 'On the frames that have keys'),
                                             ('FRAMES', 'Frames', 'Every so many frames')])
    ghost_step: IntProperty(name='Step', default=5, min=1, max=100, description='Frames between ghosts')


def next_stroke(obj, kind='AUTO', curve=0):
    """What the next stroke is: its kind, and the reference that a target is of or None. A reference without a target is given one
    in turn."""
    pen = bpy.context.window_manager.penpose
    if kind == 'AUTO' and not curve:
        kind, curve = pen.kind, pen.curve
    references = [c for c in curves.curves(obj) if c['role'] == 'reference']
    chosen = [c for c in references if c['id'] == curve]
    waiting = [c for c in references if 'target' not in c]
    if kind == 'AUTO':
        kind = 'target' if chosen or waiting else 'reference'
    if kind != 'target':
        return kind, None
    found = chosen or waiting or references
    return kind, found[-1]['id'] if found else None


def seen_in(region, rv3d, obj):
    """How a region shows an object."""
    space = drawing.known(obj, measured=False).rig.space()
    around = obj.matrix_world @ (sum((drawing.corner(c) for c in obj.bound_box), drawing.corner((0, 0, 0))) / 8)
    return seen_by(rv3d.view_matrix, rv3d.window_matrix, region.width, region.height, space, around)


def region_below(context, event):
    """The viewport's region that an event lies in, or None where a panel or a toolbar lies over it."""
    if context.area is None or context.area.type != 'VIEW_3D':
        return None
    below = [r for r in context.area.regions if r.width > 1 and r.height > 1
             and 0 <= event.mouse_x - r.x < r.width and 0 <= event.mouse_y - r.y < r.height]
    return below[0] if len(below) == 1 and below[0].type == 'WINDOW' else None


class PENPOSE_OT_draw(bpy.types.Operator):
    """Draw on the mesh: first where the feature is, then where it should be"""
    bl_idname = 'penpose.draw'
    bl_label = 'Draw'
    bl_options = {'REGISTER', 'UNDO'}

    kind: EnumProperty(name='Stroke', description='What the stroke is', items=KINDS, default='AUTO')
    curve: IntProperty(name='Curve', description='The reference that the target is of; 0: the last without one', default=0, min=0)

    @classmethod
    def poll(cls, context):
        if context.area is None or context.area.type != 'VIEW_3D':
            cls.poll_message_set('The pen draws in a 3D Viewport')
            return False
        # With the tool in hand it says why not: what is left to others drags what is selected about.
        if mesh_of(context) is None and not in_hand(context):
            cls.poll_message_set('Select the mesh to draw on')
            return False
        return True

    def invoke(self, context, event):
        obj = mesh_of(context)
        if obj is None:
            return self._choose(context, event)
        self.held, self.frame, self.stroke, self.plain = Held(obj), context.scene.frame_current, None, ()
        self.kind_drawn = next_stroke(obj, self.kind, self.curve)[0]
        event = _touches.pop() if _touches else event
        if context.region is not None and context.region.type == 'WINDOW' and event.value in {'PRESS', 'CLICK_DRAG'}:
            if not self._press(context, event, context.region, obj):
                return {'CANCELLED'}
        begin(self)
        self._say(context)
        context.window_manager.modal_handler_add(self)
        return {'RUNNING_MODAL'}

    def _choose(self, context, event):
        """Nothing is there to draw on: what lies below the pen is selected, as a click does, and the remedy is told."""
        before = context.active_object
        if context.region is not None and context.region.type == 'WINDOW' and event.type == 'LEFTMOUSE':
            place = event.mouse_x - context.region.x, event.mouse_y - context.region.y
            bpy.ops.view3d.select(deselect_all=True, location=place)
        problem = why_not(context)
        if problem:
            self.report({'WARNING'}, problem)
        return {'CANCELLED' if context.active_object == before else 'FINISHED'}

    def _press(self, context, event, region, obj):
        """The pen touches: the stroke begins. Whether it does."""
        try:
            self.stroke = self._begun(context, event, region, obj)
            self.frame = context.scene.frame_current
        except (Refused, Error) as problem:
            self.report({'ERROR'}, str(problem))
            return False
        self.button, self.corner = event.type, (region.x, region.y)
        self._take(event)
        if self.kind_drawn == 'target':
            self.plain = drawing.plain_normals(obj)
        overlay.show_stroke(self.stroke, region)
        return True

    def _begun(self, context, event, region, obj):
        """The stroke that begins here: a drawn target or another frame that lies below the pen, else what is drawn next."""
        self.kind_drawn, curve = next_stroke(obj, self.kind, self.curve)
        pen, seen = context.window_manager.penpose, seen_in(region, region.data, obj)
        if self.kind == pen.kind == 'AUTO' and self.kind_drawn == 'reference':
            place = event.mouse_x - region.x, event.mouse_y - region.y
            moment = arcs.hit(obj, place, seen, context.scene, pen)
            pulled = pull.hit(obj, place, seen, context.preferences.system.ui_scale)
            if moment or pulled:
                self.kind_drawn = 'target'
                nearer = moment and (pulled is None or moment[0] < pulled[0])
                return stroke_at(obj, *moment[1:], seen) if nearer else pull.Pull(obj, pulled[1], seen)
        return drawing.Stroke(obj, self.kind_drawn, seen, curve)

    def _say(self, context):
        what = '%s of %s' % (self.kind_drawn.capitalize(), self.held.name)
        context.workspace.status_text_set(what + (': lift the pen to keep it, Esc to leave no trace' if self.stroke else
                                                  ': draw it in the viewport, Esc to give up'))

    def _take(self, event):
        pressure = event.pressure if getattr(event, 'is_tablet', False) else 1.0
        # Events count from the window's corner; the region may be another one than that below the pen.
        self.stroke.add((event.mouse_x - self.corner[0], event.mouse_y - self.corner[1]), pressure)

    def _object(self, context):
        """The object, while the stroke makes sense; else None."""
        obj = self.held.get()  # renamed it is the same
        if obj is None or context.scene.frame_current != self.frame or mesh_of(context) != obj or obj.mode not in ('OBJECT', 'POSE'):
            return None
        return obj

    def modal(self, context, event):
        if not running(self):
            return {'CANCELLED'}
        try:
            return self._wait(context, event) if self.stroke is None else self._modal(context, event)
        except (Refused, Error) as problem:
            self.report({'WARNING'}, str(problem))
        except (ReferenceError, KeyError, AttributeError):
            self.report({'WARNING'}, 'what was drawn on is gone; the stroke is given up')
        self.leave()
        return {'CANCELLED'}

    def _wait(self, context, event):
        """Until the pen touches: the operator came from a menu or a button. The view may be turned meanwhile."""
        obj = self._object(context)
        if obj is None:
            return self._give_up()
        if event.type in {'ESC', 'RIGHTMOUSE'} and event.value == 'PRESS':
            self.leave()
            return {'CANCELLED'}
        if event.type != 'LEFTMOUSE' or event.value != 'PRESS' or event.alt:
            return {'PASS_THROUGH'}
        region = region_below(context, event)
        if region is None:
            return {'PASS_THROUGH'}
        if not self._press(context, event, region, obj):
            self.leave()
            return {'CANCELLED'}
        self._say(context)
        return {'RUNNING_MODAL'}

    def _give_up(self):
        self.report({'WARNING'}, 'the object, its mode or the frame changed; the stroke is given up')
        self.leave()
        return {'CANCELLED'}

    def _modal(self, context, event):
        obj = self._object(context)
        if obj is None:
            return self._give_up()
        if event.type == 'INBETWEEN_MOUSEMOVE':
            self._take(event)
        elif event.type == 'MOUSEMOVE':
            self._take(event)
            self.stroke.follow()
            redraw()
        elif event.type in {'ESC', 'RIGHTMOUSE'}:
            self.leave()
            return {'CANCELLED'}
        elif event.value == 'RELEASE' and event.type != self.button:
            return {'PASS_THROUGH'}  # a key that was held for the pen
        elif event.type == self.button and event.value == 'RELEASE' or event.type == 'RET':
            self._normals_back()
            moved = self.stroke.end(obj)
            context.window_manager.penpose.curve = 0
            ended(self)
            self._tell(obj, moved)
            return {'FINISHED'}
        return {'RUNNING_MODAL'}

    def _tell(self, obj, moved):
        try:
            recording.note(obj)
        except (Refused, Error, OSError) as problem:
            self.report({'WARNING'}, str(problem))
        for said in drawing.said(obj):
            self.report({'INFO'}, said)
        if moved or self.kind_drawn == 'target':
            tell_moved(self, obj, moved, self.stroke.keyed, getattr(self.stroke, 'frame', None))
            if moved:
                preferences.hint_was_read(bpy.context)

    def _normals_back(self):
        token, self.plain = self.plain, ()
        drawing.normals_back(token)

    def cancel(self, context):
        self.leave()

    def leave(self):
        """Gives the stroke up: everything as before it."""
        if not running(self):
            return
        self._normals_back()
        if self.stroke is not None:
            self.stroke.cancel(self.held.get())
            if bpy.context.scene.frame_current != self.frame:
                # What is animated has the values of the new frame.
                bpy.context.scene.frame_set(bpy.context.scene.frame_current)
        ended(self)


def control_name(control):
    """As it is called in a message."""
    return getattr(control, 'name', None) or control.bone


def tell_moved(operator, obj, moved, keyed=0, frame=None):
    """Says which controls moved, and why none did."""
    if moved:
        names = ', '.join(control_name(c) for c in moved[:8]) + (', ...' if len(moved) > 8 else '')
        on = ' and keyed on frame %g' % (bpy.context.scene.frame_current if frame is None else frame) if keyed else ''
        operator.report({'INFO'}, 'Moved%s: %s' % (on, names))
        return
    others = len([c for c in curves.curves(obj) if c['role'] == 'constraint' or 'target' in c]) > 1
    operator.report({'WARNING'}, 'nothing moved: the other curves hold it; delete those that are done, or draw them again' if others else
                    'nothing moved: no free control brings the reference nearer to that line')


CLASSES = (PENPOSE_PG_pen, PENPOSE_OT_draw)


def register():
    bpy.types.WindowManager.penpose = PointerProperty(type=PENPOSE_PG_pen)


def unregister():
    del bpy.types.WindowManager.penpose
