"""A rig whose controls are measured, on other frames: its animated channels are set to what their curves have there, Blender's own mesh is
looked at, and each channel gets back what it had, to the bit. Nothing of it is done while Blender draws."""
import bpy
import numpy as np

from . import keys, versions

MOST_KEPT = 120  # frames


class _Value:
    """One number that a curve animates."""

    def __init__(self, owner, curve):
        self.owner, self.curve = owner, curve
        path = curve.data_path
        self.is_custom = path.endswith('"]')
        head, _, tail = path.rpartition('["') if self.is_custom else path.rpartition('.')
        self.block = owner.path_resolve(head) if head else owner
        self.name = bpy.utils.unescape_identifier(tail[:-2]) if self.is_custom else tail
        whole = self.get_whole()
        self.index = curve.array_index if hasattr(whole, '__len__') and not isinstance(whole, str) else None

    def get_whole(self):
        return self.block[self.name] if self.is_custom else getattr(self.block, self.name)

    def get(self):
        return self.get_whole() if self.index is None else self.get_whole()[self.index]

    def set(self, value):
        if self.index is not None:
            self.get_whole()[self.index] = value
        elif self.is_custom:
            self.block[self.name] = type(self.block[self.name])(value)
            self.owner.update_tag()
        else:
            setattr(self.block, self.name, type(self.get())(value))


class Looked:
    """The vertices of a rig on frames that were looked at."""

    def __init__(self, rig):
        self.rig, self.kept = rig, {}

    def _values(self):
        owners = {}
        for part in self.rig.surface.parts:
            obj = part.object()
            for owner in (obj.data.shape_keys, *(m.object for m in obj.modifiers if m.type == 'ARMATURE')):
                if owner is not None:
                    owners[owner.name_full, type(owner).__name__] = owner
        for control, _, _ in self.rig.parts:
            owner = control.channels()[0][0].id_data
            owners[owner.name_full, type(owner).__name__] = owner
        out = []
        for owner in owners.values():
            for curve in versions.curves_of(owner) if owner.animation_data else ():
                try:
                    out.append(_Value(owner, curve))
                except (ValueError, KeyError, AttributeError, IndexError):
                    continue  # a curve of what is gone
        return out

    def _name(self, values, frame, unkeyed):
        return frame, np.array([v.curve.evaluate(keys.frame_in_action(v.owner, frame)) for v in values]).tobytes(), unkeyed

    def get(self, frame):
        """Vertices (n, 3) in the character's space; None where nobody looked yet."""
        values = self._values()
        return self.kept.get(self._name(values, frame, self._unkeyed(values)))

    def _unkeyed(self, values):
        animated = {(v.owner.name_full, v.curve.data_path) for v in values}
        still = [control.get() for control, _, _ in self.rig.parts
                 if not any((b.id_data.name_full, keys.keying_sets.channel(b, path).path) in animated for b, path, *_ in control.channels())]
        return str(still)

    def look(self, frames):
        """Looks at frames."""
        values = self._values()
        unkeyed, before = self._unkeyed(values), [v.get() for v in values]
        if len(self.kept) + len(frames) > MOST_KEPT:
            self.kept.clear()
        try:
            for frame in frames:
                name = self._name(values, frame, unkeyed)
                if name not in self.kept:
                    for value in values:
                        value.set(value.curve.evaluate(keys.frame_in_action(value.owner, frame)))
                    bpy.context.view_layer.update()
                    self.kept[name] = self.rig.surface.look()
        finally:
            for value, old in zip(values, before):
                value.set(old)
            bpy.context.view_layer.update()
