"""penpose in Blender: draw where a feature of your own rig is, and where it should be."""
bl_info = {
    'name': 'penpose',
    'author': 'The penpose maintainers',
    'version': (0, 2, 0),
    'blender': (3, 4, 0),
    'location': 'View3D > Sidebar > Penpose, and the tool Penpose',
    'description': 'Pose and rig characters by drawing on them',
    'category': 'Rigging',
}

import bpy
from bpy.app.handlers import persistent

from . import drawing, grease, overlay, panel, pen, recording, sketch

_CLASSES = pen.CLASSES + sketch.CLASSES + grease.CLASSES + recording.CLASSES + panel.CLASSES


@persistent
def _forget(*_):
    """After undo, redo and opening a file nothing that was known need be so."""
    pen.stop()
    drawing.forget()


_HANDLERS = ('undo_post', 'redo_post', 'load_post')


def register():
    for one in _CLASSES:
        bpy.utils.register_class(one)
    after = {'builtin.annotate'}
    for tool in pen.TOOLS:
        bpy.utils.register_tool(tool, after=after, separator=True)
    overlay.register()
    for name in _HANDLERS:
        getattr(bpy.app.handlers, name).append(_forget)


def unregister():
    pen.stop()
    drawing.forget()
    for name in _HANDLERS:
        getattr(bpy.app.handlers, name).remove(_forget)
    overlay.unregister()
    for tool in reversed(pen.TOOLS):
        bpy.utils.unregister_tool(tool)
    for one in reversed(_CLASSES):
        bpy.utils.unregister_class(one)
