"""What the list of curves in the sidebar does: choose, heed, delete, solve again."""
import bpy
from bpy.props import IntProperty

from . import curves, drawing
from .controls import Refused
from .library import Error
from .pen import mesh_of, redraw, tell_moved


class WithCurves:
    """Of an object that keeps curves."""

    @classmethod
    def poll(cls, context):
        obj = mesh_of(context)
        if obj is None or not curves.curves(obj):
            cls.poll_message_set('No curve is drawn on the active object')
            return False
        return True


class PENPOSE_OT_solve(WithCurves, bpy.types.Operator):
    """Bring all curves of the object to their targets again, from the pose as it is"""
    bl_idname = 'penpose.solve'
    bl_label = 'Solve Again'
    bl_options = {'REGISTER', 'UNDO'}

    def execute(self, context):
        try:
            moved = drawing.solve_again(mesh_of(context))
        except (Refused, Error) as problem:
            self.report({'ERROR'}, str(problem))
            return {'CANCELLED'}
        tell_moved(self, mesh_of(context), moved)
        return {'FINISHED'}


class PENPOSE_OT_delete_curve(WithCurves, bpy.types.Operator):
    """Take a curve away; the pose stays"""
    bl_idname = 'penpose.delete_curve'
    bl_label = 'Delete Curve'
    bl_options = {'UNDO'}

    curve: IntProperty(name='Curve', description='Its number; 0: all of them', default=0, min=0)

    def execute(self, context):
        drawing.delete(mesh_of(context), self.curve or None)
        redraw()
        return {'FINISHED'}


class PENPOSE_OT_choose(WithCurves, bpy.types.Operator):
    """Draw the target of this reference with the next stroke. Click again to leave it"""
    bl_idname = 'penpose.choose'
    bl_label = 'Choose Curve'
    bl_options = {'INTERNAL'}

    curve: IntProperty(name='Curve', description='Its number', default=0, min=0)

    def execute(self, context):
        pen = context.window_manager.penpose
        pen.curve = 0 if pen.curve == self.curve else self.curve
        if pen.curve:
            pen.kind = 'AUTO'
        redraw()
        return {'FINISHED'}


class PENPOSE_OT_hold(WithCurves, bpy.types.Operator):
    """Heed this constraint, or leave it for now"""
    bl_idname = 'penpose.hold'
    bl_label = 'Heed Constraint'
    bl_options = {'UNDO'}

    curve: IntProperty(name='Curve', description='Its number', default=0, min=0)

    def execute(self, context):
        obj = mesh_of(context)
        curve = next((c for c in curves.curves(obj) if c['id'] == self.curve and c['role'] == 'constraint'), None)
        if curve is None:
            self.report({'WARNING'}, 'there is no such constraint')
            return {'CANCELLED'}
        drawing.change(obj, self.curve, lambda c: c.pop('off', False) or c.update(off=True))
        redraw()
        return {'FINISHED'}


CLASSES = (PENPOSE_OT_solve, PENPOSE_OT_delete_curve, PENPOSE_OT_choose, PENPOSE_OT_hold)
