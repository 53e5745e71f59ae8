"""Drawing in Blender gives what the library gives, and Blender shows what the library computes. ZIP FOLDER"""
import json
import os
import subprocess
import sys
import unittest

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import desk  # noqa: E402
import bpy  # noqa: E402
import numpy as np  # noqa: E402
import trial  # noqa: E402

desk.install(desk.ARGUMENTS[0])
import made  # noqa: E402
from penpose_blender import drawing, placing, recording  # noqa: E402
from penpose_blender.controls import Refused  # noqa: E402
from penpose_blender.library import Character  # noqa: E402

SAME, SHOWN = 1e-6, 1e-5
worst = {'pose': 0.0, 'shown': 0.0}


def cases_of(name):
    with open(trial.model(name), encoding='utf-8') as f:
        return json.load(f)['cases']


class Posing(unittest.TestCase):
    def shows_it(self, obj):
        """Blender shows the vertices where the character has them."""
        character = drawing.known(obj).rig.character
        drawing.known(obj).rig.take_pose()
        ours = character.evaluate()
        off = float(np.abs(desk.shown_positions(obj) - ours).max()) / desk.size_of(ours)
        worst['shown'] = max(worst['shown'], off)
        self.assertLess(off, SHOWN, 'vertices of ' + obj.name)

    def draws_as(self, obj, twins, shown, reference, target):
        """A reference and its target, places (n, 2) of the region, in Blender and on each twin: the same pose."""
        rig = drawing.known(obj).rig
        desk.draw(obj, 'reference', shown, reference)
        self.shows_it(obj)
        moved = desk.draw(obj, 'target', shown, target)
        self.shows_it(obj)
        names = [p.name for p in rig.character.parameters]
        for twin in twins:
            number = twin.draw(shown.view, shown.px(reference))
            twin.draw_target(number, shown.view, shown.px(target))
            values = twin.values()
            off = max(abs(values[name] - value) for name, value in zip(names, rig.pose()))
            worst['pose'] = max(worst['pose'], off)
            self.assertLess(off, SAME, 'pose of ' + obj.name)
        return moved

    def draw_cases(self, obj, cases, twins=(), vertices_of=None):
        """Each case on a new twin of what Blender has, and further twins that are put to the same pose."""
        count = 0
        for case in cases:
            drawing.delete(obj)
            rig = drawing.known(obj).rig
            rig.take_pose()
            rest = rig.character.evaluate()
            all_twins = [Character.read(rig.character.write('.glb'), 'twin.glb')]
            for twin in twins:
                twin.clear()
                for name, value in rig.character.values().items():
                    twin.set(name, value)
                all_twins.append(twin)
            shown = desk.seen(obj, case.get('view_yaw_degrees', 0))
            for one in case['references'][:2]:
                vertices = np.array(one['vertices'] if vertices_of is None else vertices_of(one['vertices']))
                moved = self.draws_as(obj, all_twins, shown, desk.region_places(shown, rest[vertices]),
                                      desk.region_places(shown, np.array(one['target'])))
                count += len(moved)
        self.assertGreater(count, 0, 'nothing moved')

    @classmethod
    def tearDownClass(cls):
        print('worst: pose %.1e of the library\'s, vertices %.1e of the size' % (worst['pose'], worst['shown']))

    def test_ict_face(self):
        path = trial.model('ict_face.glb')
        obj = desk.opened(path)
        with open(path, 'rb') as f:
            file = Character.read(f.read(), 'ict_face.glb')
        self.assertFalse(drawing.known(obj).rig.measured)
        self.assertTrue(np.array_equal(file.evaluate(), drawing.known(obj).rig.character.evaluate()))
        self.draw_cases(obj, cases_of('ict_face_pose_cases.json'), [file])

    def test_cesium_man_at_rest_and_walking(self):
        obj = desk.opened(trial.model('cesium_man.glb'))
        armature = obj.find_armature()
        for frame in (1, 20):
            bpy.context.scene.frame_set(frame)
            drawing.delete(obj)
            self.assertFalse(drawing.known(obj).rig.measured)
            drawing.known(obj).rig.take_pose()
            self.shows_it(obj)
            before = {b.name: b.matrix_basis.copy() for b in armature.pose.bones}
            rest = drawing.known(obj).rig.character.evaluate()
            case = cases_of('cesium_body_cases.json')[0]
            vertices = case['references'][0]['vertices']
            line = rest[vertices]
            target = line + np.linspace(0, 1, len(line))[:, None] * [0.02, 0.1, 0.05]
            self.draw_cases(obj, [{'view_yaw_degrees': 90, 'references': [{'vertices': vertices, 'target': target}]}])
            moved = [b.name for b in armature.pose.bones if (b.matrix_basis - before[b.name]).to_quaternion() and
                     max(abs(x) for row in b.matrix_basis - before[b.name] for x in row) > 1e-5]
            self.assertTrue(0 < len(moved) < len(before), 'the pose on the frame stays where nothing was drawn: %s' % moved)

    def test_demo_head(self):
        path = os.path.join(desk.SCRATCH, 'demo.glb')
        with open(path, 'wb') as f:
            f.write(Character.built_in('builtin:demo').write('.glb'))
        obj = desk.opened(path)
        drawn = 0
        for key in obj.data.shape_keys.key_blocks[1:]:
            character = drawing.known(obj).rig.character
            rest = character.evaluate()
            pose = np.array([1.0 if p.name == key.name else 0.0 for p in character.parameters])
            there = character.evaluate(pose)
            # Seen from the front, and no corrective, which goes along with another key.
            across = np.linalg.norm((there - rest)[:, :2], axis=1)
            if across.max() < 0.015 * desk.size_of(rest):
                continue
            facing = rest[:, 2] > rest[np.argmax(across), 2] - 0.03 * desk.size_of(rest)
            moves = across * facing > 0.6 * across.max()
            shown = desk.seen(obj)
            there = shown.view.project(there[moves])
            at = shown.view.project(rest[moves])
            middle, way, half = at.mean(axis=0), (there - at).mean(axis=0), 0.4 * np.ptp(at[:, 0])
            line = middle + np.linspace(-half, half, 15)[:, None] * [1, 0]
            twin = Character.read(character.write('.glb'), 'twin.glb')
            drawn += bool(self.draws_as(obj, [twin], shown, shown.places(line), shown.places(line + way)))
            drawing.delete(obj)
            self.reset(obj)
        self.assertGreater(drawn, 4)

    def test_a_rig_that_changes_between_target_and_solve(self):
        made.empty_file()
        obj = made.plate()
        for name in ('up', 'up too'):
            made.add_key(obj, name, (0, 0, 0.3), middle=(0, 0.5))
        line = made.row(obj, 0.5)
        curve = placing.place_curve(obj, line)

        def lift():
            known = drawing.known(obj)
            placing.place_target(obj, curve, known.rig.character.positions(known.numbers[curve]) + [0, 0.2, 0])
        keys = obj.data.shape_keys.key_blocks
        lift()
        keys['up'].mute = True
        self.assertEqual([c.name for c in placing.solve(obj)], ['up too'])
        keys['up too'].value = 0
        keys['up'].mute = False
        lift()
        keys['up too'].slider_max = 0.01
        self.assertIn('up', [c.name for c in placing.solve(obj)])
        drawing.delete(obj, curve)
        with self.assertRaisesRegex(Refused, 'Plate has no curve'):
            placing.place_target(obj, curve, np.zeros((len(line), 3)))

    def reset(self, obj):
        for key in obj.data.shape_keys.key_blocks[1:]:
            key.value = 0
        drawing.known(obj).rig.take_pose()

    def test_ict_avatar(self):
        obj = desk.opened(trial.model('ict_avatar.glb'))
        self.assertFalse(drawing.known(obj).rig.measured)
        self.draw_cases(obj, cases_of('ict_avatar_intent_cases.json')[:6])
        arm = next(o for o in bpy.data.objects if o.type == 'MESH' and o != obj and o.find_armature() and len(o.data.vertices) > 500)
        self.shows_it(arm)

    def test_cases_of_the_command_line(self):
        if not trial.PROGRAM:
            self.skipTest('PENPOSE does not say where the program is')
        path, off = trial.model('ict_face.glb'), {}
        for case in cases_of('ict_face_pose_cases.json'):
            # How exact a curve is meant to be depends on all of a file.
            alone = os.path.join(desk.SCRATCH, 'alone.json')
            with open(alone, 'w', encoding='utf-8') as f:
                json.dump({'mesh': 'ict_face.glb', 'cases': [case]}, f)
            done = subprocess.run([trial.PROGRAM, 'pose', path, '--cases', alone, '--json'], capture_output=True, text=True, check=True)
            obj = desk.opened(path)
            for one in case['references']:
                placing.place_target(obj, placing.place_curve(obj, one['vertices']), one['target'])
            for one in case['constraints']:
                placing.place_curve(obj, one['vertices'], 'constraint')
            self.assertTrue(placing.solve(obj), case['name'])
            self.shows_it(obj)
            keys, answers = obj.data.shape_keys.key_blocks, json.loads(done.stdout)['cases'][0]['parameters']
            off[case['name']] = max(abs(keys[name].value - value) for name, value in answers.items())
        worst['pose'] = max(worst['pose'], *off.values())
        self.assertLess(max(off.values()), SAME, off)

    def test_limbs_of_the_command_line(self):
        """Bones lie otherwise in Blender than in the file, and yet turn so that each vertex is where the command line has it."""
        if not trial.PROGRAM:
            self.skipTest('PENPOSE does not say where the program is')
        path = trial.model('cesium_man.glb')
        for case in cases_of('cesium_body_cases.json'):
            alone, posed = os.path.join(desk.SCRATCH, 'alone.json'), os.path.join(desk.SCRATCH, 'posed.obj')
            with open(alone, 'w', encoding='utf-8') as f:
                json.dump({'mesh': 'cesium_man.glb', 'cases': [case]}, f)
            subprocess.run([trial.PROGRAM, 'pose', path, '--cases', alone, '-o', posed], capture_output=True, check=True)
            obj = desk.opened(path)
            armature = obj.find_armature()
            armature.animation_data_clear()
            for bone in armature.pose.bones:
                bone.matrix_basis.identity()
            bpy.context.view_layer.update()
            for one in case['references']:
                placing.place_target(obj, placing.place_curve(obj, one['vertices']), desk.of_file(obj, one['target']))
            for one in case['constraints']:
                placing.place_curve(obj, one['vertices'], 'constraint')
            self.assertTrue(placing.solve(obj), case['name'])
            bpy.context.view_layer.update()
            with open(posed, encoding='utf-8') as f:
                wanted = desk.of_file(obj, [[float(x) for x in line.split()[1:4]] for line in f if line.startswith('v ')])
            off = float(np.abs(desk.shown_positions(obj) - wanted).max()) / desk.size_of(wanted)
            worst['limbs'] = max(worst.get('limbs', 0.0), off)
            self.assertLess(off, SHOWN, case['name'])

    def test_session(self):
        if not trial.PROGRAM:
            self.skipTest('PENPOSE does not say where the program is')
        for name in ('ict_face.glb', 'cesium_man.glb'):
            obj = desk.opened(trial.model(name))
            session = os.path.join(desk.SCRATCH, name + '.session')
            recording.begin(obj, session)
            rest = drawing.known(obj).rig.character.evaluate()
            if name == 'ict_face.glb':
                one, yaw = cases_of('ict_face_pose_cases.json')[0]['references'][0], 0
            else:
                one, yaw = cases_of('cesium_body_cases.json')[0]['references'][0], 90
            shown = desk.seen(obj, yaw)
            desk.draw(obj, 'reference', shown, desk.region_places(shown, rest[one['vertices']]))
            recording.note(obj)
            line = rest[one['vertices']]
            for shift in (0.03, -0.03):
                target = line + np.linspace(0, 1, len(line))[:, None] * [0, shift * desk.size_of(rest), 0]
                self.assertTrue(desk.draw(obj, 'target', shown, desk.region_places(shown, target), of=1))
                recording.note(obj)
            file = recording.end(obj)
            done = subprocess.run([trial.PROGRAM, 'replay', file, '--model', os.path.splitext(file)[0] + '.glb', '--json'],
                                  capture_output=True, text=True)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertEqual(json.loads(done.stdout)['state'], drawing.known(obj).rig.character.state)


if __name__ == '__main__':
    trial.main(__name__)
