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

from . import drawing, grease, overlay, panel, pen, recording, sketch, tools

_CLASSES = pen.CLASSES + sketch.CLASSES + grease.CLASSES + recording.CLASSES + panel.CLASSES


@persistent
def _stop(*_):
    """Before undo, redo and another file: a stroke that is being drawn leaves no trace."""
    pen.stop()


@persistent
def _in_step(*_):
    """After undo and redo curves are those of that moment; a record goes on."""
    drawing.in_step()
    bpy.context.window_manager.penpose.curve = 0


@persistent
def _forget(*_):
    """In another file nothing that was known is so."""
    recording.end_all()
    drawing.forget()
    bpy.context.window_manager.penpose.curve = 0


_HANDLERS = [('undo_pre', _stop), ('redo_pre', _stop), ('load_pre', _stop), ('undo_post', _in_step), ('redo_post', _in_step),
             ('load_post', _forget)]


def register():
    for one in _CLASSES:
        bpy.utils.register_class(one)
    pen.register()
    tools.register()
    overlay.register()
    for name, handler in _HANDLERS:
        getattr(bpy.app.handlers, name).append(handler)


def unregister():
    pen.stop()
    drawing.forget()
    for name, handler in _HANDLERS:
        getattr(bpy.app.handlers, name).remove(handler)
    overlay.unregister()
    tools.unregister()
    pen.unregister()
    for one in reversed(_CLASSES):
        bpy.utils.unregister_class(one)
