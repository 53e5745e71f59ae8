"""What each control of a rig does, found by moving it a little and looking at the surface that Blender evaluates.

Drivers and constraints make any rig possible; near the pose as it is, each of its controls moves the vertices along straight ways. To
evaluate is what costs time: only what may move the neighbourhood of the drawing is tried, what moves little else before what moves more, and
controls that share no vertex are tried at once.
"""
import time

import bpy
import numpy as np
from mathutils.kdtree import KDTree

from .bones import BoneAngle, Channel
from .candidates import extent
from .controls import TINY, Refused, TwoSided
from .library import Shape
from .surface import making, normals_back, plain_normals

STEP = 0.05  # of a control's range
NEAR = 1e-6  # of the size: what Blender shows is what was computed
NOISE = 3e-7  # of the size: what single floats make of a place
MOST_S = 1.5  # that measuring may take
LEAST_TRIES = 100  # whatever they take
WIDE = 10  # times as large as what is drawn: what moves more than that is not meant by it
FAINT = 0.003  # of what is drawn: what can move it less is left out
ALIKE = 0.995  # the cosine from which on two controls do the same
CARRIES = 8  # times the squares of what it does near the lines: a control that does more elsewhere is meant where no other can follow
NEARBY = 0.18  # of what is drawn: what lies as near as that is near the lines. Both as core/intent has them for joints
BOTH_WAYS = 0.02  # of the shift: more of a difference between up and down is no straight way


class Way:
    """Where a unit of a control moves vertices: `vertices` and `shifts` (n, 3)."""

    def __init__(self, vertices, shifts):
        self.vertices, self.shifts = vertices, shifts

    @classmethod
    def between(cls, before, after, mask, by, size):
        """From two looks."""
        vertices = np.flatnonzero(mask)
        shifts = (after[vertices] - before[vertices])
        moved = np.abs(shifts).max(axis=1) > NOISE * size
        return cls(vertices[moved].astype(np.uint32), shifts[moved] / by)

    def speed(self, among=None):
        """The greatest shift of all vertices, or of some (a mask)."""
        shifts = self.shifts if among is None else self.shifts[among[self.vertices]]
        return float(np.linalg.norm(shifts, axis=1).max()) if len(shifts) else 0.0

    def area(self, places):
        """How large what it moves is: the length of a rod that is as far from its middle as the vertices are, by how far they go."""
        weights = (self.shifts ** 2).sum(axis=1)
        if not weights.sum():
            return 0.0
        found = places[self.vertices]
        middle = weights @ found / weights.sum()
        return float(np.sqrt(12 * weights @ ((found - middle) ** 2).sum(axis=1) / weights.sum()))

    def add_to(self, places, amount):
        """Moves places (n, 3) by an amount of it."""
        places[self.vertices] += amount * self.shifts

    def shape(self, name, least, most):
        """As a blend shape."""
        return Shape(name, self.shifts.astype(np.float32), self.vertices, least, most)

    def cosine(self, other, count):
        """How alike two are."""
        mine, theirs = np.zeros((count, 3)), np.zeros((count, 3))
        self.add_to(mine, 1)
        other.add_to(theirs, 1)
        return abs(float((mine * theirs).sum())) / max(1e-30, float(np.linalg.norm(mine) * np.linalg.norm(theirs)))


class Measured:
    """What was found of one control: its ways up and down (the same one where it is straight)."""

    def __init__(self, candidate, up, down):
        self.candidate, self.up, self.down = candidate, up, down
        self.straight = up is down
        self.control = candidate.control if self.straight else TwoSided(candidate.control)

    def far(self, touched):
        """How far it can move some vertices (a mask) from where it is."""
        control = self.candidate.control
        least, most = control.range()
        return max(self.up.speed(touched) * (most - control.get()), self.down.speed(touched) * (control.get() - least))

    def renew(self):
        """From here on it is measured from where the control is now."""
        control = self.candidate.control
        if hasattr(control, 'now'):
            control.now = control.get()
        if not self.straight:
            self.control.now = control.get()

    def moves(self):
        """Whether it moves anything."""
        return bool(len(self.up.vertices) or len(self.down.vertices))


def quiet(surface):
    """Puts aside what costs time or makes other vertices while controls are tried; what wake() wants."""
    suspended = [(held, m.name) for held in surface.aside for m in making(held.get())]
    for held, name in suspended:
        held.get().modifiers[name].show_viewport = False
    return suspended, plain_normals([p.object() for p in surface.parts])


def wake(kept):
    """Undoes quiet()."""
    suspended, normals = kept
    for held, name in suspended:
        if held.get() is not None and name in held.get().modifiers:
            held.get().modifiers[name].show_viewport = True
    normals_back(normals)


def looked(surface):
    """What Blender shows. Raises Refused."""
    seen = surface.look()
    if seen is None:
        raise Refused('a modifier changes the number of vertices of %s; turn it off in the viewport while you draw' %
                      surface.parts[0].held.name)
    return checked(surface, seen)


def checked(surface, seen):
    """Places that are finite. Raises Refused."""
    if not np.isfinite(seen).all():
        bad = next(p for p in surface.parts if not np.isfinite(seen[p.first:p.first + p.count]).all())
        raise Refused('%s shows a vertex that is not finite (NaN); mend its keys, bones or drivers' % bad.held.name)
    return seen


def chosen(found, near, places):
    """Those of the candidates that what is drawn may mean, the likeliest first. `near`: vertices that curves lie on; None: all count."""
    if near is None or not len(near):
        return sorted(found, key=lambda c: c.late)
    touching = [c for c in found if c.mask[near].any()]
    drawn = max(extent(places[near]), 1e-9)
    wide, share = {}, {}
    for c in touching:
        if id(c.mask) not in wide:
            wide[id(c.mask)], share[id(c.mask)] = extent(places[c.mask]), float(c.mask[near].mean())
    meant = [c for c in touching if c.place is None or c.fed or wide[id(c.mask)] <= WIDE * drawn]
    # What may move all that is drawn and little else comes first.
    return sorted(meant or touching, key=lambda c: (c.late, -1.0 if c.place is None or c.fed else
                                                    -share[id(c.mask)] * min(1.0, drawn / max(wide[id(c.mask)], 1e-12))))


def _step(control):
    least, most = control.range()
    step = getattr(control, 'STEP', None)
    if step is None or isinstance(control, Channel) and None not in control.limit():
        step = STEP * (most - least)
    return max(1.0, round(step)) if getattr(control, 'whole', False) else step


def _by(control, step):
    """A step of a control that its range has room for; 0: none."""
    value, (least, most) = control.get(), control.range()
    if isinstance(control, Channel):
        ends = control.limit()
        least, most = -np.inf if ends[0] is None else ends[0], np.inf if ends[1] is None else ends[1]
    return step if least - TINY <= value + step <= most + TINY else 0.0


def _batches(wanted):
    """Candidates that share no vertex go together."""
    out = []
    for one in wanted:
        for batch in out:
            if not (batch[0] & one.mask).any():
                batch[0] |= one.mask
                batch[1].append(one)
                break
        else:
            out.append([one.mask.copy(), [one]])
    return [batch for _, batch in out]


class Trials:
    """Trying controls, at one pose. `now`: what is shown there."""

    def __init__(self, surface):
        self.surface, self.begin = surface, time.perf_counter()
        self.kept = quiet(surface)
        try:
            looked(surface)
            self.now = looked(surface)
        except Refused:
            wake(self.kept)
            raise
        self.size = extent(self.now)
        self.tries = 0

    def end(self):
        """All is as it was, and seen as it is."""
        wake(self.kept)
        bpy.context.view_layer.update()

    def late(self):
        """Whether no more should be tried."""
        return self.tries >= LEAST_TRIES and time.perf_counter() - self.begin > MOST_S

    def ways(self, batch, sign):
        """The ways of candidates that are moved at once, by their ids; None for one that has no room."""
        kept, by = [], {}
        try:
            for one in batch:
                step = _by(one.control, sign * _step(one.control))
                if step:
                    kept.append((one.control, one.control.kept()))
                    before = one.control.get()
                    one.control.set(before + step)
                    by[id(one)] = one.control.get() - before
            moved = {k: v for k, v in by.items() if abs(v) > TINY}
            seen = self.surface.look() if moved else None
            self.tries += bool(moved)
        finally:
            for control, value in reversed(kept):
                control.give_back(value)
        if seen is None:
            return {}
        checked(self.surface, seen)
        return {id(one): Way.between(self.now, seen, one.mask, by[id(one)], self.size) for one in batch if id(one) in moved}

    def measure(self, wanted):
        """What the candidates do, as far as there is time for, and how many were left."""
        out, left = [], 0
        for batch in _batches(wanted):
            if self.late():
                left += len(batch)
                continue
            up = self.ways(batch, 1)
            both = [one for one in batch if one.fed or id(one) not in up]
            down = self.ways(both, -1) if both else {}
            for one in batch:
                a, b = up.get(id(one)), down.get(id(one))
                if a is None and b is None:
                    continue
                if a is None or b is None or not _differ(a, b, self.surface.count):
                    a = b = a if a is not None else b
                out.append(Measured(one, a, b))
        return [one for one in out if one.moves()], left


def _differ(up, down, count):
    a, b = np.zeros((count, 3)), np.zeros((count, 3))
    up.add_to(a, 1)
    down.add_to(b, 1)
    return float(np.abs(a - b).max()) > BOTH_WAYS * max(float(np.abs(a).max()), float(np.abs(b).max()))


def settled(found, places, near):
    """Gives controls without limits their range, and leaves out those that others do as well: a driver's control comes first."""
    for one in found:
        control = one.candidate.control
        if isinstance(control, Channel):
            speed = max(one.up.speed(), one.down.speed())
            control.reach = 0.5 * max(one.up.area(places), one.down.area(places)) / max(speed, 1e-12)
    if near is not None and len(near):
        touched = np.zeros(len(places), dtype=bool)
        touched[near] = True
        drawn = extent(places[near])
        found = [one for one in found if one.far(touched) >= FAINT * drawn]
        meant = [one for one in found if one.candidate.place is None or one.candidate.fed or one.up.area(places) <= WIDE * drawn]
        found = meant or found
    first = [one for one in found if one.candidate.fed]
    return [one for one in found if one.candidate.fed or not isinstance(one.candidate.control, (Channel, BoneAngle)) or
            not any(one.up.cosine(other.up, len(places)) > ALIKE for other in first)]


def broad(found, places, near):
    """Those that carry much more than what is near the lines."""
    if near is None or not len(near):
        return []
    tree = KDTree(len(near))
    for i, place in enumerate(places[near]):
        tree.insert(place, i)
    tree.balance()
    reach = NEARBY * extent(places[near])
    inside = np.array([tree.find(place)[2] < reach for place in places])
    sums = {}
    for one in found:
        if one.candidate.place is not None and not one.candidate.fed:
            # A bone is judged as a whole, by its places where it has some.
            kind = 0 if getattr(one.candidate.control, 'path', '') == 'location' else 1
            squares = (one.up.shifts ** 2).sum(axis=1)
            both = sums.setdefault(one.candidate.owner, {}).setdefault(kind, [0.0, 0.0])
            both[0] += squares.sum()
            both[1] += squares[inside[one.up.vertices]].sum()
    wide = {owner for owner, kinds in sums.items() if kinds[min(kinds)][0] > (1 + CARRIES) * kinds[min(kinds)][1]}
    return [one for one in found if one.candidate.place is not None and not one.candidate.fed and one.candidate.owner in wide]


def shapes_of(found, now):
    """The surface where all controls have what is their rest, and a shape for each parameter."""
    base, out, used = now.copy(), [], set()
    for one in found:
        name = one.control.name
        while name in used or name + '-' in used:
            name += ' '
        used |= {name, name + '-'}
        control = one.candidate.control
        least, most = control.range()
        if one.straight:
            rest = control.rest()
            one.up.add_to(base, rest - control.get())
            out.append(one.up.shape(name, min(0.0, least - rest), max(0.0, most - rest)))
        else:
            out.append(one.up.shape(name, 0.0, max(0.0, most - control.get())))
            out.append(Way(one.down.vertices, -one.down.shifts).shape(name + '-', 0.0, max(0.0, control.get() - least)))
    return base, out
