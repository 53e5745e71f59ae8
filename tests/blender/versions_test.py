"""The add-on's versions.py against stand-ins for Blender's data of each version from 3.4 on: objects that have what those have, and nothing else.

Sources: "Change Log" of the API's documentation of 4.0 to 5.0 (docs.blender.org/api), "Slotted Actions: Upgrading to 4.4" and the release notes
of 4.0 to 5.0 (developer.blender.org). Those of 3.4.1, 4.3.2 and 5.2.2 were compared with the Blenders themselves (releases.sh)."""
import importlib.util
import os
import sys
import types
import unittest

import numpy as np

FILE = os.path.join(os.path.dirname(os.path.abspath(__file__)), '..', '..', 'ui', 'blender', 'addon', 'versions.py')
ALL = ((3, 4, 1), (4, 0, 2), (4, 1, 1), (4, 2, 3), (4, 3, 2), (4, 4, 3), (4, 5, 4), (5, 0, 0))


class Thing:
    """Has what it is given: asking for more is an error, as it is of Blender's."""

    def __init__(self, **has):
        self.__dict__.update(has)


class Place(np.ndarray):
    """A 4 x 4 matrix."""

    @classmethod
    def at(cls, x=0.0, y=0.0, z=0.0):
        out = np.eye(4)
        out[:3, 3] = x, y, z
        return out.view(cls)


def loaded(version, **preferences):
    """versions.py in a Blender of that version."""
    asked = []
    edit = Thing(use_keyframe_insert_needed=False, **({'use_auto_keyframe_insert_needed': True} if version >= (4, 1, 0) else {}))
    edit.__dict__.update(preferences)
    properties = ['name', 'library'] + (['session_uid'] if version >= (4, 1, 0) else [])
    bpy = types.ModuleType('bpy')
    bpy.app = Thing(version=version)
    bpy.types = Thing(ID=Thing(bl_rna=Thing(properties=properties)))
    bpy.context = Thing(preferences=Thing(edit=edit))
    bpy.data = Thing(meshes={})
    bpy.utils = Thing(user_resource=lambda kind: '/data/' + kind.lower())
    if version >= (4, 2, 0):
        bpy.utils.extension_path_user = lambda package: '/extensions/' + package.split('.')[-1]
    names = ('POLYLINE_UNIFORM_COLOR', 'UNIFORM_COLOR', 'SMOOTH_COLOR')
    known = names if version >= (4, 0, 0) else tuple('3D_' + n for n in names) + ('2D_UNIFORM_COLOR',)
    gpu = types.ModuleType('gpu')
    gpu.shader = Thing(from_builtin=lambda name: name if name in known else sys.exit('%s has no shader %s' % (version, name)))
    blf = types.ModuleType('blf')

    def size(font, points):
        asked.append(points)
    blf.size = size if version >= (4, 0, 0) else lambda font, points, dpi: size(font, points)
    kept = {name: sys.modules.get(name) for name in ('bpy', 'gpu', 'blf')}
    sys.modules.update(bpy=bpy, gpu=gpu, blf=blf)
    try:
        spec = importlib.util.spec_from_file_location('versions', FILE)
        module = importlib.util.module_from_spec(spec)
        spec.loader.exec_module(module)
    finally:
        for name, one in kept.items():
            sys.modules.pop(name)
            if one is not None:
                sys.modules[name] = one
    module.asked = asked
    return module


def bone_of(version, hidden=False, selected=False, shown=True):
    """An armature and a pose bone of it; `shown`: by its layer or its collection."""
    bone = Thing(name='b') if version >= (5, 0, 0) else Thing(name='b', hide=hidden, select=selected)
    pose = Thing(name='b', bone=bone)
    if version >= (5, 0, 0):
        bone.hide = False  # of edit mode: another switch
        pose.hide, pose.select = hidden, selected
    data = Thing()
    if version >= (4, 0, 0):
        one = Thing(is_visible=shown)
        if version >= (4, 1, 0):
            # It may be on, and lie in one that is off.
            one.is_visible, one.is_visible_effectively = True, shown
        bone.collections = [one]
    else:
        data.layers, bone.layers = [True, False], [shown, not shown]
    return Thing(data=data), pose


def animated(version, curves, others=()):
    """A data-block with curves; in a slot of its own where others share the action."""
    strip = Thing(type='KEYFRAME', channelbag=lambda slot: {'mine': Thing(fcurves=curves), 'theirs': Thing(fcurves=others)}.get(slot))
    if version >= (5, 0, 0):
        action = Thing(slots=['mine', 'theirs'], layers=[Thing(strips=[strip])])
    elif version >= (4, 4, 0):
        action = Thing(slots=['mine', 'theirs'], layers=[Thing(strips=[strip])], fcurves=list(others))  # those of the first slot
    else:
        return Thing(animation_data=Thing(action=Thing(fcurves=curves)))
    return Thing(animation_data=Thing(action=action, action_slot='mine'))


def pencil_of(version):
    """Grease Pencil at x = 1 with a layer that is moved by y = 2 and a hidden one; frames 9 and 3 with a line each."""
    new = version >= (4, 3, 0)
    layers = []
    for name, hide in (('Face', False), ('Hidden', True)):
        frames = []
        for number in (9, 3):
            points = [(number, 0, 0), (number, 0, 1)]
            strokes = [Thing(points=[Thing(position=p) if new else Thing(co=p) for p in points])]
            frames.append(Thing(frame_number=number, drawing=Thing(strokes=strokes)) if new else Thing(frame_number=number, strokes=strokes))
        layer = Thing(hide=hide, parent=None, frames=frames)
        layer.__dict__.update({'name': name, 'matrix_local': Place.at(y=2)} if new else {'info': name, 'matrix_layer': Place.at(y=2)})
        layers.append(layer)

    class Layers(list):
        active = layers[0]
    return Thing(type='GREASEPENCIL' if new else 'GPENCIL', matrix_world=Place.at(x=1), data=Thing(layers=Layers(layers)))


class Versions(unittest.TestCase):
    def each(self):
        for version in ALL:
            with self.subTest(version):
                yield version, loaded(version)

    def test_shaders_and_letters(self):
        for _, versions in self.each():
            for shader in (versions.line_shader, versions.flat_shader, versions.flat_shader_of_px, versions.smooth_shader):
                self.assertIn('COLOR', shader())
            versions.set_text_size(12)
            self.assertEqual(versions.asked, [12])

    def test_bones(self):
        for version, versions in self.each():
            for hidden in (False, True):
                for shown in (False, True):
                    self.assertEqual(versions.bone_seen(*bone_of(version, hidden, shown=shown)), shown and not hidden)
            for selected in (False, True):
                self.assertEqual(versions.bone_selected(bone_of(version, selected=selected)[1]), selected)
            if version >= (4, 0, 0):
                armature, bone = bone_of(version, shown=False)
                bone.bone.collections = []
                self.assertTrue(versions.bone_seen(armature, bone), 'a bone in no collection is shown')

    def test_curves(self):
        for version, versions in self.each():
            self.assertEqual(versions.curves_of(animated(version, ['a', 'b'], ['of another'])), ['a', 'b'])
            self.assertEqual(versions.curves_of(Thing(animation_data=None)), [])
            self.assertEqual(versions.curves_of(Thing(animation_data=Thing(action=None))), [])
            if version >= (4, 4, 0):
                empty = animated(version, [], ['of another'])
                empty.animation_data.action_slot = None
                self.assertEqual(versions.curves_of(empty), [], 'no slot is chosen')

    def test_grease_pencil(self):
        for version, versions in self.each():
            pencil = pencil_of(version)
            self.assertTrue(versions.is_grease_pencil(pencil))
            self.assertFalse(versions.is_grease_pencil(Thing(type='MESH')))
            (name, active, frames), = versions.pencil_layers(pencil)
            self.assertEqual((name, active, [number for number, _ in frames]), ('Face', True, [3, 9]))
            self.assertTrue(np.array_equal(frames[0][1][0], [(4, 2, 0), (4, 2, 1)]))

    def test_rules_of_keys(self):
        for version, versions in self.each():
            late = version >= (4, 1, 0)
            self.assertEqual((versions.only_needed(True), versions.only_needed(False)), (late, False))
            wanted = {'INSERTKEY_NEEDED'} if late else {'INSERTKEY_NEEDED', 'INSERTKEY_XYZ_TO_RGB'}
            self.assertEqual(versions.key_options({'INSERTKEY_NEEDED', 'INSERTKEY_XYZ_TO_RGB'}), wanted)
            own = dict(use_insertkey_override_needed=True, use_insertkey_needed=False, use_insertkey_override_visual=False, use_insertkey_visual=True)
            if not late:
                own.update(use_insertkey_override_xyz_to_rgb=True, use_insertkey_xyz_to_rgb=True)
            self.assertEqual(versions.own_rules(Thing(**own)),
                             {'INSERTKEY_NEEDED': False} if late else {'INSERTKEY_NEEDED': False, 'INSERTKEY_XYZ_TO_RGB': True})

    def test_new_keys_do_nothing(self):
        for version, versions in self.each():
            made = Thing(value=1.0 if version >= (5, 0, 0) else 0.0)
            obj = Thing(shape_key_add=lambda name, from_mix, made=made: made)
            self.assertEqual(versions.new_key(obj, 'up').value, 0)

    def test_normals(self):
        for version, versions in self.each():
            mesh = Thing(name='m', has_custom_normals=True, loops=range(10 ** 5), library=None)
            if version < (4, 1, 0):
                mesh.use_auto_smooth = True
            versions.bpy.data.meshes['m'] = mesh
            name = versions.plain_normals(mesh)
            self.assertEqual(name, 'm' if version < (4, 1, 0) else '')
            self.assertFalse(getattr(mesh, 'use_auto_smooth', False))
            versions.normals_back(name)
            self.assertEqual(hasattr(mesh, 'use_auto_smooth') and mesh.use_auto_smooth, version < (4, 1, 0))

    def test_numbers_of_blocks(self):
        for version, versions in self.each():
            block = Thing(session_uid=7, as_pointer=lambda: 99) if version >= (4, 1, 0) else Thing(as_pointer=lambda: 99)
            self.assertEqual(versions.uid(block), 7 if version >= (4, 1, 0) else 99)

    def test_folders(self):
        for version, versions in self.each():
            self.assertEqual(versions.own_folder('penpose_blender'), os.path.join('/data/datafiles', 'penpose_blender'))
            if version >= (4, 2, 0):
                self.assertEqual(versions.own_folder('bl_ext.user_default.penpose_blender'), os.path.join('/extensions/penpose_blender', 'library'))


if __name__ == '__main__':
    unittest.main()
