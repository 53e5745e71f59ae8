"""The panel in the sidebar: what the pen does, the curves, keys, rig tool and record."""
import textwrap

import bpy

from . import drawing, recording
from .pen import KINDS, mesh_of, next_stroke, why_not

ICONS = {kind: icon for kind, _, _, icon, _ in KINDS}
TOOLS = {'OBJECT': 'penpose.pen', 'POSE': 'penpose.pen_in_pose'}


def _lines(layout, context, text, icon):
    """A text of more than a line, as wide as the sidebar."""
    column = layout.column(align=True)
    letters = max(20, int(context.region.width / (7 * context.preferences.system.ui_scale)) - 9)
    for i, line in enumerate(textwrap.wrap(text, letters)):
        column.label(text=line, icon=icon if i == 0 else 'BLANK1')


class _InSidebar:
    bl_space_type = 'VIEW_3D'
    bl_region_type = 'UI'
    bl_category = 'Penpose'


class PENPOSE_PT_panel(_InSidebar, bpy.types.Panel):
    bl_label = 'Penpose'
    bl_idname = 'PENPOSE_PT_panel'

    def draw(self, context):
        layout = self.layout
        problem = why_not(context)
        if problem:
            _lines(layout, context, problem, 'INFO')
            return
        obj, pen = mesh_of(context), context.window_manager.penpose
        if obj.data.shape_keys is None and obj.find_armature() is None:
            _lines(layout, context, '%s has no shape key and no bones: make a key by drawing first' % obj.name, 'INFO')
            return
        layout.label(text=obj.name, icon='MESH_DATA')
        name = TOOLS.get(context.mode, '')
        tool = context.workspace.tools.from_space_view3d_mode(context.mode, create=False)
        active = tool is not None and tool.idname == name
        row = layout.row()
        row.scale_y = 1.3
        row.operator('wm.tool_set_by_id', text='Pen', icon='GREASEPENCIL', depress=active).name = name
        layout.prop(pen, 'kind', text='Next')
        kind, curve = next_stroke(obj)
        said = {'reference': 'A reference, on the mesh', 'constraint': 'A constraint, on the mesh',
                'target': 'Target of Reference %s' % curve if curve else 'Draw a reference first'}[kind]
        if not active:
            said = 'Take up the pen to draw'
        layout.label(text=said, icon=ICONS[kind] if active else 'INFO')


class PENPOSE_PT_curves(_InSidebar, bpy.types.Panel):
    bl_label = 'Curves'
    bl_parent_id = 'PENPOSE_PT_panel'

    @classmethod
    def poll(cls, context):
        obj = mesh_of(context)
        return obj is not None and obj.type == 'MESH'

    def draw(self, context):
        layout, obj, chosen = self.layout, mesh_of(context), context.window_manager.penpose.curve
        column = layout.column(align=True)
        curves = drawing.store.read(obj)['curves']
        for curve in curves:
            row = column.row(align=True)
            text = '%s %d' % (curve['role'].capitalize(), curve['id'])
            if curve['role'] == 'reference':
                icon = 'RADIOBUT_ON' if curve['id'] == chosen else ICONS['reference']
                row.operator('penpose.choose', text=text + (', with target' if 'target' in curve else ''), icon=icon,
                             depress=curve['id'] == chosen).curve = curve['id']
            else:
                off = curve.get('off', False)
                row.operator('penpose.hold', text=text, icon='UNPINNED' if off else 'PINNED', depress=not off).curve = curve['id']
            row.operator('penpose.delete_curve', text='', icon='X').curve = curve['id']
        if not curves:
            column.label(text='None yet')
        column = layout.column(align=True)
        column.operator('penpose.solve', icon='FILE_REFRESH')
        column.operator('penpose.delete_curve', text='Delete All', icon='TRASH').curve = 0
        column.operator('penpose.grease_pencil', icon='OUTLINER_OB_GREASEPENCIL')
        settings = context.scene.tool_settings
        row = layout.column(align=True)
        row.prop(settings, 'use_keyframe_insert_auto', text='Auto Keying', icon='REC', toggle=True)
        row.prop_search(context.scene.keying_sets_all, 'active', context.scene, 'keying_sets_all', text='Keys')


class PENPOSE_PT_rig(_InSidebar, bpy.types.Panel):
    bl_label = 'Rig'
    bl_parent_id = 'PENPOSE_PT_panel'

    def draw(self, context):
        self.layout.operator('penpose.rig', icon='SHAPEKEY_DATA')


class PENPOSE_PT_record(_InSidebar, bpy.types.Panel):
    bl_label = 'Record'
    bl_parent_id = 'PENPOSE_PT_panel'
    bl_options = {'DEFAULT_CLOSED'}

    def draw(self, context):
        path = recording.recorded(mesh_of(context))
        if path is None:
            self.layout.operator('penpose.record', icon='REC')
        else:
            self.layout.label(text=bpy.path.basename(path), icon='REC')
            self.layout.operator('penpose.record_end', icon='SNAP_FACE')


CLASSES = (PENPOSE_PT_panel, PENPOSE_PT_curves, PENPOSE_PT_rig, PENPOSE_PT_record)
