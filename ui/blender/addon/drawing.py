"""Drawing on a character: strokes become curves of it and move its controls. What the pen operator does at each event, and scripts may
call: Stroke, with follow() for each part of a target, then end() or cancel().
"""
import numpy as np
from mathutils import Vector

from . import keys, store, surface  # noqa: F401
from . import curves as on_parts
from .controls import Refused
from .curves import change, curves, delete, kept_all, parts, places, put_back_all, target_places  # noqa: F401 what others draw and list
from .finish import Aim, farthest, finish, siblings
from .held import Held
from .known import aims_of, bring_curves, forget, in_step, known, of, said  # noqa: F401
from .library import Error, Preset, Role
from .limits import character_of, chosen, make_override, overridable  # noqa: F401
from .rig import give_back

BETTER = 0.5  # of what one reading leaves: another one that leaves less is taken
ROUNDS = 6  # after each a measured rig is measured again where it moved, and what locks and limits left is taken


class Stroke:
    """One stroke on an object. `kind`: 'reference', 'target' (of the curve `of`, else of the last reference without one) or
    'constraint'; `seen`: the view it is drawn in (space.Seen). Raises Refused or library.Error, with nothing changed."""

    def __init__(self, obj, kind, seen, of=None):
        self.held, self.kind, self.seen = Held(obj), kind, seen
        self.known = known(obj, wholly=kind != 'target', measured=kind == 'target')
        self.rig = self.known.rig
        self.rig.take_pose()
        self.kept = self.rig.kept()
        self.px, self.pressure = [], []
        self.live, self.followed = None, None  # the pose that was set last
        self.keyed = 0  # channels
        if kind == 'target':
            self.curve = self._curve(obj, of)
            self.chosen = chosen(obj)
            self._read_by(obj, False)

    def _read_by(self, obj, wide):
        self.more = self.known.limit(obj, self.chosen, wide)
        self.live = self.known.reader.character.live(self.known.reader.numbers[self.curve], self.seen.view)
        self.pose = self.rig.character.pose

    def _follow(self):
        return self.known.reader.whole(self.pose, self.live.follow(np.array(self.px)))

    def _curve(self, obj, of):
        references = [c for c in curves(obj) if c['role'] == 'reference']
        if of is not None:
            references = [c for c in references if c['id'] == of]
        else:
            references = [c for c in references if 'target' not in c] or references
        if not references and of is not None:
            raise Refused('%s has no curve %d to give a target; draw its reference again' % (obj.name, of))
        if not references:
            raise Refused('%s has no reference curve yet; draw first where the feature is, on the mesh' % obj.name)
        if references[-1]['id'] not in self.known.numbers:
            raise Refused('curve %d of %s cannot be brought onto the mesh; delete it and draw it again' % (references[-1]['id'], obj.name))
        return references[-1]['id']

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
        pose = self._follow()
        if self.more and len(self.px) > 2 and self.followed is not None and np.array_equal(pose, self.followed) and self._is_far():
            # What is near cannot follow: what carries it may.
            self._read_by(self.held.get(), True)
            pose = self._follow()
        self.rig.apply(pose, self.followed)
        self.followed = pose
        return pose

    def _is_far(self):
        """Whether the line is as long as half of its reference."""
        here = self.seen.view.project(self.rig.character.positions(self.known.numbers[self.curve]))
        return _length(np.array(self.px)) > 0.5 * _length(here)

    def places(self):
        """The line so far, px of the region."""
        return self.seen.places(self.px)

    def cancel(self, obj):
        """Leaves no trace."""
        give_back(self.kept)
        if obj is None or obj != self.held.get():
            forget()

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
            moved = self._settle(obj, px, pressure)
        except Error as problem:
            self.cancel(obj)
            raise Refused('the target on %s: %s' % (obj.name, problem)) from None
        except Refused:
            self.cancel(obj)
            raise
        owner = next(c.owner for c in curves(obj) if c['id'] == self.curve)
        view = on_parts.view_to_owner(self.rig.surface, owner, self.seen.view)
        target = {'view': vars(view), 'px': px.tolist(), 'pressure': [] if pressure is None else pressure.tolist()}
        change(obj, self.curve, lambda curve: curve.update(target=target) or curve)
        self.known.kept = on_parts.texts(obj)
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
        def solve(character, numbers):
            character.draw_target(numbers[self.curve], self.seen.view, px, pressure)
        return settle(obj, self.known, solve, [Aim(self.curve, self.seen.view, px)])


def _length(line):
    return float(np.linalg.norm(np.diff(line, axis=0), axis=1).sum())


def settle(obj, one, solve, aims=()):
    """Solves for the character, which has Blender's pose, and shows it there. `aims`: of this stroke. The controls that moved."""
    rig = one.rig
    if not rig.measured:
        return _settle_taken(obj, one, solve)
    kept = rig.kept()
    _settle_measured(obj, one, solve, aims)
    return rig.changed_from(kept)


def _settle_measured(obj, one, solve, aims):
    """What is meant is brought to the lines, again from where it went while Blender answers otherwise, for what is measured holds near the
    pose it was measured at."""
    rig, limit = one.rig, chosen(obj)
    held = [Aim(c['id'], points=rig.character.positions(one.numbers[c['id']])) for c in curves(obj)
            if c['role'] == 'constraint' and c['id'] in one.numbers]
    own = {aim.curve for aim in aims}
    every = [*aims, *held, *(aim for aim in aims_of(rig.surface, obj) if aim.curve not in own)]
    kept = rig.kept()
    more = one.limit(obj, limit)
    moved = _read(obj, one, solve, every)
    off = farthest(rig, one.numbers, aims)
    if moved and off <= 1:
        return
    # The line asks for more: what carries all of it, from where it began, or others beside what moved.
    for again in ([True] if more else []) + ([False] if moved else []):
        first = rig.kept()
        if again:
            give_back(kept)
        rig.measure(again=rig.same(moved))
        bring_curves(one, obj)
        one.limit(obj, limit, again)
        moved_more = _read(obj, one, solve, every)
        if moved_more and farthest(rig, one.numbers, aims) < BETTER * off:
            return
        give_back(first)
        rig.measure(again=rig.same([*moved, *moved_more]))
        bring_curves(one, obj)


def _settle_taken(obj, one, solve):
    rig, touched = one.rig, []
    one.limit(obj, chosen(obj))
    start = since = rig.character.pose
    for _ in range(ROUNDS):
        solve(rig.character, one.numbers)
        moved = rig.apply(rig.character.pose, since)
        touched += [control for control in moved if not any(control is known for known in touched)]
        if not moved or not rig.answers_otherwise() or rig.shows():
            break
        # Locks and limits left another pose.
        rig.take_pose()
        since = rig.character.pose
        rig.only(moved)
    return rig.moved_from(start + rig.offsets, touched)


def _read(obj, one, solve, aims):
    """One reading of a measured rig: solved, and brought to the lines by what moves. The controls that moved."""
    rig = one.rig
    _solve(one, solve)
    moved = rig.is_moved()
    for _ in range(ROUNDS if moved else 0):
        meant = siblings(rig.found, moved)
        # Keys and properties have no other ways: what the solver says of them stands.
        pose = finish(rig, one.numbers, aims, meant) if len(meant) > len(moved) else rig.character.pose
        if not rig.apply(pose) or rig.shows():
            break
        rig.measure(again=[m.control for m in meant])
        bring_curves(one, obj)
        moved = rig.same(moved)
        if len(meant) == len(moved):
            one.read_by(obj, rig.numbers_of(moved))
            _solve(one, solve)
    return moved


def _solve(one, solve):
    solve(one.reader.character, one.reader.numbers)
    one.rig.character.pose = one.reader.whole(one.rig.character.pose)


def solve_again(obj, preset=Preset.DEFAULT, wholly=True):
    """Brings all curves to their targets from the pose as it is. `wholly`: as of known(). The controls that moved."""
    one = known(obj, wholly)
    moved = settle(obj, one, lambda character, numbers: character.solve(preset))
    keys.key(moved)
    return moved


def keep_curve(one, obj, number, role):
    """Keeps a curve of the character on the mesh that it lies on, and measures what may move it. Its id there."""
    triangles, shares = one.rig.character.points(number)
    points = [(int(t), s) for t, s in zip(triangles, shares)]
    made = on_parts.add(obj, one.rig.surface, points, {'role': role})
    one.numbers[made] = number
    one.kept = on_parts.texts(obj)
    if role == 'reference' and one.rig.measured:
        one.prepare(obj)
    return made


def become_its_file(obj):
    """Makes the character of an object what the file of it holds, so that what is drawn on from here replays on that file. The file."""
    one = known(obj)
    one.rig.take_pose()
    one.rig.character.clear()
    one.rig.become_file()
    bring_curves(one, obj)
    return one.rig.character.write('.glb')


def shown_positions(obj, depsgraph):
    """Where Blender shows the vertices of a mesh, in the object's own space (n, 3); None where modifiers leave fewer of them."""
    shown = obj.evaluated_get(depsgraph).data
    if len(shown.vertices) < len(obj.data.vertices):
        return None
    return surface.coordinates(shown.vertices, len(shown.vertices)).astype(np.float64)


def plain_normals(obj):
    """Leaves custom normals of a character out while a target is drawn. What normals_back() wants."""
    return surface.plain_normals(parts(obj))


def normals_back(token):
    """Undoes plain_normals()."""
    surface.normals_back(token)


def corner(place):
    """A place as a vector."""
    return Vector(place)
