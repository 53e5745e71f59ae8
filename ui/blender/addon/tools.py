"""The pen as a tool of Blender's toolbar, in Object and in Pose mode, and its settings in the header."""
import bpy

from . import free_keys

NAMES = {'OBJECT': 'penpose.pen', 'POSE': 'penpose.pen_in_pose'}


def in_hand(context):
    """Whether the pen is the active tool."""
    if context.workspace is None:
        return False
    tool = context.workspace.tools.from_space_view3d_mode(context.mode, create=False)
    return tool is not None and tool.idname == NAMES.get(context.mode)


def _settings(context, layout, tool):
    pen = context.window_manager.penpose
    layout.row(align=True).prop(pen, 'kind', expand=True, icon_only=True)
    layout.prop(pen, 'selected_only', text='', icon='RESTRICT_SELECT_OFF')
    row = layout.row(align=True)
    row.prop(pen, 'arcs', text='', icon='CURVE_PATH')
    row.prop(pen, 'ghosts', text='', icon='GHOST_ENABLED')


class PenposeTool(bpy.types.WorkSpaceTool):
    bl_space_type = 'VIEW_3D'
    bl_context_mode = 'OBJECT'
    bl_idname = NAMES['OBJECT']
    bl_label = 'Penpose'
    bl_description = 'Pose by drawing: where the feature is, then where it should be'
    bl_icon = 'ops.curve.draw'
    bl_keymap = (('penpose.draw', {'type': 'LEFTMOUSE', 'value': 'PRESS'}, {'properties': [('kind', 'AUTO')]}),
                 ('penpose.draw', {'type': 'LEFTMOUSE', 'value': 'PRESS', 'shift': True}, {'properties': [('kind', 'constraint')]}),
                 ('penpose.draw', {'type': 'LEFTMOUSE', 'value': 'PRESS', 'ctrl': True}, {'properties': [('kind', 'reference')]}),
                 ('wm.call_menu_pie', {'type': free_keys.PIE, 'value': 'PRESS'}, {'properties': [('name', 'PENPOSE_MT_pie')]}))
    draw_settings = staticmethod(_settings)


class PenposePoseTool(bpy.types.WorkSpaceTool):
    bl_space_type = PenposeTool.bl_space_type
    bl_context_mode = 'POSE'
    bl_idname = NAMES['POSE']
    bl_label = PenposeTool.bl_label
    bl_description = PenposeTool.bl_description
    bl_icon = PenposeTool.bl_icon
    bl_keymap = PenposeTool.bl_keymap
    draw_settings = staticmethod(_settings)


TOOLS = (PenposeTool, PenposePoseTool)


_registered = []


def register():
    # Where Blender starts without windows nothing is there yet that keeps the keys of tools.
    for tool in TOOLS if bpy.context.window_manager.keyconfigs.addon is not None else ():
        bpy.utils.register_tool(tool, after={'builtin.measure'}, separator=True)
        _registered.append(tool)


def put_down():
    """Whoever holds the pen has Blender's first tool in hand: one that is gone is warned of at each event."""
    for window in bpy.context.window_manager.windows:
        area = next((a for a in window.screen.areas if a.type == 'VIEW_3D'), None)
        for tool in TOOLS if area is not None else ():
            held = window.workspace.tools.from_space_view3d_mode(tool.bl_context_mode, create=False)
            if held is not None and held.idname == tool.bl_idname:
                with bpy.context.temp_override(window=window, area=area):
                    bpy.ops.wm.tool_set_by_id(name='builtin.select_box')


def unregister():
    put_down()
    while _registered:
        bpy.utils.unregister_tool(_registered.pop())
