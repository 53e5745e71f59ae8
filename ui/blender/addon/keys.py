"""Keyframes where Blender puts them: on the frame, of what moved, while auto-key is on or a keying set is active. Blender's own rules
hold: of auto-key, of keying sets, of the preferences and of the NLA strip that is tweaked."""
import bpy
import numpy as np

from . import handles, keying_sets, versions

KEYED_THROUGH = ('CYCLES', 'STEPPED', 'NOISE')  # modifiers of curves below which keyframes still count
AT_FRAME = 0.01  # frames: Blender takes keys that are nearer for one


def wanted(scene):
    """Whether what a stroke moves is keyed."""
    return scene.tool_settings.use_keyframe_insert_auto or scene.keying_sets_all.active is not None


class Rules:
    """What of Blender's settings keyframes heed."""

    def __init__(self, scene):
        settings, edit = scene.tool_settings, bpy.context.preferences.edit
        self.auto = settings.use_keyframe_insert_auto
        active = scene.keying_sets_all.active
        self.set = active if not self.auto or settings.use_keyframe_insert_keyingset else None
        self.options = set()
        if versions.only_needed(self.auto):
            self.options.add(keying_sets.NEEDED)
        if edit.use_visual_keying:
            self.options.add(keying_sets.VISUAL)
        if edit.use_insertkey_xyz_to_rgb:
            self.options.add(keying_sets.COLORS)
        if self.auto and settings.use_keyframe_cycle_aware:
            self.options.add('INSERTKEY_CYCLE_AWARE')
        self.replace = self.auto and settings.auto_keying_mode == 'REPLACE_KEYS'
        self.available = self.replace or self.auto and self.set is None and edit.use_keyframe_insert_available
        self.type = settings.keyframe_type
        self.interpolation, self.handle = edit.keyframe_new_interpolation_type, edit.keyframe_new_handle_type

    def for_all(self):
        """The same for keys that are asked for by name: all of what moves, new curves and further keys too."""
        self.set, self.replace, self.available = None, False, False
        self.options -= {keying_sets.NEEDED, keying_sets.VISUAL}
        return self

    def channels(self, controls):
        """The channels to key for controls that moved, each once."""
        moved = [(block, keying_sets.channel(block, path, index, group)) for c in controls for block, path, index, group in c.channels()]
        if self.set is None:
            found = [one for _, one in moved]
        else:
            found = keying_sets.chosen(self.set, moved, self.options, bpy.context)
        out = {}
        for one in found:
            for index in _components(one):
                out.setdefault((one.owner.name_full, type(one.owner), one.path, index), one._replace(index=index))
        return list(out.values())


def _components(channel):
    value = channel.owner.path_resolve(channel.path)
    if not hasattr(value, '__len__') or isinstance(value, str):
        return [-1]
    return range(len(value)) if channel.index == -1 else [channel.index]


def curve_of(owner, path, index=-1):
    """The curve of a channel in the action (or slot) that is active on a data-block, or None."""
    return next((c for c in versions.curves_of(owner) if c.data_path == path and c.array_index == max(0, index)), None)


def frame_in_action(owner, frame):
    """Where a frame of the scene lies in the action of a data-block: a strip of the NLA that is tweaked may be moved and scaled."""
    data = owner.animation_data
    return data.nla_tweak_strip_time_to_scene(frame, invert=True) if data is not None and data.use_tweak_mode else frame


def _points(curve):
    """Frames and values of a curve (n, 2); of none, none."""
    points = curve.keyframe_points if curve is not None else ()
    out = np.empty(2 * len(points), dtype=np.float32)
    if len(out):
        points.foreach_get('co', out)
    return out.reshape(-1, 2)


def _has_key(curve, frame):
    return bool((np.abs(_points(curve)[:, 0] - frame) < AT_FRAME).any())


def key(controls, scene=None, frame=None, said=None):
    """Keys what moved, on the frame that is shown or another. How many channels. `said`: takes a line for each that takes no key."""
    scene = scene or bpy.context.scene
    return insert(controls, Rules(scene), scene.frame_float if frame is None else frame, said) if wanted(scene) else 0


def insert(controls, rules, frame, said=None):
    """Keys controls by these rules, whether or not auto-key is on."""
    if keying_sets.VISUAL in rules.options or rules.set is not None:
        bpy.context.view_layer.update()
    channels, done, told = rules.channels(controls), 0, []
    if not channels and controls and rules.set is not None:
        told.append('the keying set %s holds nothing of what moved, so that nothing is keyed' % rules.set.bl_label)
    if rules.replace:
        channels = [c for c in channels if any(_has_key(curve, frame_in_action(c.owner, frame)) for curve in versions.curves_of(c.owner))]
    for one in channels:
        problem = _why_no_key(one)
        if not problem:
            try:
                done += _insert(one, rules, frame)
            except (RuntimeError, TypeError) as refused:
                problem = str(refused).strip().splitlines()[0]
        if problem:
            told.append('%s of %s takes no key: %s' % (one.path, one.owner.name, problem))
    if said is not None:
        said += dict.fromkeys(told)
    return done


def _why_no_key(channel):
    """Why Blender would not insert one, with the remedy; it would say so in its console as well."""
    action = channel.owner.animation_data.action if channel.owner.animation_data else None
    if action is not None and action.library is not None:
        return 'the action %s is linked; make it local' % action.name
    curve = curve_of(channel.owner, channel.path, channel.index)
    if curve is None:
        return ''
    if curve.lock or curve.group is not None and curve.group.lock:
        return 'its curve is locked; unlock it in the Graph Editor'
    if len(curve.sampled_points) or any(m.type not in KEYED_THROUGH and not getattr(m, 'use_additive', False) for m in curve.modifiers):
        return 'its curve is sampled or made by modifiers; convert it to keyframes'
    return ''


def _insert(channel, rules, frame):
    """Keys one channel. Whether it did."""
    owner, path, index = channel.owner, channel.path, channel.index
    curve, inside = curve_of(owner, path, index), frame_in_action(owner, frame)
    if rules.available and (curve is None or rules.replace and not _has_key(curve, inside)):
        return False  # asked for a key, Blender would make an action before it looks
    before, way = _points(curve), handles.way_through(curve, inside) if rules.handle in handles.BY_HAND else None
    options = versions.key_options(rules.options if channel.options is None else channel.options)
    if not owner.keyframe_insert(path, index=index, frame=frame, group=channel.group, options=options):
        return False
    curve = curve_of(owner, path, index)
    after = _points(curve)
    for i in np.flatnonzero(~np.isin(after[:, 0], before[:, 0])):
        # A key that a script inserts leaves the preferences out; one that is replaced stays what it is.
        point = curve.keyframe_points[int(i)]
        point.type = rules.type
        if len(after) <= 2:
            point.interpolation = rules.interpolation  # later ones take that of the key before them
        point.handle_left_type = point.handle_right_type = rules.handle
        if rules.handle in handles.BY_HAND:
            handles.set_handles(point, way)
    if curve is not None:
        curve.update()
    return True
