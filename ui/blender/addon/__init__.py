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

import glob
import importlib
import os
import sys

import bpy
from bpy.app.handlers import persistent

_NAMES = ('preferences', 'pen', 'curve_list', 'hold', 'mirror', 'override', 'pie', 'sketch', 'grease', 'pencil_film', 'recording', 'panel',
          'drawing', 'overlay', 'tools')
_loaded = {}  # modules by name, while the add-on is enabled


@persistent
def _stop(*_):
    """Before undo, redo and another file: a stroke that is being drawn leaves no trace."""
    _loaded['pen'].stop()


@persistent
def _in_step(*_):
    """After undo and redo curves are those of that moment; a record goes on."""
    _loaded['drawing'].in_step()
    bpy.context.window_manager.penpose.curve = 0


@persistent
def _forget(*_):
    """In another file nothing that was known is so."""
    _loaded['recording'].end_all()
    _loaded['drawing'].forget()
    _loaded['overlay'].forget()
    pen = bpy.context.window_manager.penpose
    pen.curve, pen.selected_only = 0, False


_HANDLERS = [('undo_pre', _stop), ('redo_pre', _stop), ('load_pre', _stop), ('undo_post', _in_step), ('redo_post', _in_step),
             ('load_post', _forget)]


class PENPOSE_AP_missing(bpy.types.AddonPreferences):
    """What the preferences show where the library cannot be loaded."""
    bl_idname = __package__
    problem = ''

    def draw(self, context):
        self.layout.label(text=self.problem, icon='ERROR')


def _classes():
    return [one for name in _NAMES for one in getattr(_loaded[name], 'CLASSES', ())]


def _files():
    """Changes where the files of the add-on do."""
    found = glob.glob(os.path.join(glob.escape(os.path.dirname(os.path.abspath(__file__))), '**', '*.py'), recursive=True)
    return sorted((path, os.stat(path).st_mtime_ns, os.stat(path).st_size) for path in found)


def _load():
    """Loads the library and all modules: anew where the files are others than last time, so that none is left of an older version."""
    first = sys.modules.get(__package__ + '.library._c')
    if first is not None and getattr(first, 'files', None) == _files():
        first.load()
    else:
        _unload()
        for name in [n for n in sys.modules if n.startswith(__package__ + '.')]:
            globals().pop(name[len(__package__) + 1:], None)
            del sys.modules[name]
        importlib.invalidate_caches()
    for name in _NAMES:
        _loaded[name] = importlib.import_module('.' + name, __package__)
    sys.modules[__package__ + '.library._c'].files = _files()


def register():
    try:
        _load()
    except (ImportError, OSError) as problem:
        _unload()
        PENPOSE_AP_missing.problem = 'penpose is not ready: %s' % problem
        print(PENPOSE_AP_missing.problem)
        bpy.utils.register_class(PENPOSE_AP_missing)
        return
    sys.modules[__package__ + '.native'].clear(keep=True)
    for one in _classes():
        bpy.utils.register_class(one)
    _loaded['pen'].register()
    _loaded['tools'].register()
    _loaded['overlay'].register()
    _loaded['hold'].register()
    for name, handler in _HANDLERS:
        getattr(bpy.app.handlers, name).append(handler)


def unregister():
    """Takes all back, the library too: its file may be replaced then."""
    if not _loaded:
        bpy.utils.unregister_class(PENPOSE_AP_missing)
        return
    _loaded['pen'].stop()
    _loaded['drawing'].forget()
    for name, handler in _HANDLERS:
        getattr(bpy.app.handlers, name).remove(handler)
    _loaded['hold'].unregister()
    _loaded['overlay'].unregister()
    _loaded['tools'].unregister()
    _loaded['pen'].unregister()
    for one in reversed(_classes()):
        bpy.utils.unregister_class(one)
    _unload()


def _unload():
    """Gives the library back. Its modules stay for scripts that have them, until the files change."""
    _loaded.clear()
    for name, end in (('library._c', 'unload'), ('native', 'clear')):
        module = sys.modules.get('%s.%s' % (__package__, name))
        if module is not None:
            getattr(module, end)()
