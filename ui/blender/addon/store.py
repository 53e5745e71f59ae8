"""The curves of an object, kept on it: in a custom property, so that saving, undo, copying and appending keep them.

A curve is {"id", "role": "reference" or "constraint", "points": [[triangle, a, b, c], ...] on the mesh's triangles, "rest": where those
are at rest, and of a reference that has its target "target": {"view": ..., "px": [[x, y], ...], "pressure": [...]}}.
"""
import json

import numpy as np
from mathutils import Vector
from mathutils.bvhtree import BVHTree

PROPERTY = 'penpose'
FORMAT = 1
NEAR = 0.02  # of the mesh's size: farther from the new surface a curve is retired


def read(obj):
    """The curves of an object and the topology they lie on."""
    text = obj.get(PROPERTY)
    if not isinstance(text, str):
        return {'format': FORMAT, 'topology': '', 'next': 1, 'curves': []}
    try:
        kept = json.loads(text)
        if kept['format'] != FORMAT or not isinstance(kept['curves'], list):
            raise ValueError('another format')
        return kept
    except (ValueError, KeyError, TypeError):
        return {'format': FORMAT, 'topology': '', 'next': 1, 'curves': []}


def write(obj, kept):
    """Keeps them; without curves nothing stays on the object."""
    if kept['curves']:
        obj[PROPERTY] = json.dumps(kept, separators=(',', ':'))
    elif PROPERTY in obj:
        del obj[PROPERTY]


def find(kept, number):
    """The curve of that id, or None."""
    return next((c for c in kept['curves'] if c['id'] == number), None)


def places_of(curve, triangles, positions):
    """Where the points of a curve are (n, 3) at these positions of the vertices."""
    points = np.array(curve['points'])
    corners = positions[triangles[points[:, 0].astype(int)]]
    return np.einsum('ij,ijk->ik', points[:, 1:], corners)


def found_again(kept, mesh):
    """Moves curves to a mesh whose topology changed; the ids of those that lie on it no more, which are taken out."""
    if kept['topology'] == mesh.topology or not kept['curves']:
        kept['topology'] = mesh.topology
        return []
    tree = BVHTree.FromPolygons([Vector(p) for p in mesh.rest], [tuple(t) for t in mesh.triangles.tolist()])
    size = float(np.linalg.norm(mesh.rest.max(axis=0) - mesh.rest.min(axis=0)))
    retired = []
    for curve in list(kept['curves']):
        points = []
        for place in curve['rest']:
            at, _, triangle, distance = tree.find_nearest(Vector(place))
            if at is None or distance > NEAR * size:
                break
            points.append([triangle, *shares_of(mesh.rest[mesh.triangles[triangle]], np.array(at))])
        if len(points) == len(curve['rest']):
            curve['points'] = points
        else:
            retired.append(curve['id'])
            kept['curves'].remove(curve)
    kept['topology'] = mesh.topology
    return retired


def shares_of(corners, place):
    """The shares of three corners in a place on their triangle; 0..1, with sum 1."""
    a, b, c = corners
    matrix = np.stack([b - a, c - a], axis=1)
    (v, w), *_ = np.linalg.lstsq(matrix, place - a, rcond=None)
    shares = np.clip([1 - v - w, v, w], 0, 1)
    return (shares / shares.sum()).tolist()
