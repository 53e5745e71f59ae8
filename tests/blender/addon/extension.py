"""The add-on as an extension, as Blender 4.2 and later install it: used, updated and taken away in one session (../releases.sh). ZIP"""
import importlib
import os
import sys
import unittest

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import desk  # noqa: E402
import addon_utils  # noqa: E402
import bpy  # noqa: E402
import trial  # noqa: E402
import updating  # noqa: E402

ZIP, NAME = os.path.abspath(desk.ARGUMENTS[0]), 'bl_ext.user_default.penpose_blender'
TIMES = 5


def module(name):
    return importlib.import_module('%s.%s' % (NAME, name))


def use():
    """Brings a line of a sheet to where a key has it; the names of the controls that moved."""
    obj = updating.sheet()
    key = obj.data.shape_keys.key_blocks['Lift']
    middle = [i for i, v in enumerate(obj.data.vertices) if abs(v.co.y) < 0.01 and abs(v.co.x) < 0.6]
    placing, drawing = module('placing'), module('drawing')
    curve = placing.place_curve(obj, middle)
    aim = [tuple(key.data[i].co) for i in middle]
    placing.place_target(obj, curve, drawing.known(obj).rig.mesh.space.of_object(aim))
    return [c.name for c in placing.solve(obj)]


@unittest.skipIf(bpy.app.version < (4, 2, 0), 'Blender has no extensions')
class Extension(unittest.TestCase):
    def test_used_updated_and_taken_away(self):
        zips, folders = [ZIP, desk.another(ZIP, '0.9.1')], set()
        for i in range(TIMES):
            done = bpy.ops.extensions.package_install_files(filepath=zips[i % 2], repo='user_default', enable_on_install=True, overwrite=True)
            self.assertEqual(done, {'FINISHED'})
            self.assertTrue(addon_utils.check(NAME)[1], 'it is enabled')
            self.assertEqual(use(), ['Lift'])
            self.assertEqual(len(updating.mapped()), 1)
            folders.add(os.path.dirname(updating.mapped()[0]))
        self.assertEqual(len(folders), 2, 'each version has its library')
        self.assertNotIn('penpose_blender', sys.modules, 'nothing asks for it by a name that it has as an add-on')
        bpy.ops.preferences.addon_disable(module=NAME)
        self.assertEqual(updating.mapped(), [])
        self.assertEqual([f for f in folders if os.path.exists(f)], [], 'copies go with it')


if __name__ == '__main__':
    trial.main(__name__)
