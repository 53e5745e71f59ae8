"""The characters that are drawn on, each in step with its rig in Blender and with the curves that its meshes keep."""
import bpy
import numpy as np

from . import curves, held, store, versions
from .character import armature_of, bone_above
from .controls import Refused
from .finish import Aim
from .library import Error, Role, View
from .reader import Reader, part_of
from .rig import Rig, check

LONG = 2.0  # s that measuring takes without being told
_rigs = {}  # by the uid of the first mesh


class Known:
    """A character that is in step with the curves of its meshes. `numbers`: of the character's curves, by their ids."""

    def __init__(self, obj, measured):
        self.said = []
        self.read(obj, measured)

    def read(self, obj, measured):
        """Reads the rig of the object as it is now."""
        self.shapes = shapes(obj)
        self.kept, self.numbers, self.near = None, {}, None

        def near(surface):
            self.near = near_of(surface, obj)
            return self.near
        self.rig = Rig(obj, near, measured)
        self.signature = signature(obj, not self.rig.measured)
        if measured:
            self._tell(obj)

    def measure(self, obj):
        """Measures what its curves ask for."""
        self.near = near_of(self.rig.surface, obj)
        self.rig.measure(self.near)
        self.kept = None
        self._tell(obj)

    def prepare(self, obj):
        """Measures what a new curve asks for, where that is not known yet."""
        if not self.covers(obj):
            self.measure(obj)
            bring_curves(self, obj)

    def _tell(self, obj):
        rig = self.rig
        if rig.took_s > LONG or rig.left:
            self.said.append('measuring what %d controls of %s do took %.1f s%s; lock or hide bones that you do not draw with' % (
                len(rig.parts), obj.name, rig.took_s, ', and %d more were left out' % rig.left if rig.left else ''))

    def limit(self, obj, chosen, wide=False):
        """Rig.limit(), and makes the `reader` of it. Whether controls are left out that carry more."""
        at, more = self.rig.limit(chosen, wide)
        self.read_by(obj, at)
        return more

    def read_by(self, obj, at):
        """Lines are read by these parameters."""
        rig = self.rig
        if len(at) == len(rig.names):
            self.reader = Reader(rig.character, slice(None), self.numbers)
            return
        self.reader = Reader(part_of(rig, at), at, {})
        for curve in curves.curves(obj):
            if curve['id'] in self.numbers:
                triangles, shares = rig.character.points(self.numbers[curve['id']])
                number = self.reader.character.curve_of(triangles, shares, _role(curve))
                self.reader.numbers[curve['id']] = number
                _aim(rig, self.reader.character, number, curve, len(triangles), [])
        self.reader.character.pose = rig.character.pose[at]

    def covers(self, obj):
        """Whether the curves lie where it was measured for."""
        if not self.rig.measured:
            return True
        near = near_of(self.rig.surface, obj)
        return self.rig.found is not None and (self.near is None or near is not None and set(near.tolist()) <= set(self.near.tolist()))


def near_of(surface, obj):
    """The vertices of the surface that references lie on; None where there are none."""
    out = []
    for curve in curves.curves(obj):
        points = curves.placed(surface, curve)[0] if curve['role'] == 'reference' else None
        if points:
            out.append(surface.triangles[[t for t, _ in points]].ravel())
    return np.unique(np.concatenate(out)) if out else None


def _rounded(matrix):
    return tuple(round(x, 6) for row in matrix for x in row)


def _places(points):
    """Some of them, for all are many."""
    return [points[i].co[:] for i in range(0, len(points), max(1, len(points) // 12))]


def shapes(obj):
    """Changes where any vertex of a key does, or one of some weights. Takes 0.1 s for 50 keys of 30000 vertices, so that it is not
    asked where a target begins."""
    out, weights = [], []
    for part in curves.parts(obj):
        keys = part.data.shape_keys
        one = np.empty(3 * len(part.data.vertices), dtype=np.float32)
        for key in keys.key_blocks if keys else ():
            key.data.foreach_get('co', one)
            out.append(hash(one.tobytes()))
        vertices = part.data.vertices
        some = range(0, len(vertices), max(1, len(vertices) // 2000)) if part.vertex_groups else ()
        weights += [(e.group, e.weight) for i in some for e in vertices[i].groups]
    return out, weights


def _key_signature(keys):
    blocks = tuple((k.name, k.mute, k.slider_min, k.slider_max, k.vertex_group, k.relative_key.name, _places(k.data))
                   for k in keys.key_blocks)
    return keys.library is not None, len(keys.animation_data.drivers) if keys.animation_data else 0, blocks


LIMIT_SETTINGS = tuple(name + letter for letter in 'xyz' for name in ('min_', 'max_', 'use_limit_', 'use_min_', 'use_max_')) + ('euler_order',)


def _bone_signature(armature, bone, posed):
    limits = [(c.type, c.mute, c.influence, *(getattr(c, n, None) for n in LIMIT_SETTINGS if c.type.startswith('LIMIT_')))
              for c in bone.constraints]
    return (bone.name, bone.rotation_mode, tuple(bone.lock_rotation), bone.lock_rotations_4d, tuple(bone.lock_location),
            tuple(bone.lock_scale), versions.bone_seen(armature, bone), bone.custom_shape is not None, tuple(limits),
            (tuple(bone.location), tuple(bone.scale)) if posed else ())


def _part_signature(part, first):
    data = part.data
    coordinates = np.empty(3 * len(data.vertices), dtype=np.float32)
    data.vertices.foreach_get('co', coordinates)
    armature = armature_of(part)
    if bone_above(part) is not None:
        lies = (part.parent_bone, _rounded(part.matrix_parent_inverse), _rounded(part.matrix_basis))
    else:
        base = armature or first
        lies = _rounded(part.matrix_world.to_3x3()) if part == first else (), _rounded(base.matrix_world.inverted() @ part.matrix_world)
    return (versions.uid(part), versions.uid(data), part.visible_get(), len(data.polygons), len(data.loops), coordinates.tobytes(),
            _key_signature(data.shape_keys) if data.shape_keys else (), tuple((m.type, m.show_viewport) for m in part.modifiers),
            tuple(g.name for g in part.vertex_groups), lies, versions.uid(armature) if armature else None,
            len(part.animation_data.drivers) if part.animation_data else 0)


def signature(obj, posed):
    """Changes where the rig may have changed. `posed`: places and scales of bones are part of it; what is measured is looked at."""
    parts = curves.parts(obj)
    armatures = {versions.uid(a): a for a in map(armature_of, parts) if a is not None}
    bones = tuple(_bone_signature(a, b, posed) for a in armatures.values() for b in a.pose.bones)
    drivers = tuple(len(a.animation_data.drivers) for a in armatures.values() if a.animation_data)
    return tuple(_part_signature(p, parts[0]) for p in parts), bones, drivers


def forget(name=None):
    """Forgets what is known of all characters, or of one whose mesh has a name: it is read again at the next stroke."""
    curves.forget_parts()
    held.renew()
    if name is None:
        _rigs.clear()
        store.bring_back()
        return
    obj = bpy.data.objects.get((name, None))
    for part in curves.parts(obj) if obj is not None and obj.type == 'MESH' else ():
        _rigs.pop(versions.uid(part), None)


def in_step():
    """After undo: characters stay, and take the curves and the pose of that moment at the next stroke."""
    store.bring_back()
    curves.forget_parts()
    held.renew()
    for one in _rigs.values():
        one.kept = None


def of(obj):
    """What is known of the character of an object, or None."""
    return _rigs.get(versions.uid(curves.parts(obj)[0])) if obj is not None and obj.type == 'MESH' else None


def known(obj, wholly=False, measured=True):
    """The character of an object as it is now, with the curves that its meshes keep. Raises Refused. `wholly`: whether each vertex
    of its keys is looked at for changes; else some. `measured`: whether its controls are needed; else its surface alone."""
    check(obj)
    parts = curves.parts(obj, anew=True)
    for part in parts:
        problem = store.problem(part)
        if problem:
            raise Refused(problem)
    first = parts[0]
    one = _rigs.get(versions.uid(first))
    if one is None:
        one = _rigs[versions.uid(first)] = Known(obj, measured)
    elif one.signature != signature(obj, not one.rig.measured) or wholly and one.shapes != shapes(obj):
        one.read(obj, measured)
    elif not one.rig.holds():
        if one.rig.measured:
            one.measure(obj) if measured else one.rig.bare()
            one.kept = None
        else:
            one.read(obj, measured)
    elif measured and not one.covers(obj):
        one.measure(obj)
    if curves.texts(obj) != one.kept:
        bring_curves(one, obj)
    return one


def bring_curves(one, obj):
    """Gives the character the curves of its meshes; the pose stays."""
    rig = one.rig
    retired, all_curves = [], _distinct(obj)
    rig.character.clear()
    one.numbers = {}
    for curve in all_curves:
        points, anew = curves.placed(rig.surface, curve)
        if points is None and anew:
            retired.append(curve['id'])
            curves.change(obj, curve['id'], lambda kept: None)
        elif points and anew:
            _lay(rig.surface, obj, curve, points)
        if not points or curve.get('off'):
            continue
        number = rig.character.curve_of(np.array([t for t, _ in points], dtype=np.uint32), np.array([s for _, s in points]), _role(curve))
        one.numbers[curve['id']] = number
        _aim(rig, rig.character, number, curve, len(points), one.said)
    if retired:
        many = len(retired) > 1
        one.said.append('%d curve%s of %s lay on faces that are gone, and %s taken away; draw %s again' % (
            len(retired), 's' if many else '', obj.name, 'were' if many else 'was', 'them' if many else 'it'))
    one.kept = curves.texts(obj)
    rig.take_pose()


def _distinct(obj):
    """The curves of a character, each with an id of its own: a mesh that was copied brings its curves along."""
    used = set()
    for part in curves.parts(obj):
        kept = store.read(part)
        again = [c for c in kept['curves'] if c['id'] in used]
        for curve in again:
            curve['id'] = 1 + max(used | {c['id'] for c in kept['curves']})
            kept['next'] = max(kept['next'], curve['id'] + 1)
        if again:
            store.write(part, kept)
        used |= {c['id'] for c in kept['curves']}
    return curves.curves(obj)


def _lay(surface, obj, curve, points):
    """Keeps where a curve was found again."""
    owner = surface.part_of(curve.owner)
    lies = [surface.part_of_triangle(t) for t, _ in points]
    kept = store.read(curve.owner)
    found = store.find(kept, curve['id'])
    found.pop('on', None)
    found.pop('topologies', None)
    found.update(curves.lying(owner, lies, points))
    found['topology'] = owner.topology
    store.write(curve.owner, kept)


def _role(curve):
    return Role.CONSTRAINT if curve['role'] == 'constraint' else Role.REFERENCE


def _aim(rig, character, number, curve, count, said):
    """Gives a curve of a character, of that number, the target that is kept. `said`: takes what is wrong with it."""
    target = curve.get('target')
    if target is None:
        return
    try:
        if 'px' in target:
            view = curves.view_of_owner(rig.surface, curve.owner, View(**target['view']))
            character.draw_target(number, view, target['px'], target['pressure'] or None)
        elif count == len(target['points']):
            character.target(number, curves.of_owner(rig.surface, curve.owner, target['points']))
    except Error as problem:
        said.append('curve %d: %s' % (curve['id'], problem))


def aims_of(surface, obj):
    """Where the curves of a character should be: of those that have a target and are not left for now."""
    out = []
    for curve in curves.curves(obj):
        target = curve.get('target')
        if target is None or curve.get('off'):
            continue
        if 'points' in target:
            out.append(Aim(curve['id'], points=curves.of_owner(surface, curve.owner, target['points'])))
        else:
            out.append(Aim(curve['id'], curves.view_of_owner(surface, curve.owner, View(**target['view'])), target['px']))
    return out


def said(obj):
    """What is to be told since it was asked last, a line each."""
    one = of(obj)
    if one is None:
        return []
    lines, one.said = one.said, []
    return lines
