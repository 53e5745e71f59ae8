"""A linked character is made one's own: a library override, at the press of a button."""
import bpy

from . import drawing
from .controls import Refused
from .library import Error


class PENPOSE_OT_make_override(bpy.types.Operator):
    """Make a library override of the linked character, so that it can be posed"""
    bl_idname = 'penpose.make_override'
    bl_label = 'Make Override'
    bl_options = {'REGISTER', 'UNDO'}

    @classmethod
    def poll(cls, context):
        if drawing.overridable(context) is None:
            cls.poll_message_set('Nothing that is linked is active')
            return False
        return True

    def execute(self, context):
        try:
            obj = drawing.make_override(context)
        except (Refused, Error, RuntimeError) as problem:
            self.report({'ERROR'}, str(problem).strip().splitlines()[0])
            return {'CANCELLED'}
        self.report({'INFO'}, '%s can be drawn on now' % obj.name)
        return {'FINISHED'}


CLASSES = (PENPOSE_OT_make_override,)
