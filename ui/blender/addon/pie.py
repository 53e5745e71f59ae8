"""The pie menu of the tool: what the next stroke is, and what is done with all that is drawn."""
import bpy


class PENPOSE_MT_pie(bpy.types.Menu):
    bl_label = 'Penpose'
    bl_idname = 'PENPOSE_MT_pie'

    def draw(self, context):
        pie, pen = self.layout.menu_pie(), context.window_manager.penpose
        for kind in ('reference', 'target', 'constraint', 'AUTO'):  # left, right, below, above
            pie.prop_enum(pen, 'kind', kind)
        pie.operator('penpose.mirror', icon='MOD_MIRROR')
        pie.operator('penpose.solve', icon='FILE_REFRESH')
        box = pie.box().column(align=True)
        box.prop(pen, 'arcs', icon='CURVE_PATH')
        box.prop(pen, 'ghosts', icon='GHOST_ENABLED')
        box.prop(pen, 'selected_only', icon='RESTRICT_SELECT_OFF')
        box = pie.box().column(align=True)
        box.operator('penpose.flip', icon='ARROW_LEFTRIGHT')
        box.operator('penpose.delete_curve', text='Delete All Curves', icon='TRASH').curve = 0


CLASSES = (PENPOSE_MT_pie,)
