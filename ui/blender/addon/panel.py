"""The panel in the sidebar: what the pen does, the curves, keys, rig tool and record."""
import bpy

from . import drawing, recording
from .keys import wanted
from .pen import KINDS, kind_of, mesh_of


class PENPOSE_PT_panel(bpy.types.Panel):
    bl_label = 'Penpose'
    bl_idname = 'PENPOSE_PT_panel'
    bl_space_type = 'VIEW_3D'
    bl_region_type = 'UI'
    bl_category = 'Penpose'

    def draw(self, context):
        layout = self.layout
        obj = mesh_of(context)
        if obj is None or obj.type != 'MESH':
            layout.label(text='Select the mesh to draw on', icon='INFO')
            return
        layout.label(text=obj.name, icon='MESH_DATA')
        layout.operator('wm.tool_set_by_id', text='Pen', icon='GREASEPENCIL').name = \
            'penpose.pen_in_pose' if context.mode == 'POSE' else 'penpose.pen'
        layout.label(text='The next stroke: ' + kind_of('AUTO', obj))
        self._curves(layout, obj)
        layout.operator('penpose.grease_pencil', icon='OUTLINER_OB_GREASEPENCIL')
        layout.operator('penpose.rig', icon='SHAPEKEY_DATA')
        row = layout.row()
        row.label(text='Moves are keyed' if wanted(context.scene) else 'Moves are not keyed',
                  icon='REC' if wanted(context.scene) else 'DOT')

    def _curves(self, layout, obj):
        icons = {kind: icon for kind, _, _, icon, _ in KINDS}
        column = layout.column(align=True)
        for curve in drawing.store.read(obj)['curves']:
            row = column.row(align=True)
            row.label(text='%s %d' % (curve['role'].capitalize(), curve['id']), icon=icons[curve['role']])
            if curve['role'] == 'reference':
                draw = row.operator('penpose.draw', text='', icon='FORWARD' if 'target' in curve else 'ADD')
                draw.kind, draw.curve = 'target', curve['id']
            row.operator('penpose.delete_curve', text='', icon='X').curve = curve['id']
        row = layout.row(align=True)
        row.operator('penpose.solve', icon='FILE_REFRESH')
        row.operator('penpose.delete_curve', text='Delete All', icon='TRASH').curve = 0


class PENPOSE_PT_record(bpy.types.Panel):
    bl_label = 'Record'
    bl_parent_id = 'PENPOSE_PT_panel'
    bl_space_type = 'VIEW_3D'
    bl_region_type = 'UI'
    bl_options = {'DEFAULT_CLOSED'}

    def draw(self, context):
        path = recording.recorded(mesh_of(context))
        if path is None:
            self.layout.operator('penpose.record', icon='REC')
        else:
            self.layout.label(text=bpy.path.basename(path), icon='REC')
            self.layout.operator('penpose.record_end', icon='SNAP_FACE')


CLASSES = (PENPOSE_PT_panel, PENPOSE_PT_record)
