"""The pen in the viewport: one stroke is one operator and one step of undo."""
import bpy
from bpy.props import EnumProperty, IntProperty

from . import drawing, overlay, recording, versions
from .controls import Refused
from .library import Error
from .space import seen_by

KINDS = [('AUTO', 'Draw', 'A reference where the feature is, then its target where it should be, in turn', 'GREASEPENCIL', 0),
         ('reference', 'Reference', 'Where the feature is, on the mesh', 'CURVE_DATA', 1),
         ('target', 'Target', 'Where the reference should be: the face follows', 'FORWARD', 2),
         ('constraint', 'Constraint', 'What stays where it is', 'PINNED', 3)]

_drawn = []  # the operator whose stroke is being drawn


def stop():
    """Ends the stroke that is being drawn, without a trace (the add-on goes, or a file is loaded)."""
    for operator in list(_drawn):
        operator.leave()


def mesh_of(context):
    """The mesh that is drawn on: the active object, or the one that the active armature carries and was drawn on last."""
    active = context.active_object
    if active is not None and active.type == 'ARMATURE':
        carried = [o for o in context.view_layer.objects if o.type == 'MESH' and o.find_armature() == active and o.visible_get()]
        chosen = [o for o in carried if o.select_get()] or sorted(carried, key=lambda o: -len(o.data.vertices))
        return chosen[0] if chosen else None
    return active


def kind_of(kind, obj):
    """What the next stroke is: in turn, a reference without a target is given one."""
    if kind != 'AUTO':
        return kind
    waits = any(c['role'] == 'reference' and 'target' not in c for c in drawing.store.read(obj)['curves'])
    return 'target' if waits else 'reference'


def seen_in(region, rv3d, obj):
    """How a region shows an object."""
    space = drawing.known(obj).rig.mesh.space
    around = obj.matrix_world @ (sum((drawing.corner(c) for c in obj.bound_box), drawing.corner((0, 0, 0))) / 8)
    return seen_by(rv3d.view_matrix, rv3d.window_matrix, region.width, region.height, space, around)


class PENPOSE_OT_draw(bpy.types.Operator):
    """Draw on the mesh: first where the feature is, then where it should be"""
    bl_idname = 'penpose.draw'
    bl_label = 'Draw'
    bl_options = {'REGISTER', 'UNDO'}

    kind: EnumProperty(name='Stroke', items=KINDS, default='AUTO')
    curve: IntProperty(name='Curve', description='The reference that the target is of; 0: the last without one', default=0, min=0)

    @classmethod
    def poll(cls, context):
        return context.area is not None and context.area.type == 'VIEW_3D' and mesh_of(context) is not None

    def invoke(self, context, event):
        obj = mesh_of(context)
        try:
            self.kind_drawn = kind_of(self.kind, obj)
            self.stroke = drawing.Stroke(obj, self.kind_drawn, seen_in(context.region, context.region_data, obj), self.curve or None)
        except (Refused, Error) as problem:
            self.report({'ERROR'}, str(problem))
            return {'CANCELLED'}
        self.object = obj.name
        self.frame = context.scene.frame_current
        self.region = context.region
        self.area = context.area
        self.button = event.type
        _drawn.append(self)
        self._take(event)
        overlay.show_stroke(self.stroke)
        context.window_manager.modal_handler_add(self)
        context.workspace.status_text_set('%s of %s: lift the pen to keep it, Esc to leave no trace' % (self.kind_drawn.capitalize(), obj.name))
        return {'RUNNING_MODAL'}

    def _take(self, event):
        pressure = event.pressure if getattr(event, 'is_tablet', False) else 1.0
        # Events count from the window's corner; the region may be another one than that below the pen.
        self.stroke.add((event.mouse_x - self.region.x, event.mouse_y - self.region.y), pressure)

    def _object(self, context):
        """The object, while the stroke makes sense; else None."""
        obj = bpy.data.objects.get(self.object)
        if obj is None or context.scene.frame_current != self.frame or mesh_of(context) != obj or obj.mode not in ('OBJECT', 'POSE'):
            return None
        return obj

    def modal(self, context, event):
        if self not in _drawn:
            return {'CANCELLED'}
        try:
            return self._modal(context, event)
        except (Refused, Error) as problem:
            self.report({'ERROR'}, str(problem))
        except ReferenceError:
            self.report({'WARNING'}, 'what was drawn on is gone; the stroke is given up')
        self.leave()
        return {'CANCELLED'}

    def _modal(self, context, event):
        obj = self._object(context)
        if obj is None:
            self.report({'WARNING'}, 'the object, its mode or the frame changed; the stroke is given up')
            self.leave()
            return {'CANCELLED'}
        if event.type == 'INBETWEEN_MOUSEMOVE':
            self._take(event)
        elif event.type == 'MOUSEMOVE':
            self._take(event)
            self.stroke.follow()
            self.area.tag_redraw()
        elif event.type in {'ESC', 'RIGHTMOUSE'}:
            self.leave()
            return {'CANCELLED'}
        elif event.type == self.button and event.value == 'RELEASE' or event.type == 'RET':
            self._take(event)
            moved = self.stroke.end(obj)
            recording.note(obj)
            self._done()
            for said in drawing.said(obj):
                self.report({'INFO'}, said)
            if moved:
                self.report({'INFO'}, 'Moved: ' + ', '.join(control_name(c) for c in moved[:8]) + (', ...' if len(moved) > 8 else ''))
            elif self.kind_drawn == 'target':
                self.report({'WARNING'}, 'nothing moved: no free control brings the reference nearer to that line')
            return {'FINISHED'}
        return {'RUNNING_MODAL'}

    def cancel(self, context):
        self.leave()

    def leave(self):
        """Gives the stroke up: everything as before it."""
        if self not in _drawn:
            return
        obj = bpy.data.objects.get(self.object)
        try:
            if obj is not None:
                self.stroke.cancel(obj)
        except (ReferenceError, KeyError, AttributeError):
            drawing.forget(self.object)
        self._done()

    def _done(self):
        if self in _drawn:
            _drawn.remove(self)
        overlay.show_stroke(None)
        try:
            bpy.context.workspace.status_text_set(None)
            self.area.tag_redraw()
        except (ReferenceError, AttributeError):
            pass


def control_name(control):
    """As it is called in a message."""
    return getattr(control, 'name', None) or control.bone


class PENPOSE_OT_solve(bpy.types.Operator):
    """Bring all curves of the object to their targets again, from the pose as it is"""
    bl_idname = 'penpose.solve'
    bl_label = 'Solve Again'
    bl_options = {'REGISTER', 'UNDO'}

    @classmethod
    def poll(cls, context):
        obj = mesh_of(context)
        return obj is not None and bool(obj.get(drawing.store.PROPERTY))

    def execute(self, context):
        try:
            moved = drawing.solve_again(mesh_of(context))
        except (Refused, Error) as problem:
            self.report({'ERROR'}, str(problem))
            return {'CANCELLED'}
        self.report({'INFO'}, '%d controls moved' % len(moved))
        return {'FINISHED'}


class PENPOSE_OT_delete_curve(bpy.types.Operator):
    """Take a curve away; the pose stays"""
    bl_idname = 'penpose.delete_curve'
    bl_label = 'Delete Curve'
    bl_options = {'REGISTER', 'UNDO'}

    curve: IntProperty(name='Curve', description='Its number; 0: all of them', default=0, min=0)

    @classmethod
    def poll(cls, context):
        obj = mesh_of(context)
        return obj is not None and bool(obj.get(drawing.store.PROPERTY))

    def execute(self, context):
        drawing.delete(mesh_of(context), self.curve or None)
        return {'FINISHED'}


class PenposeTool(bpy.types.WorkSpaceTool):
    bl_space_type = 'VIEW_3D'
    bl_context_mode = 'OBJECT'
    bl_idname = 'penpose.pen'
    bl_label = 'Penpose'
    bl_description = 'Pose by drawing: where the feature is, then where it should be'
    bl_icon = 'ops.gpencil.draw.line'
    bl_keymap = (('penpose.draw', {'type': 'LEFTMOUSE', 'value': 'PRESS'}, {'properties': [('kind', 'AUTO')]}),
                 ('penpose.draw', {'type': 'LEFTMOUSE', 'value': 'PRESS', 'shift': True}, {'properties': [('kind', 'constraint')]}),
                 ('penpose.draw', {'type': 'LEFTMOUSE', 'value': 'PRESS', 'ctrl': True}, {'properties': [('kind', 'reference')]}))


class PenposePoseTool(bpy.types.WorkSpaceTool):
    bl_space_type = PenposeTool.bl_space_type
    bl_context_mode = 'POSE'
    bl_idname = 'penpose.pen_in_pose'
    bl_label = PenposeTool.bl_label
    bl_description = PenposeTool.bl_description
    bl_icon = PenposeTool.bl_icon
    bl_keymap = PenposeTool.bl_keymap


CLASSES = (PENPOSE_OT_draw, PENPOSE_OT_solve, PENPOSE_OT_delete_curve)
TOOLS = (PenposeTool, PenposePoseTool)
