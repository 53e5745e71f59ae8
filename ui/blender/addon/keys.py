"""Keyframes where Blender puts them: on the frame, of what moved, while auto-key is on or a keying set is active."""
import bpy

from .bones import BonePlace, rotation_path
from .controls import KeyControl, Property


def wanted(scene):
    """Whether what a stroke moves is keyed."""
    return scene.tool_settings.use_keyframe_insert_auto or scene.keying_sets_all.active is not None


def channels_of(control):
    """The block, path, index and group that a keyframe of a control goes into."""
    if isinstance(control, (KeyControl, Property)):
        block, path, index = control.path()
        return block, path, index, ''
    if isinstance(control, BonePlace):
        return control.pose_bone(), 'location', control.axis, control.bone
    turn = getattr(control, 'turn', control)
    bone = turn.pose_bone()
    return bone, rotation_path(bone), -1, bone.name


def _in_set(keying_set, block, path):
    """A keying set of paths keys what it names; a built-in one, whose paths are made as it is used, all that moved."""
    if keying_set is None or not keying_set.paths:
        return True
    full = block.path_from_id(path) if not path.startswith('[') else block.path_from_id() + path
    for one in keying_set.paths:
        if one.id == block.id_data and (full == one.data_path or full.startswith(one.data_path)):
            return True
    return False


def key(controls, scene=None):
    """Keys what moved, on the frame. How many channels."""
    scene = scene or bpy.context.scene
    if not wanted(scene):
        return 0
    auto = scene.tool_settings.use_keyframe_insert_auto
    keying_set = scene.keying_sets_all.active
    only_set = keying_set if keying_set is not None and (not auto or scene.tool_settings.use_keyframe_insert_keyingset) else None
    done = set()
    for control in controls:
        block, path, index, group = channels_of(control)
        name = (block.id_data.name, path, index, getattr(block, 'name', ''))
        if name in done or (only_set is not None and not _in_set(only_set, block, path)):
            continue
        done.add(name)
        block.keyframe_insert(path, index=index, frame=scene.frame_current, **({'group': group} if group else {}))
    return len(done)
