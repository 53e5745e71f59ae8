"""The curves of an object, kept on it: in a custom property, so that saving, undo, copying and appending keep them.

A curve is {"id", "role": "reference" or "constraint", "points": [[triangle, a, b, c], ...] on the mesh's triangles, "rest": where those
are at rest, and of a reference that has its target "target": {"view": ..., "px": [[x, y], ...], "pressure": [...]},
drawn, or {"points": [[x, y, z], ...]}, placed. Where a curve goes over several parts of a character, the object of most of its points
keeps it, "on" has for each point the name of another object or "", and "topologies" those of the others. Places and views are in the
space of the object that keeps it (character.frame_of()).
"""
import json

import bpy
import numpy as np
from mathutils import Vector

from .library import View

PROPERTY = 'penpose'
FORMAT = 1
NEAR = 0.02  # of the mesh's size: farther from the new surface a curve is retired


def _checked(kept):
    """Curves as they were read. Raises ValueError where they are not as they are written."""
    kinds = [('curves', list), ('topology', str), ('next', int)]
    if kept['format'] != FORMAT or not all(isinstance(kept[name], kind) for name, kind in kinds):
        raise ValueError('another format')
    for curve in kept['curves']:
        points, rest = np.array(curve['points'], dtype=float), np.array(curve['rest'], dtype=float)
        if not isinstance(curve['id'], int) or curve['role'] not in ('reference', 'constraint'):
            raise ValueError('a curve without its role')
        if points.ndim != 2 or points.shape[1] != 4 or rest.shape != (len(points), 3) or points[:, 0].min() < 0:
            raise ValueError('a curve without its points')
        if 'on' in curve and not (len(curve['on']) == len(points) and set(curve['on']) <= {'', *curve['topologies']}):
            raise ValueError('a curve whose points lie on unknown parts')
        target = curve.get('target')
        if target is None:
            continue
        if 'points' in target:
            if np.array(target['points'], dtype=float).shape != rest.shape:
                raise ValueError('a target without its points')
            continue
        px = np.array(target['px'], dtype=float)
        if px.ndim != 2 or px.shape[1] != 2 or len(target['pressure']) not in (0, len(px)) or not np.isfinite(px).all():
            raise ValueError('a target without its line')
        View(**target['view'])
    return kept


def _read(obj):
    """The curves of an object, and why they cannot be read: a pair, with one of them None."""
    text = obj.get(PROPERTY)
    if text is None:
        return {'format': FORMAT, 'topology': '', 'next': 1, 'curves': []}, None
    try:
        return _checked(json.loads(text)), None
    except (ValueError, KeyError, TypeError, IndexError, AttributeError) as problem:
        return None, '%s: %s' % (type(problem).__name__, problem)


def read(obj):
    """The curves of an object and the topology they lie on; none where they cannot be read (problem() says why)."""
    return _read(obj)[0] or {'format': FORMAT, 'topology': '', 'next': 1, 'curves': []}


def problem(obj):
    """Why the curves that an object keeps cannot be read, with the remedy; an empty text where they can."""
    why = _read(obj)[1]
    return '' if why is None else 'the curves kept on %s are damaged (%s); mend its custom property "%s", or delete all of its curves' % (
        obj.name, why, PROPERTY)


def write(obj, kept):
    """Keeps them; without curves nothing stays on the object."""
    if kept['curves']:
        obj[PROPERTY] = json.dumps(kept, separators=(',', ':'))
    elif PROPERTY in obj:
        del obj[PROPERTY]
    _keep_beside(obj)


def _keep_beside(obj):
    """Blender does not save a property that is new on a library override: the scene keeps a copy."""
    if obj.override_library is None:
        return
    beside = PROPERTY + ' ' + obj.name
    if PROPERTY in obj:
        bpy.context.scene[beside] = obj[PROPERTY]
    elif beside in bpy.context.scene:
        del bpy.context.scene[beside]


def bring_back():
    """Gives library overrides, as a file is opened, the curves that scenes keep for them."""
    for scene in bpy.data.scenes:
        for name in [n for n in scene.keys() if n.startswith(PROPERTY + ' ')]:
            for obj in scene.objects:  # the linked one may have the same name
                if PROPERTY + ' ' + obj.name == name and obj.override_library is not None and PROPERTY not in obj:
                    obj[PROPERTY] = scene[name]


def put_back(obj, text):
    """What get(PROPERTY) gave earlier."""
    if text is not None:
        obj[PROPERTY] = text
    elif PROPERTY in obj:
        del obj[PROPERTY]
    _keep_beside(obj)


def find(kept, number):
    """The curve of that id, or None."""
    return next((c for c in kept['curves'] if c['id'] == number), None)


def places_of(curve, triangles, positions):
    """Where the points of a curve are (n, 3) at these positions of the vertices."""
    points = np.array(curve['points'])
    corners = positions[triangles[points[:, 0].astype(int)]]
    return np.einsum('ij,ijk->ik', points[:, 1:], corners)


def found_again(surface, rest):
    """Points of the surface as it is now that lie where a curve was at rest (n, 3): [(triangle, shares)]; None where one lies off."""
    tree = surface.tree()
    size = float(np.linalg.norm(surface.rest.max(axis=0) - surface.rest.min(axis=0)))
    out = []
    for place in rest:
        at, _, triangle, distance = tree.find_nearest(Vector(place))
        if at is None or distance > NEAR * size:
            return None
        out.append((triangle, shares_of(surface.rest[surface.triangles[triangle]], np.array(at))))
    return out


def shares_of(corners, place):
    """The shares of three corners in a place on their triangle; 0..1, with sum 1."""
    a, b, c = corners
    matrix = np.stack([b - a, c - a], axis=1)
    (v, w), *_ = np.linalg.lstsq(matrix, place - a, rcond=None)
    shares = np.clip([1 - v - w, v, w], 0, 1)
    return (shares / shares.sum()).tolist()
