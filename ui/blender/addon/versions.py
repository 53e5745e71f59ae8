"""What changed in Blender's interface after 3.4, with the version that changed it. All else of the add-on is the same everywhere."""
import os

import blf
import bpy
import gpu
import numpy as np

VERSION = bpy.app.version
MANY_CORNERS = 30000  # from which on custom normals make a pen lag


def line_shader():
    """The shader of lines of one colour and of any width. 4.0 took the 3D out of its name."""
    return gpu.shader.from_builtin('POLYLINE_UNIFORM_COLOR' if VERSION >= (4, 0, 0) else '3D_POLYLINE_UNIFORM_COLOR')


def flat_shader():
    """The shader of triangles and points of one colour; renamed with the other."""
    return gpu.shader.from_builtin('UNIFORM_COLOR' if VERSION >= (4, 0, 0) else '3D_UNIFORM_COLOR')


def flat_shader_of_px():
    """The same in px of a region, (n, 2)."""
    return gpu.shader.from_builtin('UNIFORM_COLOR' if VERSION >= (4, 0, 0) else '2D_UNIFORM_COLOR')


def smooth_shader():
    """The shader of triangles with a colour at each corner."""
    return gpu.shader.from_builtin('SMOOTH_COLOR' if VERSION >= (4, 0, 0) else '3D_SMOOTH_COLOR')


def set_text_size(points):
    """Of what blf draws next. 4.0 took its dpi away."""
    blf.size(0, points) if VERSION >= (4, 0, 0) else blf.size(0, points, 72)


def plain_normals(mesh, corners=None):
    """Leaves custom normals out while a target is drawn: they take Blender four fifths of the time of an evaluation. `corners`: of all
    that is evaluated. What normals_back() wants. 4.1 reads them where they are asked for, and has no such switch on the mesh."""
    slow = getattr(mesh, 'use_auto_smooth', False) and mesh.has_custom_normals and (corners or len(mesh.loops)) >= MANY_CORNERS
    if not slow or mesh.library is not None:
        return ''
    mesh.use_auto_smooth = False
    return mesh.name


def normals_back(name):
    """Undoes plain_normals()."""
    mesh = bpy.data.meshes.get(name) if name else None
    if mesh is not None:
        mesh.use_auto_smooth = True


def pencil_layers(obj):
    """The visible layers of a Grease Pencil: [(name, whether it is active, [(frame, strokes)])], frames in order, a stroke as points (n, 3)
    of the world. 4.3 replaced its data: frames have a drawing, and a layer has other names for what it is called and where it lies."""
    out = []
    for layer in obj.data.layers:
        if layer.hide:
            continue
        old = hasattr(layer, 'info')
        above = obj.matrix_world
        if layer.parent is not None:
            above = layer.parent.matrix_world @ getattr(layer, 'matrix_inverse' if old else 'matrix_parent_inverse')
        place = np.array(above @ getattr(layer, 'matrix_layer' if old else 'matrix_local'))
        frames = []
        for frame in sorted(layer.frames, key=lambda f: f.frame_number):
            strokes = frame.strokes if old else frame.drawing.strokes
            lines = [np.array([p.co if old else p.position for p in s.points], dtype=float).reshape(-1, 3) for s in strokes]
            frames.append((frame.frame_number, [line @ place[:3, :3].T + place[:3, 3] for line in lines]))
        out.append((layer.info if old else layer.name, layer == obj.data.layers.active, frames))
    return out


def is_grease_pencil(obj):
    """4.3 calls the type GREASEPENCIL, those before GPENCIL."""
    return obj is not None and obj.type in ('GPENCIL', 'GREASEPENCIL')


def own_folder(package):
    """Where the add-on may keep files of its own. 4.2 has a folder for each extension; an add-on that is none has a folder of data there, too."""
    if VERSION >= (4, 2, 0) and package.startswith('bl_ext.'):
        return os.path.join(bpy.utils.extension_path_user(package), 'library')
    return os.path.join(bpy.utils.user_resource('DATAFILES'), package)


def curves_of(owner):
    """The curves that animate a data-block. 4.4 put them into slots of an action, and 5.0 took Action.fcurves away."""
    data = owner.animation_data
    action = data.action if data is not None else None
    if action is None:
        return []
    if not hasattr(action, 'slots'):
        return list(action.fcurves)
    slot = data.action_slot
    bags = [strip.channelbag(slot) for layer in action.layers for strip in layer.strips if strip.type == 'KEYFRAME'] if slot else []
    return [curve for bag in bags if bag is not None for curve in bag.fcurves]


def only_needed(auto):
    """Whether keys go only where they change something. 4.1 has a switch for auto-key beside that for other keys."""
    edit = bpy.context.preferences.edit
    return getattr(edit, 'use_auto_keyframe_insert_needed', edit.use_keyframe_insert_needed) if auto else edit.use_keyframe_insert_needed


def own_rules(holder):
    """The rules of keyframes that a keying set or one of its paths has of its own: {option: whether it is on}. 4.1 took the colours out."""
    names = (('INSERTKEY_NEEDED', 'needed'), ('INSERTKEY_VISUAL', 'visual'), ('INSERTKEY_XYZ_TO_RGB', 'xyz_to_rgb'))
    return {option: getattr(holder, 'use_insertkey_' + name) for option, name in names
            if getattr(holder, 'use_insertkey_override_' + name, False)}


def key_options(options):
    """Options of keyframe_insert. From 4.1 on the colours of new curves are those of the preferences, whoever inserts."""
    return set(options) - ({'INSERTKEY_XYZ_TO_RGB'} if VERSION >= (4, 1, 0) else set())


# Sessions number their blocks for good since 4.1; until then an address stands for the number, which undo keeps for what it leaves.
LASTING_UID = 'session_uid' in bpy.types.ID.bl_rna.properties


def uid(block):
    """What tells a data-block from all others of the session, whatever its name."""
    return block.session_uid if LASTING_UID else block.as_pointer()


def new_key(obj, name):
    """A shape key of the mesh as it is, which does nothing yet. 5.0 makes keys that act at once."""
    key = obj.shape_key_add(name=name, from_mix=False)
    key.value = 0
    return key


def bone_seen(armature, pose_bone):
    """Whether a pose bone is in what the armature shows. 4.0 has collections of bones instead of layers, 5.0 hides pose bones."""
    bone = pose_bone.bone
    if pose_bone.hide if hasattr(pose_bone, 'hide') else bone.hide:
        return False
    if hasattr(armature.data, 'layers'):
        return any(shown and has for shown, has in zip(armature.data.layers, bone.layers))
    seen = [getattr(c, 'is_visible_effectively', c.is_visible) for c in bone.collections]  # 4.1 nests them
    return not seen or any(seen)


def bone_selected(pose_bone):
    """Whether a pose bone is selected. 5.0 keeps that on the pose bone."""
    return pose_bone.select if hasattr(pose_bone, 'select') else pose_bone.bone.select


def editable_override(block):
    """Lets an override be edited: 3.4 makes all but the chosen object's for the system alone."""
    if hasattr(block.override_library, 'is_system_override'):
        block.override_library.is_system_override = False
