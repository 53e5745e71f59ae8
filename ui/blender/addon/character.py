"""Which objects are one character: meshes that one armature carries, that hang on each other or on the same empty, or that the same
values drive."""
import bpy

from .controls import drivers_of


def armature_modifiers(obj):
    """The Armature modifiers that are seen."""
    return [m for m in obj.modifiers if m.type == 'ARMATURE' and m.show_viewport and m.object is not None]


def armature_of(obj):
    """The armature that carries a mesh by its weights, or None."""
    for modifier in armature_modifiers(obj):
        return modifier.object
    if obj.parent is not None and obj.parent.type == 'ARMATURE' and obj.parent_type == 'ARMATURE':
        return obj.parent
    return None


def bone_above(obj):
    """The armature and bone that take an object along as a whole, or None."""
    while obj is not None:
        if obj.parent is not None and obj.parent.type == 'ARMATURE' and obj.parent_type == 'BONE':
            bone = obj.parent.pose.bones.get(obj.parent_bone)
            return (obj.parent, bone) if bone is not None else None
        obj = obj.parent
    return None


def objects_of_modifiers(obj):
    """The objects that modifiers of an object look at."""
    out = []
    for modifier in obj.modifiers:
        if not modifier.show_viewport:
            continue
        for prop in modifier.bl_rna.properties:
            if prop.type == 'POINTER' and prop.fixed_type.identifier == 'Object':
                other = getattr(modifier, prop.identifier)
                if other is not None:
                    out.append(other)
    return out


def objects_of_constraints(owner):
    """The objects, and bones by name or '', that constraints in force follow."""
    out = []
    for c in owner.constraints:
        if c.mute or c.influence == 0:
            continue
        if c.type == 'ARMATURE':
            out += [(c, t.target, t.subtarget) for t in c.targets if t.target is not None]
        elif getattr(c, 'target', None) is not None:
            out.append((c, c.target, getattr(c, 'subtarget', '')))
        if getattr(c, 'pole_target', None) is not None:
            out.append((c, c.pole_target, c.pole_subtarget))
    return out


def _values_of(obj):
    """The values that drive keys of a mesh, and the keys themselves, which may drive others'."""
    keys = obj.data.shape_keys
    if keys is None:
        return []
    out = [('block', keys.as_pointer())]
    for driver in drivers_of(keys):
        for variable in driver.driver.variables:
            for target in variable.targets:
                if target.id is None or isinstance(target.id, bpy.types.Scene):
                    continue
                whole = isinstance(target.id, bpy.types.Key) or getattr(target.id, 'type', '') == 'ARMATURE'
                out.append(('block', target.id.as_pointer()) if whole else
                           ('value', target.id.as_pointer(), target.data_path or target.bone_target or variable.type))
    return out


class _Bound:
    """Sets of what belongs together."""

    def __init__(self):
        self.above = {}

    def root(self, one):
        while one in self.above:
            one = self.above[one]
        return one

    def tie(self, a, b):
        a, b = self.root(a), self.root(b)
        if a != b:
            self.above[a] = b


def _object(obj):
    return ('block', obj.as_pointer())


def _tie_all(objects):
    bound, hanging = _Bound(), {}
    for obj in objects:
        own = _object(obj)
        armature = armature_of(obj) if obj.type == 'MESH' else None
        if armature is not None:
            bound.tie(own, _object(armature))
        if obj.type == 'MESH':
            for value in _values_of(obj):
                bound.tie(own, value)
            for other in objects_of_modifiers(obj):
                if other.type in ('MESH', 'LATTICE', 'ARMATURE'):
                    bound.tie(own, _object(other))
        if obj.type in ('MESH', 'LATTICE', 'EMPTY', 'ARMATURE'):
            for constraint, other, _ in objects_of_constraints(obj):
                if other.type == 'ARMATURE' and constraint.type in ('CHILD_OF', 'COPY_TRANSFORMS', 'ARMATURE', 'COPY_LOCATION'):
                    bound.tie(own, _object(other))
        if obj.type == 'LATTICE':
            for other in objects_of_modifiers(obj):
                bound.tie(own, _object(other))
        if obj.parent is not None and obj.parent.type in ('MESH', 'ARMATURE', 'LATTICE'):
            bound.tie(own, _object(obj.parent))
        elif obj.parent is not None and obj.parent.type == 'EMPTY':
            hanging.setdefault(obj.parent.as_pointer(), []).append(obj)
    for children in hanging.values():
        # A scene may hang on one empty: what has two armatures is no character.
        armatures = {bound.root(_object(o)) for o in children if o.type == 'ARMATURE' or o.type == 'MESH' and armature_of(o)}
        for obj in children if len(armatures) < 2 else ():
            if obj.type in ('MESH', 'ARMATURE', 'EMPTY'):
                bound.tie(_object(obj), _object(obj.parent))
                bound.tie(_object(obj), _object(children[0]))
    return bound


def parts_of(obj, view_layer=None):
    """The meshes of the character that a mesh is part of, hidden ones too; those that are seen come first, large before small."""
    view_layer = view_layer or bpy.context.view_layer
    objects = [o for o in view_layer.objects if o is not None and o.library is None]  # None: deleted just now
    if obj not in objects:
        return [obj]
    bound = _tie_all(objects)
    root = bound.root(_object(obj))
    found = [o for o in objects if o.type == 'MESH' and bound.root(_object(o)) == root and (o == obj or may_be_drawn_on(o))]
    return sorted(found, key=lambda o: (not o.visible_get(), -len(o.data.polygons), o.name))


def may_be_drawn_on(obj):
    """Whether a mesh of a character is one that has a surface, as it is shown."""
    keys = obj.data.shape_keys
    return bool(obj.data.polygons) and obj.display_type not in ('BOUNDS', 'WIRE') and abs(obj.matrix_world.determinant()) > 1e-30 and \
        obj.mode in ('OBJECT', 'POSE') and (keys is None or keys.use_relative and not obj.show_only_shape_key)


def largest_of(armature, view_layer=None):
    """The mesh with the most faces of the character that an object (armature, empty, control) moves, or None."""
    view_layer = view_layer or bpy.context.view_layer
    objects = [o for o in view_layer.objects if o is not None and o.library is None]  # None: deleted just now
    if armature not in objects:
        return None
    bound = _tie_all(objects)
    root = bound.root(_object(armature))
    found = [o for o in objects if o.type == 'MESH' and bound.root(_object(o)) == root and o.visible_get() and may_be_drawn_on(o)]
    return max(found, key=lambda o: (len(o.data.polygons), o.name), default=None)


def frame_of(obj):
    """The object whose place and turn the curves of a mesh are kept in: itself, or what does not move with a pose."""
    above = bone_above(obj)
    return above[0] if above is not None else obj
