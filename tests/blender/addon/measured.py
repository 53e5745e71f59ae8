"""Rigs where drivers, constraints and modifiers act: what controls do is measured. ZIP"""
import json
import math
import os
import subprocess
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import desk  # noqa: E402
import bpy  # noqa: E402
import numpy as np  # noqa: E402
import trial  # noqa: E402

desk.install(desk.ARGUMENTS[0])
import made  # noqa: E402
from penpose_blender import drawing, known, placing, rig  # noqa: E402


class Measured(made.Trial):
    def driven(self, owner_of, path):
        """A key and another that custom properties drive; drawing the key moves the property."""
        obj = made.plate()
        made.add_key(obj, 'up', (0, 0, 0.4), middle=(0, 0.5))
        made.add_key(obj, 'free', (0.3, 0, 0), middle=(0, -0.5))
        armature = made.bones(obj)
        owner = owner_of(obj, armature)
        owner['lift'] = 0.1
        owner.id_data.update_tag()
        bpy.context.view_layer.update()
        owner.id_properties_ui('lift').update(min=-1, max=2, soft_min=0, soft_max=1)
        made.drive(obj.data.shape_keys, 'key_blocks["up"].value', owner.id_data, path + '["lift"]', '0.5 * x + 0.2 * x * x')
        bpy.context.view_layer.update()
        return obj, armature, owner

    def test_properties_that_drive_keys(self):
        for owner_of, path in ((lambda o, a: a, ''), (lambda o, a: a.pose.bones['high'], 'pose.bones["high"]'), (lambda o, a: o, '')):
            with self.subTest(path=path):
                made.empty_file()
                obj, armature, owner = self.driven(owner_of, path)
                for bone in armature.pose.bones:
                    bone.lock_rotation = (True, True, True)
                before = made.state_of(obj, armature)
                shown = desk.shown_positions(obj)
                known = drawing.known(obj)
                self.assertEqual(known.rig.measured, 'drivers')
                self.assertEqual(made.state_of(obj, armature), before, 'measuring leaves all as it was')
                self.assertTrue(np.array_equal(desk.shown_positions(obj), shown))
                line = made.row(obj)
                kept = owner['lift']

                def change(on):
                    owner['lift'] = 0.9 if on else kept
                    owner.id_data.update_tag()
                drawn = made.Drawn(obj, line, made.shown_with(obj, change)[line])
                self.good(drawn)
                self.assertAlmostEqual(owner['lift'], 0.9, delta=0.05)

    def test_a_rig_of_drivers_is_posed_as_by_the_command_line(self):
        if not trial.PROGRAM:
            self.skipTest('PENPOSE does not say where the program is')
        obj = made.plate()
        for name, way, middle in (('up', (0, 0, 0.4), 0.5), ('over', (0.3, 0, 0.1), -0.3)):
            made.add_key(obj, name, way, middle=(0, middle))
            obj[name + 's'] = 0.0
            obj.update_tag()
            bpy.context.view_layer.update()
            obj.id_properties_ui(name + 's').update(min=0, max=1, soft_min=0, soft_max=1)
            made.drive(obj.data.shape_keys, 'key_blocks["%s"].value' % name, obj, '["%ss"]' % name)
        bpy.context.view_layer.update()
        character = drawing.known(obj).rig.character
        line, rest = made.row(obj), character.evaluate()
        target = character.evaluate([0.6, 0.3])[line]
        model, cases = os.path.join(desk.SCRATCH, 'driven.glb'), os.path.join(desk.SCRATCH, 'driven.json')
        with open(model, 'wb') as f:
            f.write(character.write('.glb'))
        reference = {'curve': 'row', 'vertices': [int(v) for v in line], 'target': target.tolist()}
        case = {'name': 'lift', 'references': [reference], 'constraints': []}
        with open(cases, 'w', encoding='utf-8') as f:
            json.dump({'mesh': 'driven.glb', 'cases': [case]}, f)
        done = subprocess.run([trial.PROGRAM, 'pose', model, '--cases', cases, '--json'], capture_output=True, text=True, check=True)
        placing.place_target(obj, placing.place_curve(obj, line), target)
        self.assertTrue(placing.solve(obj))
        answers = json.loads(done.stdout)['cases'][0]['parameters']
        for name, value in answers.items():
            self.assertAlmostEqual(obj[name], value, delta=1e-6, msg=answers)
        self.assertGreater(np.abs(desk.shown_positions(obj) - rest).max(), 0.1)

    def test_whole_numbers_and_chains(self):
        obj = made.plate()
        made.add_key(obj, 'up', (0, 0, 0.4), middle=(0, 0.5))
        obj['steps'], obj['between'] = 2, 0.0
        obj.update_tag()
        bpy.context.view_layer.update()
        obj.id_properties_ui('steps').update(min=0, max=10, soft_min=0, soft_max=10)
        made.drive(obj, '["between"]', obj, '["steps"]', '0.1 * x')
        made.drive(obj.data.shape_keys, 'key_blocks["up"].value', obj, '["between"]')
        bpy.context.view_layer.update()
        known = drawing.known(obj)
        self.assertEqual([c.name for c, _, _ in known.rig.parts], ['steps'])
        self.assertIs(type(obj['steps']), int)
        line = made.row(obj)

        def change(on):
            obj['steps'] = 8 if on else 2
            obj.update_tag()
        self.good(made.Drawn(obj, line, made.shown_with(obj, change)[line]), near=False)
        self.assertEqual((obj['steps'], type(obj['steps'])), (8, int))

    def test_measuring_leaves_values(self):
        obj, armature, _ = self.driven(lambda o, a: a, '')
        for bone, mode in zip(armature.pose.bones, ('QUATERNION', 'YZX')):
            bone.rotation_mode = mode
        armature.pose.bones['low'].rotation_quaternion = (0.9, 0.123, -0.2, 0.3)  # not of length 1
        armature.pose.bones['high'].rotation_euler = (0.3, 4.0, -0.2)
        armature['lift'] = 1.7  # beyond its soft range
        bpy.context.view_layer.update()
        before, shown = made.state_of(obj, armature), desk.shown_positions(obj)
        rig.Rig(obj)
        self.assertEqual(made.state_of(obj, armature), before)
        self.assertTrue(np.array_equal(desk.shown_positions(obj), shown))
        # Giving up a stroke leaves no trace either.
        shown_from = desk.seen(obj)
        line = desk.region_places(shown_from, shown[made.row(obj)])
        desk.draw(obj, 'reference', shown_from, line)
        stroke = drawing.Stroke(obj, 'target', shown_from)
        for place in line + [0, 60]:
            stroke.add(place)
            stroke.follow()
        self.assertNotEqual(made.state_of(obj, armature), before)
        stroke.cancel(obj)
        after = {k: v for k, v in made.state_of(obj, armature).items() if k != (obj.name, 'penpose')}
        self.assertEqual(after, before)

    def test_bones_driven_by_a_property(self):
        obj = made.plate()
        armature = made.bones(obj)
        high = armature.pose.bones['high']
        high.rotation_mode = 'XYZ'
        armature.pose.bones['low'].lock_rotation = (True, True, True)
        armature['bend'] = 0.0
        armature.update_tag()
        bpy.context.view_layer.update()
        curve = armature.driver_add('pose.bones["high"].rotation_euler', 2)
        curve.driver.type, curve.driver.expression = 'SCRIPTED', '0.8 * x'
        variable = curve.driver.variables.new()
        variable.name, variable.targets[0].id, variable.targets[0].data_path = 'x', armature, '["bend"]'
        bpy.context.view_layer.update()
        line = made.row(obj)

        def change(on):
            armature['bend'] = 0.6 if on else 0.0
            armature.update_tag()
        drawn = made.Drawn(obj, line, made.shown_with(obj, change)[line])
        self.good(drawn, shown=False)
        self.assertAlmostEqual(armature['bend'], 0.6, delta=0.05)

    def controlled_plate(self, place):
        """A plate with bones and one more, "control", at a place; the plate is active."""
        obj = made.plate()
        armature = made.bones(obj)
        made.activate(armature)
        bpy.ops.object.mode_set(mode='EDIT')
        bone = armature.data.edit_bones.new('control')
        bone.head, bone.tail = place, (place[0], place[1] + 0.3, place[2])
        bpy.ops.object.mode_set(mode='OBJECT')
        made.activate(obj)
        return obj, armature

    def test_copy_rotation(self):
        obj, armature = self.controlled_plate((0, 0.5, 0))
        copy = armature.pose.bones['high'].constraints.new('COPY_ROTATION')
        copy.target, copy.subtarget, copy.mix_mode, copy.owner_space, copy.target_space = armature, 'control', 'ADD', 'LOCAL', 'LOCAL'
        armature.pose.bones['low'].lock_rotation = (True, True, True)
        bpy.context.view_layer.update()
        self.assertEqual(drawing.known(obj).rig.measured, 'constraints of bones')
        line = made.row(obj)
        there = self.turned(armature, obj, (0, 0, 0.5), 'control')
        drawn = made.Drawn(obj, line, there[line])
        self.good(drawn, shown=False)

    def test_inverse_kinematics(self):
        obj, armature = self.controlled_plate((0.1, 0, 1))
        ik = armature.pose.bones['high'].constraints.new('IK')
        ik.target, ik.subtarget, ik.chain_count = armature, 'control', 2
        bpy.context.view_layer.update()
        line = made.row(obj, 0.75, 0.5)

        def change(on):
            armature.pose.bones['control'].location = (0.3, 0, 0.2) if on else (0, 0, 0)
        drawn = made.Drawn(obj, line, made.shown_with(obj, change)[line])
        self.good(drawn, shown=False)

    def test_modifiers(self):
        obj = made.plate()
        made.add_key(obj, 'up', (0, 0, 0.4), middle=(0, 0.5))
        obj.modifiers.new('Subdivision', 'SUBSURF')
        bpy.context.view_layer.update()
        line = made.row(obj)
        rest = drawing.known(obj).rig.character.evaluate()
        shown = desk.seen(obj)
        desk.draw(obj, 'reference', shown, desk.region_places(shown, rest[line]))
        self.assertTrue(desk.draw(obj, 'target', shown, desk.region_places(shown, rest[line] + [0, 0.2, 0])))
        made.empty_file()
        obj = made.plate()
        made.add_key(obj, 'up', (0, 0, 0.4), middle=(0, 0.5))
        bend = obj.modifiers.new('Bend', 'SIMPLE_DEFORM')
        bend.deform_method, bend.deform_axis, bend.angle = 'BEND', 'Y', math.radians(40)
        bpy.context.view_layer.update()
        self.assertEqual(drawing.known(obj).rig.measured, 'the modifier Bend')
        self.good(self.keys_drawn(obj, 'up', 0.7))

    def test_time_is_told(self):
        obj, _, _ = self.driven(lambda o, a: a, '')
        kept, known.LONG = known.LONG, 0.0
        try:
            drawing.known(obj)
        finally:
            known.LONG = kept
        self.assertRegex(' '.join(drawing.said(obj)), r'measuring what \d+ controls of Plate do took \d')

    def test_measured_once_while_nothing_changes(self):
        obj, _, _ = self.driven(lambda o, a: a, '')
        first = drawing.known(obj).rig
        self.assertIs(drawing.known(obj).rig, first)
        shown = desk.seen(obj)
        drawing.Stroke(obj, 'reference', shown)
        self.assertIs(drawing.known(obj).rig, first)


if __name__ == '__main__':
    trial.main(__name__)
