"""Drawings by Grease Pencil pose faces, one drawing on each frame. ZIP FOLDER"""
import os
import re
import subprocess
import sys
import time
import unittest

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import desk  # noqa: E402
import bpy  # noqa: E402
import numpy as np  # noqa: E402
import trial  # noqa: E402

desk.install(desk.ARGUMENTS[0])
from penpose_blender import drawing, grease, pencil_film, versions  # noqa: E402
from penpose_blender.controls import Refused  # noqa: E402
from penpose_blender.library import Character  # noqa: E402

POSES = {3: {'jawOpen': 0.6, 'mouthSmile_L': 0.7, 'mouthSmile_R': 0.7}, 10: {'browInnerUp_L': 0.8, 'browInnerUp_R': 0.8}, 18: {'jawOpen': 0.9}}
NEAR = 0.1  # of a value, in which lines that were drawn by the pose give it back
SHEET = 2e-4  # m a px, wherever the sheet lies


def demo_path():
    path = os.path.join(desk.SCRATCH, 'demo.glb')
    with open(path, 'wb') as f:
        f.write(Character.built_in('builtin:demo').write('.glb'))
    return path


class Drawn(unittest.TestCase):
    """Lines on sheets of Grease Pencil."""

    def opened(self, path):
        self.obj = desk.opened(path)
        self.shown, self.scene = desk.seen(self.obj), bpy.context.scene

    def film(self, pencil):
        one = pencil_film.Film(self.obj, pencil, self.shown)
        while one.step():
            pass
        return one


class Faces(Drawn):
    """A face whose features are found, on sheets that the program draws."""

    def setUp(self):
        if not trial.PROGRAM:
            self.skipTest('PENPOSE does not say where the program is')
        self.path = trial.model('ict_face.glb')
        self.opened(self.path)

    def lines(self, pose):
        """The feature lines that the program draws of a pose, on a sheet beside the head."""
        svg = os.path.join(desk.SCRATCH, 'lines.svg')
        settings = [word for item in pose.items() for word in ('--set', '%s=%s' % item)]
        subprocess.run([trial.PROGRAM, 'render', self.path, *settings, '--view', 'front', '--lines', '-o', svg], check=True)
        with open(svg, encoding='utf-8') as f:
            found = re.findall(r'<path id="(\w+)" d="([^"]*)"', f.read())
        self.names = [name for name, _ in found if not name.startswith('silhouette')]
        px = [np.array(re.findall(r'([\d.]+) ([\d.]+)', d), dtype=float) - 512 for name, d in found if name in self.names]
        return [np.column_stack([SHEET * line[:, 0] + 0.3, np.full(len(line), -0.4), -SHEET * line[:, 1]]) for line in px]

    def values(self, pose):
        names = [p.name for p in drawing.known(self.obj).rig.character.parameters]
        return {name: value for name, value in zip(names, pose) if abs(value) > 1e-6}

    def near(self, found, pose):
        for name in {*found, *pose}:
            self.assertAlmostEqual(found.get(name, 0), pose.get(name, 0), delta=NEAR, msg=name)

    def test_a_pencil_test_becomes_an_animation(self):
        pencil = desk.pencil([('Face', {frame: self.lines(pose) for frame, pose in POSES.items()})])
        begin = time.perf_counter()
        film = self.film(pencil)
        self.assertEqual(film.left, [])
        for frame, pose in POSES.items():
            self.near(self.values(film.poses[frame]), pose)
        self.scene.frame_set(7)
        self.assertEqual(drawing.known(self.obj).rig.character.evaluate().tolist(), drawing.known(self.obj).rig.character.evaluate([0] * 53).tolist(),
                         'reading moves nothing')
        moving = film.key(self.scene)
        print('%d drawings: %.0f ms each' % (len(POSES), 1e3 * (time.perf_counter() - begin) / len(POSES)))
        self.assertEqual(self.scene.frame_current, 7)
        owner, blocks = self.obj.data.shape_keys, self.obj.data.shape_keys.key_blocks
        self.assertEqual({c.data_path for c in versions.curves_of(owner)}, {'key_blocks["%s"].value' % c.name for c in moving})
        for curve in versions.curves_of(owner):
            self.assertEqual([p.co.x for p in curve.keyframe_points], list(POSES))
        for frame, pose in POSES.items():
            self.scene.frame_set(frame)
            self.near({key.name: key.value for key in blocks[1:] if key.value}, pose)

    def test_all_layers_are_one_drawing(self):
        lines, rest = self.lines(POSES[3]), self.lines({})
        brows, mouth = lines[:2], lines[2:]
        pencil = desk.pencil([('Brows', {1: brows}), ('Mouth target', {1: rest}), ('Neutral', {1: rest}), ('Mouth', {1: rest[2:], 3: mouth})])
        found = grease.drawings_of(pencil)
        self.assertEqual({frame: (len(a), len(b)) for frame, (a, b) in found.items()}, {1: (len(rest), len(rest)), 3: (len(lines), len(rest))})
        pose, unknown = pencil_film.read(drawing.known(self.obj).rig, *found[3], self.shown.view)
        self.assertEqual(unknown, 0)
        self.near(self.values(pose), POSES[3])
        pencil.data.layers['Brows'].hide = True
        self.assertEqual(len(grease.drawings_of(pencil)[3][0]), len(mouth))


class Sheets(Drawn):
    """What counts as a drawing."""

    def setUp(self):
        self.opened(demo_path())

    def lines(self, high=0.0):
        """Two brows and a mouth, of a kind."""
        x = np.linspace(-0.05, 0.05, 9)
        return [np.column_stack([x, np.full(9, -0.4), z + high * x * x]) for z in (0.1, 0.05, 0)]

    def test_a_blank_frame_has_no_key(self):
        pencil = desk.pencil([('Face', {1: self.lines(), 5: [], 9: self.lines(4)})])
        self.assertEqual(list(grease.drawings_of(pencil)), [1, 9])

    def test_moved_layers(self):
        pencil = desk.pencil([('Face', {1: self.lines()})])
        before = grease.drawings_of(pencil)[1][0][0]
        layer = pencil.data.layers[0]
        setattr(layer, 'location' if hasattr(layer, 'location') else 'translation', (0, 0, 0.25))
        bpy.context.view_layer.update()
        after = grease.drawings_of(pencil)[1][0][0]
        self.assertTrue(np.allclose(after - before, (0, 0, 0.5), atol=1e-5))

    def test_told(self):
        with self.assertRaisesRegex(Refused, '^Pencil has no drawing; draw the face with Grease Pencil'):
            self.film(desk.pencil([('Face', {})]))
        pencil = desk.pencil([('Face', {9: self.lines()})])
        with self.assertRaisesRegex(Refused, 'has no drawing on this frame'):
            grease.shown_on_frame(pencil, 3)

    def test_no_face(self):
        bpy.ops.mesh.primitive_cube_add()
        self.obj = bpy.context.object
        self.obj.shape_key_add(name='Basis')
        self.obj.shape_key_add(name='up').data[0].co.z += 1
        film = self.film(desk.pencil([('Face', {2: self.lines()})]))
        self.assertEqual(len(film.left), 1)
        self.assertRegex(film.left[0], '^frame 2 is left out: ')
        self.assertEqual(film.key(self.scene), [])
        self.assertIsNone(self.obj.data.shape_keys.animation_data)


if __name__ == '__main__':
    trial.main(__name__)
