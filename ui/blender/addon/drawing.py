"""Drawing on an object: strokes become curves of its character and move its controls. What the pen operator does at each event, and
scripts may call: begin(), follow() for each part of a target, then end() or cancel().
"""
import numpy as np
from mathutils import Vector

from . import keys, measure, store
from .controls import Refused
from .library import Error, Preset, Role, View
from .rig import Rig, armature_of, check, give_back
from .space import Space

ROUNDS = 3  # after each a measured rig is measured again, and what locks and limits left is taken
LONG = 1.0  # s that measuring takes without being told
_rigs = {}  # by the object's name


class _Known:
    """A character that is in step with the curves that its object keeps."""

    def __init__(self, obj):
        self.kept = ''
        self.numbers = {}  # of the character's curves, by ids of those on the object
        self.said = []
        self.read(obj)

    def read(self, obj):
        """Reads the rig of the object as it is now."""
        self.signature, self.shapes = _signature(obj), _shapes(obj)
        self.rig = Rig(obj)
        self.kept, self.numbers = '', {}
        if self.rig.took_s > LONG:
            self.said.append('measuring what %d controls of %s do took %.1f s; lock or hide bones that you do not draw with' % (
                len(self.rig.parts), obj.name, self.rig.took_s))


def _rounded(matrix):
    return tuple(round(x, 6) for row in matrix for x in row)


def _places(points):
    """Some of them, for all are many."""
    return tuple(tuple(points[i].co) for i in range(0, len(points), max(1, len(points) // 50)))


def _shapes(obj):
    """Changes where any vertex of a key does, or one of some weights. Takes 0.1 s for 50 keys of 30000 vertices, so that it is not
    asked where a target begins."""
    keys = obj.data.shape_keys
    out, one = [], np.empty(3 * len(obj.data.vertices), dtype=np.float32)
    for key in keys.key_blocks if keys else ():
        key.data.foreach_get('co', one)
        out.append(hash(one.tobytes()))
    vertices = obj.data.vertices
    some = range(0, len(vertices), max(1, len(vertices) // 2000)) if obj.vertex_groups else ()
    return out, [(e.group, e.weight) for i in some for e in vertices[i].groups]


def _key_signature(keys):
    blocks = tuple((k.name, k.mute, k.slider_min, k.slider_max, k.vertex_group, k.relative_key.name, _places(k.data))
                   for k in keys.key_blocks)
    return keys.library is not None, blocks


def _bone_signature(bone):
    limits = [(c.type, c.mute, c.influence, *(getattr(c, n, None) for n in ('min_x', 'max_x', 'min_y', 'max_y', 'min_z', 'max_z',
                                                                          'use_limit_x', 'use_limit_y', 'use_limit_z', 'euler_order')))
              for c in bone.constraints]
    return (bone.name, bone.rotation_mode, tuple(bone.lock_rotation), bone.lock_rotations_4d, tuple(bone.location), tuple(bone.scale),
            bone.bone.hide, tuple(limits))


def _signature(obj):
    """Changes where the rig may have changed."""
    keys_of = obj.data.shape_keys
    armature = armature_of(obj)
    blocks = _key_signature(keys_of) if keys_of else ()
    bones = tuple(_bone_signature(b) for b in armature.pose.bones) if armature else ()
    drivers = tuple(len(b.animation_data.drivers) for b in (keys_of, armature, obj) if b is not None and b.animation_data)
    modifiers = [(m.type, m.show_viewport) for m in obj.modifiers]
    groups = tuple(g.name for g in obj.vertex_groups)
    coordinates = np.empty(3 * len(obj.data.vertices), dtype=np.float32)
    obj.data.vertices.foreach_get('co', coordinates)
    shape = hash(coordinates.tobytes())
    between = _rounded(armature.matrix_world.inverted() @ obj.matrix_world) if armature else ()
    return (obj.data.name, len(obj.data.polygons), len(obj.data.loops), shape, blocks, bones, drivers, tuple(modifiers), groups,
            _rounded(obj.matrix_world.to_3x3()), armature.name if armature else None, between)


def forget(name=None):
    """Forgets what is known of an object, or of all (as a file is opened): it is read again at the next stroke."""
    if name is None:
        _rigs.clear()
        store.bring_back()
    else:
        _rigs.pop(name, None)


def in_step():
    """After undo: characters stay, and take the curves and the pose of that moment at the next stroke."""
    store.bring_back()
    for one in _rigs.values():
        one.kept = ''


def known(obj, wholly=False):
    """The character of an object as it is now, with the curves that the object keeps. Raises Refused. `wholly`: whether each vertex
    of its keys is looked at for changes; else some."""
    check(obj)
    problem = store.problem(obj)
    if problem:
        raise Refused(problem)
    one = _rigs.get(obj.name)
    if one is None:
        one = _rigs[obj.name] = _Known(obj)
    elif one.signature != _signature(obj) or not one.rig.holds(obj) or wholly and one.shapes != _shapes(obj):
        one.read(obj)
    if obj.get(store.PROPERTY, '') != one.kept:
        _bring_curves(one, obj)
    return one


def _bring_curves(one, obj):
    """Gives the character the object's curves; the pose stays."""
    rig, kept = one.rig, store.read(obj)
    before = kept['topology']
    retired = store.found_again(kept, rig.mesh)
    if kept['curves'] and kept['topology'] != before or retired:
        store.write(obj, kept)
    if retired:
        several = len(retired) > 1
        one.said.append('%d curve%s of %s lay on faces that are gone, and %s taken away; draw %s again' % (
            len(retired), 's' if several else '', obj.name, 'were' if several else 'was', 'them' if several else 'it'))
    rig.character.clear()
    one.numbers = {}
    for curve in kept['curves']:
        if curve.get('off'):
            continue
        role = Role.CONSTRAINT if curve['role'] == 'constraint' else Role.REFERENCE
        points = np.array(curve['points'])
        number = rig.character.curve_of(points[:, 0].astype(np.uint32), points[:, 1:], role)
        one.numbers[curve['id']] = number
        target = curve.get('target')
        if target:
            try:
                if 'points' in target:
                    rig.character.target(number, target['points'])
                else:
                    rig.character.draw_target(number, View(**target['view']), target['px'], target['pressure'] or None)
            except Error as problem:
                one.said.append('curve %d: %s' % (curve['id'], problem))
    one.kept = obj.get(store.PROPERTY, '')
    rig.take_pose()


def become_its_file(obj):
    """Makes the character of an object what the file of it holds, so that what is drawn on from here replays on that file. The file."""
    one = known(obj)
    one.rig.take_pose()
    one.rig.character.clear()
    one.rig.become_file()
    _bring_curves(one, obj)
    return one.rig.character.write('.glb')


def keep_curve(one, obj, number, role):
    """Keeps a curve of the character on the object. Its id there."""
    kept = store.read(obj)
    kept['topology'] = one.rig.mesh.topology
    triangles, shares = one.rig.character.points(number)
    points = [[int(t), *map(float, s)] for t, s in zip(triangles, shares)]
    curve = {'id': kept['next'], 'role': role, 'points': points}
    curve['rest'] = store.places_of(curve, one.rig.mesh.triangles, one.rig.mesh.rest).tolist()
    kept['next'] += 1
    kept['curves'].append(curve)
    store.write(obj, kept)
    one.numbers[curve['id']] = number
    one.kept = obj.get(store.PROPERTY, '')
    return curve['id']


class Stroke:
    """One stroke on an object. `kind`: 'reference', 'target' (of the curve `of`, else of the last reference without one) or
    'constraint'; `seen`: the view it is drawn in (space.Seen). Raises Refused or library.Error, with nothing changed."""

    def __init__(self, obj, kind, seen, of=None):
        self.object, self.kind, self.seen = obj.name, kind, seen
        self.known = known(obj, wholly=kind != 'target')
        self.rig = self.known.rig
        self.rig.take_pose()
        self.before, self.kept = self.rig.pose(), self.rig.kept()
        self.px, self.pressure = [], []
        self.live, self.followed = None, None  # the pose that was set last
        self.keyed = 0  # channels
        if kind == 'target':
            self.curve = self._curve(obj, of)
            self.live = self.rig.character.live(self.known.numbers[self.curve], seen.view)

    def _curve(self, obj, of):
        curves = [c for c in store.read(obj)['curves'] if c['role'] == 'reference']
        if of is not None:
            curves = [c for c in curves if c['id'] == of]
        else:
            curves = [c for c in curves if 'target' not in c] or curves
        if not curves and of is not None:
            raise Refused('%s has no curve %d to give a target; draw its reference again' % (obj.name, of))
        if not curves:
            raise Refused('%s has no reference curve yet; draw first where the feature is, on the mesh' % obj.name)
        if curves[-1]['id'] not in self.known.numbers:
            raise Refused('curve %d of %s cannot be brought onto the mesh; delete it and draw it again' % (curves[-1]['id'], obj.name))
        return curves[-1]['id']

    def add(self, place, pressure=1.0):
        """A place of the region, px from its lower left corner. Moves nothing yet."""
        px = self.seen.px([place])[0]
        if not np.isfinite(px).all():
            return
        if self.px and np.abs(px - self.px[-1]).max() < 1e-3:
            return
        self.px.append(px)
        self.pressure.append(min(1.0, max(0.0, pressure)))

    def follow(self):
        """Moves the rig as far as the target is drawn; the pose."""
        if self.live is None or len(self.px) < 2:
            return None
        pose = self.live.follow(np.array(self.px)).copy()
        self.rig.apply(pose, self.followed)
        self.followed = pose
        return pose

    def places(self):
        """The line so far, px of the region."""
        return self.seen.places(self.px)

    def cancel(self, obj):
        """Leaves no trace."""
        give_back(self.kept)
        if obj is None or obj.name != self.object:
            forget(self.object)

    def end(self, obj):
        """The stroke is drawn: keeps its curve, settles the pose, keys what moved. The controls that moved."""
        if len(self.px) < 2:
            self.cancel(obj)
            raise Refused('a stroke is a line; draw it on %s with the pen down' % obj.name)
        give_back(self.kept)
        self.rig.take_pose()
        px = np.array(self.px)
        pressure = None if all(p == 1.0 for p in self.pressure) else np.array(self.pressure)
        if self.kind != 'target':
            self._keep_curve(obj, px)
            return []
        try:
            self._settle(obj, px, pressure)
        except Error as problem:
            self.cancel(obj)
            raise Refused('the target on %s: %s' % (obj.name, problem)) from None
        except Refused:
            self.cancel(obj)
            raise
        kept = store.read(obj)
        target = {'view': vars(self.seen.view), 'px': px.tolist(), 'pressure': [] if pressure is None else pressure.tolist()}
        store.find(kept, self.curve)['target'] = target
        store.write(obj, kept)
        self.known.kept = obj.get(store.PROPERTY, '')
        moved = self.rig.moved_from(self.before)
        self.keyed = keys.key(moved, said=self.known.said)
        return moved

    def _keep_curve(self, obj, px):
        role = Role.CONSTRAINT if self.kind == 'constraint' else Role.REFERENCE
        try:
            number = self.rig.character.draw(self.seen.view, px, role)
        except Error as problem:
            raise Refused('the %s on %s: %s' % (self.kind, obj.name, problem)) from None
        keep_curve(self.known, obj, number, self.kind)

    def _settle(self, obj, px, pressure):
        self.rig.character.draw_target(self.known.numbers[self.curve], self.seen.view, px, pressure)
        self.rig.apply(self.rig.character.pose)
        for _ in range(ROUNDS if self.rig.answers_otherwise() else 0):
            if measure.shows(obj, self.rig):
                break
            # What is measured holds near the pose it was measured at.
            known(obj)
            self.rig = self.known.rig
            self.rig.take_pose()
            self.rig.character.draw_target(self.known.numbers[self.curve], self.seen.view, px, pressure)
            if not self.rig.apply(self.rig.character.pose):
                break


def solve_again(obj, preset=Preset.DEFAULT):
    """Brings all curves to their targets from the pose as it is. The controls that moved."""
    one = known(obj, wholly=True)
    before = one.rig.pose()
    one.rig.take_pose()
    for _ in range(ROUNDS if one.rig.answers_otherwise() else 1):
        one.rig.character.solve(preset)
        if not one.rig.apply(one.rig.character.pose) or measure.shows(obj, one.rig):
            break
        one = known(obj)
        one.rig.take_pose()
    moved = one.rig.moved_from(before)
    keys.key(moved, said=one.said)
    return moved


def delete(obj, number=None):
    """Takes a curve away, or all of them; the pose stays."""
    kept = store.read(obj)
    kept['curves'] = [c for c in kept['curves'] if number is not None and c['id'] != number]
    store.write(obj, kept)


def places(obj, depsgraph):
    """Where the curves of an object are as Blender shows it, in the world: [(curve, (n, 3))]. Changes nothing."""
    kept = store.read(obj)
    if not kept['curves']:
        return []
    data = obj.data
    data.calc_loop_triangles()
    used = {int(p[0]) for c in kept['curves'] for p in c['points']}
    positions = shown_positions(obj, depsgraph)
    if positions is None or max(used) >= len(data.loop_triangles):
        return []
    # This is drawn at each frame, and to ask for all triangles takes Blender ms.
    triangles = np.zeros((len(data.loop_triangles), 3), dtype=np.int32)
    for number in used:
        triangles[number] = data.loop_triangles[number].vertices
    if obj.matrix_world.determinant() < 0:
        triangles = triangles[:, ::-1]
    matrix = np.array(obj.matrix_world)
    return [(c, store.places_of(c, triangles, positions) @ matrix[:3, :3].T + matrix[:3, 3]) for c in kept['curves']]


def shown_positions(obj, depsgraph):
    """Where Blender shows the vertices, in the object's own space (n, 3); None where modifiers leave fewer of them. Of what
    subdivides, the vertices of the cage come first."""
    shown = obj.evaluated_get(depsgraph).data
    if len(shown.vertices) < len(obj.data.vertices):
        return None
    positions = np.empty(3 * len(shown.vertices), dtype=np.float32)
    shown.vertices.foreach_get('co', positions)
    return positions.reshape(-1, 3).astype(np.float64)


def target_places(obj, curve):
    """Where a target was drawn, in the world, as deep as the middle of its reference at rest (n, 3)."""
    target, space = curve['target'], Space(obj.matrix_world)
    if 'points' in target:
        return space.to_world(target['points'])
    view = View(**target['view'])
    eye, look = np.array(view.eye), np.array(view.look_at)
    forward = (look - eye) / np.linalg.norm(look - eye)
    side = np.cross(forward, np.array(view.up))
    side /= np.linalg.norm(side)
    up = np.cross(side, forward)
    depth = float((np.array(curve['rest']).mean(axis=0) - eye) @ forward)
    px = np.array(target['px']) - [0.5 * view.width, 0.5 * view.height]
    scale = depth * np.tan(np.radians(0.5 * view.vertical_fov_degrees)) / (0.5 * view.height)
    return space.to_world(eye + depth * forward + scale * (px[:, :1] * side - px[:, 1:] * up))


def said(obj):
    """What is to be told since it was asked last, a line each."""
    one = _rigs.get(obj.name)
    if one is None:
        return []
    lines, one.said = one.said, []
    return lines


def corner(place):
    """A place as a vector."""
    return Vector(place)
