"""What each control of a character may move, from how its parts depend on each other: nothing is evaluated.

Nodes are tuples: ('channel', owner, path, axis) of a bone or object, ('local', owner) the pose of one by itself, ('placed', owner) where it is
in the end, and ('value', block, path) any other number. What comes out is more than what moves, never less.
"""
import re

import bpy
import numpy as np

from .character import armature_modifiers, armature_of, bone_above, objects_of_constraints, objects_of_modifiers
from .controls import drivers_of
from .surface import coordinates, finite

BONE = re.compile(r'^pose\.bones\["((?:[^"\\]|\\.)*)"\]\.?(.*)$')
CHANNEL = re.compile(r'^(location|scale|rotation_euler|rotation_quaternion|rotation_axis_angle)(?:\[(\d)\])?$')
LIMITS = ('LIMIT_ROTATION', 'LIMIT_LOCATION', 'LIMIT_SCALE')
LOCAL_SPACES = ('LOCAL', 'LOCAL_OWNER_ORIENT')
EXACT = ('ARMATURE',)  # modifiers after which a vertex moves by its own weights alone


def key_of(block):
    """What a node calls a block."""
    return block.as_pointer()


class Graph:
    """Dependencies, walked from the meshes of a character up to all that moves them. `armatures`, `others`: objects that were met;
    `driven`: whether drivers act; `properties`: [(block, path of the owner, name)] of custom properties that drivers look at."""

    def __init__(self, surface):
        self.surface, self.after, self.sinks = surface, {}, {}
        self.armatures, self.others, self.properties = [], [], []
        self.driven, self.fed, self.followed = False, set(), set()  # nodes that drivers look at, owners that constraints do
        self._met, self._waiting, self._scanned = set(), [], set()
        for part in surface.parts:
            self._part(part)
        while self._waiting:
            self._object(self._waiting.pop())

    def _edge(self, a, b):
        self.after.setdefault(a, set()).add(b)

    def _meet(self, obj):
        if key_of(obj) not in self._met:
            self._met.add(key_of(obj))
            self._waiting.append(obj)

    # What carries the vertices.

    def _part(self, part):
        obj, whole = part.object(), slice(part.first, part.first + part.count)
        self._meet(obj)
        exact = not part.shown and all(m.type in EXACT for m in obj.modifiers if m.show_viewport)

        def sink(node, inside):
            mask = self.sinks.setdefault(node, np.zeros(self.surface.count, dtype=bool))
            mask[whole] |= inside if exact else bool(np.any(inside))
        sink(('placed', key_of(obj)), True)
        armatures = {m.object for m in armature_modifiers(obj)} | ({armature_of(obj)} - {None})
        if armatures:
            masks = group_masks(obj)
            for armature in armatures:
                self._meet(armature)
                sink(('placed', key_of(armature)), True)
                envelopes = any(m.use_bone_envelopes for m in armature_modifiers(obj) if m.object == armature)
                for bone in armature.data.bones:
                    if bone.use_deform and (envelopes or bone.name in masks):
                        inside = True if envelopes else masks[bone.name]
                        sink(('placed', key_of(armature), bone.name), inside if exact or envelopes else bool(inside.any()))
        keys = obj.data.shape_keys
        for key in keys.key_blocks if keys else ():
            if key != keys.reference_key and not key.mute:
                count = len(obj.data.vertices)
                finite(coordinates(key.data, count), 'the shape key %s of %s' % (key.name, obj.name))
                moved = np.any(coordinates(key.data, count) != coordinates(key.relative_key.data, count), axis=1)
                sink(('value', key_of(keys), 'key_blocks["%s"].value' % bpy.utils.escape_identifier(key.name)),
                     moved if exact else bool(moved.any()))

    # What moves an object.

    def _object(self, obj):
        here = ('placed', key_of(obj))
        for path in ('location', 'rotation_euler', 'scale'):
            for axis in range(3):
                self._edge(('channel', key_of(obj), path, axis), ('local', key_of(obj)))
        self._edge(('local', key_of(obj)), here)
        if obj.parent is not None:
            self._meet(obj.parent)
            above = bone_above(obj) if obj.parent_type == 'BONE' else None
            self._edge(('placed', key_of(obj.parent), above[1].name) if above else ('placed', key_of(obj.parent)), here)
        self._constrained(obj, key_of(obj))
        self._deformed(obj, here)
        self._drivers(obj)
        if obj.type == 'ARMATURE':
            self.armatures.append(obj)
            self._bones(obj)
        else:
            self.others.append(obj)
        self._drivers(obj.data)
        self._drivers(getattr(obj.data, 'shape_keys', None))

    def _deformed(self, obj, here):
        """Modifiers look at other objects; what those are moved by moves this one too."""
        for other in objects_of_modifiers(obj):
            self._meet(other)
            if other.type != 'ARMATURE':
                self.followed.add((key_of(other),))
                self._edge(('placed', key_of(other)), here)
        if self.surface.part_of(obj) is not None:
            return
        for modifier in armature_modifiers(obj):
            armature = modifier.object
            for group in obj.vertex_groups:
                if group.name in armature.data.bones:
                    self._edge(('placed', key_of(armature), group.name), here)
            self._edge(('placed', key_of(armature)), here)
        keys = getattr(obj.data, 'shape_keys', None)
        for key in keys.key_blocks if keys else ():
            self._edge(('value', key_of(keys), 'key_blocks["%s"].value' % bpy.utils.escape_identifier(key.name)), here)

    def _constrained(self, owner, *name):
        for constraint, target, subtarget in objects_of_constraints(owner):
            self._meet(target)
            bone = subtarget if target.type == 'ARMATURE' else ''
            local = getattr(constraint, 'target_space', '') in LOCAL_SPACES and bone
            self.followed.add((key_of(target), *([bone] if bone else [])))
            source = ('local' if local else 'placed', key_of(target), *([bone] if bone else []))
            self._edge(source, ('constrained', *name))
            for moved in _chain(owner, constraint):
                self._edge(source, ('placed', name[0], moved.name))
                self._edge(('local', name[0], moved.name), ('constrained', *name))
        self._edge(('constrained', *name), ('local', *name))

    def _bones(self, armature):
        own = key_of(armature)
        for bone in armature.pose.bones:
            name = bone.name
            for path in ('location', 'rotation', 'scale'):
                for axis in range(3):
                    self._edge(('channel', own, name, path, axis), ('local', own, name))
            self._edge(('local', own, name), ('placed', own, name))
            self._edge(('placed', own), ('placed', own, name))
            for child in bone.children:
                self._edge(('placed', own, name), ('placed', own, child.name))
            if bone.constraints:
                self._constrained(bone, own, name)
            if bone.bone.bbone_segments > 1:
                for other in [bone.parent, *bone.children, bone.bone.bbone_custom_handle_start, bone.bone.bbone_custom_handle_end]:
                    if other is not None:
                        self._edge(('placed', own, other.name), ('placed', own, name))

    # What drives numbers.

    def _drivers(self, block):
        if block is None or key_of(block) in self._scanned:
            return
        self._scanned.add(key_of(block))
        for driver in drivers_of(block):
            ends = self._ends(block, driver.data_path, driver.array_index)
            self.driven |= any(end[0] != 'value' or end[2].startswith('key_blocks[') for end in ends)
            for variable in driver.driver.variables:
                for source in self._sources(variable):
                    self.fed.add(source)
                    for end in ends:
                        self._edge(source, end)

    def _ends(self, block, path, index):
        """What a driver of a path changes."""
        own = key_of(block)
        if not isinstance(block, bpy.types.Object):
            return [('value', own, path)]
        bone = BONE.match(path)
        if bone is not None:
            name, rest = bpy.utils.unescape_identifier(bone[1]), bone[2]
            return [('value', own, path)] if rest.startswith('["') else [('local', own, name)]
        if path.startswith('["'):
            return [('value', own, path)]
        if CHANNEL.match(path):
            return [('local', own)]
        return [('placed', own)] if path.startswith(('modifiers[', 'constraints[')) else [('value', own, path)]

    def _sources(self, variable):
        out = []
        for target in variable.targets:
            block = target.id
            if block is None:
                continue
            if isinstance(block, bpy.types.Object):
                self._meet(block)
            else:
                self._drivers(block)
            if variable.type == 'SINGLE_PROP':
                out += self._numbers(block, target.data_path)
            elif variable.type == 'TRANSFORMS':
                out += self._transforms(block, target)
            else:
                out.append(('placed', key_of(block), *([target.bone_target] if target.bone_target else [])))
        return out

    def _numbers(self, block, path):
        own, bone = key_of(block), BONE.match(path)
        owner, rest = ([own, bpy.utils.unescape_identifier(bone[1])], bone[2]) if bone else ([own], path)
        channel = CHANNEL.match(rest) if isinstance(block, bpy.types.Object) else None
        if channel is not None:
            kind = 'rotation' if bone and channel[1].startswith('rotation') else channel[1]
            turned = kind.startswith('rotation') and (bone or kind != 'rotation_euler')
            axes = range(3) if turned or channel[2] is None else [int(channel[2])]
            return [('channel', *owner, kind, axis) for axis in axes]
        head, bracket, tail = path.rpartition('["')
        if bracket and tail.endswith('"]'):
            self.properties.append((block, head, bpy.utils.unescape_identifier(tail[:-2])))
        return [('value', own, path)]

    def _transforms(self, block, target):
        own = key_of(block)
        owner = [own, target.bone_target] if target.bone_target and block.type == 'ARMATURE' else [own]
        if target.transform_space == 'WORLD_SPACE':
            return [('placed', *owner)]
        kind, _, letter = target.transform_type.partition('_')
        path = {'LOC': 'location', 'SCALE': 'scale'}.get(kind, 'rotation' if len(owner) > 1 else 'rotation_euler')
        axes = ['XYZ'.index(letter)] if letter in ('X', 'Y', 'Z') and not path.startswith('rotation') else range(3)
        return [('channel', *owner, path, axis) for axis in axes] + [('constrained', *owner)]

    # Answers.

    def vertices(self, starts):
        """The vertices that may move with nodes, as a mask."""
        seen, waiting = set(starts), list(starts)
        out = np.zeros(self.surface.count, dtype=bool)
        while waiting:
            node = waiting.pop()
            if node in self.sinks:
                out |= self.sinks[node]
            for other in self.after.get(node, ()):
                if other not in seen:
                    seen.add(other)
                    waiting.append(other)
        return out

    def is_followed(self, *owner):
        """Whether constraints of others follow a bone or object."""
        return owner in self.followed

    def feeds(self, starts):
        """Whether drivers look at one of these nodes."""
        return any(node in self.fed for node in starts)


def _chain(owner, constraint):
    """The bones that an IK constraint moves beside its own."""
    if constraint.type not in ('IK', 'SPLINE_IK'):
        return []
    above = [owner, *owner.parent_recursive]
    return above[:constraint.chain_count] if constraint.chain_count else above


def group_masks(obj):
    """The vertices that have some weight in each vertex group, by its name."""
    names, count = [g.name for g in obj.vertex_groups], len(obj.data.vertices)
    where = {}
    for vertex in obj.data.vertices:
        for entry in vertex.groups:
            if entry.weight > 0:
                where.setdefault(entry.group, []).append(vertex.index)
    out = {}
    for group, indices in where.items():
        if group < len(names):
            out[names[group]] = np.zeros(count, dtype=bool)
            out[names[group]][indices] = True
    return out
