"""A reading brought to its lines: the bones that are meant go where the lines say in all of their ways.

The solver counts each channel of a measured bone as a control of its own and takes as few as it can; to an animator the three ways of
a handle, or the three angles of a bone, are one. Least squares in the picture, with the cost that core/intent has for shares of ranges
(docs/posing.md), by Gauss and Newton."""
import numpy as np

from .bones import BoneAngle, Channel

DOUBT = 2.2e-3  # of the height of a view: the width of a hand's doubt
LOOKS = 7  # independent looks at a curve, and the cost of squares of shares of ranges
RAY = 0.02  # as strongly as across the line a point is held where it is along the ray, as core/intent has it
PART = 0.85  # of the curve: a shorter line is one of a part of it
SLIDES = 0.015  # of a line's length: how far a hand slides along it
TURN = 0.25  # radians that a bone goes at once: farther off what was measured says little
STEPS = 12
SAMPLES = 40  # of a drawn line


class Aim:
    """A curve and where it should be: a drawn line (view and px), or points in the character's space."""

    def __init__(self, curve, view=None, px=None, points=None):
        self.curve, self.view, self.points = curve, view, points
        self.px = None if px is None else _resampled(np.asarray(px, dtype=float))


def _resampled(line):
    along = np.r_[0, np.cumsum(np.linalg.norm(np.diff(line, axis=0), axis=1))]
    at = np.linspace(0, along[-1], SAMPLES)
    return np.column_stack([np.interp(at, along, line[:, i]) for i in (0, 1)])


def siblings(found, moved):
    """Those of what was measured (measure.Measured) that moved, and the other places, or angles, of the same bones and objects."""
    own = {id(control) for control in moved}
    owners = {(one.candidate.owner, _kind(one.candidate.control)) for one in found if id(one.control) in own} - {None}
    return [one for one in found if id(one.control) in own or
            _kind(one.candidate.control) is not None and (one.candidate.owner, _kind(one.candidate.control)) in owners]


def _kind(control):
    if isinstance(control, BoneAngle):
        return 'angle'
    return control.path if isinstance(control, Channel) and control.path != 'scale' else None


def _nearest(points, line):
    """For each point the piece of a polyline that is nearest, and the share along it: (pieces, shares)."""
    a, along = line[:-1], np.diff(line, axis=0)
    share = np.einsum('pij,ij->pi', points[:, None] - a, along) / np.maximum(1e-12, (along ** 2).sum(axis=1))
    share = np.clip(share, 0, 1)
    off = np.linalg.norm(points[:, None] - (a + share[..., None] * along), axis=2)
    piece = off.argmin(axis=1)
    return piece, share[np.arange(len(points)), piece]


class _Term:
    """What one aim asks of the changes: weighted residuals and how they change."""

    def __init__(self, aim, rig, number, ways):
        self.aim = aim
        triangles, shares = rig.character.points(number)
        corners = rig.surface.triangles[triangles]
        self.places = rig.character.positions(number)
        self.ways = [np.einsum('pc,pci->pi', shares, _dense(way, rig.surface.count)[corners]) for way in ways]

    def rows(self, amounts):
        """(residuals, their change with each amount)."""
        places = self.places + sum((a * w for a, w in zip(amounts, self.ways)), np.zeros_like(self.places))
        if self.aim.points is not None:
            size = max(1e-12, float(np.linalg.norm(np.ptp(places, axis=0))))
            scale = np.sqrt(LOOKS / len(places)) / (DOUBT * size)
            return scale * (places - self.aim.points).ravel(), scale * np.array([w.ravel() for w in self.ways]).T
        view, step = self.aim.view, 1e-5 * max(1e-12, float(np.linalg.norm(np.ptp(places, axis=0))))
        px = view.project(places)
        moved = [(view.project(places + step * _unit(w)) - px) / step * _length(w) for w in self.ways]
        residual, change = self._across(px, moved, DOUBT * view.height)
        # A line says almost nothing of depth.
        rays = self.places - view.eye
        depth = np.linalg.norm(rays, axis=1)
        px_of = 0.5 * view.height / np.tan(np.radians(0.5 * view.vertical_fov_degrees)) / depth
        weight = RAY * np.sqrt(LOOKS / len(rays)) / (DOUBT * view.height) * px_of / depth
        deep = np.array([weight * (w * rays).sum(axis=1) for w in self.ways]).T
        return np.r_[residual, deep @ amounts], np.vstack([change, deep])

    def _across(self, px, moved, sigma):
        residual, change = _pulled(self.aim.px, px, moved)
        part = _long(self.aim.px) < PART * _long(px)
        back, more = _pushed(px, self.aim.px, moved, part)
        weight = np.sqrt(0.5 * LOOKS) / sigma
        residual, change = weight * np.r_[residual, back], weight * np.vstack([change, more])
        if not part:
            slid, slides = _slid(self.aim.px, px, moved)
            residual, change = np.r_[residual, slid], np.vstack([change, slides])
        return residual, change


def _long(line):
    return float(np.linalg.norm(np.diff(line, axis=0), axis=1).sum())


def _pulled(line, px, moved):
    """From each place of a line to the curve: (residuals, their changes). Beyond the curve's ends all of the way counts, else that across."""
    piece, share = _nearest(line, px)
    off = px[piece] + share[:, None] * (px[piece + 1] - px[piece]) - line
    changes = [m[piece] + share[:, None] * (m[piece + 1] - m[piece]) for m in moved]
    return _weighed(off, changes, _normals(px)[piece], _ends(piece, share, px), None)


def _pushed(px, line, moved, part):
    """From each point of the curve to the line. `part`: what lies beyond its ends is not drawn."""
    piece, share = _nearest(px, line)
    off = px - line[piece] - share[:, None] * (line[piece + 1] - line[piece])
    end = _ends(piece, share, line)
    return _weighed(off, moved, _normals(line)[piece], end, end if part else None)


def _slid(line, px, moved):
    """How far points of the curve lie along the line from where their share of the length is, as shares of what a hand slides."""
    along = np.r_[0, np.cumsum(np.linalg.norm(np.diff(px, axis=0), axis=1))]
    if np.linalg.norm(line[0] - px[0]) + np.linalg.norm(line[-1] - px[-1]) > np.linalg.norm(line[0] - px[-1]) + np.linalg.norm(line[-1] - px[0]):
        line = line[::-1]
    at = along / max(along[-1], 1e-12) * (len(line) - 1)
    there = np.column_stack([np.interp(at, range(len(line)), line[:, i]) for i in (0, 1)])
    piece = np.minimum(at.astype(int), len(line) - 2)
    tangent = np.diff(line, axis=0)[piece]
    tangent /= np.maximum(1e-12, np.linalg.norm(tangent, axis=1))[:, None]
    scale = len(px) ** -0.5 / (SLIDES * _long(line))
    return scale * ((px - there) * tangent).sum(axis=1), scale * np.array([(m * tangent).sum(axis=1) for m in moved]).T


def _ends(piece, share, line):
    return (piece == 0) & (share == 0) | (piece == len(line) - 2) & (share == 1)


def _weighed(off, changes, normal, end, left_out):
    scale = len(off) ** -0.5
    counts = np.ones(len(off)) if left_out is None else 1.0 * ~left_out

    def rows(way):
        across = (way * normal).sum(axis=1)
        return scale * np.r_[counts * np.where(end, way[:, 0], across), counts * np.where(end, way[:, 1], 0.0)]
    return rows(off), np.array([rows(c) for c in changes]).T


def _dense(way, count):
    out = np.zeros((count, 3))
    way.add_to(out, 1.0)
    return out


def _length(way):
    return float(np.linalg.norm(way, axis=1).max()) or 1.0


def _unit(way):
    return way / _length(way)


def _normals(line):
    along = np.diff(line, axis=0)
    return np.column_stack([-along[:, 1], along[:, 0]]) / np.maximum(1e-12, np.linalg.norm(along, axis=1))[:, None]


def finish(rig, numbers, aims, meant):
    """The pose of the character that brings the curves to their aims by what is meant (siblings()), near the pose that it has."""
    pose = rig.character.pose
    where = [next(n for control, n, _ in rig.parts if control is one.control) for one in meant]
    now = np.array([pose[n[0]] - (pose[n[1]] if len(n) > 1 else 0.0) for n in where])
    least = np.array([rig.least[n[0]] if len(n) == 1 else -rig.most[n[1]] for n in where])
    most = np.array([rig.most[n[0]] for n in where])
    scale = 1.0 / np.maximum(1e-12, most - least)
    amounts = np.zeros(len(meant))
    terms = []
    for aim in aims:
        if aim.curve in numbers:
            terms.append(_Term(aim, rig, numbers[aim.curve], [one.up if now[i] >= 0 else one.down for i, one in enumerate(meant)]))
    for _ in range(STEPS if terms else 0):
        rows = [term.rows(amounts) for term in terms]
        residual, change = np.concatenate([r for r, _ in rows]), np.concatenate([c for _, c in rows])
        pull = np.diag(LOOKS * scale ** 2)
        step = np.linalg.solve(change.T @ change + pull, -change.T @ residual - pull @ (now + amounts))
        before = amounts
        amounts = np.clip(now + amounts + step, least, most) - now
        if np.abs((amounts - before) * scale).max() < 1e-6:
            break
    far = max([abs(a) for a, one in zip(amounts, meant) if isinstance(one.candidate.control, BoneAngle)], default=0.0)
    amounts *= min(1.0, TURN / max(far, 1e-12))
    for n, value in zip(where, now + amounts):
        pose[n[0]] = value if len(n) == 1 else max(0.0, value)
        if len(n) > 1:
            pose[n[1]] = max(0.0, -value)
    return np.clip(pose, rig.least, rig.most)


def farthest(rig, numbers, aims):
    """How far curves and their drawn lines lie apart where the character has them, in widths of doubt; 0 without any."""
    out = 0.0
    for aim in aims:
        if aim.curve in numbers and aim.px is not None:
            px = aim.view.project(rig.character.positions(numbers[aim.curve]))
            apart = [_apart(aim.px, px)]
            if _long(aim.px) >= PART * _long(px):
                apart.append(_apart(px, aim.px))
            out = max(out, max(apart) / (DOUBT * aim.view.height))
    return out


def _apart(points, line):
    piece, share = _nearest(points, line)
    return float(np.linalg.norm(line[piece] + share[:, None] * (line[piece + 1] - line[piece]) - points, axis=1).max())
