"""The sample that make_sample.py writes has a head, curves and keys that the pen goes on with. ZIP"""
import os
import subprocess
import sys
import unittest

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import desk  # noqa: E402
import bpy  # noqa: E402
import trial  # noqa: E402

desk.install(desk.ARGUMENTS[0])
import made  # noqa: E402
from penpose_blender import arcs, curves, drawing  # noqa: E402

SCRIPT = os.path.join(os.path.dirname(os.path.abspath(__file__)), '..', '..', '..', 'ui', 'blender', 'make_sample.py')


class Sample(unittest.TestCase):
    def test_it_is_made_and_drawn_on(self):
        path = os.path.join(desk.SCRATCH, 'sample.blend')
        done = subprocess.run([bpy.app.binary_path, '--background', '--factory-startup', '--python-exit-code', '1', '--python', SCRIPT, '--',
                               desk.ARGUMENTS[0], path], capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertNotIn('Traceback', done.stdout + done.stderr)
        bpy.ops.wm.open_mainfile(filepath=path)
        obj = bpy.data.objects['Head']
        self.assertEqual([(c['role'], 'target' in c) for c in curves.curves(obj)], [('reference', True)] * 3)
        keys = obj.data.shape_keys.key_blocks
        self.assertGreater(len(keys), 15)
        wanted = {12: ('mouth_corner_L', 'mouth_corner_R'), 24: ('brow_inner_L', 'brow_outer_L'), 36: ('jaw',)}
        for frame, names in wanted.items():
            bpy.context.scene.frame_set(frame)
            for name in names:
                self.assertGreater(keys[name].value, 0.25, '%s on %d' % (name, frame))
        bpy.context.scene.frame_set(12)
        drawing.known(obj)
        self.assertTrue(arcs.arcs_of(arcs.Times(obj), bpy.context.scene, bpy.context.window_manager.penpose))
        made.activate(obj)
        shown = desk.seen(obj)
        value = keys['jaw'].value
        self.assertTrue(desk.draw(obj, 'target', shown, made.curve_px(obj, shown) - (0, 15), of=curves.curves(obj)[-1]['id']))
        self.assertNotEqual(keys['jaw'].value, value)
        print('the sample has %.1f MB' % (os.path.getsize(path) / 1e6))


if __name__ == '__main__':
    trial.main(__name__)
