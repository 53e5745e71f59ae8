#!/usr/bin/env python3
"""The Python package on its own: arrays in and out, what is refused, sessions, tablets, and that all of it says what it takes and gives.
usage: python_test.py TRACE HEADER, with PENPOSE_LIBRARY and PYTHONPATH naming the library and the package; TRACE is of a tablet,
HEADER is penpose.h."""
import gc
import inspect
import re
import sys
import threading
import unittest

import numpy as np

import penpose
from penpose import _c

TRACE, HEADER = sys.argv[1:3]
SIDE = 9


def sheet():
    """A bent sheet with two shapes: `lift` raises its upper half, `lean` all of it, the more the further up."""
    y, x = [part.ravel() for part in np.meshgrid(np.linspace(-1, 1, SIDE), np.linspace(-1, 1, SIDE), indexing='ij')]
    positions = np.stack([x, y, -0.2 * x * x], axis=1)
    at = np.arange(SIDE * SIDE).reshape(SIDE, SIDE)
    a, b, c, d = at[:-1, :-1].ravel(), at[:-1, 1:].ravel(), at[1:, 1:].ravel(), at[1:, :-1].ravel()
    triangles = np.concatenate([np.stack([a, b, c], axis=1), np.stack([a, c, d], axis=1)])
    up = np.flatnonzero(y > 0.1)
    lift = np.zeros((len(up), 3))
    lift[:, 1] = 0.3
    lean = np.zeros((len(x), 3))
    lean[:, 0] = 0.2 * (y + 1)
    return penpose.Character.from_arrays(positions, triangles, [penpose.Shape('lift', lift, up), penpose.Shape('lean', lean, minimum=-1)])


def status(call, *arguments):
    try:
        call(*arguments)
    except penpose.Error as problem:
        assert str(problem) and '\n' not in str(problem)
        return problem.status
    return penpose.Status.OK


class Arrays(unittest.TestCase):
    def setUp(self):
        self.sheet = sheet()

    def test_positions_come_into_the_array_that_is_given(self):
        for kind in (np.float64, np.float32):
            room = np.full((SIDE * SIDE + 2, 3), 7, dtype=kind)
            inner = room[1:-1]
            self.assertIs(self.sheet.evaluate([1, 0], out=inner), inner)
            self.assertAlmostEqual(inner[-1, 1], 1.3, 6)
            self.assertTrue((room[0] == 7).all() and (room[-1] == 7).all(), 'nothing beside it is touched')
        np.testing.assert_array_equal(self.sheet.evaluate([1, 0]).astype(np.float32), inner)

    def test_an_array_that_does_not_fit_is_said_so(self):
        fits = np.zeros((SIDE * SIDE, 3))
        fixed = fits.copy()
        fixed.flags.writeable = False
        for out in (fits[:, ::-1], fits.T, fits.ravel(), fits.astype(int), fixed, np.asfortranarray(fits)):
            with self.assertRaises(ValueError):
                self.sheet.evaluate(out=out)
        self.assertEqual(status(lambda: self.sheet.evaluate(out=fits[1:])), penpose.Status.BAD_ARGUMENT)
        self.assertFalse(fits.any())

    def test_any_layout_is_taken(self):
        """Lists, other numbers, every other row, columns first: each gives the same curve."""
        line = np.stack([np.linspace(400, 600, 12), np.full(12, 450.0)], axis=1)
        view = self.sheet.view()
        wide = np.zeros((24, 4))
        wide[::2, 1:3] = line
        given = [line, line.tolist(), line.astype(np.float32), np.asfortranarray(line), wide[::2, 1:3], line.view(np.ndarray)]
        curves = [self.sheet.positions(self.sheet.draw(view, px)) for px in given]
        for curve in curves:
            np.testing.assert_allclose(curve, curves[0], atol=1e-6)
        triangles, shares = self.sheet.points(self.sheet.draw(view, line))
        np.testing.assert_array_equal(self.sheet.positions(self.sheet.curve_of(triangles, shares)), curves[0])
        for px in (line.T, line.ravel(), [[1, 2, 3]]):
            with self.assertRaises(ValueError):
                self.sheet.draw(view, px)
        for vertices in ([-1, 2], [0.5, 1], [2**32, 1]):
            with self.assertRaises((ValueError, OverflowError)):
                self.sheet.curve_at(vertices)

    def test_what_was_given_may_go(self):
        """The library keeps no array of the caller's."""
        before = self.sheet.evaluate([0.5, 0.5])
        gc.collect()
        junk = [np.full(1000, np.nan) for _ in range(100)]
        np.testing.assert_array_equal(self.sheet.evaluate([0.5, 0.5]), before)
        del junk

    def test_a_pose_is_a_copy_and_is_set_whole(self):
        self.sheet.pose = [0.25, -0.5]
        pose = self.sheet.pose
        pose[:] = 9
        self.assertEqual(self.sheet.values(), {'lift': 0.25, 'lean': -0.5})
        for wrong in ([1], [1, 2, 3], [[1, 2]]):
            with self.assertRaises((ValueError, penpose.Error)):
                self.sheet.pose = wrong
        with self.assertRaises(penpose.Error):
            self.sheet.pose = [np.nan, 0]
        self.assertEqual(self.sheet.values(), {'lift': 0.25, 'lean': -0.5})


class Calls(unittest.TestCase):
    def test_it_is_solved_and_followed(self):
        character = sheet()
        curve = character.curve_at(SIDE * (SIDE - 1) + np.arange(SIDE))
        character.target(curve, character.positions(curve) + [0, 0.18, 0])
        for preset in penpose.Preset:
            character.reset()
            character.solve(preset)
            self.assertAlmostEqual(character.values()['lift'], 0.6, delta=0.02, msg=preset)
        view = character.view()
        character.reset()
        over = view.project(character.positions(curve))
        live = character.live(curve, view)
        follows = live.follow(over - [0, 20])
        self.assertGreater(follows[0], 0.01)
        self.assertEqual(character.values()['lift'], 0, 'a preview changes nothing')
        character.draw_target(curve, view, over - [0, 20])
        self.assertGreater(character.values()['lift'], 0.01)

    def test_a_refusal_changes_nothing(self):
        character = sheet()
        curve = character.curve_at([60, 61, 62])
        state = character.state
        refused, bad = penpose.Status.REFUSED, penpose.Status.BAD_ARGUMENT
        self.assertEqual(status(character.target, curve, np.full((3, 3), np.nan)), refused)
        self.assertEqual(status(character.target, curve, np.zeros((2, 3))), refused)
        self.assertEqual(status(character.target, 99, np.zeros((3, 3))), refused)
        self.assertEqual(status(character.set, 'nothing', 1), refused)
        self.assertEqual(status(character.perform, 'make_coffee'), refused)
        self.assertEqual(status(character.solve, 7), bad)
        self.assertEqual(status(penpose.Character.read, b'not a model'), refused)
        with self.assertRaises(ValueError):
            character.set('li\0ft', 1)
        self.assertEqual(character.state, state)

    def test_what_was_closed_is_known_to_be(self):
        character = sheet()
        character.close()
        for call in (character.solve, character.reset, character.evaluate, character.close, character.copy):
            self.assertEqual(status(call), penpose.Status.BAD_HANDLE)

    def test_files_and_sessions_come_back_with_their_state(self):
        character = sheet()
        again = penpose.Character.read(character.write(), 'x.glb')
        self.assertEqual(again.state, character.state)
        character.record('sheet.glb')
        curve = character.curve_at(SIDE * (SIDE - 1) + np.arange(SIDE))
        character.target(curve, character.positions(curve) + [0.1, 0.1, 0])
        character.solve()
        played, playback = penpose.play(character.recorded, again)
        self.assertEqual((played.state, playback.differing), (character.state, 0))
        self.assertGreater(playback.checked, 0)
        spoiled = re.sub(rb'(penpose state )(.)', lambda found: found[1] + (b'0' if found[2] != b'0' else b'1'), character.recorded)
        self.assertNotEqual(spoiled, character.recorded)
        self.assertEqual(status(penpose.play, spoiled, again), penpose.Status.DIVERGED)

    def test_a_track_becomes_an_animation(self):
        character = sheet()
        state = character.state
        take = b'Timecode,BlendShapeCount,Lift,TongueOut\n0:0:0:0,2,0.25,0\n0:0:0:1,2,nan,0\n0:0:0:2,2,0.5,0.5\n'
        made = penpose.animate(character, take)
        self.assertEqual((made.held, made.unmatched, made.rest), (1, 1, None))
        np.testing.assert_array_equal(made.poses[:, 0], [0.25, 0.25, 0.5])
        self.assertEqual(made.times.shape, (3,))
        self.assertTrue(any('line 3' in note for note in made.notes), made.notes)
        self.assertNotEqual(made.character.state, state)
        self.assertEqual(character.state, state)
        again = penpose.animate(character, take, '{"format": "arkit", "names": {"TongueOut": "lean"}}', stretch=10)
        self.assertEqual((again.unmatched, again.poses[2, 1]), (0, 0.5))
        np.testing.assert_allclose(again.times, [0, 0.1, 0.2])
        refused = penpose.Status.REFUSED
        self.assertEqual(status(penpose.animate, character, b''), refused)
        self.assertEqual(status(penpose.animate, character, take, 'openface'), refused)
        self.assertEqual(status(lambda: penpose.animate(character, take, smooth_s=99)), refused)
        for wrong in ({'head': 'nod'}, {'neutral': -1}):
            with self.assertRaises(ValueError):
                penpose.animate(character, take, **wrong)

    def test_a_drawing_of_the_face_poses_it(self):
        head = penpose.Character.built_in('builtin:demo')
        view = head.view()
        names = [name + side for name in ('eyelid_upper', 'eyelid_lower', 'brow') for side in ('_L', '_R')]
        names += ['lip_upper', 'lip_lower', 'lip_upper_inner', 'lip_lower_inner', 'jaw', 'nose_bridge']

        def lines():
            return [view.project(head.positions(head.curve(name))) for name in names]
        rest = lines()
        for name, value in (('jaw', 0.5), ('mouth_corner_L', 0.8), ('mouth_corner_R', 0.8)):
            head.set(name, value)
        laugh, meant = lines(), head.pose
        head.reset()
        drawn = head.draw_face(laugh, view)
        self.assertGreaterEqual(sum(line.curve == name for line, name in zip(drawn.lines, names)), len(names) - 1)
        self.assertTrue(all(0 <= line.start < line.end <= 1 for line in drawn.lines if line.curve))
        self.assertEqual(drawn.neutral, [])
        self.assertLess(np.abs(head.pose - meant).max(), 0.5)
        self.assertEqual(len(head.draw_face(laugh, neutral=rest).neutral), len(names))
        state = head.state
        self.assertEqual(status(head.draw_face, []), penpose.Status.REFUSED)
        self.assertEqual(status(head.draw_face, [[[1, 1], [np.nan, 2]]]), penpose.Status.REFUSED)
        with self.assertRaises(ValueError):
            head.draw_face([[1, 2, 3]])
        self.assertEqual(head.state, state)

    def test_characters_of_several_threads(self):
        """Each thread with one of its own, and all with one that is shared, come to what one thread comes to."""
        shared, failed = sheet(), []
        curve = shared.curve_at(SIDE * (SIDE - 1) + np.arange(SIDE))
        shared.target(curve, shared.positions(curve) + [0, 0.18, 0])
        first = shared.copy()
        first.solve()

        def work():
            for _ in range(20):
                own = shared.copy()
                own.solve()
                if own.state != first.state or not np.isfinite(shared.evaluate([0.5, 0])).all():
                    failed.append(own.state)
        threads = [threading.Thread(target=work) for _ in range(4)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(failed, [])

    def test_a_tablet_is_read(self):
        """As hid-recorder wrote it down: R is the descriptor, I the ids, E a report."""
        with open(TRACE, encoding='utf-8') as file:
            lines = [line.split() for line in file if line[:1] in 'RIE']
        def raw(words): return bytes(int(word, 16) for word in words)
        descriptor = next(raw(line[2:]) for line in lines if line[0] == 'R:')
        bus, vendor, product = next([int(word, 16) for word in line[1:4]] for line in lines if line[0] == 'I:')
        tablet = penpose.Tablet(vendor, product, descriptor, bus=bus)
        samples = [sample for line in lines if line[0] == 'E:' for sample in tablet.report(raw(line[3:]))]
        self.assertTrue(any(sample.tip for sample in samples))
        for axis in ('x', 'y', 'pressure'):
            limits = tablet.axes[axis]
            values = [getattr(sample, axis) for sample in samples if sample.in_range]
            self.assertTrue(all(limits.minimum <= value <= limits.maximum for value in values), axis)
            self.assertGreater(max(values), min(values), axis)
        with self.assertRaises(penpose.Error):
            penpose.Tablet(0x1234, 0x5678)


class Told(unittest.TestCase):
    def test_all_that_is_public_is_described_and_typed(self):
        for name in penpose.__all__:
            thing = getattr(penpose, name)
            if not callable(thing):
                continue
            self.assertTrue(inspect.getdoc(thing), name)
            members = [(name, thing)] if inspect.isfunction(thing) else [
                (name + '.' + key, getattr(member, 'fget', getattr(member, '__func__', member))) for key, member in vars(thing).items()
                if key == '__init__' or not key.startswith('_')]
            for full, member in members:
                if not inspect.isfunction(member) or member.__module__.split('.')[0] != 'penpose':
                    continue
                self.assertTrue(full.endswith('__init__') or inspect.getdoc(member), full)
                for parameter in list(inspect.signature(member).parameters.values()):
                    if parameter.name not in ('self', 'cls', '_cls'):
                        self.assertIsNot(parameter.annotation, inspect.Parameter.empty, full + ' ' + parameter.name)
                if not full.endswith('__init__'):
                    self.assertIsNot(inspect.signature(member).return_annotation, inspect.Signature.empty, full)

    def test_every_function_of_the_header_is_there(self):
        """What penpose.h has is called from Python, but for what Python does without."""
        missing = set(_c._FUNCTIONS) ^ set(declared())
        self.assertEqual(missing, {'penpose_handle_count'})


def declared():
    """Functions of penpose.h that end with a place for an error."""
    with open(HEADER, encoding='utf-8') as file:
        text = file.read()
    return re.findall(r'PENPOSE_API int32_t (penpose_\w+)\([^;]*penpose_error\* error\);', text)


if __name__ == '__main__':
    unittest.main(argv=sys.argv[:1])
