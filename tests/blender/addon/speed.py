"""What an event of the pen costs: penpose under 2 ms of 8 ms at p99 on a face of 26719 vertices and 53 keys; and a pose by script, under
5 ms. ZIP FOLDER"""
import json
import os
import sys
import time
import unittest

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import desk  # noqa: E402
import bpy  # noqa: E402
import numpy as np  # noqa: E402
import trial  # noqa: E402

desk.install(desk.ARGUMENTS[0])
import face_rig  # noqa: E402
import made  # noqa: E402
from penpose_blender import drawing, placing  # noqa: E402
from penpose_blender.rig import give_back  # noqa: E402

OURS_MS, WHOLE_MS = 2.0, 8.0
POSE_MS = 5.0
PASSES = 5  # the best of them counts: others use the machine too


class Speed(unittest.TestCase):
    def one_pass(self, obj, shown, line):
        for key in obj.data.shape_keys.key_blocks:
            key.value = 0
        bpy.context.view_layer.update()
        stroke, ours, whole, thread = drawing.Stroke(obj, 'target', shown, 1), [], [], []
        for place in line:
            begin, used, own = time.perf_counter(), time.process_time(), time.thread_time()
            stroke.add(place)
            stroke.follow()
            ours.append(1e3 * (time.process_time() - used))
            bpy.context.view_layer.update()
            whole.append(1e3 * (time.perf_counter() - begin))
            thread.append(1e3 * (time.thread_time() - own))
        begin = time.perf_counter()
        stroke.end(obj)
        return [np.percentile(one, [50, 99]) for one in (ours, whole, thread)] + [1e3 * (time.perf_counter() - begin)]

    def test_events(self):
        with open(trial.model('ict_face_pose_cases.json'), encoding='utf-8') as f:
            one = json.load(f)['cases'][0]['references'][0]
        obj = desk.opened(trial.model('ict_face.glb'))
        shown = desk.seen(obj)
        rest = drawing.known(obj).rig.character.evaluate()
        desk.draw(obj, 'reference', shown, desk.region_places(shown, rest[one['vertices']]))
        target = desk.region_places(shown, np.array(one['target']))
        ends = np.linspace(0, len(target) - 1, 300)
        line = np.column_stack([np.interp(ends, range(len(target)), target[:, i]) for i in (0, 1)])
        best = [1e9, 1e9]
        # Auto Smooth, which the importer turns on, is most of what Blender itself takes.
        for smooth in (True, False):
            obj.data.use_auto_smooth = smooth
            for _ in range(PASSES if not smooth else 1):
                ours, whole, thread, end = self.one_pass(obj, shown, line)
                print('300 events%s, ms: ours %.2f (p99 %.2f) of the processor, with Blender %.2f (p99 %.2f), '
                      'of its main thread %.2f (p99 %.2f); pen-up %.0f' % (
                          ' with Auto Smooth' if smooth else '', *ours, *whole, *thread, end))
                best = [min(best[0], ours[1]), min(best[1], whole[1])]
        self.assertLess(best[0], OURS_MS)
        busy = os.getloadavg()[0]
        if busy > 1:
            print('whole events are not judged: others use the machine (load %.1f)' % busy)
            return
        self.assertLess(best[1], WHOLE_MS)

    def test_poses_by_script(self):
        for model in ('ict_face.glb', 'ict_avatar.glb'):
            obj = desk.opened(trial.model(model))
            with open(trial.model('ict_face_landmarks.json'), encoding='utf-8') as f:
                corner = json.load(f)['curves']['lip_upper_outer']['vertices'][:1]
            curve = placing.place_curve(obj, corner)
            known = drawing.known(obj)
            rest, begin_pose = known.rig.character.positions(known.numbers[curve]), known.rig.kept()
            size, random, took = desk.size_of(known.rig.surface.rest), np.random.default_rng(1), []
            for way in random.uniform(-0.005, 0.005, (200, 3)):
                give_back(begin_pose)
                used = time.process_time()
                placing.place_target(obj, curve, rest + size * way)
                placing.solve(obj)
                took.append(1e3 * (time.process_time() - used))
            print('%s: 200 poses by script, ms of the processor: %.2f (p99 %.2f)' % (model, *np.percentile(took, [50, 99])))
            if model == 'ict_face.glb':
                self.assertLess(np.mean(took), POSE_MS)

    def character(self, what, obj, line, shift, shown=None):
        """Events on another character: a line along vertices of it, drawn to where they lie after shift(True)."""
        surface = drawing.known(obj, measured=False).rig.surface
        shown = shown or desk.seen(obj)
        here = desk.region_places(shown, surface.look()[line])
        shift(True)
        there = desk.region_places(shown, surface.look()[line])
        shift(False)
        surface.look()
        begin = time.perf_counter()
        desk.draw(obj, 'reference', shown, here)
        found = time.perf_counter() - begin
        ends = np.linspace(0, len(there) - 1, 300)
        target = np.column_stack([np.interp(ends, range(len(there)), there[:, i]) for i in (0, 1)])
        best = [1e9, 1e9, 1e9]
        for _ in range(PASSES):
            stroke, token = drawing.Stroke(obj, 'target', shown, 1), drawing.plain_normals(obj)
            bpy.context.view_layer.update()
            ours, whole, thread = [], [], []
            for place in target:
                begin, used, own = time.perf_counter(), time.process_time(), time.thread_time()
                stroke.add(place)
                stroke.follow()
                ours.append(1e3 * (time.process_time() - used))
                bpy.context.view_layer.update()
                whole.append(1e3 * (time.perf_counter() - begin))
                thread.append(1e3 * (time.thread_time() - own))
            stroke.cancel(obj)
            drawing.normals_back(token)
            bpy.context.view_layer.update()
            best = [min(b, np.percentile(one, 99)) for b, one in zip(best, (ours, whole, thread))]
        print('%s: %d vertices in %d meshes; reference %.2f s; p99 of an event, ms: ours %.2f of the processor, '
              'with Blender %.2f, of its main thread %.2f' % (
            what, surface.count, len(surface.parts), found, *best))
        self.assertLess(best[0], OURS_MS)
        if os.getloadavg()[0] > 1:
            print('whole events are not judged: others use the machine (load %.1f)' % os.getloadavg()[0])
            return
        self.assertLess(best[1], WHOLE_MS)
        self.assertLess(found, 2)

    def test_five_meshes(self):
        obj = desk.opened(trial.model('ict_avatar.glb'))
        with open(trial.model('ict_face_landmarks.json'), encoding='utf-8') as f:
            line = json.load(f)['curves']['lip_upper_outer']['vertices']
        keys = [obj.data.shape_keys.key_blocks[n] for n in ('mouthSmile_L', 'mouthSmile_R')]

        def shift(on):
            for key in keys:
                key.value = 0.8 if on else 0.0
        self.character('five meshes', obj, line, shift, face_rig.seen(obj, drawing.known(obj).rig))

    def test_face_of_handles(self):
        made.empty_file()
        obj = face_rig.head()
        armature = face_rig.rig(obj)

        def shift(on):
            for side, x in (('L', 0.06), ('R', -0.06)):
                face_rig.place(armature.pose.bones['lips.' + side], (x, 0, 0.09) if on else (0, 0, 0))
        self.character('a face of handles', obj, face_rig.along(obj, 'lip.T'), shift)

    def test_rigify(self):
        if not any(m.__name__ == 'rigify' for m in desk.addon_utils.modules()):
            self.skipTest('Blender has no Rigify here')
        obj, armature, curves = face_rig.rigify(trial.model('ict_avatar.glb'), trial.model('ict_face_landmarks.json'))

        def shift(on):
            for side, x in (('L', 0.006), ('R', -0.006)):
                face_rig.place(armature.pose.bones['lips.' + side], (x, 0, 0.009) if on else (0, 0, 0))
        self.character('Rigify', obj, curves['lip_upper_outer'], shift, face_rig.seen(obj, drawing.known(obj, measured=False).rig))

    def test_board(self):
        made.empty_file()
        obj = made.plate('Face', 161)
        for name, way, z in (('smile', (0, 0, 0.3), 0.5), ('wide', (0.3, 0, 0), -0.5)):
            made.add_key(obj, name, way, middle=(0, z))
        board = bpy.data.objects.new('Board', None)
        bpy.context.scene.collection.objects.link(board)
        made.drive(obj.data.shape_keys, 'key_blocks["smile"].value', board, 'location[2]')
        bpy.context.view_layer.update()

        def shift(on):
            board.location.z = 0.7 if on else 0.0
        self.character('a board', obj, made.row(obj), shift)


if __name__ == '__main__':
    trial.main(__name__)
