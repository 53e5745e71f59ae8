"""Blender that starts in the background with the add-on enabled in its preferences. ZIP"""
import os
import subprocess
import sys
import unittest

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import desk  # noqa: E402
import bpy  # noqa: E402
import trial  # noqa: E402

ENABLE = """
import addon_utils, bpy
bpy.ops.preferences.addon_install(overwrite=True, filepath=%r)
addon_utils.enable('penpose_blender', default_set=True)
bpy.ops.wm.save_userpref()
"""
LOOK = """
import addon_utils, bpy
print('enabled', addon_utils.check('penpose_blender'), hasattr(bpy.types.WindowManager, 'penpose'))
addon_utils.disable('penpose_blender')
print('disabled', hasattr(bpy.types.WindowManager, 'penpose'))
"""


class Startup(unittest.TestCase):
    def run_blender(self, home, *arguments):
        """What a Blender with its own preferences says."""
        place = {**{k: v for k, v in os.environ.items() if not k.startswith(('BLENDER_USER', 'XDG_'))}, 'HOME': home}
        done = subprocess.run([bpy.app.binary_path, '--background', *arguments], env=place, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                              text=True, timeout=300, check=False)
        return done.stdout

    def test_enabled_in_the_preferences(self):
        home = os.path.join(desk.SCRATCH, 'home')
        os.mkdir(home)
        self.run_blender(home, '--factory-startup', '--python-expr', ENABLE % os.path.abspath(desk.ARGUMENTS[0]))
        said = self.run_blender(home, '--python-expr', LOOK)
        self.assertNotRegex(said, 'Traceback|Error|Exception')
        self.assertIn('enabled (True, True) True', said)
        self.assertIn('disabled False', said)


if __name__ == '__main__':
    trial.main(__name__)
