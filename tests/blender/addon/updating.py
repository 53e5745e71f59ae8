"""Installing, enabling, disabling and updating the add-on many times in one session, while it is in use. ZIP [FOLDER]"""
import contextlib
import importlib
import io
import os
import re
import sys
import unittest
import zipfile

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import desk  # noqa: E402
import addon_utils  # noqa: E402
import bpy  # noqa: E402
import numpy as np  # noqa: E402
import trial  # noqa: E402

ZIP = os.path.abspath(desk.ARGUMENTS[0])
NAME = 'penpose_blender'
TIMES = 20


def mapped():
    """Paths of penpose's libraries that are in memory."""
    with open('/proc/self/maps', encoding='utf-8') as f:
        return sorted({line.split(None, 5)[5].strip() for line in f if 'penpose' in line.rpartition('/')[2]})


def sheet():
    """An object that can be drawn on: a grid with a key that lifts its middle."""
    for one in list(bpy.data.objects):
        bpy.data.objects.remove(one)
    bpy.ops.mesh.primitive_grid_add(x_subdivisions=8, y_subdivisions=8, size=2)
    obj = bpy.context.active_object
    obj.shape_key_add(name='Basis')
    key = obj.shape_key_add(name='Lift')
    for i, vertex in enumerate(obj.data.vertices):
        key.data[i].co.z += 0.5 * max(0.0, 1 - vertex.co.length)
    key.value = 0
    return obj


def use():
    """Draws a reference on the object and solves it to a target; the value of the key."""
    from penpose_blender import drawing, placing
    obj = sheet()
    middle = [i for i, v in enumerate(obj.data.vertices) if abs(v.co.y) < 0.01 and abs(v.co.x) < 0.6]
    curve = placing.place_curve(obj, middle)
    rig = drawing.known(obj).rig
    key = obj.data.shape_keys.key_blocks['Lift']
    key.value = 1
    aim = rig.mesh.space.of_object(np.array([tuple(key.data[i].co) for i in middle]))
    key.value = 0
    placing.place_target(obj, curve, aim)
    placing.solve(obj)
    if not bpy.app.background:
        pen_in_hand()
    return key.value


def pen_in_hand():
    """The windows are drawn with the tool, its panel and the curves."""
    window = bpy.context.window_manager.windows[0]
    area = next(a for a in window.screen.areas if a.type == 'VIEW_3D')
    with bpy.context.temp_override(window=window, area=area, region=next(r for r in area.regions if r.type == 'WINDOW')):
        bpy.context.space_data.show_region_ui = True
        bpy.ops.wm.tool_set_by_id(name='penpose.pen')
        bpy.ops.wm.redraw_timer(type='DRAW_WIN_SWAP', iterations=1)


class Updating(unittest.TestCase):
    def setUp(self):
        self.said = io.StringIO()
        self.zips = [ZIP, desk.another(ZIP, '0.9.1')]

    def tearDown(self):
        addon_utils.disable(NAME, default_set=True)

    def told(self, text):
        """Nothing that Blender said was an error."""
        self.assertNotRegex(text, 'Traceback|Error|Exception|Warning')

    def test_update_while_enabled_many_times(self):
        folders, modules = set(), []
        for i in range(TIMES):
            with contextlib.redirect_stdout(self.said), contextlib.redirect_stderr(self.said):
                self.assertEqual(bpy.ops.preferences.addon_install(overwrite=True, filepath=self.zips[i % 2]), {'FINISHED'})
                addon = addon_utils.enable(NAME, default_set=True)
            self.assertTrue(addon.__addon_enabled__)
            self.assertEqual(addon.bl_info['version'], (0, 9, 1) if i % 2 else self.first_version(), 'the new add-on runs')
            self.assertAlmostEqual(use(), 1, delta=0.05)
            self.assertEqual(len(mapped()), 1, 'the library before it is unloaded: %s' % mapped())
            folders.add(os.path.dirname(mapped()[0]))
            here = [m for name, m in sys.modules.items() if name.startswith(NAME + '.')]
            self.assertFalse([m for m in here for old in modules if m is old], 'no module of the version before is left')
            modules = here
        self.assertEqual(len(folders), 2, 'each version has its library')
        self.assertEqual(len([f for f in folders if os.path.isdir(f)]), 1, 'the old one is removed')
        self.told(self.said.getvalue())

    def first_version(self):
        with zipfile.ZipFile(ZIP) as packed:
            return tuple(map(int, re.search(r"'version': \((\d+), (\d+), (\d+)\)", packed.read(NAME + '/__init__.py').decode()).groups()))

    def test_the_same_zip_over_itself_while_in_use(self):
        desk.install(ZIP)
        use()
        for _ in range(TIMES):
            with contextlib.redirect_stdout(self.said), contextlib.redirect_stderr(self.said):
                bpy.ops.preferences.addon_install(overwrite=True, filepath=ZIP)
            self.assertAlmostEqual(use(), 1, delta=0.05, msg='what is enabled goes on until it is enabled anew')
        self.told(self.said.getvalue())

    def test_enable_and_disable_many_times(self):
        desk.install(ZIP)
        for _ in range(TIMES):
            self.assertAlmostEqual(use(), 1, delta=0.05)
            with contextlib.redirect_stdout(self.said), contextlib.redirect_stderr(self.said):
                addon_utils.disable(NAME, default_set=True)
            self.assertEqual(mapped(), [], 'no library stays')
            self.assertFalse(hasattr(bpy.types.WindowManager, 'penpose'))
            with contextlib.redirect_stdout(self.said), contextlib.redirect_stderr(self.said):
                addon_utils.enable(NAME, default_set=True)
        self.told(self.said.getvalue())

    def test_characters_that_a_script_still_holds_end_with_the_library(self):
        desk.install(ZIP)
        from penpose_blender.library import Character, Error
        held = Character.built_in('builtin:demo')
        self.assertGreater(len(held.evaluate()), 0)
        addon_utils.disable(NAME, default_set=True)
        with self.assertRaisesRegex(Error, 'unloaded'):
            held.evaluate()
        with self.assertRaisesRegex(Error, 'unloaded'):
            held.solve()
        with self.assertRaisesRegex(Error, 'unloaded'):
            Character.built_in('builtin:demo')
        addon_utils.enable(NAME, default_set=True)
        with self.assertRaises(Error):
            held.evaluate()
        held.__del__()
        self.assertGreater(len(Character.built_in('builtin:demo').evaluate()), 0, 'what a script imported goes on')
        self.assertAlmostEqual(use(), 1, delta=0.05)

    def test_the_packages_of_the_add_on_and_of_python_are_two(self):
        desk.install(ZIP)
        python = os.path.join(os.path.dirname(os.path.abspath(__file__)), '..', '..', '..', 'ui', 'python')
        os.environ['PENPOSE_LIBRARY'] = mapped()[0]
        sys.path.insert(0, python)
        try:
            package = importlib.import_module('penpose')
            head = package.Character.built_in('builtin:demo')
            addon_utils.disable(NAME, default_set=True)
            self.assertGreater(len(head.evaluate()), 0, 'the package goes on without the add-on')
            sys.modules['penpose._c'].unload()
            self.assertEqual(mapped(), [])
        finally:
            sys.path.remove(python)
            del os.environ['PENPOSE_LIBRARY']
        self.assertIsNot(package, sys.modules[NAME])

    def test_a_zip_of_another_system_says_so_in_a_line(self):
        desk.install(ZIP)
        from penpose_blender import native
        addon_utils.disable(NAME, default_set=True)
        path = os.path.join(os.path.dirname(sys.modules[NAME].__file__), 'native.py')
        with open(path, encoding='utf-8') as f:
            text = f.read()
        with open(path, 'w', encoding='utf-8') as f:
            f.write(text.replace("'%s'" % native.system(), "'vax-780'"))
        with contextlib.redirect_stdout(self.said), contextlib.redirect_stderr(self.said):
            addon_utils.enable(NAME, default_set=True)
        lines = [line for line in self.said.getvalue().splitlines() if 'not disabled' not in line]
        self.assertEqual(len(lines), 1, self.said.getvalue())
        self.assertRegex(lines[0], 'penpose is not ready: .* only for vax-780')
        with contextlib.redirect_stdout(self.said), contextlib.redirect_stderr(self.said):
            addon_utils.disable(NAME, default_set=True)
            bpy.ops.preferences.addon_install(overwrite=True, filepath=ZIP)
            addon_utils.enable(NAME, default_set=True)
        self.assertAlmostEqual(use(), 1, delta=0.05)
        self.told(self.said.getvalue())


def in_window():
    """From a timer, once windows are drawn."""
    try:
        trial.main('updating')
    finally:
        os._exit(1)


if __name__ == '__main__':
    if bpy.app.background:
        trial.main(__name__)
    bpy.context.preferences.view.show_splash = False
    # What a script of the command line defines is gone when it has ended.
    bpy.app.timers.register(importlib.import_module('updating').in_window, first_interval=2)
