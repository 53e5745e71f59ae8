"""Rigs as they are in Blender: rotation modes, locks, limits, keys of all kinds, scales, parents, links. ZIP"""
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import desk  # noqa: E402
import bpy  # noqa: E402
import numpy as np  # noqa: E402
import trial  # noqa: E402

desk.install(desk.ARGUMENTS[0])
import made  # noqa: E402
from mathutils import Euler, Matrix, Quaternion  # noqa: E402
from penpose_blender import bones, drawing  # noqa: E402
from penpose_blender.character import armature_of  # noqa: E402
from penpose_blender.controls import Refused  # noqa: E402


def linked_character(path):
    """The collection of a character that another file has, linked into an empty one."""
    made.empty_file()
    with bpy.data.libraries.load(path, link=True) as (_, to):
        to.collections = ['Character']
    bpy.context.scene.collection.children.link(to.collections[0])
    return to.collections[0]


class Rigs(made.Trial):
    def test_rotation_modes(self):
        for mode in ('QUATERNION', 'XYZ', 'XZY', 'YXZ', 'YZX', 'ZXY', 'ZYX', 'AXIS_ANGLE'):
            for start in ((0, 0, 0), (0.2, -0.3, 0.15)):
                with self.subTest(mode=mode):
                    made.empty_file()
                    obj = made.plate()
                    armature = made.bones(obj)
                    for bone in armature.pose.bones:
                        bone.rotation_mode = mode
                        bones.set_turn(bone, Euler(start).to_quaternion())
                    bpy.context.view_layer.update()
                    self.assertEqual(drawing.known(obj).rig.measured, '')
                    line = made.row(obj)
                    there = self.turned(armature, obj, (start[0] + 0.1, start[1] - 0.2, start[2] + 0.5))
                    drawn = made.Drawn(obj, line, there[line])
                    self.good(drawn)
                    self.assertEqual({b.rotation_mode for b in armature.pose.bones}, {mode})

    def test_locks(self):
        for mode, components in (('QUATERNION', False), ('QUATERNION', True), ('XYZ', True), ('YZX', False), ('AXIS_ANGLE', False)):
            for locked in ((True, False, False), (False, True, False), (True, True, False), (False, True, True)):
                with self.subTest(mode=mode, components=components, locked=locked):
                    made.empty_file()
                    obj = made.plate()
                    armature = made.bones(obj)
                    for bone in armature.pose.bones:
                        bone.rotation_mode = mode
                        bones.set_turn(bone, Euler((0.2, -0.1, 0.15)).to_quaternion())
                        bone.lock_rotation, bone.lock_rotations_4d = locked, components
                    bpy.context.view_layer.update()
                    order = mode if len(mode) == 3 else 'XYZ'
                    channels = (lambda b: list(b.rotation_quaternion)[1:]) if components and mode == 'QUATERNION' else (
                        lambda b: bones.turn_of(b).to_matrix().to_euler(order))
                    before = {b.name: channels(b) for b in armature.pose.bones}
                    line = made.row(obj)
                    there = self.turned(armature, obj, (0.4, 0.1, 0.5), order=order)
                    drawn = made.Drawn(obj, line, there[line])
                    self.good(drawn, near=False)
                    for bone in armature.pose.bones:
                        now = channels(bone)
                        for axis in range(3):
                            if locked[axis]:
                                self.assertAlmostEqual(now[axis], before[bone.name][axis], delta=2e-6)

    def test_all_locked_or_4d(self):
        obj = made.plate()
        armature = made.bones(obj)
        armature.pose.bones['high'].lock_rotation = (True, True, True)
        low = armature.pose.bones['low']
        low.lock_rotations_4d, low.lock_rotation_w = True, True
        with self.assertRaisesRegex(Refused, 'Plate has nothing to pose'):
            drawing.known(obj)

    def test_limits(self):
        for mode, order in (('QUATERNION', 'AUTO'), ('XYZ', 'AUTO'), ('ZYX', 'AUTO'), ('YZX', 'XZY')):
            for least, most in ((-0.1, 0.2), (0.3, 0.9)):
                with self.subTest(mode=mode, least=least):
                    made.empty_file()
                    obj = made.plate()
                    armature = made.bones(obj)
                    for bone in armature.pose.bones:
                        bone.rotation_mode = mode
                        limit = bone.constraints.new('LIMIT_ROTATION')
                        limit.owner_space, limit.euler_order = 'LOCAL', order
                        limit.use_limit_x = limit.use_limit_y = limit.use_limit_z = True
                        limit.min_x, limit.max_x = -0.05, 0.05
                        limit.min_y, limit.max_y = -0.2, 0.2
                        limit.min_z, limit.max_z = least, most
                    bpy.context.view_layer.update()
                    known = drawing.known(obj)
                    self.assertEqual(known.rig.measured, '')
                    self.assertLess(float(np.abs(known.rig.character.evaluate() - desk.shown_positions(obj)).max()), 1e-5)
                    line = made.row(obj)
                    there = desk.shown_positions(obj)[line]
                    turn = np.array(Matrix.Rotation(-0.8, 3, 'Z'))
                    drawn = made.Drawn(obj, line, there @ turn.T)
                    self.good(drawn, near=False)
                    for bone in [armature.pose.bones[c.bone] for c in drawn.moved]:
                        real = bones.turn_of(bone)
                        self.assertGreater(abs(real.dot(bones.limited(bone, real))), 1 - 1e-6, 'the bone itself stays in its limit')

    def test_slider_ranges(self):
        for least, most, value in ((0.0, 1.0, 0.7), (-1.0, 1.0, -0.6), (0.2, 1.0, 0.8), (0.0, 10.0, 4.0), (-2.0, -0.5, -1.2)):
            with self.subTest(least=least, most=most):
                made.empty_file()
                obj = made.plate()
                made.add_key(obj, 'up', (0, 0, 0.1 if most > 5 else 0.4), least, most, middle=(0, 0.5))
                made.add_key(obj, 'over', (0.3, 0, 0), middle=(0, -0.5))
                obj.data.shape_keys.key_blocks['up'].value = least
                drawn = self.keys_drawn(obj, 'up', value)
                self.good(drawn)
                self.assertAlmostEqual(obj.data.shape_keys.key_blocks['up'].value, value, delta=0.05 * (most - least))
        # Past the end of the slider the key stays at the end.
        made.empty_file()
        obj = made.plate()
        key = made.add_key(obj, 'up', (0, 0, 0.4), 0.2, 0.5, middle=(0, 0.5))
        line = made.row(obj)
        drawn = made.Drawn(obj, line, desk.shown_positions(obj)[line] + [0, 0.15, 0])
        self.good(drawn, near=False)
        self.assertAlmostEqual(key.value, 0.5, delta=1e-6)

    def test_muted_grouped_and_relative_keys(self):
        obj = made.plate()
        made.add_key(obj, 'muted', (0, 0, 0.4), middle=(0, 0.5), mute=True, value=0.5)
        obj.vertex_groups.new(name='right').add([v.index for v in obj.data.vertices if v.co.x > 0], 0.75, 'REPLACE')
        made.add_key(obj, 'grouped', (0, 0, 0.4), middle=(0, 0.5), vertex_group='right')
        first = made.add_key(obj, 'first', (0.3, 0, 0), middle=(0, -0.5))
        made.add_key(obj, 'relative', (0.3, 0, 0.3), middle=(0, -0.5)).relative_key = first
        self.good(self.keys_drawn(obj, 'relative', 0.8, z=-0.5))
        keys = obj.data.shape_keys.key_blocks
        self.assertAlmostEqual(keys['relative'].value, 0.8, delta=0.03)
        drawing.delete(obj)
        line = [v for v in made.row(obj, reach=0.7) if obj.data.vertices[v].co.x > 0.05]
        there = desk.shown_positions(obj)[line] + [0, 0.2, 0]
        self.good(made.Drawn(obj, line, there), near=False)
        self.assertGreater(keys['grouped'].value, 0.5)
        self.assertEqual(keys['muted'].value, 0.5)

    def test_scales_and_parents(self):
        for scale in ((1, 1, 1), (2, 0.5, 1.5), (-1, 1, 1), (-1, -2, 0.5), (100, 100, 100), (0.001, 0.001, 0.001)):
            for rigged in (False, True):
                with self.subTest(scale=scale, rigged=rigged):
                    made.empty_file()
                    obj = made.plate()
                    made.add_key(obj, 'up', (0, 0, 0.4), middle=(0, 0.5))
                    above = bpy.data.objects.new('Above', None)
                    bpy.context.scene.collection.objects.link(above)
                    above.rotation_euler, above.scale = (0.3, 0.2, -0.4), scale
                    above.location = np.array((3, 1, -2)) * abs(scale[0])  # what Blender rounds is as small as it is
                    if rigged:
                        armature = made.bones(obj)
                        armature.parent, armature.scale, armature.rotation_euler = above, (1, 1.5, 1), (0, 0.1, 0)
                        armature.pose.bones['low'].rotation_quaternion = Quaternion((0.99, 0.1, 0.02, 0.05))
                        armature.pose.bones['low'].scale = (1.2, 0.9, 1.1)
                        armature.pose.bones['low'].location = (0.1, 0.02, 0)
                        obj.scale, obj.rotation_euler, obj.parent = (1.1, 0.8, 1), (0, 0, 0.2), armature
                    else:
                        obj.parent = above
                    bpy.context.view_layer.update()
                    drawn = self.keys_drawn(obj, 'up', 0.7)
                    self.good(drawn, near=not rigged)

    def test_vertices_that_no_bone_carries(self):
        obj = made.plate()
        armature = made.bones(obj)
        free = [v.index for v in obj.data.vertices if v.co.z < -0.9]
        for group in obj.vertex_groups:
            group.remove(free)
        armature.location, armature.scale = (0.5, 0, 0), (1, 2, 1)
        armature.pose.bones['low'].rotation_quaternion = Quaternion((0.99, 0.1, 0.02, 0.05))
        bpy.context.view_layer.update()
        line = made.row(obj)
        self.good(made.Drawn(obj, line, self.turned(armature, obj, (0, 0, 0.4))[line]))

    def test_armature_moved_between_strokes(self):
        obj = made.plate()
        armature = made.bones(obj)
        line = made.row(obj)
        self.good(made.Drawn(obj, line, self.turned(armature, obj, (0, 0, 0.3))[line]))
        armature.location = (0.3, 0, 0.2)
        bpy.context.view_layer.update()
        drawing.delete(obj)
        self.good(made.Drawn(obj, line, self.turned(armature, obj, (0, 0, -0.3))[line]))

    def test_links_and_overrides(self):
        obj = made.plate()
        made.add_key(obj, 'up', (0, 0, 0.4), middle=(0, 0.5))
        armature = made.bones(obj)
        obj.parent = armature
        group = bpy.data.collections.new('Character')
        bpy.context.scene.collection.children.link(group)
        for one in (obj, armature):
            group.objects.link(one)
            bpy.context.scene.collection.objects.unlink(one)
        path = os.path.join(desk.SCRATCH, 'character.blend')
        bpy.ops.wm.save_as_mainfile(filepath=path)
        linked_character(path)
        linked = bpy.data.objects['Plate']
        with self.assertRaisesRegex(Refused, 'Plate is linked; make a library override'):
            drawing.known(linked)
        # The object alone overridden: its armature is still linked.
        made.empty_file()
        with bpy.data.libraries.load(path, link=True) as (_, to):
            to.objects = ['Plate']
        bpy.context.scene.collection.objects.link(to.objects[0])
        alone = to.objects[0].override_create()
        bpy.context.scene.collection.objects.link(alone)
        bpy.context.view_layer.update()
        with self.assertRaisesRegex(Refused, 'linked.*make a library override of the whole character'):
            drawing.known(alone)
        linked_character(path).override_hierarchy_create(bpy.context.scene, bpy.context.view_layer)
        over = next(o for o in bpy.data.objects if o.type == 'MESH' and o.override_library)
        rig_over = next(o for o in bpy.data.objects if o.type == 'ARMATURE' and o.override_library)
        try:
            over.override_library.is_system_override = rig_over.override_library.is_system_override = False
        except AttributeError:
            pass
        bpy.context.view_layer.update()
        drawing.known(over)  # its bones; its keys are still linked
        over.data.override_create(remap_local_usages=True)
        bpy.context.view_layer.update()
        self.assertEqual([c.key for c, _, _ in drawing.known(over).rig.parts if hasattr(c, 'key')], ['up'])
        self.good(self.keys_drawn(over, 'up', 0.7))
        saved = os.path.join(desk.SCRATCH, 'scene.blend')
        values, pose = {k.name: k.value for k in over.data.shape_keys.key_blocks}, made.state_of(rig_over)
        bpy.ops.wm.save_as_mainfile(filepath=saved)
        bpy.ops.wm.open_mainfile(filepath=saved)
        over = next(o for o in bpy.data.objects if o.type == 'MESH' and o.override_library)
        rig_over = next(o for o in bpy.data.objects if o.type == 'ARMATURE' and o.override_library)
        self.assertEqual({k.name: k.value for k in over.data.shape_keys.key_blocks}, values)
        self.assertEqual(made.state_of(rig_over), pose)
        self.assertEqual(len(drawing.store.read(over)['curves']), 1)

    def test_another_rig_that_is_followed_and_linked(self):
        other = made.plate('Prop')
        path = os.path.join(desk.SCRATCH, 'prop.blend')
        armature = made.bones(other, 'Prop rig')
        bpy.ops.wm.save_as_mainfile(filepath=path)
        del armature
        made.empty_file()
        obj = made.plate()
        own = made.bones(obj)
        with bpy.data.libraries.load(path, link=True) as (_, to):
            to.objects = ['Prop rig']
        bpy.context.scene.collection.objects.link(to.objects[0])
        follow = own.pose.bones['low'].constraints.new('COPY_LOCATION')
        follow.target, follow.subtarget, follow.influence = to.objects[0], 'low', 0.5
        bpy.context.view_layer.update()
        line = made.row(obj)
        there = self.turned(own, obj, (0, 0, 0.3))[line]
        self.good(made.Drawn(obj, line, there), near=False, shown=False)

    def test_a_linked_collection_is_overridden(self):
        obj = made.plate()
        made.add_key(obj, 'up', (0, 0, 0.4), middle=(0, 0.5))
        teeth = made.plate('Teeth', 7)
        made.add_key(teeth, 'up', (0, 0, 0.4))
        teeth.location.y = 1
        made.activate(obj)
        armature = made.bones(obj)
        obj.parent = teeth.parent = armature
        group = bpy.data.collections.new('Character')
        bpy.context.scene.collection.children.link(group)
        for one in (obj, teeth, armature):
            group.objects.link(one)
            bpy.context.scene.collection.objects.unlink(one)
        path = os.path.join(desk.SCRATCH, 'collection.blend')
        bpy.ops.wm.save_as_mainfile(filepath=path)
        made.empty_file()
        with bpy.data.libraries.load(path, link=True) as (_, to):
            to.collections = ['Character']
        empty = bpy.data.objects.new('Stands for it', None)
        empty.instance_type, empty.instance_collection = 'COLLECTION', to.collections[0]
        bpy.context.scene.collection.objects.link(empty)
        made.activate(empty)
        self.assertEqual(drawing.overridable(bpy.context), empty)
        over = drawing.make_override(bpy.context)
        self.assertIsNone(drawing.overridable(bpy.context))
        self.assertIsNotNone(over.override_library)
        self.assertEqual(len(drawing.parts(over)), 2)
        for bone in armature_of(over).pose.bones:
            bone.lock_rotation = (True, True, True)
        self.good(self.keys_drawn(over, 'up', 0.7))
        self.assertEqual({round(o.data.shape_keys.key_blocks['up'].value, 6) for o in drawing.parts(over)},
                         {round(over.data.shape_keys.key_blocks['up'].value, 6)})


if __name__ == '__main__':
    trial.main(__name__)
