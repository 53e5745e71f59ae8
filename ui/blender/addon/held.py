"""Blocks of Blender that are found again whatever they are called by then, and after an undo that made them anew."""
import bpy

from . import versions

COLLECTIONS = ('objects', 'armatures', 'meshes', 'shape_keys', 'lattices', 'curves', 'materials', 'scenes', 'collections', 'node_groups')
_moment = [0]


def renew():
    """After an undo or another file no reference to a block is used again."""
    _moment[0] += 1


def collection_of(block):
    """The collection of bpy.data that a block lies in, or None."""
    for name in COLLECTIONS:
        if getattr(bpy.data, name).get((block.name, block.library.filepath if block.library else None)) == block:
            return name
    return None


class Held:
    """A data-block. Its name is the last one that it was found by."""

    def __init__(self, block):
        self.collection = 'objects' if isinstance(block, bpy.types.Object) else collection_of(block)
        self._take(block)

    def _take(self, block):
        self.block, self.name, self.moment = block, block.name, _moment[0]
        self.library = block.library.filepath if block.library else None
        self.uid = versions.uid(block)

    def get(self):
        """The block, or None where it is gone."""
        if self.moment == _moment[0]:
            try:
                self.name = self.block.name
                return self.block
            except ReferenceError:
                return None
        found = self._sought()
        if found is not None:
            self._take(found)
        return found

    def _sought(self):
        blocks = getattr(bpy.data, self.collection)
        named = blocks.get((self.name, self.library))
        if named is not None and versions.uid(named) == self.uid:
            return named
        return next((b for b in blocks if versions.uid(b) == self.uid), None if versions.LASTING_UID else named)

    def __eq__(self, other):
        return isinstance(other, Held) and self.get() == other.get()

    __hash__ = None


class Member:
    """A pose bone or a shape key: one of a collection that a block has, found by its name or, where that changed, by its place."""

    def __init__(self, member):
        self.name, self.place = member.name, member.as_pointer()

    def of(self, collection):
        """The member in its collection, or None."""
        found = collection.get(self.name)
        if found is None:
            found = next((m for m in collection if m.as_pointer() == self.place), None)
            if found is None:
                return None
            self.name = found.name
        self.place = found.as_pointer()
        return found
