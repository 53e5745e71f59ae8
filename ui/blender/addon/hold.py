"""A key held for the pen: while it is down, strokes are drawn whatever tool is in hand."""
import bpy

from . import free_keys
from .pen import begin, begin_stroke, ended, mesh_of, region_below, running

_items = []


class PENPOSE_OT_hold_pen(bpy.types.Operator):
    """Draw with the pen while the key is down, over any tool"""
    bl_idname = 'penpose.hold_pen'
    bl_label = 'Hold for the Pen'
    bl_options = {'INTERNAL'}

    @classmethod
    def poll(cls, context):
        return context.area is not None and context.area.type == 'VIEW_3D' and mesh_of(context) is not None

    def invoke(self, context, event):
        if getattr(event, 'is_repeat', False):
            return {'CANCELLED'}
        self.key = event.type
        begin(self)
        context.window_manager.modal_handler_add(self)
        self._say(context)
        return {'RUNNING_MODAL'}

    def _say(self, context):
        context.workspace.status_text_set('Pen: draw while the key is down. Shift: what stays, Ctrl: another reference')

    def modal(self, context, event):
        if not running(self):
            return {'CANCELLED'}
        if event.type == self.key and event.value == 'RELEASE' or event.type == 'WINDOW_DEACTIVATE':
            self.leave()
            return {'FINISHED'}
        if event.type == self.key:
            return {'RUNNING_MODAL'}
        region = region_below(context, event)
        if event.type != 'LEFTMOUSE' or event.value != 'PRESS' or region is None:
            return {'PASS_THROUGH'}
        kind = 'constraint' if event.shift else 'reference' if event.ctrl else 'AUTO'
        problem = begin_stroke(context, region, event, kind)
        if problem:
            self.report({'WARNING'}, problem)
        return {'RUNNING_MODAL'}

    def cancel(self, context):
        self.leave()

    def leave(self):
        """The key counts no more."""
        ended(self)


CLASSES = (PENPOSE_OT_hold_pen,)


def register():
    config = bpy.context.window_manager.keyconfigs.addon
    for name in ('Object Mode', 'Pose') if config is not None else ():
        keymap = config.keymaps.new(name=name, space_type='EMPTY')
        _items.append((keymap, keymap.keymap_items.new('penpose.hold_pen', free_keys.HOLD, 'PRESS')))


def unregister():
    while _items:
        keymap, item = _items.pop()
        keymap.keymap_items.remove(item)
