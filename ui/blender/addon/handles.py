"""Handles of a new keyframe that are set by hand (free, aligned): as Blender has them, which keeps the way between its neighbours."""
import numpy as np
from mathutils import Vector

ALONE = Vector((1, 0))  # frames to either side of a key without neighbours
BY_HAND = ('FREE', 'ALIGNED')


def way_through(curve, frame):
    """The four points (4, 2) of the part of a curve that a frame lies within, before a key is there; None at an end and where it is no
    Bezier curve."""
    points = curve.keyframe_points if curve is not None else ()
    after = next((i for i, point in enumerate(points) if point.co.x > frame), 0)
    if after == 0 or points[after - 1].interpolation != 'BEZIER':
        return None
    before, behind = points[after - 1], points[after]
    return np.array([before.co, before.handle_right, behind.handle_left, behind.co], dtype=float)


def set_handles(point, way):
    """Gives a key its handles. `way`: what way_through() gave."""
    if way is None:
        point.handle_left, point.handle_right = point.co - ALONE, point.co + ALONE
        return
    low, high = 0.0, 1.0
    for _ in range(60):
        share = 0.5 * (low + high)
        left, here, right = _split(way, share)
        low, high = (share, high) if here[0] < point.co.x else (low, share)
    up = (0, point.co.y - here[1])
    point.handle_left, point.handle_right = Vector(left + up), Vector(right + up)


def _split(way, share):
    """The handles and the point of the curve at a share of its parameter (de Casteljau)."""
    a, b, c = way[:-1] + share * np.diff(way, axis=0)
    left, right = a + share * (b - a), b + share * (c - b)
    return left, left + share * (right - left), right
