"""Small lines are lines: a smile on a mouth of 60, 120 and 300 px moves what smiles, on keys, five meshes and Rigify's face. ZIP FOLDER"""
import json
import math
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import desk  # noqa: E402
import addon_utils  # noqa: E402
import bpy  # noqa: E402
import numpy as np  # noqa: E402
import trial  # noqa: E402
from mathutils import Matrix, Vector  # noqa: E402

desk.install(desk.ARGUMENTS[0])
import face_rig  # noqa: E402
import made  # noqa: E402
from penpose_blender import drawing, space  # noqa: E402
from penpose_blender.rig import give_back  # noqa: E402

WIDTHS = (60, 120, 300)  # px of the mouth
WIDE, HIGH = 1000, 700  # px of the view
LEFT = 0.5  # of how far off the corners were drawn, at most


def near(obj, places, width):
    """A view from the front in which places of the character are so many px wide."""
    world = space.Space(obj.matrix_world).to_world(places)
    middle, zoom = Vector(world.mean(axis=0)), 2.0
    distance = zoom * 0.5 * HIGH * float(np.linalg.norm(world[-1] - world[0])) / width
    camera = Matrix.Translation(middle) @ Matrix.Rotation(math.radians(90), 4, 'X') @ Matrix.Translation((0, 0, distance))
    least, most = 0.01 * distance, 10 * distance
    window = Matrix(((zoom * HIGH / WIDE, 0, 0, 0), (0, zoom, 0, 0),
                     (0, 0, (most + least) / (least - most), 2 * most * least / (least - most)), (0, 0, -1, 0)))
    return space.seen_by(camera.inverted(), window, WIDE, HIGH, space.Space(obj.matrix_world), middle)


def smiling(line, width):
    """The line of a mouth, as a hand draws it smiling."""
    along = (line[:, 0] - line[:, 0].mean()) / (0.5 * width)
    return line + np.column_stack([0.08 * width * along, 0.1 * width * along ** 2]) + np.random.default_rng(3).normal(0, 0.3, line.shape)


class Small(made.Trial):
    def smiles(self, what, obj, vertices, wanted):
        """`wanted`: names of what may move."""
        for width in WIDTHS:
            with self.subTest(what=what, width=width):
                drawing.delete(obj)
                surface = drawing.known(obj, measured=False).rig.surface
                shown = near(obj, surface.look()[vertices], width)
                here = desk.region_places(shown, surface.look()[vertices])
                there = smiling(here, width)
                desk.draw(obj, 'reference', shown, here)
                kept = drawing.known(obj).rig.kept()
                moved = desk.draw(obj, 'target', shown, there)
                end = desk.region_places(shown, surface.look()[vertices])
                off = [float(np.linalg.norm(line[[0, -1]] - there[[0, -1]], axis=1).max()) for line in (here, end)]
                print('%s, %d px wide: corners %.1f px off, %.1f px afterwards' % (what, width, *off))
                self.assertLess(off[1], LEFT * off[0])
                self.assertLessEqual({getattr(c, 'bone', '') or c.name for c in moved}, wanted)
                drawing.delete(obj)
                give_back(kept)
                bpy.context.view_layer.update()

    def mouth(self):
        with open(trial.model('ict_face_landmarks.json'), encoding='utf-8') as f:
            return json.load(f)['curves']['lip_upper_outer']['vertices']

    def test_keys(self):
        self.smiles('keys', desk.opened(trial.model('ict_face.glb')), self.mouth(), {'mouthSmile_L', 'mouthSmile_R'})

    def test_five_meshes(self):
        self.smiles('five meshes', desk.opened(trial.model('ict_avatar.glb')), self.mouth(), {'mouthSmile_L', 'mouthSmile_R'})

    def test_handles(self):
        obj = face_rig.head()
        face_rig.rig(obj)
        self.smiles('a face of handles', obj, face_rig.along(obj, 'lip.T'), {'lips.L', 'lips.R'})

    def test_rigify(self):
        if not any(m.__name__ == 'rigify' for m in addon_utils.modules()):
            self.skipTest('Blender has no Rigify here')
        obj, _, curves = face_rig.rigify(trial.model('ict_avatar.glb'), trial.model('ict_face_landmarks.json'))
        self.smiles('Rigify', obj, curves['lip_upper_outer'], {'lips.L', 'lips.R'})


if __name__ == '__main__':
    trial.main(__name__)
