"""Drawing on an object: strokes become curves of its character and move its controls. What the pen operator does at each event, and
scripts may call: begin(), follow() for each part of a target, then end() or cancel().
"""
import numpy as np
from mathutils import Vector

from . import keys, store
from .controls import Refused
from .library import Error, Preset, Role, View
from .rig import Rig, check
from .space import Space

ROUNDS = 3  # a measured rig is measured again after each
_rigs = {}  # by the object's name


class _Known:
    """A character that is in step with the curves that its object keeps."""

    def __init__(self, obj):
        self.signature = _signature(obj)
        self.rig = Rig(obj)
        self.kept = ''
        self.numbers = {}  # of the character's curves, by ids of those on the object
        self.said = []


def _signature(obj):
    """Changes where the rig may have changed."""
    keys_of = obj.data.shape_keys
    armature = obj.find_armature()
    blocks = [(k.name, k.mute, k.slider_min, k.slider_max, k.vertex_group, k.relative_key.name) for k in keys_of.key_blocks] if keys_of else []
    bones = [(b.name, tuple(b.lock_rotation), tuple(b.location), tuple(b.scale), len(b.constraints)) for b in armature.pose.bones] if armature else []
    drivers = len(keys_of.animation_data.drivers) if keys_of and keys_of.animation_data else 0
    modifiers = [(m.type, m.show_viewport) for m in obj.modifiers]
    coordinates = np.empty(3 * len(obj.data.vertices), dtype=np.float32)
    obj.data.vertices.foreach_get('co', coordinates)
    shape = hash(coordinates.tobytes())
    linear = tuple(round(x, 6) for row in (obj.matrix_world.to_3x3()) for x in row)
    return (obj.data.name, len(obj.data.polygons), len(obj.data.loops), shape, tuple(blocks), tuple(bones), drivers, tuple(modifiers), linear,
            armature.name if armature else None)


def forget(name=None):
    """Forgets what is known of an object, or of all: it is read again at the next stroke."""
    if name is None:
        _rigs.clear()
    else:
        _rigs.pop(name, None)


def known(obj):
    """The character of an object as it is now, with the curves that the object keeps."""
    check(obj)
    one = _rigs.get(obj.name)
    if one is not None and one.signature != _signature(obj):
        one = None
    if one is None:
        one = _rigs[obj.name] = _Known(obj)
    elif one.rig.measured:
        _measure_again(one, obj)
    text = obj.get(store.PROPERTY, '')
    if text != one.kept:
        _bring_curves(one, obj)
    return one


def _measure_again(one, obj):
    one.rig = Rig(obj)
    one.kept, one.numbers = '', {}


def _bring_curves(one, obj):
    """Gives the character the object's curves; the pose stays."""
    rig, kept = one.rig, store.read(obj)
    retired = store.found_again(kept, rig.mesh)
    if retired:
        one.said.append('%d curve%s lay on faces that are gone, and %s taken away' %
                        (len(retired), 's' if len(retired) > 1 else '', 'were' if len(retired) > 1 else 'was'))
        store.write(obj, kept)
    rig.character.clear()
    one.numbers = {}
    for curve in kept['curves']:
        role = Role.CONSTRAINT if curve['role'] == 'constraint' else Role.REFERENCE
        points = np.array(curve['points'])
        number = rig.character.curve_of(points[:, 0].astype(np.uint32), points[:, 1:], role)
        one.numbers[curve['id']] = number
        target = curve.get('target')
        if target:
            try:
                rig.character.draw_target(number, View(**target['view']), target['px'], target['pressure'] or None)
            except Error as problem:
                one.said.append('curve %d: %s' % (curve['id'], problem))
    one.kept = obj.get(store.PROPERTY, '')
    rig.take_pose()


class Stroke:
    """One stroke on an object. `kind`: 'reference', 'target' (of the curve `of`, else of the last reference without one) or
    'constraint'; `seen`: the view it is drawn in (space.Seen). Raises Refused or library.Error, with nothing changed."""

    def __init__(self, obj, kind, seen, of=None):
        self.object, self.kind, self.seen = obj.name, kind, seen
        self.known = known(obj)
        self.rig = self.known.rig
        self.rig.take_pose()
        self.before = self.rig.pose()
        self.px, self.pressure = [], []
        self.live = None
        if kind == 'target':
            self.curve = self._curve(obj, of)
            self.live = self.rig.character.live(self.known.numbers[self.curve], seen.view)

    def _curve(self, obj, of):
        curves = [c for c in store.read(obj)['curves'] if c['role'] == 'reference']
        if of is not None:
            curves = [c for c in curves if c['id'] == of]
        else:
            curves = [c for c in curves if 'target' not in c] or curves
        if not curves:
            raise Refused('there is no reference curve yet; draw first where the feature is, on the mesh')
        return curves[-1]['id']

    def add(self, place, pressure=1.0):
        """A place of the region, px from its lower left corner. Moves nothing yet."""
        px = self.seen.px([place])[0]
        if self.px and np.abs(px - self.px[-1]).max() < 1e-3:
            return
        self.px.append(px)
        self.pressure.append(min(1.0, max(0.0, pressure)))

    def follow(self):
        """Moves the rig as far as the target is drawn; the pose."""
        if self.live is None or len(self.px) < 2:
            return None
        pose = self.live.follow(np.array(self.px))
        self.rig.apply(pose)
        return pose

    def places(self):
        """The line so far, px of the region."""
        return self.seen.places(self.px)

    def cancel(self, obj):
        """Leaves no trace."""
        self.rig.apply(self.before)
        self.rig.take_pose()
        del obj

    def end(self, obj):
        """The stroke is drawn: keeps its curve, settles the pose, keys what moved. The controls that moved."""
        if len(self.px) < 2:
            self.cancel(obj)
            raise Refused('a stroke is a line; draw it with the pen down')
        self.rig.apply(self.before)
        self.rig.take_pose()
        px = np.array(self.px)
        pressure = None if all(p == 1.0 for p in self.pressure) else np.array(self.pressure)
        kept = store.read(obj)
        kept['topology'] = self.rig.mesh.topology
        if self.kind != 'target':
            self._keep_curve(obj, kept, px)
            return []
        try:
            self._settle(obj, px, pressure)
        except Error:
            self.cancel(obj)
            raise
        target = {'view': vars(self.seen.view), 'px': px.tolist(), 'pressure': [] if pressure is None else pressure.tolist()}
        store.find(kept, self.curve)['target'] = target
        store.write(obj, kept)
        self.known.kept = obj.get(store.PROPERTY, '')
        moved = self.rig.moved_from(self.before)
        keys.key(moved)
        return moved

    def _keep_curve(self, obj, kept, px):
        role = Role.CONSTRAINT if self.kind == 'constraint' else Role.REFERENCE
        number = self.rig.character.draw(self.seen.view, px, role)
        triangles, shares = self.rig.character.points(number)
        points = [[int(t), *map(float, s)] for t, s in zip(triangles, shares)]
        curve = {'id': kept['next'], 'role': self.kind, 'points': points}
        curve['rest'] = store.places_of(curve, self.rig.mesh.triangles, self.rig.mesh.rest).tolist()
        kept['next'] += 1
        kept['curves'].append(curve)
        store.write(obj, kept)
        self.known.numbers[curve['id']] = number
        self.known.kept = obj.get(store.PROPERTY, '')

    def _settle(self, obj, px, pressure):
        self.rig.character.draw_target(self.known.numbers[self.curve], self.seen.view, px, pressure)
        self.rig.apply(self.rig.character.pose)
        for _ in range(ROUNDS if self.rig.measured else 0):
            # What is measured holds near the pose it was measured at.
            known(obj)
            self.rig = self.known.rig
            self.rig.character.draw_target(self.known.numbers[self.curve], self.seen.view, px, pressure)
            if not self.rig.apply(self.rig.character.pose):
                break


def solve_again(obj):
    """Brings all curves to their targets from the pose as it is. The controls that moved."""
    one = known(obj)
    before = one.rig.pose()
    one.rig.take_pose()
    for _ in range(ROUNDS if one.rig.measured else 1):
        one.rig.character.solve(Preset.DEFAULT)
        if not one.rig.apply(one.rig.character.pose) or not one.rig.measured:
            break
        one = known(obj)
    moved = one.rig.moved_from(before)
    keys.key(moved)
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
    triangles = np.empty(3 * len(data.loop_triangles), dtype=np.int32)
    data.loop_triangles.foreach_get('vertices', triangles)
    triangles = triangles.reshape(-1, 3)
    if obj.matrix_world.determinant() < 0:
        triangles = triangles[:, ::-1]
    positions = shown_positions(obj, depsgraph)
    if positions is None or max(p[0] for c in kept['curves'] for p in c['points']) >= len(triangles):
        return []
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
