"""What of a rig in Blender penpose may move: shape keys and custom properties here, pose bones in bones.py.

A control is found again by names at each use, because undo and file loads leave no reference to a bone or key valid.
"""
import bpy

TINY = 1e-6
WIDEST = 1000.0  # wider ranges of custom properties are taken for none


class Refused(Exception):
    """What is asked for cannot be done; the text is one line for a person, with the remedy."""


def object_named(name):
    """The object of that name. Raises Refused."""
    obj = bpy.data.objects.get((name, None))  # not a linked one of the same name
    if obj is None:
        raise Refused('the object %s is gone or has another name; select the mesh and draw again' % name)
    return obj


def _within(value, least, most):
    return min(most, max(least, value))


class KeyControl:
    """The value of a shape key."""

    def __init__(self, obj, key):
        self.object = obj.name
        self.key = key.name
        self.name = key.name
        self.least, self.most = key.slider_min, key.slider_max

    def _key(self):
        keys = object_named(self.object).data.shape_keys
        key = keys.key_blocks.get(self.key) if keys else None
        if key is None:
            raise Refused('%s has no shape key %s any more; draw again' % (self.object, self.key))
        return key

    def rest(self):
        """What the character has as 0: the value nearest to 0 that the slider has."""
        return _within(0.0, self.least, self.most)

    def range(self):
        """Of the value."""
        return self.least, self.most

    def get(self):
        return self._key().value

    def set(self, value):
        self._key().value = _within(value, self.least, self.most)

    def kept(self):
        """What give_back() brings back to the bit."""
        return self._key().value

    def give_back(self, kept):
        self._key().value = kept

    def path(self):
        """The block that a keyframe goes into, its path and index."""
        return self._key(), 'value', -1


class Property:
    """A custom property that drives what is seen."""

    def __init__(self, owner_path, owner, prop, name):
        self.owner_path = owner_path  # of bpy.data, evaluated at each use
        self.prop = prop
        self.name = name
        self.whole = isinstance(owner[prop], int)
        ui = owner.id_properties_ui(prop).as_dict()
        self.least, self.most = (float(ui.get('soft_' + end, ui.get(end, 0.0))) for end in ('min', 'max'))
        if self.most - self.least > WIDEST:
            # A property that nobody gave a range to.
            now = float(owner[prop])
            self.least, self.most = (max(self.least, min(-1.0, now - 1)), min(self.most, max(1.0, now + 1)))

    def owner(self):
        return resolve(self.owner_path)

    def rest(self):
        """What the character has as 0."""
        return _within(0.0, *self.range())

    def range(self):
        now = self.get()
        return min(self.least, now), max(self.most, now)

    def get(self):
        return float(self.owner()[self.prop])

    def set(self, value):
        value = _within(float(value), *self.range())
        self.give_back(int(round(value)) if self.whole else value)

    def kept(self):
        """What give_back() brings back to the bit."""
        return self.owner()[self.prop]

    def give_back(self, kept):
        owner = self.owner()
        owner[self.prop] = kept
        owner.id_data.update_tag()

    def path(self):
        return self.owner(), '["%s"]' % bpy.utils.escape_identifier(self.prop), -1


def resolve(path):
    """The block that a path such as ('objects', 'Rig', 'pose.bones["face"]') names."""
    block = getattr(bpy.data, path[0]).get(path[1])
    if block is None:
        raise Refused('%s, which drives what is drawn on, is gone or has another name; draw again' % path[1])
    return block.path_resolve(path[2]) if path[2] else block


def drivers_of(block):
    """The drivers in force of a data-block."""
    data = block.animation_data if block is not None else None
    return [d for d in data.drivers if not d.mute] if data else []


def curves_that_act(obj, armature):
    """The drivers that what is seen of an object depends on: of its keys, its modifiers, and the bones that carry it."""
    keys = obj.data.shape_keys
    out = [d for d in drivers_of(keys) if d.data_path.endswith('.value')]
    out += [d for d in drivers_of(obj) if d.data_path.startswith('modifiers[')]
    return out + [d for d in drivers_of(armature) if d.data_path.startswith('pose.bones[')]


def properties_that_drive(curves):
    """The custom properties of float or int that these drivers look at, as controls, each once; of those that are driven
    themselves, the ones that drive them."""
    found, seen, waiting = {}, set(), list(curves)
    while waiting:
        for variable in waiting.pop().driver.variables:
            if variable.type != 'SINGLE_PROP' or variable.targets[0].id is None:
                continue
            block, data_path = variable.targets[0].id, variable.targets[0].data_path
            head, bracket, tail = data_path.rpartition('["')
            collection = _collection_of(block)
            if not bracket or not tail.endswith('"]') or collection is None or (block.name, data_path) in seen:
                continue
            seen.add((block.name, data_path))
            above = [d for d in drivers_of(block) if d.data_path == data_path]
            waiting += above
            name = bpy.utils.unescape_identifier(tail[:-2])
            path = (collection, block.name, head)
            try:
                owner = resolve(path)
                if not above and isinstance(owner[name], (float, int)) and not isinstance(owner[name], bool):
                    found[path, name] = Property(path, owner, name, name)
            except (KeyError, ValueError, AttributeError, TypeError):
                continue
    return list(found.values())


def _collection_of(block):
    for name in ('objects', 'armatures', 'meshes', 'shape_keys'):
        if getattr(bpy.data, name).get(block.name) == block:
            return name
    return None
