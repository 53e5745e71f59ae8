"""The panel in the sidebar: the pen, the curves, time, drawings by Grease Pencil, keys, rig tool and record."""
import textwrap

import bpy

from . import curves, drawing, recording
from .pen import KINDS, mesh_of, next_stroke, why_not
from .tools import NAMES, in_hand

ICONS = {kind: icon for kind, _, _, icon, _ in KINDS}


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


class _OfCharacter(_InSidebar):
    """Shown while there is a mesh to draw on."""
    bl_parent_id = 'PENPOSE_PT_panel'

    @classmethod
    def poll(cls, context):
        return not why_not(context)


class PENPOSE_PT_panel(_InSidebar, bpy.types.Panel):
    bl_label = 'Penpose'
    bl_idname = 'PENPOSE_PT_panel'

    def draw(self, context):
        layout = self.layout
        problem = why_not(context)
        if problem:
            _lines(layout, context, problem, 'INFO')
            if drawing.overridable(context) is not None:
                layout.operator('penpose.make_override', icon='LIBRARY_DATA_OVERRIDE')
            return
        obj, pen = mesh_of(context), context.window_manager.penpose
        if obj.data.shape_keys is None and obj.find_armature() is None and len(drawing.parts(obj)) == 1:
            _lines(layout, context, '%s has no shape key and no bones: make a key by drawing first' % obj.name, 'INFO')
            return
        layout.label(text=obj.name, icon='MESH_DATA')
        row = layout.row()
        row.scale_y = 1.3
        held = in_hand(context)
        row.operator('wm.tool_set_by_id', text='Pen', icon='GREASEPENCIL', depress=held).name = NAMES.get(context.mode, NAMES['OBJECT'])
        layout.prop(pen, 'kind', text='Next')
        kind, curve = next_stroke(obj)
        said = {'reference': 'A reference, on the mesh', 'constraint': 'A constraint, on the mesh',
                'target': 'Target of Reference %s' % curve if curve else 'Draw a reference first'}[kind]
        layout.label(text=said if held else 'Take up the pen to draw', icon=ICONS[kind] if held else 'INFO')
        layout.prop(pen, 'selected_only', icon='RESTRICT_SELECT_OFF', toggle=True)


class PENPOSE_PT_curves(_OfCharacter, bpy.types.Panel):
    bl_label = 'Curves'

    def draw(self, context):
        layout, obj, chosen = self.layout, mesh_of(context), context.window_manager.penpose.curve
        column = layout.column(align=True)
        drawn = curves.curves(obj)
        for curve in drawn:
            row = column.row(align=True)
            text = '%s %d' % (curve['role'].capitalize(), curve['id'])
            if curve['role'] == 'reference':
                icon = 'RADIOBUT_ON' if curve['id'] == chosen else ICONS['reference']
                row.operator('penpose.choose', text=text + (', with target' if 'target' in curve else ''), icon=icon,
                             depress=curve['id'] == chosen).curve = curve['id']
            else:
                off = curve.get('off', False)
                row.operator('penpose.hold', text=text, icon='UNPINNED' if off else 'PINNED', depress=not off).curve = curve['id']
            row.operator('penpose.mirror', text='', icon='MOD_MIRROR').curve = curve['id']
            row.operator('penpose.delete_curve', text='', icon='X').curve = curve['id']
        if not drawn:
            column.label(text='None yet')
        column = layout.column(align=True)
        column.operator('penpose.solve', icon='FILE_REFRESH')
        row = column.row(align=True)
        row.operator('penpose.mirror', icon='MOD_MIRROR').curve = 0
        row.operator('penpose.flip', icon='ARROW_LEFTRIGHT')
        column.operator('penpose.delete_curve', text='Delete All', icon='TRASH').curve = 0


class PENPOSE_PT_time(_OfCharacter, bpy.types.Panel):
    bl_label = 'Over Time'

    def draw(self, context):
        layout, pen = self.layout, context.window_manager.penpose
        layout.use_property_split = layout.use_property_decorate = False
        row = layout.row(align=True)
        row.prop(pen, 'arcs', icon='CURVE_PATH', toggle=True)
        row.prop(pen, 'arc_frames')
        row = layout.row(align=True)
        row.prop(pen, 'ghosts', icon='GHOST_ENABLED', toggle=True)
        row.prop(pen, 'ghost_count', text='Count')
        row = layout.row(align=True)
        row.active = pen.ghosts
        row.prop(pen, 'ghost_at', expand=True)
        if pen.ghost_at == 'FRAMES':
            row.prop(pen, 'ghost_step')
        settings = context.scene.tool_settings
        column = layout.column(align=True)
        column.prop(settings, 'use_keyframe_insert_auto', text='Auto Keying', icon='REC', toggle=True)
        column.prop_search(context.scene.keying_sets_all, 'active', context.scene, 'keying_sets_all', text='Keys')


class PENPOSE_PT_pencil(_OfCharacter, bpy.types.Panel):
    bl_label = 'Grease Pencil'
    bl_options = {'DEFAULT_CLOSED'}

    def draw(self, context):
        column = self.layout.column(align=True)
        column.operator('penpose.pencil_pose', icon='OUTLINER_OB_GREASEPENCIL')
        column.operator('penpose.pencil_film', icon='RENDER_ANIMATION')
        column.operator('penpose.grease_pencil', text='Curves from Strokes', icon='CURVE_DATA')


class PENPOSE_PT_rig(_InSidebar, bpy.types.Panel):
    bl_label = 'Rig'
    bl_parent_id = 'PENPOSE_PT_panel'
    bl_options = {'DEFAULT_CLOSED'}

    def draw(self, context):
        self.layout.operator('penpose.rig', icon='SHAPEKEY_DATA')


class PENPOSE_PT_record(_OfCharacter, bpy.types.Panel):
    bl_label = 'Record'
    bl_options = {'DEFAULT_CLOSED'}

    def draw(self, context):
        path = recording.recorded(mesh_of(context))
        if path is None:
            self.layout.operator('penpose.record', icon='REC')
        else:
            self.layout.label(text=bpy.path.basename(path), icon='REC')
            self.layout.operator('penpose.record_end', icon='SNAP_FACE')


CLASSES = (PENPOSE_PT_panel, PENPOSE_PT_curves, PENPOSE_PT_time, PENPOSE_PT_pencil, PENPOSE_PT_rig, PENPOSE_PT_record)
