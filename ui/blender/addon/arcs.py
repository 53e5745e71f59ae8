"""Motion arcs of the drawn curves and ghosts of the face over time, and what of them a pen touches.

An arc is the way of the middle of a reference over the frames around the current one; a ghost is the face on another frame. Both are
found where they are drawn, from the curves of the controls, and never while the animation plays."""
import bpy
import numpy as np

from . import curves, drawing
from .moments import Moments, Shapes
from .pull import distance

REACH_PX = 10.0  # so near to a frame of an arc, or to a line of a ghost, is on it
STILL = 1e-6  # of the places: what moves less stays
APART_PX = 6.0  # a ghost's line that is nearer to the face's own line is not taken for it
_seen = {}  # the Shapes of the character that was shown last


class Arc:
    """The way of a point of one curve: `frames`, `points` (n, 3) of the world, `keyed` (which frames have a key)."""

    def __init__(self, curve, frames, points, keyed):
        self.curve, self.frames, self.points, self.keyed = curve, frames, points, keyed


class Ghost:
    """The face on another frame: `away` counts ghosts from now (-1: the one before), `vertices` (n, 3) of the character, `lines`
    [(curve, (n, 3) of the world)]."""

    def __init__(self, frame, away, vertices, lines):
        self.frame, self.away, self.vertices, self.lines = frame, away, vertices, lines


class Times:
    """What is known of a character over time; made anew for each picture. `missing`: frames that have to be looked at first."""

    def __init__(self, obj):
        one = drawing.of(obj)
        if one is None or not one.rig.parts or one.kept is None:
            raise LookupError(obj.name)  # it is not read yet
        self.rig, self.numbers, self.space = one.rig, one.numbers, one.rig.mesh.space
        self.moments, self.shapes, self.missing = Moments(self.rig), shapes_of(one), []
        self.now = np.clip(self.rig.pose() - self.rig.offsets, self.rig.least, self.rig.most)
        self.curves = {c['id']: c for c in curves.curves(obj) if c['role'] == 'reference' and c['id'] in self.numbers}

    def vertices(self, frame):
        """All vertices on a frame (n, 3), in the character's space; None where nobody looked yet."""
        if not self.rig.measured:
            return self.shapes.vertices(self.moments.pose(frame))
        found = self.shapes.looked.get(frame)
        if found is None and frame not in self.missing:
            self.missing.append(frame)
        return found

    def here(self):
        """All vertices as they are now."""
        return self.shapes.vertices(self.now)

    def line(self, curve, frame):
        """Where a curve is on a frame (n, 3), in the world; None where nobody looked yet."""
        if not self.rig.measured:
            return self.space.to_world(self.shapes.curve(self.numbers[curve], self.moments.pose(frame)))
        vertices = self.vertices(frame)
        return None if vertices is None else self.space.to_world(self.shapes.on(self.numbers[curve], vertices))


def shapes_of(one):
    """What is remembered of a known character at poses."""
    stamp = one.rig.character, tuple(one.numbers.items())
    kept = _seen.get('shapes')
    if kept is None or kept.stamp[0] is not stamp[0] or kept.stamp[1] != stamp[1]:
        kept = _seen['shapes'] = Shapes(one.rig)
        kept.stamp = stamp
    return kept


def forget():
    """Nothing is remembered."""
    _seen.clear()


def frames_around(scene, pen):
    """The frames that arcs go through."""
    now = scene.frame_current
    return list(range(now - pen.arc_frames, now + pen.arc_frames + 1))


def ghost_frames(times, scene, pen):
    """[(frame, away)] of the ghosts, the nearest first: at keys, or every so many frames."""
    now, count = scene.frame_current, pen.ghost_count
    if pen.ghost_at == 'FRAMES':
        return [(now + side * n * pen.ghost_step, side * n) for n in range(1, count + 1) for side in (-1, 1)]
    keyed = times.moments.keyed()
    before, after = [f for f in keyed if f < now][::-1][:count], [f for f in keyed if f > now][:count]
    return [(f, -n - 1) for n, f in enumerate(before)] + [(f, n + 1) for n, f in enumerate(after)]


def arcs_of(times, scene, pen):
    """The arcs of all references, without those that stay where they are: of the middle, and of the ends where those travel farther."""
    frames, keyed, out = frames_around(scene, pen), set(times.moments.keyed()), []
    for curve in times.curves:
        found = [(f, line) for f, line in ((f, times.line(curve, f)) for f in frames) if line is not None]
        if len(found) < 2:
            continue
        ways = np.array([line[_told_of(line)] for _, line in found]).transpose(1, 0, 2)
        middle, *ends = (float(np.linalg.norm(np.diff(way, axis=0), axis=1).sum()) for way in ways)
        for way, travels in zip(ways, (True, *(end > middle for end in ends))):
            if travels and np.ptp(way, axis=0).max() > STILL * max(STILL, np.abs(way).max()):
                out.append(Arc(curve, [f for f, _ in found], way, [f in keyed for f, _ in found]))
    return out


def _told_of(line):
    return [len(line) // 2, 0, len(line) - 1]


def ghosts_of(times, scene, pen):
    """The ghosts, the farthest first."""
    out = []
    for frame, away in ghost_frames(times, scene, pen):
        vertices = times.vertices(frame)
        if vertices is not None:
            out.append(Ghost(frame, away, vertices, [(c, times.line(c, frame)) for c in times.curves]))
    return sorted(out, key=lambda ghost: -abs(ghost.away))


def hit(obj, place, seen, scene, pen):
    """What a pen touches at a place of the region: (px away, 'arc' or 'ghost', curve, frame), or None."""
    if not (pen.arcs or pen.ghosts):
        return None
    drawing.known(obj)
    times, found = Times(obj), []

    def px(points):
        return seen.places(seen.view.project(times.space.from_world(points)))
    for arc in arcs_of(times, scene, pen) if pen.arcs else ():
        near = np.linalg.norm(px(arc.points) - np.asarray(place), axis=1)
        i = int(np.argmin(near))
        found.append((near[i], 'arc', arc.curve, arc.frames[i]))
    for ghost in ghosts_of(times, scene, pen) if pen.ghosts else ():
        for curve, line in ghost.lines:
            near = distance(px(line), place)
            here = distance(px(times.space.to_world(times.shapes.curve(times.numbers[curve], times.now))), place)
            if here > max(APART_PX, near):
                found.append((near, 'ghost', curve, ghost.frame))
    found = [one for one in found if one[0] <= REACH_PX * max(1.0, bpy.context.preferences.system.ui_scale)]
    return min(found) if found else None
