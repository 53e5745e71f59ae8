"""Face boards: bones and objects whose places drive keys, properties, chains of drivers, and what is preferred. ZIP"""
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import desk  # noqa: E402
import bpy  # noqa: E402
import trial  # noqa: E402

desk.install(desk.ARGUMENTS[0])
import made  # noqa: E402
from penpose_blender import drawing  # noqa: E402


def board(names, limits=((-1, 1), (-1, 1))):
    """An armature beside the face with a bone for each name, whose places are limited in x and y."""
    data = bpy.data.armatures.new('Board')
    armature = bpy.data.objects.new('Board', data)
    bpy.context.scene.collection.objects.link(armature)
    armature.location = (4, 0, 0)
    made.activate(armature)
    bpy.ops.object.mode_set(mode='EDIT')
    for i, name in enumerate(names):
        bone = data.edit_bones.new(name)
        bone.head, bone.tail = (0, 0, i), (0, 0, i + 0.3)
    bpy.ops.object.mode_set(mode='OBJECT')
    for bone in armature.pose.bones:
        bone.lock_rotation, bone.lock_scale, bone.lock_location = (True,) * 3, (True,) * 3, (False, False, True)
        if limits is None:
            continue
        limit = bone.constraints.new('LIMIT_LOCATION')
        limit.owner_space, limit.use_transform_limit = 'LOCAL', True
        for letter, (least, most) in zip('xy', limits):
            for end, value in (('min_', least), ('max_', most)):
                setattr(limit, 'use_' + end + letter, True)
                setattr(limit, end + letter, value)
    return armature


def drive_by_place(keys, key, armature, bone, kind='LOC_Y', expression='x', space='LOCAL_SPACE'):
    """A key's value by the place of a bone (or an object, without one)."""
    curve = keys.driver_add('key_blocks["%s"].value' % key)
    curve.driver.type, curve.driver.expression = 'SCRIPTED', expression
    variable = curve.driver.variables.new()
    variable.name, variable.type = 'x', 'TRANSFORMS'
    target = variable.targets[0]
    target.id, target.transform_type, target.transform_space = armature, kind, space
    if bone:
        target.bone_target = bone
    return curve


class Boards(made.Trial):
    def face(self):
        obj = made.plate()
        for name, way, z in (('smile', (0, 0, 0.3), 0.5), ('frown', (0, 0, -0.3), 0.5), ('wide', (0.3, 0, 0), -0.5)):
            made.add_key(obj, name, way, middle=(0, z))
        return obj

    def moved_place(self, obj, armature, bone, place, z=0.5, **settings):
        pose = armature.pose.bones[bone]

        def change(on):
            pose.location = place if on else (0, 0, 0)
        line = made.row(obj, z)
        there = made.shown_with(obj, change)
        return made.Drawn(obj, line, there[line], **settings)

    def test_both_ways_of_a_bone(self):
        for limits in (((-1, 1), (-1, 1)), None):
            for y in (0.7, -0.6):
                with self.subTest(limits=limits, y=y):
                    made.empty_file()
                    obj = self.face()
                    armature = board(['mouth'], limits)
                    keys = obj.data.shape_keys
                    drive_by_place(keys, 'smile', armature, 'mouth', expression='max(0, x)')
                    drive_by_place(keys, 'frown', armature, 'mouth', expression='max(0, -x)')
                    drive_by_place(keys, 'wide', armature, 'mouth', 'LOC_X')
                    made.activate(obj)
                    bpy.context.view_layer.update()
                    drawn = self.moved_place(obj, armature, 'mouth', (0, y, 0))
                    self.good(drawn)
                    self.assertEqual({c.name for c in drawn.moved}, {'mouth.y'})
                    self.assertAlmostEqual(armature.pose.bones['mouth'].location.y, y, delta=0.05)
                    self.assertEqual(tuple(armature.pose.bones['mouth'].location)[::2], (0, 0))

    def test_limits_hold(self):
        obj = self.face()
        armature = board(['mouth'], ((0, 0), (0, 0.4)))
        drive_by_place(obj.data.shape_keys, 'smile', armature, 'mouth')
        for name in ('frown', 'wide'):
            obj.data.shape_keys.key_blocks[name].mute = True
        made.activate(obj)
        bpy.context.view_layer.update()
        line = made.row(obj)
        drawn = made.Drawn(obj, line, desk.shown_positions(obj)[line] + [0, 0.3, 0])
        self.good(drawn, near=False)
        self.assertAlmostEqual(armature.pose.bones['mouth'].location.y, 0.4, delta=1e-3)

    def test_an_object(self):
        for path in ('transforms', 'single'):
            with self.subTest(path=path):
                made.empty_file()
                obj = self.face()
                handle = bpy.data.objects.new('Handle', None)
                bpy.context.scene.collection.objects.link(handle)
                handle.location = (3, 0, 1)
                if path == 'transforms':
                    drive_by_place(obj.data.shape_keys, 'smile', handle, '', 'LOC_Z', 'x - 1', 'WORLD_SPACE')
                else:
                    made.drive(obj.data.shape_keys, 'key_blocks["smile"].value', handle, 'location[2]', 'x - 1')
                for name in ('frown', 'wide'):
                    obj.data.shape_keys.key_blocks[name].mute = True
                bpy.context.view_layer.update()
                line = made.row(obj)

                def change(on):
                    handle.location.z = 1.6 if on else 1.0
                drawn = made.Drawn(obj, line, made.shown_with(obj, change)[line])
                self.good(drawn)
                self.assertEqual({c.name for c in drawn.moved}, {'Handle.z'})
                self.assertAlmostEqual(handle.location.z, 1.6, delta=0.05)

    def test_a_chain_of_drivers(self):
        obj = self.face()
        armature = board(['mouth'])
        bone = armature.pose.bones['mouth']
        bone['amount'] = 0.0
        curve = armature.driver_add('pose.bones["mouth"]["amount"]')
        curve.driver.type, curve.driver.expression = 'SCRIPTED', 'x'
        variable = curve.driver.variables.new()
        variable.name, variable.type = 'x', 'TRANSFORMS'
        variable.targets[0].id, variable.targets[0].bone_target = armature, 'mouth'
        variable.targets[0].transform_type, variable.targets[0].transform_space = 'LOC_Y', 'LOCAL_SPACE'
        made.drive(obj.data.shape_keys, 'key_blocks["smile"].value', armature, 'pose.bones["mouth"]["amount"]')
        for name in ('frown', 'wide'):
            obj.data.shape_keys.key_blocks[name].mute = True
        made.activate(obj)
        bpy.context.view_layer.update()
        drawn = self.moved_place(obj, armature, 'mouth', (0, 0.7, 0))
        self.good(drawn)
        self.assertEqual({c.name for c in drawn.moved}, {'mouth.y'})

    def test_a_property_before_the_bone_it_drives(self):
        obj = made.plate()
        armature = made.bones(obj)
        made.activate(armature)
        bpy.ops.object.mode_set(mode='EDIT')
        above = armature.data.edit_bones.new('above')
        above.head, above.tail = (0, 0, 0), (0, 0.3, 0)
        armature.data.edit_bones['high'].use_connect = False
        armature.data.edit_bones['high'].parent = above
        bpy.ops.object.mode_set(mode='OBJECT')
        made.activate(obj)
        for bone in armature.pose.bones:
            bone.rotation_mode = 'XYZ'
        armature.pose.bones['low'].lock_rotation = (True, True, True)
        armature.pose.bones['above'].lock_rotation = (True, True, False)
        armature['bend'] = 0.0
        armature.update_tag()
        bpy.context.view_layer.update()
        # The property turns the bone 'high' as 'above', which carries it, does by hand.
        curve = armature.driver_add('pose.bones["high"].rotation_euler', 2)
        curve.driver.type, curve.driver.expression = 'SCRIPTED', '0.8 * x'
        variable = curve.driver.variables.new()
        variable.name, variable.targets[0].id, variable.targets[0].data_path = 'x', armature, '["bend"]'
        bpy.context.view_layer.update()
        line = made.row(obj)

        def change(on):
            armature['bend'] = 0.4 if on else 0.0
            armature.update_tag()
        drawn = made.Drawn(obj, line, made.shown_with(obj, change)[line])
        self.good(drawn, shown=False)
        self.assertIn('bend', {c.name for c in drawn.moved})

    def test_the_board_of_two_meshes(self):
        obj = self.face()
        teeth = made.plate('Teeth', 7)
        made.add_key(teeth, 'smile', (0, 0, 0.3))
        teeth.location.y = 1
        armature = board(['mouth'])
        for one in (obj, teeth):
            drive_by_place(one.data.shape_keys, 'smile', armature, 'mouth')
        made.activate(obj)
        bpy.context.view_layer.update()
        self.assertEqual(drawing.parts(obj), [obj, teeth])
        self.good(self.moved_place(obj, armature, 'mouth', (0, 0.6, 0)))
        self.assertAlmostEqual(teeth.data.shape_keys.key_blocks['smile'].value, armature.pose.bones['mouth'].location.y, delta=1e-6)

    def test_a_board_that_is_given_up(self):
        obj = self.face()
        armature = board(['mouth'])
        drive_by_place(obj.data.shape_keys, 'smile', armature, 'mouth')
        made.activate(obj)
        bpy.context.view_layer.update()
        before, shown = made.state_of(obj, armature), desk.seen(obj)
        line = desk.region_places(shown, desk.shown_positions(obj)[made.row(obj)])
        desk.draw(obj, 'reference', shown, line)
        stroke = drawing.Stroke(obj, 'target', shown)
        for place in line + [0, 60]:
            stroke.add(place)
            stroke.follow()
        armature.name, armature.pose.bones['mouth'].name = 'Renamed', 'renamed'
        stroke.add(line[-1] + [5, 60])
        stroke.follow()
        self.assertGreater(armature.pose.bones['renamed'].location.y, 0.1)
        stroke.cancel(obj)
        armature.name, armature.pose.bones['renamed'].name = 'Board', 'mouth'
        self.assertEqual({k: v for k, v in made.state_of(obj, armature).items() if k != (obj.name, 'penpose')}, before)


if __name__ == '__main__':
    trial.main(__name__)
