"""A drawn target is pulled afterwards: it moves along with the pen, and the face follows."""
import numpy as np

from . import curves, drawing
from .library import View
from .space import Seen

REACH_PX = 8.0  # so near to its line, px of an ordinary display, is on it


def hit(obj, place, seen, scale=1.0):
    """The drawn target that lies below a place of the region: (px away, id), or None."""
    best = None
    for curve in curves.curves(obj):
        if 'px' not in curve.get('target', ()):
            continue
        line = _line(obj, curve, seen)
        away = distance(line, place) if line is not None else np.inf
        if away <= REACH_PX * scale and (best is None or away < best[0]):
            best = away, curve['id']
    return best


def _line(obj, curve, seen):
    """A target as a view shows it, px of the region (n, 2); None where it lies behind."""
    space = drawing.known(obj, measured=False).rig.space()
    try:
        return seen.places(seen.view.project(space.from_world(drawing.target_places(obj, curve))))
    except drawing.Error:
        return None


def distance(line, place):
    """How far a place lies from a line, px."""
    place = np.asarray(place, dtype=float)
    a, along = line[:-1], np.diff(line, axis=0)
    share = np.einsum('ij,ij->i', place - a, along) / np.maximum(1e-12, (along ** 2).sum(axis=1))
    return float(np.linalg.norm(a + np.clip(share, 0, 1)[:, None] * along - place, axis=1).min()) if len(line) > 1 else np.inf


class Pull(drawing.Stroke):
    """The stroke that a target is drawn anew by, in the view that it was drawn in, moved as the pen moves in the view of now."""

    def __init__(self, obj, curve, seen):
        target = next(c for c in curves.curves(obj) if c['id'] == curve)
        self.pulled_in, self.grabbed, self.pulls = seen, None, curve
        self.line = drawing.target_places(obj, target)
        view = curves.view_of_owner(drawing.known(obj).rig.surface, target.owner, View(**target['target']['view']))
        super().__init__(obj, 'target', Seen(view, (0, 0)), curve)
        self.weight = target['target']['pressure']
        self.space = self.rig.mesh.space
        self.moved = self.line

    def add(self, place, pressure=1.0):
        """A place of the region where the pen is now."""
        here = np.asarray(place, dtype=float)
        if not np.isfinite(here).all():
            return
        self.grabbed = here if self.grabbed is None else self.grabbed
        self.moved = self.line + self._shift(here - self.grabbed)
        self.px = list(self.seen.view.project(self.space.from_world(self.moved)))
        self.pressure = self.weight or [1.0] * len(self.px)

    def _shift(self, px):
        """So many px of the region, as far away as the line is, in the world."""
        view = self.pulled_in.view
        eye, look = np.array(view.eye), np.array(view.look_at)
        forward = (look - eye) / np.linalg.norm(look - eye)
        side = np.cross(forward, np.array(view.up))
        side /= np.linalg.norm(side)
        depth = float((self.space.from_world(self.line).mean(axis=0) - eye) @ forward)
        scale = depth * np.tan(np.radians(0.5 * view.vertical_fov_degrees)) / (0.5 * view.height)
        shift = scale * (px[0] * side + px[1] * np.cross(side, forward))
        return self.space.to_world([shift, (0, 0, 0)])[0] - self.space.to_world([(0, 0, 0)])[0]

    def places(self):
        """The line as the view of now shows it, px of the region."""
        return self.pulled_in.places(self.pulled_in.view.project(self.space.from_world(self.moved)))
