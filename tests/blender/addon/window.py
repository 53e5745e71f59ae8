"""The add-on in a window: blender --window-geometry 0 0 1380 860 --python window.py -- ZIP MODEL [COMMANDS]

Imports the model, frames it from the front, takes up the pen and opens the sidebar; a mouse (xdotool's) does the rest. Files *.py that
appear in the folder COMMANDS are run from a timer one by one, and what they print lands in *.out: so a test does things while a button
is held down.
"""
import contextlib
import glob
import io
import os
import sys
import traceback

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import desk  # noqa: E402
import bpy  # noqa: E402


def view(window=None):
    """The 3D viewport: what bpy.context.temp_override() takes."""
    window = window or bpy.context.window_manager.windows[0]
    area = max((a for a in window.screen.areas if a.type == 'VIEW_3D'), key=lambda a: a.width)
    region = next(r for r in area.regions if r.type == 'WINDOW')
    return {'window': window, 'screen': window.screen, 'area': area, 'region': region}


def prepare(model):
    """The model from the front with the pen and the panel."""
    desk.imported(model)
    with bpy.context.temp_override(**view()):
        space = bpy.context.space_data
        space.show_region_ui = True
        bpy.context.preferences.view.smooth_view = 0
        bpy.ops.view3d.view_axis(type='FRONT')
        bpy.ops.view3d.view_selected()
        bpy.ops.wm.tool_set_by_id(name='penpose.pen')
        bpy.ops.ed.undo_push(message='the model')


def look(folder):
    """Runs the commands that lie there."""
    for path in sorted(glob.glob(os.path.join(folder, '*.py'))):
        with open(path, encoding='utf-8') as f:
            text = f.read()
        os.remove(path)
        out = io.StringIO()
        with contextlib.redirect_stdout(out):
            try:
                exec(compile(text, path, 'exec'), {'bpy': bpy, 'view': view, 'desk': desk})
            except Exception:  # noqa: BLE001 whatever a command does is told
                traceback.print_exc(file=sys.stdout)
        with open(path[:-3] + '.new', 'w', encoding='utf-8') as f:
            f.write(out.getvalue())
        os.replace(path[:-3] + '.new', path[:-3] + '.out')
    return 0.05


def main():
    archive, model, *folder = desk.ARGUMENTS
    bpy.context.preferences.view.show_splash = False
    bpy.ops.wm.read_homefile(use_empty=False, use_factory_startup=True)
    bpy.context.preferences.view.show_splash = False
    for one in list(bpy.data.objects):
        bpy.data.objects.remove(one)
    desk.install(os.path.abspath(archive))

    def begin():
        prepare(model)
        print('ready', flush=True)
    bpy.app.timers.register(begin, first_interval=1.0)
    if folder:
        bpy.app.timers.register(lambda: look(folder[0]), first_interval=2.0, persistent=True)


main()
