"""Characters of several meshes: what belongs together, equal keys, lines on any part, parts that come and go. ZIP FOLDER"""
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import desk  # noqa: E402
import bpy  # noqa: E402
import numpy as np  # noqa: E402
import trial  # noqa: E402

desk.install(desk.ARGUMENTS[0])
import made  # noqa: E402
from mathutils import Quaternion  # noqa: E402
from penpose_blender import drawing, mirror, placing, store  # noqa: E402
from penpose_blender.controls import Refused  # noqa: E402


def second(name='Teeth', z=0.0, side=7):
    """A small plate in front of the large one."""
    obj = made.plate(name, side, (0.3, 1, 0.3))
    bpy.ops.object.transform_apply(location=False, rotation=False, scale=True)
    obj.location = (0, -0.4, z)
    bpy.context.view_layer.update()
    return obj


class Characters(made.Trial):
    def pair(self):
        """A plate with two keys and bones, and a small one that the same armature carries, with one key of the same name."""
        teeth = second()
        made.add_key(teeth, 'up', (0, 0, 0.4))
        face = made.plate()
        made.add_key(face, 'up', (0, 0, 0.4), middle=(0, 0.5))
        made.add_key(face, 'over', (0.3, 0, 0), middle=(0, -0.5))
        armature = made.bones(face)
        teeth.vertex_groups.new(name='high').add(range(len(teeth.data.vertices)), 1, 'REPLACE')
        teeth.modifiers.new('Armature', 'ARMATURE').object = armature
        bpy.context.view_layer.update()
        return face, teeth, armature

    def test_equal_keys_are_one_control(self):
        face, teeth, armature = self.pair()
        for bone in armature.pose.bones:
            bone.lock_rotation = (True, True, True)
        self.good(self.keys_drawn(face, 'up', 0.7))
        self.assertEqual(drawing.parts(face), [face, teeth])
        values = [o.data.shape_keys.key_blocks['up'].value for o in (face, teeth)]
        self.assertAlmostEqual(values[0], 0.7, delta=0.03)
        self.assertEqual(values[0], values[1])

    def test_hidden_parts_move_along_and_are_not_drawn_on(self):
        face, teeth, armature = self.pair()
        for bone in armature.pose.bones:
            bone.lock_rotation = (True, True, True)
        teeth.hide_set(True)
        self.good(self.keys_drawn(face, 'up', 0.7))
        self.assertAlmostEqual(teeth.data.shape_keys.key_blocks['up'].value, 0.7, delta=0.03)
        shown = desk.seen(face)
        line = desk.region_places(shown, desk.shown_positions(face)[made.row(face, 0.0, 0.2)])
        desk.draw(face, 'reference', shown, line)
        self.assertEqual([c.owner for c in drawing.curves(face)], [face, face])

    def test_a_line_on_another_part(self):
        face, teeth, _ = self.pair()
        shown = desk.seen(face)
        count = len(face.data.vertices)
        rest = desk.shown_positions(face)
        line = [count + i for i in made.row(teeth, 0.0, 0.2)]
        desk.draw(face, 'reference', shown, desk.region_places(shown, rest[line]))
        self.assertEqual([c.owner for c in drawing.curves(face)], [teeth])
        self.assertEqual(drawing.curves(teeth), drawing.curves(face))
        key = teeth.data.shape_keys.key_blocks['up']
        there = made.shown_with(face, lambda on: setattr(key, 'value', 0.6 if on else 0.0))[line]
        # It is drawn with the other mesh active.
        made.activate(teeth)
        moved = desk.draw(teeth, 'target', shown, desk.region_places(shown, there))
        bpy.context.view_layer.update()
        self.assertTrue(moved)
        points = drawing.places(face, bpy.context.evaluated_depsgraph_get())[0][1]
        here = desk.region_places(shown, drawing.known(face).rig.space().from_world(points))
        wanted = desk.region_places(shown, there)
        self.assertLess(made._apart(here, wanted), 0.05 * desk.size_of(wanted))

    def test_a_line_over_two_parts(self):
        face, teeth, _ = self.pair()
        count = len(face.data.vertices)
        placing.place_curve(face, [*made.row(face, 0.0, 0.7), *[count + i for i in made.row(teeth, 0.0, 0.2)]])
        curve = drawing.curves(face)[0]
        self.assertEqual(len(set(curve['on'])), 2, 'points lie on both')
        before = len(drawing.known(face).rig.character.positions(drawing.known(face).numbers[1]))
        bpy.data.objects.remove(teeth if curve.owner == face else face)
        left = bpy.data.objects['Plate' if curve.owner == face else 'Teeth']
        one = drawing.known(left)
        self.assertLess(len(one.rig.character.positions(one.numbers[1])), before)

    def test_parts_come_and_go(self):
        face, teeth, armature = self.pair()
        shown = desk.seen(face)
        rest = desk.shown_positions(face)
        desk.draw(face, 'reference', shown, desk.region_places(shown, rest[made.row(face)]))
        places = drawing.places(face, bpy.context.evaluated_depsgraph_get())[0][1]
        large = made.plate('Coat', 41)
        large.location.y = 2
        large.parent = armature
        bpy.data.objects.remove(teeth)
        bpy.context.view_layer.update()
        self.assertEqual(drawing.parts(face, anew=True), [large, face])
        one = drawing.known(face)
        self.assertEqual((list(one.numbers), drawing.said(face)), ([1], []))
        self.assertTrue(np.allclose(drawing.places(face, bpy.context.evaluated_depsgraph_get())[0][1], places, atol=1e-6))

    def test_a_part_on_a_bone(self):
        face = made.plate()
        armature = made.bones(face)
        eye = second('Eye', 0.5)
        eye.parent, eye.parent_type, eye.parent_bone = armature, 'BONE', 'high'
        eye.matrix_parent_inverse = (armature.matrix_world @ armature.pose.bones['high'].matrix).inverted()
        armature.pose.bones['high'].rotation_quaternion = Quaternion((0.99, 0.05, 0.02, 0.1)).normalized()
        made.activate(face)
        bpy.context.view_layer.update()
        one = drawing.known(face)
        self.assertEqual((one.rig.measured, drawing.parts(face)), ('', [face, eye]))
        self.assertLess(float(np.abs(one.rig.character.evaluate() - desk.shown_positions(face)).max()), 1e-5)
        count = len(face.data.vertices)
        line = [count + i for i in made.row(eye, 0.0, 0.2)]
        there = self.turned(armature, face, (0.1, 0, 0.4))[line]
        shown = desk.seen(face)
        desk.draw(eye, 'reference', shown, desk.region_places(shown, desk.shown_positions(face)[line]))
        self.assertEqual({c.bone for c in desk.draw(eye, 'target', shown, desk.region_places(shown, there))} - {'low', 'high'}, set())
        bpy.context.view_layer.update()
        wanted = desk.region_places(shown, there)
        self.assertLess(made._apart(desk.region_places(shown, desk.shown_positions(face)[line]), wanted), 0.1 * desk.size_of(wanted))
        self.assertLess(float(np.abs(drawing.known(face).rig.character.evaluate() - desk.shown_positions(face)).max()), 1e-5)

    def test_what_belongs_together(self):
        def apart(how, wanted):
            made.empty_file()
            face, other = made.plate(), second()
            how(face, other)
            bpy.context.view_layer.update()
            self.assertEqual(len(drawing.parts(face, anew=True)), wanted, how.__name__)

        def alone(face, other):
            pass

        def child(face, other):
            other.parent = face

        def hang(face, other):
            above = bpy.data.objects.new('Above', None)
            bpy.context.scene.collection.objects.link(above)
            face.parent = other.parent = above

        def driven(face, other):
            for obj in (face, other):
                made.add_key(obj, 'up', (0, 0, 0.4))
            made.drive(other.data.shape_keys, 'key_blocks["up"].value', face, 'data.shape_keys.key_blocks["up"].value')
            other.data.shape_keys.animation_data.drivers[0].driver.variables[0].targets[0].id_type = 'KEY'
            other.data.shape_keys.animation_data.drivers[0].driver.variables[0].targets[0].id = face.data.shape_keys
            other.data.shape_keys.animation_data.drivers[0].driver.variables[0].targets[0].data_path = 'key_blocks["up"].value'

        def same_value(face, other):
            board = bpy.data.objects.new('Board', None)
            bpy.context.scene.collection.objects.link(board)
            board['lift'] = 0.0
            for obj in (face, other):
                made.add_key(obj, 'up', (0, 0, 0.4))
                made.drive(obj.data.shape_keys, 'key_blocks["up"].value', board, '["lift"]')

        def other_values(face, other):
            board = bpy.data.objects.new('Board', None)
            bpy.context.scene.collection.objects.link(board)
            board['lift'] = board['sink'] = 0.0
            for obj, name in ((face, 'lift'), (other, 'sink')):
                made.add_key(obj, 'up', (0, 0, 0.4))
                made.drive(obj.data.shape_keys, 'key_blocks["up"].value', board, '["%s"]' % name)

        def two_rigs(face, other):
            above = bpy.data.objects.new('Scene', None)
            bpy.context.scene.collection.objects.link(above)
            for name, obj in (('One', face), ('Other', other)):
                armature = made.bones(obj, name)
                armature.parent = obj.parent = above
        for how, wanted in ((alone, 1), (child, 2), (hang, 2), (driven, 2), (same_value, 2), (other_values, 1), (two_rigs, 1)):
            with self.subTest(how=how.__name__):
                apart(how, wanted)

    def test_a_driven_twin_moves_along(self):
        face, other = made.plate(), second()
        for obj in (face, other):
            made.add_key(obj, 'up', (0, 0, 0.4), middle=(0, 0.5) if obj == face else (0, 0))
        curve = other.data.shape_keys.driver_add('key_blocks["up"].value')
        curve.driver.type, curve.driver.expression = 'SCRIPTED', 'x'
        variable = curve.driver.variables.new()
        variable.name = 'x'
        variable.targets[0].id_type, variable.targets[0].id = 'KEY', face.data.shape_keys
        variable.targets[0].data_path = 'key_blocks["up"].value'
        made.activate(face)
        bpy.context.view_layer.update()
        self.assertEqual(drawing.known(face).rig.measured, 'drivers')
        self.good(self.keys_drawn(face, 'up', 0.7))

    def test_mirrored(self):
        face = made.plate()
        for name, x in (('left', 0.5), ('right', -0.5)):
            made.add_key(face, name, (0, 0, 0.3), middle=(x, 0.5), width=0.3)
        shown = desk.seen(face, yaw=10)
        rest = desk.shown_positions(face)
        line = [i for i in made.row(face, 0.5, 0.8) if face.data.vertices[i].co.x > 0.2]
        key = face.data.shape_keys.key_blocks['left']
        there = made.shown_with(face, lambda on: setattr(key, 'value', 0.8 if on else 0.0))[line]
        desk.draw(face, 'reference', shown, desk.region_places(shown, rest[line]))
        desk.draw(face, 'target', shown, desk.region_places(shown, there))
        self.assertAlmostEqual(key.value, 0.8, delta=0.05)
        moved = mirror.mirror_curve(face, 1)
        self.assertEqual([c.name for c in moved], ['right'])
        self.assertAlmostEqual(face.data.shape_keys.key_blocks['right'].value, key.value, delta=0.03)
        self.assertEqual([c['id'] for c in drawing.curves(face)], [1, 2])

    def test_only_what_is_selected(self):
        face, _, armature = self.pair()
        line = made.row(face)
        shown = desk.seen(face)
        rest = desk.shown_positions(face)
        there = desk.region_places(shown, rest[line] + [0, 0.2, 0])
        desk.draw(face, 'reference', shown, desk.region_places(shown, rest[line]))
        settings = bpy.context.window_manager.penpose
        if not hasattr(settings, 'selected_only'):
            self.skipTest('the setting is not there')
        settings.selected_only = True
        try:
            face.active_shape_key_index = 0
            with self.assertRaisesRegex(Refused, 'nothing is selected that may move'):
                drawing.Stroke(face, 'target', shown)
            face.active_shape_key_index = 2
            before = made.state_of(face, armature)
            moved = desk.draw(face, 'target', shown, there, 1)
            self.assertEqual([c.name for c in moved if c.name != 'over'], [])
            face.active_shape_key_index = 1
            self.assertEqual([c.name for c in desk.draw(face, 'target', shown, there, 1) if c.name != 'up'], [])
            self.assertNotEqual(made.state_of(face, armature), before)
        finally:
            settings.selected_only = False

    def test_avatars(self):
        for name, line, key in (('ict_avatar.glb', None, 'mouthSmile_L'),):
            with self.subTest(name=name):
                obj = desk.opened(trial.model(name))
                meshes = drawing.parts(obj)
                self.assertEqual(sorted(m.name for m in meshes), ['body', 'eye_L', 'eye_R', 'face', 'hair'])
                character = drawing.known(obj).rig.character
                self.assertLess(float(np.abs(character.evaluate() - desk.shown_positions(obj)).max()), 1e-5)

    def test_curves_of_a_copy(self):
        face, teeth, _ = self.pair()
        shown = desk.seen(face)
        desk.draw(face, 'reference', shown, desk.region_places(shown, desk.shown_positions(face)[made.row(face)]))
        copy = face.copy()
        copy.data = face.data.copy()
        bpy.context.scene.collection.objects.link(copy)
        bpy.context.view_layer.update()
        self.assertEqual(sorted(drawing.known(face).numbers), [1, 2])
        self.assertTrue(drawing.change(face, 2, lambda curve: curve))
        drawing.delete(face, 2)
        self.assertEqual([c['id'] for c in drawing.curves(copy)], [1])
        self.assertEqual(sum(len(store.read(o)['curves']) for o in drawing.parts(face)), 1)
        self.assertEqual(len(drawing.curves(teeth)), 1)


if __name__ == '__main__':
    trial.main(__name__)
