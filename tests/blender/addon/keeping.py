"""What is drawn is kept: undo, redo, files, renders, keyframes, Grease Pencil, changed topology. ZIP"""
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
from penpose_blender import drawing, grease, keys, recording, store, versions  # noqa: E402
from penpose_blender.controls import Refused  # noqa: E402
from penpose_blender.library import Character, play  # noqa: E402


class Keeping(unittest.TestCase):
    def setUp(self):
        made.empty_file()
        self.make()

    def make(self):
        self.obj = made.plate()
        made.add_key(self.obj, 'up', (0, 0, 0.4), middle=(0, 0.5))
        made.add_key(self.obj, 'over', (0.4, 0, 0), middle=(0, -0.5))
        self.armature = made.bones(self.obj)
        self.shown = desk.seen(self.obj)
        self.begin = desk.region_places(self.shown, desk.shown_positions(self.obj)[made.row(self.obj)])
        kept = self.obj.data.shape_keys.key_blocks['up']
        kept.value = 0.7
        bpy.context.view_layer.update()
        self.finish = desk.region_places(self.shown, desk.shown_positions(self.obj)[made.row(self.obj)])
        kept.value = 0
        bpy.context.view_layer.update()

    def draw(self):
        desk.draw(self.obj, 'reference', self.shown, self.begin)
        moved = desk.draw(self.obj, 'target', self.shown, self.finish)
        bpy.context.view_layer.update()
        return moved

    def state(self):
        obj, armature = bpy.data.objects['Plate'], bpy.data.objects['Rig']
        return ({k.name: k.value for k in obj.data.shape_keys.key_blocks},
                {b.name: tuple(b.rotation_quaternion) for b in armature.pose.bones}, obj.get(store.PROPERTY))

    def test_a_record_goes_on_after_undo(self):
        if not bpy.ops.ed.undo_push.poll():
            self.skipTest('undo wants a window')
        session = os.path.join(desk.SCRATCH, 'undone.session')
        bpy.ops.ed.undo_push(message='made')
        recording.begin(self.obj, session)
        desk.draw(self.obj, 'reference', self.shown, self.begin)
        bpy.ops.ed.undo_push(message='reference')
        desk.draw(self.obj, 'target', self.shown, self.finish)
        bpy.ops.ed.undo_push(message='target')
        bpy.ops.ed.undo()
        obj = bpy.data.objects['Plate']
        desk.draw(obj, 'target', self.shown, self.begin + 0.5 * (self.finish - self.begin))
        recording.note(obj)
        self.assertEqual(recording.end(obj), session)
        with open(session, 'rb') as recorded, open(session.replace('.session', '.glb'), 'rb') as model:
            _, played = play(recorded.read(), Character.read(model.read(), 'undone.glb'))
        self.assertGreater(played.steps, 3)
        self.assertEqual(played.state, drawing.known(obj).rig.character.state)

    def test_undo_and_redo(self):
        if not bpy.ops.ed.undo_push.poll():
            self.skipTest('undo wants a window')
        bpy.ops.ed.undo_push(message='made')
        before = self.state()
        desk.draw(self.obj, 'reference', self.shown, self.begin)
        bpy.ops.ed.undo_push(message='reference')
        reference = self.state()
        desk.draw(self.obj, 'target', self.shown, self.finish)
        bpy.ops.ed.undo_push(message='target')
        target = self.state()
        self.assertNotEqual(reference[0], target[0])
        undo, redo = bpy.ops.ed.undo, bpy.ops.ed.redo
        for do, wanted in ((undo, reference), (undo, before), (redo, reference), (redo, target)):
            do()
            self.assertEqual(self.state(), wanted)
        obj = bpy.data.objects['Plate']
        self.assertEqual(len(drawing.known(obj).numbers), 1)
        bpy.ops.ed.undo()
        self.assertTrue(desk.draw(bpy.data.objects['Plate'], 'target', self.shown, self.finish))
        self.assertEqual(self.state()[0]['up'], target[0]['up'])

    def test_save_and_reopen(self):
        self.draw()
        before, shown = self.state(), desk.shown_positions(self.obj)
        path = os.path.join(desk.SCRATCH, 'kept.blend')
        bpy.ops.wm.save_as_mainfile(filepath=path)
        made.empty_file()
        bpy.ops.wm.open_mainfile(filepath=path)
        self.assertEqual(self.state(), before)
        obj = bpy.data.objects['Plate']
        self.assertTrue(np.array_equal(desk.shown_positions(obj), shown))
        one = drawing.known(obj)
        self.assertEqual(len(one.numbers), 1)
        self.assertEqual(self.state(), before, 'reading the curves moves nothing')
        self.assertTrue(np.allclose(one.rig.character.evaluate(), shown, atol=1e-5))
        # The target can be drawn anew, on the same curve.
        self.assertTrue(desk.draw(obj, 'target', self.shown, self.begin + 0.5 * (self.finish - self.begin), of=1))
        self.assertEqual(len(store.read(obj)['curves']), 1)

    def test_copied_object(self):
        self.draw()
        copy = self.obj.copy()
        copy.data = self.obj.data.copy()
        bpy.context.scene.collection.objects.link(copy)
        bpy.context.view_layer.update()
        # One armature carries both: one character, whose curves are told apart.
        self.assertEqual(sorted(drawing.known(copy).numbers), [1, 2])
        copy.modifiers.clear()
        bpy.context.view_layer.update()
        self.assertEqual(len(drawing.known(copy).numbers), 1)

    def test_render(self):
        self.draw()
        camera = bpy.data.objects.new('Camera', bpy.data.cameras.new('Camera'))
        bpy.context.scene.collection.objects.link(camera)
        camera.location, camera.rotation_euler = (0, -6, 0), (1.5708, 0, 0)
        scene = bpy.context.scene
        scene.camera, scene.render.engine = camera, 'CYCLES'
        scene.render.resolution_x = scene.render.resolution_y = 32
        scene.cycles.samples, scene.cycles.use_denoising = 1, False
        scene.render.filepath = os.path.join(desk.SCRATCH, 'render.png')
        before, seen = self.state(), []

        def look(scene, depsgraph=None):
            if depsgraph is not None:
                mesh = self.obj.evaluated_get(depsgraph).data
                out = np.empty(3 * len(mesh.vertices), dtype=np.float32)
                mesh.vertices.foreach_get('co', out)
                seen.append(out.reshape(-1, 3))
        bpy.app.handlers.depsgraph_update_post.append(look)
        shown = desk.shown_positions(self.obj)
        try:
            bpy.ops.render.render(write_still=True)
        finally:
            bpy.app.handlers.depsgraph_update_post.remove(look)
        self.assertTrue(os.path.exists(scene.render.filepath))
        self.assertEqual(self.state(), before)
        self.assertTrue(np.array_equal(desk.shown_positions(self.obj), shown))

    def curves_of(self, block):
        return {(c.data_path, c.array_index): [tuple(p.co) for p in c.keyframe_points] for c in versions.curves_of(block)}

    def test_no_keys_unless_wanted(self):
        self.draw()
        self.assertEqual(self.curves_of(self.obj.data.shape_keys), {})
        self.assertEqual(self.curves_of(self.armature), {})

    def test_auto_key(self):
        scene = bpy.context.scene
        scene.tool_settings.use_keyframe_insert_auto = True
        scene.frame_set(12)
        moved = self.draw()
        self.assertEqual([c.name for c in moved], ['up'])
        value = self.obj.data.shape_keys.key_blocks['up'].value
        self.assertEqual(self.curves_of(self.obj.data.shape_keys), {('key_blocks["up"].value', 0): [(12.0, value)]})
        self.assertEqual(self.curves_of(self.armature), {})
        scene.frame_set(20)
        shown = desk.seen(self.obj)
        there = desk.region_places(shown, desk.shown_positions(self.obj)[made.row(self.obj)])
        desk.draw(self.obj, 'target', shown, there + 0.5 * (self.begin - self.finish), of=1)
        frames = self.curves_of(self.obj.data.shape_keys)[('key_blocks["up"].value', 0)]
        self.assertEqual([f for f, _ in frames], [12.0, 20.0])
        scene.frame_set(12)
        self.assertAlmostEqual(self.obj.data.shape_keys.key_blocks['up'].value, value, delta=1e-6)

    def turn_target(self):
        high = self.armature.pose.bones['high']
        high.rotation_quaternion = Quaternion((0.97, 0, 0, 0.243)).normalized()
        bpy.context.view_layer.update()
        there = desk.region_places(self.shown, desk.shown_positions(self.obj)[made.row(self.obj)])
        high.rotation_quaternion = (1, 0, 0, 0)
        bpy.context.view_layer.update()
        desk.draw(self.obj, 'reference', self.shown, self.begin)
        return desk.draw(self.obj, 'target', self.shown, there)

    def test_keys_of_bones(self):
        scene = bpy.context.scene
        scene.tool_settings.use_keyframe_insert_auto = True
        scene.frame_set(5)
        moved = self.turn_target()
        names = {c.bone for c in moved if hasattr(c, 'bone')}
        self.assertTrue(names)
        found = self.curves_of(self.armature)
        self.assertEqual(set(found), {('pose.bones["%s"].rotation_quaternion' % n, i) for n in names for i in range(4)})
        self.assertEqual({c.group.name for c in versions.curves_of(self.armature)}, names)
        for (path, index), points in found.items():
            bone = self.armature.path_resolve(path.rpartition('.')[0])
            self.assertEqual(points, [(5.0, bone.rotation_quaternion[index])])

    def test_keying_set(self):
        scene = bpy.context.scene
        made_set = scene.keying_sets.new(idname='Face', name='Face')
        made_set.paths.add(self.obj.data.shape_keys, 'key_blocks["over"].value')
        scene.keying_sets.active = made_set
        self.draw()
        self.assertEqual(self.curves_of(self.obj.data.shape_keys), {}, 'what is not of the set is not keyed')
        drawing.delete(self.obj)
        self.obj.data.shape_keys.key_blocks['up'].value = 0
        made_set.paths.add(self.obj.data.shape_keys, 'key_blocks["up"].value')
        self.draw()
        self.assertEqual(set(self.curves_of(self.obj.data.shape_keys)), {('key_blocks["up"].value', 0)}, 'only what moved')

    def test_built_in_keying_set(self):
        scene = bpy.context.scene
        try:
            scene.keying_sets_all.active = scene.keying_sets_all['Rotation']
        except (KeyError, TypeError) as problem:
            self.skipTest(str(problem))
        self.assertTrue(keys.wanted(scene))
        self.turn_target()
        self.assertTrue(self.curves_of(self.armature))

    def test_driven_property_is_keyed(self):
        self.armature['lift'] = 0.0
        self.armature.update_tag()
        bpy.context.view_layer.update()
        for bone in self.armature.pose.bones:
            bone.lock_rotation = (True, True, True)
        curve = self.obj.data.shape_keys.driver_add('key_blocks["up"].value')
        variable = curve.driver.variables.new()
        variable.name, variable.targets[0].id, variable.targets[0].data_path = 'x', self.armature, '["lift"]'
        curve.driver.type, curve.driver.expression = 'SCRIPTED', 'x'
        bpy.context.view_layer.update()
        bpy.context.scene.tool_settings.use_keyframe_insert_auto = True
        self.assertTrue(self.draw())
        self.assertEqual(set(self.curves_of(self.armature)), {('["lift"]', 0)})
        self.assertAlmostEqual(self.armature['lift'], 0.7, delta=0.02)

    # Grease Pencil.

    def pencil(self, layers):
        """An object of Grease Pencil with layers [(name, strokes of points in the world)]; the last is active."""
        obj = desk.pencil([(name, {1: strokes}) for name, strokes in layers])
        bpy.context.scene.frame_set(1)
        return obj

    def test_grease_pencil(self):
        from mathutils import Vector
        from penpose_blender import space
        place = space.Space(self.obj.matrix_world)
        points = desk.shown_positions(self.obj)[made.row(self.obj)]
        key = self.obj.data.shape_keys.key_blocks['up']
        key.value = 0.7
        bpy.context.view_layer.update()
        there = desk.shown_positions(self.obj)[made.row(self.obj)]
        key.value = 0
        bpy.context.view_layer.update()
        lines = [[Vector(p) for p in place.to_world(line)] for line in (points, there)]

        def region(point):
            return desk.region_places(self.shown, [place.of_world(point)])[0]
        pencil = self.pencil([('Lines', [lines[1], *lines])])
        self.assertEqual([kind for kind, _ in grease.strokes_of(pencil)], ['reference', 'target'])
        moved = grease.draw_strokes(self.obj, grease.strokes_of(pencil), self.shown, region)
        self.assertEqual([c.name for c in moved], ['up'])
        self.assertAlmostEqual(key.value, 0.7, delta=0.02)
        drawing.delete(self.obj)
        key.value = 0
        bpy.context.view_layer.update()
        layers = [('Mouth reference', lines[:1]), ('Mouth target', lines[1:])]
        for which in layers:
            one = self.pencil([which])
            moved = grease.draw_strokes(self.obj, grease.strokes_of(one), self.shown, region)
        self.assertAlmostEqual(key.value, 0.7, delta=0.02)
        kinds = [kind for kind, _ in grease.strokes_of(self.pencil([('Constraint', lines)]))]
        self.assertEqual(kinds, ['constraint', 'constraint'])
        with self.assertRaisesRegex(Refused, 'Pencil.*has one stroke; draw two'):
            grease.strokes_of(self.pencil([('Lines', lines[:1])]))
        with self.assertRaisesRegex(Refused, 'Pencil.*has no stroke'):
            grease.strokes_of(self.pencil([('Lines', [])]))

    # The mesh changes below the curves.

    def test_topology_changes(self):
        self.draw()
        before = drawing.places(self.obj, bpy.context.evaluated_depsgraph_get())[0][1]
        bpy.ops.object.mode_set(mode='EDIT')
        bpy.ops.mesh.select_all(action='SELECT')
        bpy.ops.mesh.subdivide(number_cuts=1)
        bpy.ops.object.mode_set(mode='OBJECT')
        self.assertGreater(len(self.obj.data.vertices), 4 * made.SIDE ** 2 - 200)
        one = drawing.known(self.obj)
        self.assertEqual((len(one.numbers), drawing.said(self.obj)), (1, []))
        after = drawing.places(self.obj, bpy.context.evaluated_depsgraph_get())[0][1]
        self.assertLess(float(np.abs(after - before).max()), 0.02)
        self.assertIn('target', store.read(self.obj)['curves'][0])
        # The half that the curve lies on goes.
        bpy.ops.object.mode_set(mode='EDIT')
        bpy.ops.mesh.select_all(action='DESELECT')
        bpy.ops.object.mode_set(mode='OBJECT')
        for vertex in self.obj.data.vertices:
            vertex.select = vertex.co.z > 0.2
        bpy.ops.object.mode_set(mode='EDIT')
        bpy.ops.mesh.delete(type='VERT')
        bpy.ops.object.mode_set(mode='OBJECT')
        drawing.known(self.obj)
        self.assertEqual(drawing.said(self.obj), ['1 curve of Plate lay on faces that are gone, and was taken away; draw it again'])
        self.assertEqual(store.read(self.obj)['curves'], [])

    def test_a_key_is_edited(self):
        self.draw()
        key = self.obj.data.shape_keys.key_blocks['over']
        key.data[131].co.x += 0.2
        key.value = 1
        bpy.context.view_layer.update()
        desk.draw(self.obj, 'reference', self.shown, self.begin)
        character = drawing.known(self.obj).rig.character
        self.assertLess(float(np.abs(character.evaluate() - desk.shown_positions(self.obj)).max()), 1e-5)

    def test_weights_are_painted(self):
        self.draw()
        self.obj.vertex_groups['low'].remove([v.index for v in self.obj.data.vertices if v.co.z < -0.3])
        self.armature.pose.bones['low'].rotation_quaternion = Quaternion((0.97, 0.1, 0, 0.2)).normalized()
        bpy.context.view_layer.update()
        desk.draw(self.obj, 'reference', self.shown, desk.region_places(self.shown, desk.shown_positions(self.obj)[made.row(self.obj)]))
        character = drawing.known(self.obj).rig.character
        self.assertLess(float(np.abs(character.evaluate() - desk.shown_positions(self.obj)).max()), 1e-5)

    def test_solve_again(self):
        self.draw()
        value = self.obj.data.shape_keys.key_blocks['up'].value
        self.obj.data.shape_keys.key_blocks['up'].value = 0.1
        bpy.context.view_layer.update()
        self.assertTrue(drawing.solve_again(self.obj))
        self.assertAlmostEqual(self.obj.data.shape_keys.key_blocks['up'].value, value, delta=0.02)


if __name__ == '__main__':
    trial.main(__name__)
