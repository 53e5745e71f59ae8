"""The surface as it is shown: Mirror, Subdivision, Corrective Smooth, Surface Deform, lattices, mesh deform. ZIP"""
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import desk  # noqa: E402
import bpy  # noqa: E402
import numpy as np  # noqa: E402
import trial  # noqa: E402

desk.install(desk.ARGUMENTS[0])
import made  # noqa: E402
from penpose_blender import drawing, surface  # noqa: E402


def shown_row(obj, z=0.5, least=-0.6, most=0.6):
    """Numbers of the vertices that Blender shows along a row, from left to right."""
    points = drawing.shown_positions(obj, bpy.context.evaluated_depsgraph_get())
    found = [i for i, (x, _, v) in enumerate(points) if abs(v - z) < 1e-3 and least <= x <= most]
    return sorted(found, key=lambda i: points[i][0])


class Surfaces(made.Trial):
    def close(self, drawn):
        """A line that others could mean as well, px of 1000."""
        self.good(drawn, near=False, shown=False)
        self.assertLess(drawn.end * drawn.size, 10)
        self.assertGreater(drawn.start * drawn.size, 60)

    def half(self):
        """The right half of a plate with a Mirror."""
        obj = made.plate()
        points = [tuple(v.co) for v in obj.data.vertices]
        keep = {i: n for n, i in enumerate(i for i, p in enumerate(points) if p[0] > -1e-6)}
        faces = [[keep[v] for v in f.vertices] for f in obj.data.polygons if all(v in keep for v in f.vertices)]
        obj.data = bpy.data.meshes.new('Half')
        obj.data.from_pydata([points[i] for i in keep], [], faces)
        obj.data.update()
        made.add_key(obj, 'up', (0, 0, 0.3), middle=(0.5, 0.5), width=0.3)
        made.add_key(obj, 'over', (0.2, 0, 0), middle=(0.5, -0.5), width=0.3)
        obj.modifiers.new('Mirror', 'MIRROR')
        bpy.context.view_layer.update()
        return obj

    def drawn_by_key(self, obj, name, value, line, **settings):
        key = obj.data.shape_keys.key_blocks[name]
        there = made.shown_with(obj, lambda on: setattr(key, 'value', value if on else 0.0))
        drawn = made.Drawn(obj, line, there[line], **settings)
        self.assertAlmostEqual(key.value, value, delta=0.05)
        return drawn

    def test_mirror(self):
        for least, most in ((0.2, 0.8), (-0.8, -0.2), (-0.8, 0.8)):
            with self.subTest(least=least):
                made.empty_file()
                obj = self.half()
                line = shown_row(obj, 0.5, least, most)
                self.good(self.drawn_by_key(obj, 'up', 0.7, line))
                self.assertGreater(len(desk.shown_positions(obj)), len(obj.data.vertices))

    def test_subdivision(self):
        for levels in (1, 2):
            with self.subTest(levels=levels):
                made.empty_file()
                obj = made.plate()
                made.add_key(obj, 'up', (0, 0, 0.4), middle=(0, 0.5))
                obj.modifiers.new('Subdivision', 'SUBSURF').levels = levels
                bpy.context.view_layer.update()
                line = made.row(obj)
                self.good(self.drawn_by_key(obj, 'up', 0.7, line))
                self.assertEqual(drawing.known(obj).rig.surface.count, len(desk.shown_positions(obj)), 'it is drawn on as it is shown')

    def test_subdivision_that_is_too_fine(self):
        obj = made.plate()
        made.add_key(obj, 'up', (0, 0, 0.4), middle=(0, 0.5))
        obj.modifiers.new('Subdivision', 'SUBSURF').levels = 2
        bpy.context.view_layer.update()
        kept, surface.MOST_SHOWN = surface.MOST_SHOWN, 1000
        try:
            shown, rest = desk.seen(obj), desk.shown_positions(obj)
            line, key = made.row(obj), obj.data.shape_keys.key_blocks['up']
            there = made.shown_with(obj, lambda on: setattr(key, 'value', 0.7 if on else 0.0))
            desk.draw(obj, 'reference', shown, desk.region_places(shown, rest[line]))
            desk.draw(obj, 'target', shown, desk.region_places(shown, there[line]))
            self.assertAlmostEqual(key.value, 0.7, delta=0.05)
            self.assertEqual(drawing.known(obj).rig.surface.count, len(obj.data.vertices))
            self.assertTrue(obj.modifiers['Subdivision'].show_viewport)
            places = drawing.places(obj, bpy.context.evaluated_depsgraph_get())
            self.assertEqual(len(places), 1)
        finally:
            surface.MOST_SHOWN = kept

    def test_mirror_and_bones(self):
        obj = self.half()
        armature = made.bones(obj)
        line = shown_row(obj, 0.5, -0.8, 0.8)
        there = self.turned(armature, obj, (0.4, 0, 0))[line]
        drawn = made.Drawn(obj, line, there, yaw=50)
        self.good(drawn, near=False)

    def test_corrective_smooth(self):
        obj = made.plate()
        made.add_key(obj, 'up', (0, 0, 0.4), middle=(0, 0.5))
        armature = made.bones(obj)
        del armature
        smooth = obj.modifiers.new('Smooth', 'CORRECTIVE_SMOOTH')
        smooth.use_only_smooth = False
        bpy.context.view_layer.update()
        self.assertEqual(drawing.known(obj).rig.measured, 'the modifier Smooth')
        self.good(self.drawn_by_key(obj, 'up', 0.7, made.row(obj)), near=False)

    def lattice(self, obj):
        data = bpy.data.lattices.new('Lattice')
        data.points_u = data.points_v = data.points_w = 3
        cage = bpy.data.objects.new('Lattice', data)
        bpy.context.scene.collection.objects.link(cage)
        cage.scale = (2.2, 1.2, 2.2)
        obj.modifiers.new('Lattice', 'LATTICE').object = cage
        return cage

    def test_lattice(self):
        obj = made.plate()
        cage = self.lattice(obj)
        armature = made.bones(obj)
        obj.modifiers.remove(obj.modifiers['Armature'])
        obj.vertex_groups.clear()
        # The bones carry the lattice, and that the plate.
        for name, top in (('low', False), ('high', True)):
            group = cage.vertex_groups.new(name=name)
            group.add([i for i, p in enumerate(cage.data.points) if (p.co.z > 0.1) == top], 1, 'REPLACE')
        cage.modifiers.new('Armature', 'ARMATURE').object = armature
        bpy.context.view_layer.update()
        line = made.row(obj)
        there = self.turned(armature, obj, (0, 0, 0.4))[line]
        drawn = made.Drawn(obj, line, there)
        self.close(drawn)
        self.assertEqual({c.bone for c in drawn.moved} - {'low', 'high'}, set())

    def test_lattice_by_keys(self):
        obj = made.plate()
        cage = self.lattice(obj)
        cage.shape_key_add(name='Basis')
        key = cage.shape_key_add(name='lift')
        for point in key.data:
            if point.co.z > 0.1:
                point.co.z += 0.2
        made.drive(cage.data.shape_keys, 'key_blocks["lift"].value', obj, '["amount"]')
        obj['amount'] = 0.0
        obj.update_tag()
        bpy.context.view_layer.update()
        line = made.row(obj)

        def change(on):
            obj['amount'] = 0.6 if on else 0.0
            obj.update_tag()
        self.good(made.Drawn(obj, line, made.shown_with(obj, change)[line]))
        self.assertAlmostEqual(obj['amount'], 0.6, delta=0.05)

    def test_surface_deform(self):
        cage = made.plate('Cage', 9)
        armature = made.bones(cage)
        obj = made.plate('Plate', made.SIDE)
        obj.location.y = -0.05
        bind = obj.modifiers.new('Bind', 'SURFACE_DEFORM')
        bind.target = cage
        bpy.context.view_layer.update()
        made.activate(obj)
        bpy.ops.object.surfacedeform_bind(modifier='Bind')
        cage.hide_set(True)
        bpy.context.view_layer.update()
        self.assertTrue(bind.is_bound)
        line = made.row(obj)
        there = self.turned(armature, obj, (0, 0, 0.4))[line]
        self.close(made.Drawn(obj, line, there))

    def test_mesh_deform(self):
        bpy.ops.mesh.primitive_cube_add(size=3)
        cage = bpy.context.object
        cage.name, cage.display_type = 'Cage', 'WIRE'
        armature = made.bones(cage)
        obj = made.plate()
        modifier = obj.modifiers.new('Bind', 'MESH_DEFORM')
        modifier.object, modifier.precision = cage, 3
        bpy.context.view_layer.update()
        bpy.ops.object.meshdeform_bind(modifier='Bind')
        bpy.context.view_layer.update()
        self.assertTrue(modifier.is_bound)
        self.assertEqual(drawing.parts(obj, anew=True), [obj], 'a cage is not drawn on')
        line = made.row(obj)
        there = self.turned(armature, obj, (0, 0, 0.4))[line]
        self.close(made.Drawn(obj, line, there))

    def test_places_of_curves_on_what_is_made(self):
        obj = self.half()
        line = shown_row(obj, 0.5, -0.8, -0.2)
        shown = desk.seen(obj)
        rest = desk.shown_positions(obj)
        desk.draw(obj, 'reference', shown, desk.region_places(shown, rest[line]))
        places = drawing.places(obj, bpy.context.evaluated_depsgraph_get())[0][1]
        self.assertLess(float(places[:, 0].max()), 0)
        self.assertLess(float(np.abs(places[:, 2] - 0.5).max()), 0.01)
        # Without the modifier the faces are gone that it lay on.
        obj.modifiers['Mirror'].show_viewport = False
        bpy.context.view_layer.update()
        drawing.known(obj)
        self.assertEqual(drawing.curves(obj), [])
        self.assertIn('lay on faces that are gone', ' '.join(drawing.said(obj)))


if __name__ == '__main__':
    trial.main(__name__)
