"""What of a rig in Blender penpose may move: shape keys and custom properties here, pose bones and objects in bones.py.

A control is found again at each use, because undo and file loads leave no reference to a bone or key valid. All have the same calls:
rest() is what the character has as 0, range() are least and most, get() and set() the value, kept() what give_back() brings back to
the bit, channels() where its keyframes go: [(block, path, index, group)].
"""
import bpy

from .held import Held, Member

TINY = 1e-6
WIDEST = 1000.0  # wider ranges of custom properties are taken for none


class Refused(Exception):
    """What is asked for cannot be done; the text is one line for a person, with the remedy."""


def found(held):
    """The block that is held. Raises Refused."""
    block = held.get()
    if block is None:
        raise Refused('%s is gone; select the mesh to draw on, and draw again' % held.name)
    return block


def within(value, least, most):
    """A value brought into a range."""
    return min(most, max(least, value))


class KeyControl:
    """The value of a shape key, or of those of several meshes that have one name. `keys`: pairs of (object, key)."""

    def __init__(self, keys):
        self.keys = [(Held(obj), Member(key)) for obj, key in keys]
        first = keys[0][1]
        self.key = self.name = first.name
        least, most = max(k.slider_min for _, k in keys), min(k.slider_max for _, k in keys)
        self.least, self.most = (least, most) if least < most else (first.slider_min, first.slider_max)

    def blocks(self):
        """The keys themselves. Raises Refused."""
        out = []
        for held, member in self.keys:
            keys = found(held).data.shape_keys
            key = member.of(keys.key_blocks) if keys else None
            if key is None:
                raise Refused('%s has no shape key %s any more; draw again' % (held.name, member.name))
            out.append(key)
        return out

    def rest(self):
        return within(0.0, self.least, self.most)

    def range(self):
        return self.least, self.most

    def get(self):
        return self.blocks()[0].value

    def set(self, value):
        for key in self.blocks():
            key.value = within(value, self.least, self.most)

    def kept(self):
        return [key.value for key in self.blocks()]

    def give_back(self, kept):
        for key, value in zip(self.blocks(), kept):
            key.value = value

    def channels(self):
        return [(key, 'value', -1, '') for key in self.blocks()]


class Property:
    """A custom property that drives what is seen. `path`: of the bone or whatever has it, in its block."""

    def __init__(self, block, path, prop, name):
        self.held, self.owner_path, self.prop, self.name = Held(block), path, prop, name
        self.bone = Member(block.path_resolve(path)) if path.startswith('pose.bones[') else None
        owner = self.owner()
        self.whole = isinstance(owner[prop], int)
        ui = owner.id_properties_ui(prop).as_dict()
        self.least, self.most = (float(ui.get('soft_' + end, ui.get(end, 0.0))) for end in ('min', 'max'))
        if self.most - self.least > WIDEST:
            # A property that nobody gave a range to.
            now = float(owner[prop])
            self.least, self.most = (max(self.least, min(-1.0, now - 1)), min(self.most, max(1.0, now + 1)))

    def owner(self):
        """What has the property. Raises Refused."""
        block = found(self.held)
        owner = self.bone.of(block.pose.bones) if self.bone else block.path_resolve(self.owner_path) if self.owner_path else block
        if owner is None or self.prop not in owner:
            raise Refused('%s has no property %s any more; draw again' % (self.held.name, self.prop))
        return owner

    def rest(self):
        return within(0.0, *self.range())

    def range(self):
        now = self.get()
        return min(self.least, now), max(self.most, now)

    def get(self):
        return float(self.owner()[self.prop])

    def set(self, value):
        value = within(float(value), *self.range())
        self.give_back(int(round(value)) if self.whole else value)

    def kept(self):
        return self.owner()[self.prop]

    def give_back(self, kept):
        owner = self.owner()
        owner[self.prop] = kept
        owner.id_data.update_tag()

    def channels(self):
        return [(self.owner(), '["%s"]' % bpy.utils.escape_identifier(self.prop), -1, self.bone.name if self.bone else '')]


class TwoSided:
    """A control that does one thing above where it is and another below, as drivers with max() and min() do: two parameters, how
    much of each."""

    def __init__(self, control):
        self.control, self.name, self.now = control, control.name, control.get()

    def rest(self):
        return [0.0, 0.0]

    def get(self):
        by = self.control.get() - self.now
        return [max(0.0, by), max(0.0, -by)]

    def set(self, values):
        self.control.set(self.now + values[0] - values[1])

    def locked(self):
        return [False, False]

    def kept(self):
        return self.control.kept()

    def give_back(self, kept):
        self.control.give_back(kept)

    def channels(self):
        return self.control.channels()


def drivers_of(block):
    """The drivers in force of a data-block."""
    data = getattr(block, 'animation_data', None)
    return [d for d in data.drivers if not d.mute] if data else []
