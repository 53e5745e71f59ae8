"""The add-on's interface: mirror and flip, selected only, overrides, the hint, keys of the keyboard. ZIP"""
import importlib.util
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
from mathutils import Euler  # noqa: E402
from penpose_blender import curves, drawing, free_keys, lines, mirror, pen, preferences, versions  # noqa: E402
from penpose_blender.controls import Refused  # noqa: E402


class Sides(unittest.TestCase):
    """A plate with a key on each side."""

    def setUp(self):
        made.empty_file()
        self.obj = made.plate()
        self.keys = [made.add_key(self.obj, 'up' + side, (0, 0, 0.4), middle=(x, 0.5), width=0.3) for side, x in (('_L', 0.5), ('_R', -0.5))]
        self.shown = desk.seen(self.obj)

    def values(self):
        bpy.context.view_layer.update()
        return [round(key.value, 2) for key in self.keys]

    def draw_left(self):
        line = [i for i in made.row(self.obj, reach=0.9) if self.obj.data.vertices[i].co.x > 0.05]
        here = desk.region_places(self.shown, desk.shown_positions(self.obj)[line])
        self.keys[0].value = 0.7
        bpy.context.view_layer.update()
        there = desk.region_places(self.shown, desk.shown_positions(self.obj)[line])
        self.keys[0].value = 0
        bpy.context.view_layer.update()
        desk.draw(self.obj, 'reference', self.shown, here)
        desk.draw(self.obj, 'target', self.shown, there)
        self.assertEqual(self.values(), [0.7, 0])

    def test_mirror(self):
        self.draw_left()
        self.assertEqual(bpy.ops.penpose.mirror(), {'FINISHED'})
        self.assertEqual(self.values(), [0.7, 0.7])
        self.assertEqual([('target' in c) for c in curves.curves(self.obj)], [True, True])
        a, b = (points for _, points in drawing.places(self.obj, bpy.context.evaluated_depsgraph_get()))
        self.assertLess(float(np.abs(np.sort(a[:, 0]) - np.sort(-b[:, 0])).max()), 0.02)

    def test_mirror_leaves_the_drawn_side(self):
        self.draw_left()
        self.keys[0].value = 0.57  # not where the line is
        self.assertEqual(bpy.ops.penpose.mirror(curve=1), {'FINISHED'})
        self.assertEqual(self.values(), [0.57, 0.57])

    def test_mirror_without_names_moves_the_other_side_alone(self):
        self.keys[0].name, self.keys[1].name = 'one', 'two'
        self.draw_left()
        self.keys[0].value = 0.5
        self.assertEqual(bpy.ops.penpose.mirror(curve=1), {'FINISHED'})
        self.assertEqual(self.values()[0], 0.5)
        self.assertAlmostEqual(self.values()[1], 0.7, delta=0.03)

    def test_flip(self):
        self.draw_left()
        self.assertEqual(bpy.ops.penpose.flip(), {'FINISHED'})
        self.assertEqual(self.values(), [0, 0.7])
        (_, points), = drawing.places(self.obj, bpy.context.evaluated_depsgraph_get())
        self.assertLess(points[:, 0].max(), 0)
        self.assertEqual(bpy.ops.penpose.flip(), {'FINISHED'})
        self.assertEqual(self.values(), [0.7, 0])

    def test_flip_turns_values_not_lines(self):
        self.draw_left()
        self.keys[0].value, self.keys[1].value = 0.3, 0.9  # not where the lines are
        kept = curves.curves(self.obj)
        self.assertEqual(bpy.ops.penpose.flip(), {'FINISHED'})
        self.assertEqual(self.values(), [0.9, 0.3])
        (there,) = curves.curves(self.obj)
        self.assertEqual(there['id'], kept[0]['id'])
        self.assertTrue(np.allclose(np.array(there['rest']).mean(axis=0), np.array(kept[0]['rest']).mean(axis=0) * (-1, 1, 1), atol=1e-5))
        bpy.ops.penpose.flip()
        self.assertEqual(self.values(), [0.3, 0.9])
        (again,) = curves.curves(self.obj)
        self.assertTrue(np.allclose(again['rest'], kept[0]['rest'], atol=1e-5))
        self.assertTrue(np.allclose(again['target']['px'], kept[0]['target']['px'], atol=1e-3))
        self.assertTrue(np.allclose(again['target']['view']['eye'], kept[0]['target']['view']['eye'], atol=1e-5))

    def test_flip_of_a_measured_rig_turns_what_no_curve_lies_on(self):
        made.add_key(self.obj, 'driven', (0, -0.1, 0), middle=(0, -0.9), width=0.2)
        self.obj['push'] = 0.0
        driver = self.obj.data.shape_keys.driver_add('key_blocks["driven"].value').driver
        driver.type = 'AVERAGE'
        variable = driver.variables.new()
        variable.targets[0].id, variable.targets[0].data_path = self.obj, '["push"]'
        self.draw_left()
        far = [made.add_key(self.obj, 'low' + side, (0, 0, 0.2), middle=(x, -0.7), width=0.1) for side, x in (('_L', 0.6), ('_R', -0.6))]
        far[0].value = 0.4
        self.assertTrue(drawing.known(self.obj).rig.measured)
        bpy.ops.penpose.flip()
        self.assertEqual(self.values(), [0, 0.7])
        self.assertEqual([round(key.value, 4) for key in far], [0, 0.4])

    def test_mirror_of_bones_that_are_measured(self):
        armature = made.bones(self.obj)
        made.activate(armature)
        bpy.ops.object.mode_set(mode='EDIT')
        data = armature.data.edit_bones
        for side, x in (('.L', 0.5), ('.R', -0.5)):
            bone = data.new('lid' + side)
            bone.head, bone.tail, bone.parent = (x, -0.3, 0.5), (x, -0.3, 0.7), data['low']
        bpy.ops.object.mode_set(mode='OBJECT')
        for side, x in (('.L', 0.5), ('.R', -0.5)):
            group = self.obj.vertex_groups.new(name='lid' + side)
            for vertex in self.obj.data.vertices:
                group.add([vertex.index], 3 * float(np.exp(-((vertex.co.x - x) ** 2 + (vertex.co.z - 0.5) ** 2) / 0.04)), 'REPLACE')
        self.obj.modifiers['Armature'].use_deform_preserve_volume = True  # so that it is measured
        self.obj.shape_key_clear()
        made.activate(self.obj)
        left, right = (armature.pose.bones['lid' + side] for side in ('.L', '.R'))
        line = [i for i in made.row(self.obj, reach=0.9) if self.obj.data.vertices[i].co.x > 0.2]
        here = desk.region_places(self.shown, desk.shown_positions(self.obj)[line])
        desk.draw(self.obj, 'reference', self.shown, here)
        desk.draw(self.obj, 'target', self.shown, here + (0, 15))
        left.rotation_mode = right.rotation_mode = 'XYZ'
        left.rotation_euler = (0.1, 0.2, 0.3)
        bpy.context.view_layer.update()
        self.assertTrue(drawing.known(self.obj).rig.measured)
        self.assertEqual(bpy.ops.penpose.mirror(curve=1), {'FINISHED'})
        self.assertTrue(np.allclose(left.rotation_euler, (0.1, 0.2, 0.3), atol=1e-5))
        self.assertTrue(np.allclose(right.rotation_euler, (0.1, -0.2, -0.3), atol=1e-4), right.rotation_euler)

    def test_flip_of_a_symmetric_pose_warns_of_nothing(self):
        self.draw_left()
        self.keys[0].value = self.keys[1].value = 0.5
        said = []
        told = type('Told', (), {'report': lambda self, kind, text: said.append((kind, text)), 'tell': mirror.PENPOSE_OT_flip.tell})()
        moved = mirror.PENPOSE_OT_flip.across(told, self.obj)
        self.assertEqual((moved, self.values()), ([], [0.5, 0.5]))
        told.tell(self.obj, moved)
        self.assertEqual([kind for kind, _ in said], [{'INFO'}])

    def test_flip_bones(self):
        armature = made.bones(self.obj)
        high = armature.pose.bones['high']
        high.rotation_mode = 'XYZ'
        high.rotation_euler = (0.1, 0.2, 0.3)
        bpy.context.view_layer.update()
        rig = drawing.known(self.obj).rig
        self.assertEqual([c.name for c in mirror.flip_pose(rig)], ['high'])
        self.assertTrue(np.allclose(high.rotation_euler, Euler((0.1, -0.2, -0.3)), atol=1e-5))

    def test_flip_is_keyed(self):
        self.keys[0].value = 0.5
        bpy.context.scene.tool_settings.use_keyframe_insert_auto = True
        bpy.ops.penpose.flip()
        self.assertEqual({c.data_path for c in versions.curves_of(self.obj.data.shape_keys)}, {'key_blocks["up_L"].value', 'key_blocks["up_R"].value'})

    def test_selected_only(self):
        state = bpy.context.window_manager.penpose
        for key, wanted in ((0, [True, False]), (1, [False, True])):
            for one in self.keys:
                one.value = 0
            drawing.delete(self.obj)
            self.obj.active_shape_key_index = key + 1
            state.selected_only = True
            line = made.row(self.obj, reach=0.9)
            here = desk.region_places(self.shown, desk.shown_positions(self.obj)[line])
            desk.draw(self.obj, 'reference', self.shown, here)
            desk.draw(self.obj, 'target', self.shown, here + (0, 30))
            self.assertEqual([v > 0 for v in self.values()], wanted)
        state.selected_only = False
        desk.draw(self.obj, 'target', self.shown, here + (0, 30), of=1)
        self.assertEqual([v > 0 for v in self.values()], [True, True])

    def test_selected_only_ends_with_its_file(self):
        state = bpy.context.window_manager.penpose
        path = os.path.join(desk.SCRATCH, 'another.blend')
        bpy.ops.wm.save_as_mainfile(filepath=path)
        state.selected_only = True
        bpy.ops.wm.open_mainfile(filepath=path)
        self.assertFalse(bpy.context.window_manager.penpose.selected_only)


class Linked(unittest.TestCase):
    """A character of another file."""

    def linked(self, instance):
        made.empty_file()
        obj = made.plate()
        made.add_key(obj, 'up', (0, 0, 0.4), middle=(0, 0.5))
        armature = made.bones(obj)
        collection = bpy.data.collections.new('Character')
        bpy.context.scene.collection.children.link(collection)
        for one in (obj, armature):
            bpy.context.scene.collection.objects.unlink(one)
            collection.objects.link(one)
        path = os.path.join(desk.SCRATCH, 'character.blend')
        bpy.ops.wm.save_as_mainfile(filepath=path)
        made.empty_file()
        with bpy.data.libraries.load(path, link=True) as (_, into):
            into.collections = ['Character']
        if instance:
            empty = bpy.data.objects.new('Character', None)
            empty.instance_type, empty.instance_collection = 'COLLECTION', into.collections[0]
            bpy.context.scene.collection.objects.link(empty)
            made.activate(empty)
        else:
            bpy.context.scene.collection.children.link(into.collections[0])
            made.activate(bpy.data.objects['Plate'])

    def test_override(self):
        for instance in (True, False):
            with self.subTest(instance=instance):
                self.linked(instance)
                self.assertRegex(pen.why_not(bpy.context), 'is linked; make .*override')
                self.assertEqual(bpy.ops.penpose.make_override(), {'FINISHED'})
                obj = pen.mesh_of(bpy.context)
                self.assertIsNotNone(obj.override_library)
                self.assertEqual(pen.why_not(bpy.context), '')
                shown = desk.seen(obj)
                here = desk.region_places(shown, desk.shown_positions(obj)[made.row(obj)])
                desk.draw(obj, 'reference', shown, here)
                self.assertTrue(desk.draw(obj, 'target', shown, here + (0, 30)))

    def test_nothing_linked(self):
        made.empty_file()
        made.plate()
        self.assertFalse(bpy.ops.penpose.make_override.poll())


class Around(unittest.TestCase):
    def test_the_hint_is_shown_until_it_was_read(self):
        self.assertTrue(preferences.hint_is_wanted(bpy.context))
        preferences.hint_was_read(bpy.context)
        self.assertFalse(preferences.hint_is_wanted(bpy.context))

    def test_keys_that_are_free(self):
        path = os.path.join(bpy.utils.system_resource('SCRIPTS'), 'presets', 'keyconfig', 'keymap_data', 'blender_default.py')
        spec = importlib.util.spec_from_file_location('blender_default', path)
        default = importlib.util.module_from_spec(spec)
        spec.loader.exec_module(default)
        taken = set()
        maps = ('Window', 'Screen', '3D View', '3D View Generic', 'Object Mode', 'Object Non-modal', 'Pose', 'Frames', 'Animation')
        for name, _, content in default.generate_keymaps(default.Params()):
            for _, event, _ in content['items'] if name in maps else ():
                if not any(event.get(m) for m in ('shift', 'ctrl', 'alt')):
                    taken.add(event['type'])
        self.assertTrue({'G', 'R', 'S'} <= taken)
        self.assertFalse({free_keys.HOLD, free_keys.PIE} & taken)

    def test_colours_of_the_window(self):
        said = ['#%02x%02x%02x' % tuple(round(255 * x) for x in lines.COLORS[kind][:3]) for kind in ('reference', 'target', 'constraint')]
        self.assertEqual(said, ['#2fd24a', '#2f7bff', '#f23a3a'])

    def test_refused_is_told(self):
        made.empty_file()
        made.plate()
        with self.assertRaises(RuntimeError) as caught:
            bpy.ops.penpose.flip()
        self.assertRegex(str(caught.exception), 'nothing to pose')
        self.assertIsInstance(Refused('x'), Exception)


if __name__ == '__main__':
    trial.main(__name__)
