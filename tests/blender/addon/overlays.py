"""Arcs, ghosts and strokes on other frames; targets that are pulled afterwards. ZIP"""
import os
import sys
import unittest

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import desk  # noqa: E402
import bpy  # noqa: E402
import numpy as np  # noqa: E402
import trial  # noqa: E402

desk.install(desk.ARGUMENTS[0])
import made  # noqa: E402
from mathutils import Quaternion  # noqa: E402
from penpose_blender import arcs, curves, drawing, keys, moments, pull  # noqa: E402
from penpose_blender.controls import Refused  # noqa: E402
from penpose_blender.moment_stroke import MomentStroke, stroke_at  # noqa: E402

LAST = 21
SAME = 1e-4  # of the mesh's size


class Overlays(unittest.TestCase):
    def setUp(self):
        made.empty_file()
        arcs.forget()
        self.obj = made.plate()
        self.key = made.add_key(self.obj, 'up', (0, 0, 0.4), middle=(0, 0.5))
        made.add_key(self.obj, 'over', (0.4, 0, 0), middle=(0, 0.5))
        self.armature = made.bones(self.obj)
        self.high = self.armature.pose.bones['high']
        self.scene, self.pen = bpy.context.scene, bpy.context.window_manager.penpose
        self.pen.arcs, self.pen.ghosts, self.pen.arc_frames, self.pen.ghost_count, self.pen.ghost_at = True, True, 6, 2, 'KEYS'
        self.shown = desk.seen(self.obj)
        self.line = made.row(self.obj)
        self.begin = desk.region_places(self.shown, desk.shown_positions(self.obj)[self.line])
        desk.draw(self.obj, 'reference', self.shown, self.begin)

    def animate(self):
        """Up and down again by a key, a turn of the bone."""
        for frame, value, turn in ((1, 0, 0), (11, 1, 0.3), (LAST, 0, 0)):
            self.key.value = value
            self.key.keyframe_insert('value', frame=frame)
            self.high.rotation_quaternion = Quaternion((1, 0, turn, 0)).normalized()
            self.high.keyframe_insert('rotation_quaternion', frame=frame)
        self.scene.frame_set(5)

    def state(self):
        return made.state_of(self.obj, self.armature), self.scene.frame_current

    def test_other_frames_as_blender_has_them(self):
        self.animate()
        rig = drawing.known(self.obj).rig
        when, shapes, before = moments.Moments(rig), moments.Shapes(rig), self.state()
        found = {frame: shapes.vertices(when.pose(frame)) for frame in (1, 3, 7.5, 11, 16, 30)}
        self.assertEqual(self.state(), before, 'nothing of the scene is moved')
        for frame, ours in found.items():
            self.scene.frame_set(int(frame), subframe=frame % 1)
            self.assertLess(float(np.abs(desk.shown_positions(self.obj) - ours).max()), SAME * desk.size_of(ours), frame)
        self.assertEqual(when.keyed(), [1, 11, LAST])
        self.assertEqual(when.neighbours(5), [1, 11])

    def test_rotation_modes(self):
        for mode in ('XYZ', 'ZXY', 'AXIS_ANGLE'):
            self.high.rotation_mode = mode
            path = 'rotation_axis_angle' if mode == 'AXIS_ANGLE' else 'rotation_euler'
            for frame, value in ((1, 0.1), (9, 0.5)):
                setattr(self.high, path, (value, 0, 0, 1) if mode == 'AXIS_ANGLE' else (value, 0.2, -value))
                self.high.keyframe_insert(path, frame=frame)
            self.scene.frame_set(1)
            rig = drawing.known(self.obj).rig
            ours = moments.Shapes(rig).vertices(moments.Moments(rig).pose(6))
            self.scene.frame_set(6)
            self.assertLess(float(np.abs(desk.shown_positions(self.obj) - ours).max()), SAME * desk.size_of(ours), mode)

    def times(self):
        drawing.known(self.obj)
        return arcs.Times(self.obj)

    def test_arcs(self):
        self.assertEqual(arcs.arcs_of(self.times(), self.scene, self.pen), [], 'what stays has no arc')
        self.animate()
        arc = arcs.arcs_of(self.times(), self.scene, self.pen)[0]
        self.assertEqual(arc.frames, list(range(-1, 12)))
        self.assertEqual([f for f, k in zip(arc.frames, arc.keyed) if k], [1, 11])
        self.scene.frame_set(9)
        bpy.context.view_layer.update()
        _, points = drawing.places(self.obj, bpy.context.evaluated_depsgraph_get())[0]
        self.assertLess(float(np.abs(points[len(points) // 2] - arc.points[arc.frames.index(9)]).max()), 2e-4)

    def test_ghosts(self):
        self.animate()
        found = arcs.ghosts_of(self.times(), self.scene, self.pen)
        self.assertEqual([(g.frame, g.away) for g in found], [(LAST, 2), (1, -1), (11, 1)])
        self.pen.ghost_at, self.pen.ghost_step = 'FRAMES', 3
        found = arcs.ghosts_of(self.times(), self.scene, self.pen)
        self.assertEqual(sorted(g.frame for g in found), [-1, 2, 8, 11])

    def place_on_arc(self, frame):
        arc = arcs.arcs_of(self.times(), self.scene, self.pen)[0]
        return self.shown.places(self.shown.view.project(self.times().space.from_world(arc.points)))[arc.frames.index(frame)]

    def test_hits(self):
        self.animate()
        self.pen.ghosts = False
        self.assertEqual(arcs.hit(self.obj, self.place_on_arc(9) + (2, 1), self.shown, self.scene, self.pen)[1:], ('arc', 1, 9))
        self.assertIsNone(arcs.hit(self.obj, self.place_on_arc(9) + (300, 0), self.shown, self.scene, self.pen))
        self.pen.arcs, self.pen.ghosts = False, True
        ghost = next(g for g in arcs.ghosts_of(self.times(), self.scene, self.pen) if g.frame == 11)
        on_it = self.shown.places(self.shown.view.project(self.times().space.from_world(ghost.lines[0][1])))
        self.assertEqual(arcs.hit(self.obj, on_it[len(on_it) // 2], self.shown, self.scene, self.pen)[1:], ('ghost', 1, 11))
        wide = int(np.argmax(np.linalg.norm(np.diff(on_it, axis=0), axis=1)))
        between = on_it[wide:wide + 2].mean(axis=0)
        self.assertLess(arcs.hit(self.obj, between, self.shown, self.scene, self.pen)[0], 0.01, 'as near as a target that is pulled')
        self.assertIsNone(arcs.hit(self.obj, self.begin[0] - (200, 0), self.shown, self.scene, self.pen))
        self.pen.ghosts = False
        self.assertIsNone(arcs.hit(self.obj, self.place_on_arc(9), self.shown, self.scene, self.pen), 'what is not shown is not touched')

    def drawn(self, frame):
        """Where Blender has the curve on a frame, px of the region."""
        now = self.scene.frame_current
        self.scene.frame_set(frame)
        out = made.curve_px(self.obj, self.shown)
        self.scene.frame_set(now)
        return out

    def test_an_arc_is_pulled(self):
        self.animate()
        before = {frame: self.drawn(frame) for frame in (1, 5, 11, LAST)}
        start = self.place_on_arc(8)
        here = self.drawn(8)
        stroke = MomentStroke(self.obj, 'arc', 1, 8, self.shown)
        for share in np.linspace(0, 1, 10):
            stroke.add(start + share * np.array((0, 40)))
            stroke.follow()
        middle = len(here) // 2
        self.assertGreater(stroke.line_of_frame()[middle][1] - here[middle][1], 20, 'the curve follows on its frame')
        moved = stroke.end(self.obj)
        self.assertTrue(moved)
        self.assertGreater(stroke.keyed, 0)
        self.assertEqual(self.scene.frame_current, 5)
        self.assertGreater(self.drawn(8)[middle][1] - here[middle][1], 25, 'that frame is posed')
        for frame in (1, 11, LAST):
            self.assertLess(np.abs(self.drawn(frame) - before[frame]).max(), 0.5, 'keys of other frames stay: %d' % frame)
        for control in moved:
            for block, path, index, _ in control.channels():
                curve = keys.curve_of(block.id_data, moments._path(block, path), max(0, index))
                self.assertIn(8, [p.co.x for p in curve.keyframe_points])

    def test_a_ghost_is_drawn_on(self):
        self.animate()
        line, wanted = self.drawn(11), self.drawn(8)
        stroke = MomentStroke(self.obj, 'ghost', 1, 11, self.shown)
        for place in wanted:
            stroke.add(place)
            stroke.follow()
        self.assertTrue(stroke.end(self.obj))
        self.assertGreater(made._apart(line, wanted), 20)
        self.assertLess(made._apart(self.drawn(11), wanted) / desk.size_of(np.vstack([line, wanted])), made.NEAR)
        self.assertEqual(moments.Moments(drawing.known(self.obj).rig).keyed(), [1, 11, LAST])

    def test_what_was_never_keyed_changes_between_neighbours(self):
        self.animate()
        over = self.obj.data.shape_keys.key_blocks['over']
        for bone in self.armature.pose.bones:
            bone.lock_rotation = (True, True, True)
        line = self.drawn(11)
        stroke = MomentStroke(self.obj, 'ghost', 1, 11, self.shown)
        for place in line + (40, 0):
            stroke.add(place)
        self.assertIn('over', [c.name for c in stroke.end(self.obj)])
        curve = keys.curve_of(self.obj.data.shape_keys, 'key_blocks["over"].value')
        self.assertEqual([p.co.x for p in curve.keyframe_points], [1, 11, LAST])
        self.assertEqual([p.co.y for p in curve.keyframe_points][::2], [0, 0])
        self.assertGreater(curve.evaluate(11), 0.1)
        self.assertEqual(over.value, curve.evaluate(5))

    def test_given_up_or_no_line(self):
        self.animate()
        before, curve = self.state(), [tuple(p.co) for p in keys.curve_of(self.obj.data.shape_keys, 'key_blocks["up"].value').keyframe_points]
        stroke = MomentStroke(self.obj, 'arc', 1, 8, self.shown)
        start = self.place_on_arc(8)
        stroke.add(start)
        with self.assertRaisesRegex(Refused, 'a stroke is a line; pull Plate'):
            stroke.end(self.obj)
        stroke.add(start + (0, 30))
        stroke.follow()
        stroke.cancel(self.obj)
        self.assertEqual(self.state(), before)
        self.assertEqual([tuple(p.co) for p in keys.curve_of(self.obj.data.shape_keys, 'key_blocks["up"].value').keyframe_points], curve)

    def middle(self, line):
        """The px in the middle of a line."""
        return line[len(line) // 2]

    # Rigs whose controls are measured.

    def driven(self):
        """The key goes by a property, which is animated with a turn of the bone."""
        drawing.delete(self.obj)
        self.armature['lift'] = 0.0
        made.drive(self.obj.data.shape_keys, 'key_blocks["up"].value', self.armature, '["lift"]', 'x * x')
        for frame, value, turn in ((1, 0, 0), (11, 1, 0.3), (LAST, 0, 0)):
            self.armature['lift'] = float(value)
            self.armature.keyframe_insert('["lift"]', frame=frame)
            self.high.rotation_quaternion = Quaternion((1, 0, turn, 0)).normalized()
            self.high.keyframe_insert('rotation_quaternion', frame=frame)
        self.scene.frame_set(1)
        desk.draw(self.obj, 'reference', self.shown, self.begin)
        self.scene.frame_set(5)
        self.assertTrue(drawing.known(self.obj).rig.measured)

    def test_measured_rigs_are_looked_at(self):
        self.driven()
        times, before = self.times(), self.state()
        self.assertEqual(arcs.arcs_of(times, self.scene, self.pen), [])
        self.assertEqual(times.missing, arcs.frames_around(self.scene, self.pen))
        times.shapes.looked.look(times.missing)
        self.assertEqual(self.state(), before, 'each channel has what it had, to the bit')
        times = self.times()
        arc = arcs.arcs_of(times, self.scene, self.pen)[0]
        self.assertEqual(times.missing, [])
        lines = {frame: times.line(1, frame) for frame in (3, 8, 11)}
        for frame, ours in lines.items():
            self.scene.frame_set(frame)
            bpy.context.view_layer.update()
            _, theirs = drawing.places(self.obj, bpy.context.evaluated_depsgraph_get())[0]
            self.assertLess(float(np.abs(ours - theirs).max()), 1e-5)
            self.assertLess(float(np.abs(arc.points[arc.frames.index(frame)] - theirs[len(theirs) // 2]).max()), 1e-5)

    def test_measured_rigs_are_drawn_on_there(self):
        self.driven()
        line, wanted, kept = self.drawn(11), self.drawn(8), self.obj['penpose']
        stroke = stroke_at(self.obj, 'ghost', 1, 11, self.shown)
        self.assertEqual(self.scene.frame_current, 11)
        for place in wanted:
            stroke.add(place)
            stroke.follow()
        self.assertTrue(stroke.end(self.obj))
        self.assertEqual((self.scene.frame_current, self.obj['penpose']), (5, kept))
        self.assertLess(made._apart(self.drawn(11), wanted), 0.3 * made._apart(line, wanted))
        before = self.state()
        stroke = stroke_at(self.obj, 'arc', 1, 8, self.shown)
        stroke.add((500, 500))
        stroke.add((500, 530))
        stroke.follow()
        stroke.cancel(self.obj)
        self.assertEqual(self.state(), before)

    # Pulling a target.

    def target(self, shift=40):
        desk.draw(self.obj, 'target', self.shown, self.begin + (0, shift), of=1)
        bpy.context.view_layer.update()

    def test_pulled(self):
        self.target()
        value, before = self.key.value, made.curve_px(self.obj, self.shown)
        on_it = self.begin[3] + (0, 42)
        self.assertEqual(pull.hit(self.obj, on_it, self.shown)[1], 1)
        self.assertIsNone(pull.hit(self.obj, self.begin[3] + (0, 90), self.shown))
        stroke = pull.Pull(self.obj, 1, self.shown)
        for share in np.linspace(0, 1, 12):
            stroke.add(on_it + share * np.array((0, 30)))
            stroke.follow()
        self.assertLess(np.abs(stroke.places() - (self.begin + (0, 70)))[:, 1].max(), 4)
        followed = self.key.value
        self.assertGreater(followed, value + 0.1, 'the face follows')
        self.assertTrue(stroke.end(self.obj))
        self.assertEqual(len(curves.curves(self.obj)), 1)
        self.assertGreater(self.middle(made.curve_px(self.obj, self.shown))[1], self.middle(before)[1] + 25)

    def test_pulled_as_drawn(self):
        """A line that is pulled gives what is drawn there at once."""
        self.target()
        stroke = pull.Pull(self.obj, 1, self.shown)
        for share in np.linspace(0, 1, 5):
            stroke.add(self.begin[3] + (0, 40 + 20 * share))
        stroke.end(self.obj)
        pulled = self.key.value
        self.key.value = 0
        for bone in self.armature.pose.bones:
            bone.rotation_quaternion = (1, 0, 0, 0)
        drawing.delete(self.obj)
        desk.draw(self.obj, 'reference', self.shown, self.begin)
        desk.draw(self.obj, 'target', self.shown, self.begin + (0, 60))
        self.assertAlmostEqual(pulled, self.key.value, delta=0.03)

    def test_pulled_from_another_view(self):
        self.target()
        value, other = self.key.value, desk.seen(self.obj, 25)
        place = self.times().space.from_world(drawing.target_places(self.obj, curves.curves(self.obj)[0]))
        on_it = other.places(other.view.project(place))[5]
        self.assertEqual(pull.hit(self.obj, on_it, other)[1], 1)
        stroke = pull.Pull(self.obj, 1, other)
        stroke.add(on_it)
        stroke.add(on_it + (0, 25))
        self.assertLess(np.abs(stroke.places()[5] - on_it - (0, 25)).max(), 1)
        stroke.end(self.obj)
        self.assertGreater(self.key.value, value + 0.05)

    def test_a_pull_is_given_up(self):
        self.target()
        before, kept = self.state(), self.obj['penpose']
        stroke = pull.Pull(self.obj, 1, self.shown)
        stroke.add(self.begin[3] + (0, 40))
        stroke.add(self.begin[3] + (0, 90))
        stroke.follow()
        self.assertNotEqual(self.state(), before)
        stroke.cancel(self.obj)
        self.assertEqual(self.state(), before)
        self.assertEqual(self.obj['penpose'], kept)


if __name__ == '__main__':
    trial.main(__name__)
