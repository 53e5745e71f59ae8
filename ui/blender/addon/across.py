"""A curve and its target on the other side of a character: across the X of its first mesh."""
import numpy as np

from . import curves, store
from .controls import Refused
from .library import View


def _flip(surface, points):
    """Places (n, 3) of the character on the other side."""
    first = surface.anchor.get().matrix_world
    space = surface.space
    own = np.array(first.inverted(), dtype=float)
    world = space.to_world(points)
    local = world @ own[:3, :3].T + own[:3, 3]
    local[:, 0] *= -1
    back = np.array(first, dtype=float)
    return space.from_world(local @ back[:3, :3].T + back[:3, 3])


def flipped_view(surface, view, px):
    """A view, and px (n, 2) in it, on the other side."""
    eye, look, above = _flip(surface, np.array([view.eye, view.look_at, np.array(view.eye) + view.up]))
    px = np.array(px, dtype=float)
    px[:, 0] = view.width - px[:, 0]
    return View(tuple(eye), tuple(look), tuple(above - eye), view.vertical_fov_degrees, view.width, view.height), px


def flipped(surface, curve):
    """What is kept of a curve on the other side: where it lies, and its target. Raises Refused where nothing of the mesh lies there."""
    owner = curve.owner
    points = store.found_again(surface, _flip(surface, curves.of_owner(surface, owner, curve['rest'])))
    if points is None:
        raise Refused('nothing of %s lies on the other side of curve %d; draw it there' % (owner.name, curve['id']))
    made = {'role': curve['role']}
    target = curve.get('target')
    if target is None:
        return points, made
    if 'points' in target:
        made['target'] = {'points': _flip(surface, curves.of_owner(surface, owner, target['points']))}
        return points, made
    view, px = flipped_view(surface, curves.view_of_owner(surface, owner, View(**target['view'])), target['px'])
    made['target'] = {'view': view, 'px': px.tolist(), 'pressure': target['pressure']}
    return points, made
