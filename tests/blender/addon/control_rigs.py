"""Control rigs: a face of handles, mechanism and carriers as Rigify makes them, by script; and Rigify's own where Blender has it. ZIP FOLDER"""
import os
import sys
import time

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import desk  # noqa: E402
import addon_utils  # noqa: E402
import bpy  # noqa: E402
import numpy as np  # noqa: E402
import trial  # noqa: E402

desk.install(desk.ARGUMENTS[0])
import face_rig  # noqa: E402
import made  # noqa: E402
from mathutils import Quaternion  # noqa: E402
from penpose_blender import drawing, versions  # noqa: E402
from penpose_blender.candidates import touchable  # noqa: E402

FOUND_S, PX = 2.0, 2.0  # in a view 1000 px high


def places_in_view(rig, shown, vertices):
    """Where the view shows vertices of the character, px."""
    return desk.region_places(shown, rig.surface.look()[vertices])


class Control(made.Trial):
    def drawn(self, obj, armature, vertices, shift, shown=None):
        """A line along vertices, drawn where shift(bones) brings them: how far the rig ends from it (px), what moved, and the time to find."""
        rig = drawing.known(obj, measured=False).rig
        shown = shown or face_rig.seen(obj, rig)
        before = made.state_of(armature)
        here = places_in_view(rig, shown, vertices)
        shift(armature.pose.bones)
        there = places_in_view(rig, shown, vertices)
        face_rig.rest(armature)
        self.assertEqual(made.state_of(armature), before)
        desk.draw(obj, 'reference', shown, here)
        one = drawing.known(obj)
        self.found = one.rig.took_s
        moved = desk.draw(obj, 'target', shown, there)
        bpy.context.view_layer.update()
        end = places_in_view(drawing.known(obj).rig, shown, vertices)
        way = float(np.linalg.norm(there - here, axis=1).max())
        self.assertGreater(way, 8, 'the line says something')
        return made._apart(end, there), {c.bone for c in moved if getattr(c, 'bone', '')}, one

    def judge(self, what, off, moved, one, wanted):
        print('%s: found in %.2f s among %d controls; %.2f px off; moved %s' % (
            what, self.found, len(one.rig.parts), off, ', '.join(sorted(moved))))
        self.assertLess(off, PX)
        self.assertLessEqual(moved, wanted)
        self.assertTrue(moved)
        if os.getloadavg()[0] < 2:
            self.assertLess(self.found, FOUND_S)

    def test_what_an_animator_may_touch(self):
        obj = face_rig.head()
        armature = face_rig.rig(obj)
        names = {b.name for b in touchable(armature)}
        self.assertEqual(names, set(face_rig.HANDLES) | {'torso', 'head', 'jaw_master'})
        self.assertFalse(any(n.startswith(('DEF-', 'MCH-', 'ORG-')) for n in names))
        hidden = armature.pose.bones['lips.L']
        (hidden if hasattr(hidden, 'hide') else hidden.bone).hide = True  # 5.0 hides pose bones
        self.assertNotIn('lips.L', {b.name for b in touchable(armature)})
        armature.pose.bones['lips.R'].lock_location = (True, True, True)
        controls = [c.control for c in drawing.known(obj, measured=False).rig.candidates]
        self.assertNotIn('location', {c.path for c in controls if getattr(c, 'bone', '') == 'lips.R' and hasattr(c, 'path')})

    def test_a_smile(self):
        obj = face_rig.head()
        armature = face_rig.rig(obj)

        def shift(bones):
            for side, x in (('L', 0.06), ('R', -0.06)):
                face_rig.place(bones['lips.' + side], (x, 0, 0.09))
        self.judge('smile', *self.drawn(obj, armature, face_rig.along(obj, 'lip.T'), shift), {'lips.L', 'lips.R'})

    def test_a_brow(self):
        obj = face_rig.head()
        armature = face_rig.rig(obj)

        def shift(bones):
            face_rig.place(bones['brow.T.L.001'], (0, 0, 0.08))
            face_rig.place(bones['brow.T.L.002'], (0, 0, 0.1))
        self.judge('brow', *self.drawn(obj, armature, face_rig.along(obj, 'brow.T.L'), shift), {'brow.T.L.00%d' % i for i in (1, 2, 3)} | {'brow.T.L'})

    def test_a_lid(self):
        obj = face_rig.head()
        armature = face_rig.rig(obj)

        def shift(bones):
            face_rig.place(bones['lid.T.L.002'], (0, 0, -0.09))
        self.judge('lid', *self.drawn(obj, armature, face_rig.along(obj, 'lid.T.L'), shift), {'lid.T.L.002'})

    def test_a_jaw(self):
        obj = face_rig.head()
        armature = face_rig.rig(obj)

        def shift(bones):
            bones['jaw_master'].rotation_quaternion = Quaternion((1, 0, 0), 0.15)
        self.judge('jaw', *self.drawn(obj, armature, made.row(obj, -0.75, 0.5), shift), {'jaw_master'})

    def test_a_torso_is_not_meant_by_a_mouth(self):
        obj = face_rig.head()
        armature = face_rig.rig(obj)
        coat = made.plate('Coat', 9, (4, 1, 4))
        coat.location.z = -6
        coat.vertex_groups.new(name='DEF-torso').add(range(len(coat.data.vertices)), 1, 'REPLACE')
        coat.modifiers.new('Armature', 'ARMATURE').object = armature
        made.activate(obj)
        bpy.context.view_layer.update()

        def shift(bones):
            for name in {name for name in face_rig.CHAINS['lip.T']}:
                face_rig.place(bones[name], (0, 0, 0.05))
        _, moved, _ = self.drawn(obj, armature, face_rig.along(obj, 'lip.T'), shift)
        self.assertEqual(moved & {'torso', 'head'}, set())

    def test_keys_go_into_places(self):
        obj = face_rig.head()
        armature = face_rig.rig(obj)
        settings = bpy.context.scene.tool_settings
        settings.use_keyframe_insert_auto = True
        try:
            def shift(bones):
                face_rig.place(bones['lid.T.L.002'], (0, 0, -0.09))
            self.drawn(obj, armature, face_rig.along(obj, 'lid.T.L'), shift)
        finally:
            settings.use_keyframe_insert_auto = False
        paths = {c.data_path for c in versions.curves_of(armature)}
        self.assertEqual(paths, {'pose.bones["lid.T.L.002"].location'})

    def test_nothing_is_left_by_measuring(self):
        obj = face_rig.head()
        armature = face_rig.rig(obj)
        bone = armature.pose.bones['jaw_master']
        bone.rotation_quaternion = (0.9, 0.123, 0.0, 0.1)  # not of length 1
        bpy.context.view_layer.update()
        before, shown = made.state_of(armature), desk.shown_positions(obj)
        drawing.known(obj)
        self.assertEqual(made.state_of(armature), before)
        self.assertTrue(np.array_equal(desk.shown_positions(obj), shown))

    def test_rigify(self):
        """Rigify's own face on a head."""
        if not any(m.__name__ == 'rigify' for m in addon_utils.modules()):
            self.skipTest('Blender has no Rigify here')
        obj, armature, landmarks = face_rig.rigify(trial.model('ict_avatar.glb'), trial.model('ict_face_landmarks.json'))
        self.assertGreater(len(armature.pose.bones), 250)
        begin = time.perf_counter()
        rig = drawing.known(obj, measured=False).rig
        print('Rigify: read in %.2f s, %d channels that may be touched' % (time.perf_counter() - begin, len(rig.candidates)))
        shown = face_rig.seen(obj, rig)

        def move(**by):
            def shift(bones):
                for name, way in by.items():
                    face_rig.place(bones[name.replace('_', '.')], way)
            return shift

        def jaw(bones):
            bones['jaw_master'].rotation_quaternion = Quaternion((1, 0, 0), 0.2)
        cases = [('smile', 'lip_upper_outer', move(lips_L=(0.006, 0, 0.009), lips_R=(-0.006, 0, 0.009)), {'lips.L', 'lips.R'}),
                 ('brow', 'brow_L', move(brow_T_L_001=(0, 0, 0.01)), {'brow.T.L', 'brow.T.L.001', 'brow.T.L.002', 'brow.T.L.003'}),
                 ('lid', 'eyelid_upper_L', move(lid_T_L_002=(0, 0, -0.006)), {'lid.T.L.002'}),
                 ('jaw', 'chin', jaw, {'jaw_master', 'chin', 'chin.001', 'chin.002', 'jaw'})]
        for what, curve, shift, wanted in cases:
            with self.subTest(what=what):
                drawing.delete(obj)
                self.judge('Rigify, ' + what, *self.drawn(obj, armature, landmarks[curve], shift, shown), wanted)
                face_rig.rest(armature)


if __name__ == '__main__':
    trial.main(__name__)
