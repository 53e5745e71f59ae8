"""Where a character is on other frames, by the curves of its controls: nothing of the scene is moved or evaluated for it."""
import copy

import numpy as np

from . import keys, versions
from .controls import TINY
from .looked import Looked

MOST_KEPT = 200  # poses of which curves or vertices are remembered


class _Shown:
    """Stands for a bone, key or owner of a property as its curves have it on a frame."""

    def __init__(self, block, values):
        self._block, self._values = block, values
        self._head = '' if block == block.id_data else block.path_from_id()

    def _at(self, path, value):
        found = self._values(self._block.id_data, path)
        if not found:
            return value
        if not hasattr(value, '__len__'):
            return found.get(0, value)
        out = value.copy() if hasattr(value, 'copy') else list(value)
        for index, number in found.items():
            out[index] = number
        return out

    def __getattr__(self, name):
        value = getattr(self._block, name)
        return self._at(self._head + '.' + name if self._head else name, value) if name in ANIMATED else value

    def __getitem__(self, name):
        return self._at('%s["%s"]' % (self._head, name), self._block[name])

    def __contains__(self, name):
        return name in self._block


ANIMATED = ('value', 'location', 'scale', 'rotation_euler', 'rotation_quaternion', 'rotation_axis_angle')


def _at(control, values):
    """A control that reads what `values` gives instead of what Blender has now."""
    one = copy.copy(control)
    for name in ('turn', 'control'):  # what it is made of
        if hasattr(one, name):
            setattr(one, name, _at(getattr(one, name), values))
    for name in ('blocks', 'owner', 'pose_bone'):
        read = getattr(control, name, None)
        if read is not None:
            setattr(one, name, (lambda read=read: [_Shown(b, values) for b in read()]) if name == 'blocks' else
                    (lambda read=read: _Shown(read(), values)))
    return one


class Moments:
    """The poses of a rig over time, as its curves are now."""

    def __init__(self, rig):
        self.rig, self.curves, self.owners = rig, {}, {}
        for control, _, _ in rig.parts:
            for block, *_ in control.channels():
                owner = block.id_data
                if owner.name_full not in self.owners:
                    self.owners[owner.name_full] = owner
                    for curve in versions.curves_of(owner):
                        self.curves.setdefault((owner.name_full, curve.data_path), {})[curve.array_index] = curve

    def _values(self, frame):
        inside = {name: keys.frame_in_action(owner, frame) for name, owner in self.owners.items()}

        def at(owner, path):
            found = self.curves.get((owner.name_full, path), ())
            return {index: found[index].evaluate(inside[owner.name_full]) for index in found}
        return at

    def is_animated(self, control):
        """Whether any curve moves a control."""
        return any((block.id_data.name_full, _path(block, path)) in self.curves for block, path, _, _ in control.channels())

    def pose(self, frame):
        """The pose of the character on a frame, as character.pose; what no curve moves is as it is now."""
        values, out = self._values(frame), []
        for control, _, _ in self.rig.parts:
            value = _at(control, values).get() if self.is_animated(control) else control.get()
            out += value if isinstance(value, list) else [value]
        return np.clip(np.array(out) - self.rig.offsets, self.rig.least, self.rig.most)

    def keyed(self):
        """The frames with a key of any control, in order."""
        found = set()
        for (owner, _), curves in self.curves.items():
            for curve in curves.values():
                data = self.owners[owner].animation_data
                for point in curve.keyframe_points:
                    x = point.co.x
                    found.add(round(data.nla_tweak_strip_time_to_scene(x) if data.use_tweak_mode else x, 3))
        return sorted(found)

    def neighbours(self, frame):
        """The keyed frames next to one on either side; fewer at the ends."""
        keyed = self.keyed()
        return [f for f in keyed if f < frame - TINY][-1:] + [f for f in keyed if f > frame + TINY][:1]


def _path(block, path):
    head = '' if block == block.id_data else block.path_from_id()
    return head + path if not head or path.startswith('[') else '%s.%s' % (head, path)


class Shapes:
    """Places of a character at poses, remembered by pose: of its curves, and of all vertices."""

    def __init__(self, rig):
        self.rig, self.character, self.kept, self.looked = rig, rig.character.copy(), {}, Looked(rig)
        self.corners = None

    def on(self, number, vertices):
        """The points (n, 3) of a curve where vertices are given."""
        triangles, shares = self._remembered(number, None, lambda: self.character.points(number))
        corners = self.character.triangles if self.corners is None else self.corners
        self.corners = corners
        return np.einsum('ij,ijk->ik', shares, vertices[corners[triangles]])

    def curve(self, number, pose):
        """The points (n, 3) of a curve of the character, in its space."""
        return self._remembered((number, pose.tobytes()), pose, lambda: self.character.positions(number))

    def vertices(self, pose):
        """All vertices (n, 3), in its space, float32."""
        def find():
            return self.character.evaluate(out=np.empty((self.character.vertex_count, 3), np.float32))
        return self._remembered(pose.tobytes(), pose, find)

    def _remembered(self, name, pose, find):
        if name not in self.kept:
            if len(self.kept) >= MOST_KEPT:
                self.kept.clear()
            if pose is not None:
                self.character.pose = pose
            self.kept[name] = find()
        return self.kept[name]
