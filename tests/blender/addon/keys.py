"""Keyframes follow Blender's rules: auto-key, keying sets, preferences, NLA. ZIP

Where Blender has an operator that keys, its keys are what ours are compared with."""
import os
import sys
import unittest

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import desk  # noqa: E402
import bpy  # noqa: E402
import trial  # noqa: E402

desk.install(desk.ARGUMENTS[0])
import made  # noqa: E402
from penpose_blender import keying_sets, keys, versions  # noqa: E402


class Place:
    """A control whose keys Blender's own operator inserts, too: the location of an object."""

    def __init__(self, obj):
        self.object = obj

    def channels(self):
        return [(self.object, 'location', -1, 'Object Transforms')]


def told(owner):
    """All of the curves of a data-block."""
    return {(c.data_path, c.array_index): (c.group.name if c.group else '', c.color_mode, [
        (tuple(p.co), p.interpolation, p.handle_left_type, p.handle_right_type, p.type, [round(x, 5) for x in (*p.handle_left, *p.handle_right)])
        for p in c.keyframe_points]) for c in versions.curves_of(owner)}


class Keys(unittest.TestCase):
    maxDiff = None
    def setUp(self):
        made.empty_file()
        self.scene = bpy.context.scene
        self.settings, self.edit = self.scene.tool_settings, bpy.context.preferences.edit
        self.obj = made.plate()
        self.up = made.add_key(self.obj, 'up', (0, 0, 0.4))
        self.over = made.add_key(self.obj, 'over', (0.4, 0, 0))
        self.armature = made.bones(self.obj)
        self.high = self.armature.pose.bones['high']

    def auto(self, **settings):
        self.settings.use_keyframe_insert_auto = True
        for name, value in settings.items():
            setattr(self.settings if hasattr(self.settings, name) else self.edit, name, value)

    def control(self, key):
        from penpose_blender.controls import KeyControl
        return KeyControl([(self.obj, key)])

    def turn(self):
        from penpose_blender.bones import BoneTurn
        return BoneTurn(self.armature, self.high)

    def frames(self, owner, path, index=0):
        curve = keys.curve_of(owner, path, index)
        return None if curve is None else [p.co.x for p in curve.keyframe_points]

    # As Blender's own operator.

    def twins(self):
        """Two empties that are keyed alike, by Blender and by us."""
        out = []
        for name in ('theirs', 'ours'):
            one = bpy.data.objects.new(name, None)
            self.scene.collection.objects.link(one)
            out.append(one)
        return out

    def both(self, pair, frame, place):
        theirs, ours = pair
        self.scene.frame_set(frame)
        for one in pair:
            one.location = place
        made.activate(theirs)
        window = bpy.context.window_manager.windows[0]
        with bpy.context.temp_override(window=window, screen=window.screen, area=window.screen.areas[0]):
            bpy.ops.anim.keyframe_insert_by_name(type='Location')
        keys.insert([Place(ours)], keys.Rules(self.scene), frame)
        self.assertEqual(told(ours), told(theirs))

    def same_keys(self, frames=(3, 12, 7, 12, 20, 3)):
        pair = self.twins()
        for n, frame in enumerate(frames):
            self.both(pair, frame, (0.1 * n, 1, n % 2))
        return pair

    def test_as_blender_keys(self):
        pair = self.same_keys()
        self.assertEqual(len(told(pair[1])), 3)

    def test_interpolation_and_handles(self):
        for interpolation, handle in (('LINEAR', 'VECTOR'), ('CONSTANT', 'AUTO'), ('ELASTIC', 'ALIGNED'), ('BEZIER', 'FREE')):
            self.edit.keyframe_new_interpolation_type, self.edit.keyframe_new_handle_type = interpolation, handle
            pair = self.same_keys()
            self.assertIn(interpolation, str(told(pair[1])))
            self.assertIn(handle, str(told(pair[1])))

    def test_types(self):
        pair = self.twins()
        for frame, kind in ((1, 'KEYFRAME'), (8, 'EXTREME'), (8, 'BREAKDOWN'), (15, 'JITTER')):
            self.settings.keyframe_type = kind
            self.both(pair, frame, (0.1 * frame, 0, 0))
        self.assertIn('JITTER', str(told(pair[1])))

    def test_colours(self):
        for on in (True, False):
            self.edit.use_insertkey_xyz_to_rgb = on
            pair = self.same_keys((1, 2))
            self.assertEqual('AUTO_RGB' in str(told(pair[1])), on)

    def test_needed(self):
        self.edit.use_keyframe_insert_needed = True
        pair = self.twins()
        for frame, place in ((1, (0, 0, 0)), (5, (0, 0, 1)), (9, (0, 0, 1)), (13, (0, 0, 1)), (20, (1, 0, 1))):
            self.both(pair, frame, place)
        self.assertLess(len(keys.curve_of(pair[1], 'location', 1).keyframe_points), 3)

    def test_visual(self):
        self.edit.use_visual_keying = True
        other = bpy.data.objects.new('followed', None)
        other.location = (3, 2, 1)
        self.scene.collection.objects.link(other)
        pair = self.twins()
        for one in pair:
            one.constraints.new('COPY_LOCATION').target = other
        self.both(pair, 4, (0, 0, 0))
        self.assertEqual([p.co.y for p in keys.curve_of(pair[1], 'location', 0).keyframe_points], [3])

    # Auto-key.

    def test_nothing_unless_wanted(self):
        self.assertEqual(keys.key([self.control(self.up)]), 0)
        self.assertIsNone(self.obj.data.shape_keys.animation_data)

    def test_available(self):
        self.auto(use_keyframe_insert_available=True)
        self.assertEqual(keys.key([self.control(self.up), self.turn()]), 0)
        self.assertIsNone(self.obj.data.shape_keys.animation_data, 'no action is made where no curve is')
        self.assertIsNone(self.armature.animation_data)
        self.up.keyframe_insert('value', frame=1)
        self.high.keyframe_insert('rotation_quaternion', index=2, frame=1)
        self.scene.frame_set(9)
        self.assertEqual(keys.key([self.control(self.up), self.control(self.over), self.turn()]), 2)
        self.assertEqual(set(told(self.obj.data.shape_keys)), {('key_blocks["up"].value', 0)})
        self.assertEqual(set(told(self.armature)), {('pose.bones["high"].rotation_quaternion', 2)})
        self.assertEqual(self.frames(self.obj.data.shape_keys, 'key_blocks["up"].value'), [1, 9])

    def test_replace(self):
        self.auto(auto_keying_mode='REPLACE_KEYS')
        control = self.control(self.up)
        self.scene.frame_set(5)
        self.assertEqual(keys.key([control]), 0)
        self.assertIsNone(self.obj.data.shape_keys.animation_data)
        self.up.keyframe_insert('value', frame=5)
        self.over.keyframe_insert('value', frame=2)
        self.up.value = 0.5
        self.assertEqual(keys.key([control, self.control(self.over)]), 1)
        curve = keys.curve_of(self.obj.data.shape_keys, 'key_blocks["up"].value')
        self.assertEqual([tuple(p.co) for p in curve.keyframe_points], [(5, 0.5)])
        self.scene.frame_set(6)
        self.assertEqual(keys.key([control]), 0)
        self.settings.auto_keying_mode = 'ADD_REPLACE_KEYS'
        self.assertEqual(keys.key([control]), 1)

    def test_cycle_aware(self):
        self.auto(use_keyframe_cycle_aware=True)
        for frame in (1, 11):
            self.up.keyframe_insert('value', frame=frame)
        keys.curve_of(self.obj.data.shape_keys, 'key_blocks["up"].value').modifiers.new('CYCLES')
        self.scene.frame_set(24)
        self.up.value = 0.5
        self.settings.keyframe_type = 'BREAKDOWN'
        self.assertEqual(keys.key([self.control(self.up)]), 1)
        curve = keys.curve_of(self.obj.data.shape_keys, 'key_blocks["up"].value')
        self.assertEqual([(p.co.x, p.type) for p in curve.keyframe_points], [(1, 'KEYFRAME'), (4, 'BREAKDOWN'), (11, 'KEYFRAME')])

    # Keying sets.

    def active(self, name):
        self.scene.keying_sets_all.active = self.scene.keying_sets_all[name]
        self.assertTrue(keys.wanted(self.scene))

    def paths(self, owner):
        return {path for path, _ in told(owner)}

    def test_built_in_sets(self):
        wanted = {'Location': {'location'}, 'Rotation': {'rotation_quaternion'}, 'Scale': {'scale'},
                  'Location, Rotation & Scale': {'location', 'rotation_quaternion', 'scale'}, 'BBone Shape': None, 'Available': set()}
        for name, channels in wanted.items():
            if name not in self.scene.keying_sets_all:  # 5.0 has none of bendy bones
                continue
            with self.subTest(name):
                self.armature.animation_data_clear()
                self.active(name)
                said = []
                keys.key([self.turn()], said=said)
                found = self.paths(self.armature)
                if channels is None:
                    self.assertTrue(found and all('bbone' in path for path in found), found)
                else:
                    self.assertEqual(found, {'pose.bones["high"].' + c for c in channels})
                self.assertEqual(bool(said), name == 'Available')
        self.assertEqual({c.group.name for c in versions.curves_of(self.armature)}, set())
        self.active('Rotation')
        keys.key([self.turn()])
        self.assertEqual({c.group.name for c in versions.curves_of(self.armature)}, {'high'})

    def test_a_set_for_bones_leaves_keys(self):
        self.active('Location, Rotation & Scale')
        said = []
        self.assertEqual(keys.key([self.control(self.up)], said=said), 0)
        self.assertEqual(said, ['the keying set Location, Rotation & Scale holds nothing of what moved, so that nothing is keyed'])
        self.assertIsNone(self.obj.data.shape_keys.animation_data)

    def test_set_of_what_is_available(self):
        self.over.keyframe_insert('value', frame=1)
        self.up.keyframe_insert('value', frame=1)
        self.active('Available')
        self.scene.frame_set(4)
        keys.key([self.control(self.up), self.turn()])
        self.assertEqual(self.frames(self.obj.data.shape_keys, 'key_blocks["up"].value'), [1, 4])
        self.assertEqual(self.frames(self.obj.data.shape_keys, 'key_blocks["over"].value'), [1], 'what did not move has no new key')
        self.assertIsNone(self.armature.animation_data)

    def test_whole_character(self):
        self.active('Whole Character')
        self.high['twist'] = 0.5
        keys.key([self.turn()])
        found = self.paths(self.armature)
        self.assertIn('pose.bones["high"]["twist"]', found)
        self.assertIn('pose.bones["high"].rotation_quaternion', found)
        self.assertFalse([path for path in found if '"low"' in path])

    def test_own_set(self):
        own = self.scene.keying_sets.new(idname='Face', name='Face')
        own.paths.add(self.armature, 'pose.bones["high"].rotation_quaternion', index=2, group_method='NAMED', group_name='Mine')
        own.paths.add(self.obj.data.shape_keys, 'key_blocks["over"].value')
        self.scene.keying_sets.active = own
        said = []
        self.assertEqual(keys.key([self.turn(), self.control(self.up)], said=said), 1)
        self.assertEqual(told(self.armature).keys(), {('pose.bones["high"].rotation_quaternion', 2)})
        self.assertEqual(told(self.armature)['pose.bones["high"].rotation_quaternion', 2][0], 'Mine')
        self.assertEqual(said, [])
        # While auto-key is on, the set counts where the user says so.
        self.auto(use_keyframe_insert_keyingset=True)
        self.assertEqual(keys.key([self.control(self.up)]), 0)
        self.settings.use_keyframe_insert_keyingset = False
        self.assertEqual(keys.key([self.control(self.up)]), 1)

    def test_rules_of_a_set(self):
        own = self.scene.keying_sets.new(idname='Face', name='Face')
        own.paths.add(self.obj.data.shape_keys, 'key_blocks["up"].value')
        self.scene.keying_sets.active = own
        for frame in (1, 5, 9):
            self.scene.frame_set(frame)
            keys.key([self.control(self.up)])
        self.assertEqual(self.frames(self.obj.data.shape_keys, 'key_blocks["up"].value'), [1, 5, 9])
        own.use_insertkey_override_needed = own.use_insertkey_needed = True
        self.scene.frame_set(20)
        keys.key([self.control(self.up)])
        kept = [1, 5, 20] if bpy.app.version < (4, 1, 0) else [1, 5, 9]
        self.assertEqual(self.frames(self.obj.data.shape_keys, 'key_blocks["up"].value'), kept, 'up to 4.0 Blender moves one that says nothing')
        self.assertEqual(keying_sets.rules_of(own, ()), {'INSERTKEY_NEEDED'})

    # Where keys go.

    def test_strip_that_is_tweaked(self):
        self.auto()
        owner = self.obj.data.shape_keys
        self.up.keyframe_insert('value', frame=1)
        action = owner.animation_data.action
        strip = owner.animation_data.nla_tracks.new().strips.new('moved', 10, action)
        owner.animation_data.action = None
        strip.action_frame_start, strip.action_frame_end, strip.scale = 1, 11, 2
        strip.select = True
        owner.animation_data.nla_tracks[0].select = True
        owner.animation_data.use_tweak_mode = True
        self.assertTrue(owner.animation_data.use_tweak_mode)
        self.assertEqual(owner.animation_data.action, action)
        self.scene.frame_set(20)
        self.up.value = 0.5
        self.settings.keyframe_type = 'EXTREME'
        keys.key([self.control(self.up)])
        points = keys.curve_of(owner, 'key_blocks["up"].value').keyframe_points
        self.assertEqual([(round(p.co.x, 3), p.type) for p in points], [(1, 'KEYFRAME'), (6, 'EXTREME')])
        self.settings.auto_keying_mode = 'REPLACE_KEYS'
        self.up.value = 0.25
        self.assertEqual(keys.key([self.control(self.up)]), 1)
        self.assertEqual(keys.curve_of(owner, 'key_blocks["up"].value').keyframe_points[1].co.y, 0.25)

    def test_other_frames(self):
        self.auto()
        self.scene.frame_set(3)
        keys.key([self.control(self.up)], frame=17)
        self.assertEqual(self.frames(self.obj.data.shape_keys, 'key_blocks["up"].value'), [17])

    def test_keys_of_several_meshes(self):
        """One control that is a key of each."""
        from penpose_blender.controls import KeyControl
        other = made.plate('Teeth')
        twin = made.add_key(other, 'up', (0, 0, 0.2))
        control = KeyControl([(self.obj, self.up), (other, twin)])
        control.set(0.5)
        self.auto()
        self.scene.frame_set(4)
        self.assertEqual(keys.key([control]), 2)
        for mesh in (self.obj, other):
            self.assertEqual([tuple(p.co) for p in keys.curve_of(mesh.data.shape_keys, 'key_blocks["up"].value').keyframe_points], [(4, 0.5)])

    def test_locked_curve(self):
        self.auto()
        self.up.keyframe_insert('value', frame=1)
        keys.curve_of(self.obj.data.shape_keys, 'key_blocks["up"].value').lock = True
        self.scene.frame_set(8)
        said = []
        self.assertEqual(keys.key([self.control(self.up), self.control(self.over)], said=said), 1, 'others are keyed')
        self.assertEqual(len(said), 1)
        self.assertRegex(said[0], r'^key_blocks\["up"\]\.value of .* takes no key: its curve is locked; unlock it')


if __name__ == '__main__':
    trial.main(__name__)
