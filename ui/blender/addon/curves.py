"""The curves of a character: each kept on the mesh that most of its points lie on, and brought onto the surface of all meshes."""
import bpy
import numpy as np

from . import store, versions
from .character import frame_of, parts_of
from .held import Held
from .library import View
from .space import Space
from .surface import is_drawn_as_shown

_parts = {}  # by the uid of a mesh: the meshes of its character


class Curve(dict):
    """A curve as it is kept. `owner`: the object that keeps it, `topology`: of the triangles that it lies on."""

    def __init__(self, kept, owner, topology):
        super().__init__(kept)
        self.owner, self.topology = owner, topology


def forget_parts():
    """Characters are put together anew when they are asked for."""
    _parts.clear()


def parts(obj, anew=False):
    """The meshes of the character that a mesh is part of, those that are seen first, large before small."""
    known = [] if anew else [held.get() for held in _parts.get(versions.uid(obj), ())]
    if known and None not in known:
        return known
    found = parts_of(obj)
    holds = [Held(o) for o in found]
    for one in found:
        _parts[versions.uid(one)] = holds
    return found


def curves(obj):
    """All curves of the character that a mesh is part of. To change one: change()."""
    out = []
    for part in parts(obj) if obj is not None and obj.type == 'MESH' else ():
        kept = store.read(part)
        out += [Curve(c, part, c.get('topology', kept['topology'])) for c in kept['curves']]
    return sorted(out, key=lambda c: c['id'])


def texts(obj):
    """What the meshes keep, to see whether it changed."""
    return [(p.name, p.get(store.PROPERTY, '')) for p in parts(obj)]


def kept_all(obj):
    """What the meshes keep, for put_back_all()."""
    return [(Held(p), p.get(store.PROPERTY)) for p in parts(obj)]


def put_back_all(kept):
    """What kept_all() gave earlier."""
    for held, text in kept:
        if held.get() is not None:
            store.put_back(held.get(), text)


def change(obj, number, how):
    """Changes a kept curve by how(curve); None as what it returns takes the curve away. Whether there is one."""
    for part in parts(obj):
        kept = store.read(part)
        found = store.find(kept, number)
        if found is not None:
            if how(found) is None:
                kept['curves'].remove(found)
            store.write(part, kept)
            return True
    return False


def delete(obj, number=None):
    """Takes a curve away, or all of them; the pose stays."""
    for part in parts(obj):
        kept = store.read(part)
        kept['curves'] = [c for c in kept['curves'] if number is not None and c['id'] != number]
        store.write(part, kept)


def add(obj, surface, points, curve):
    """Keeps a new curve: `points` [(triangle of the surface, shares)]. Its id."""
    lies = [surface.part_of_triangle(t) for t, _ in points]
    owner = max(surface.parts, key=lie_count(lies))
    holder = owner.object()
    places = np.array([surface.rest[surface.triangles[t]].T @ s for t, s in points])
    number = 1 + max((c['id'] for c in curves(obj)), default=0)
    kept = store.read(holder)
    number = max(number, kept['next'])
    if 'target' in curve:
        curve = {**curve, 'target': _target_to_owner(surface, holder, curve['target'])}
    out = {'id': number, **curve, 'topology': owner.topology, **lying(owner, lies, points), 'rest': to_owner(surface, holder, places).tolist()}
    kept['topology'], kept['next'] = owner.topology, number + 1
    kept['curves'].append(out)
    store.write(holder, kept)
    return number


def _target_to_owner(surface, holder, target):
    if 'points' in target:
        return {'points': to_owner(surface, holder, target['points']).tolist()}
    return {**target, 'view': {k: list(v) if isinstance(v, tuple) else v for k, v in
                               vars(view_to_owner(surface, holder, target['view'])).items()}}


def lie_count(lies):
    """A key: how many points lie on a part."""
    return lambda part: sum(one is part for one in lies)


def lying(owner, lies, points):
    """Where points lie, as it is kept."""
    out = {'points': [[int(t - part.first_triangle), *map(float, s)] for part, (t, s) in zip(lies, points)]}
    others = {part.held.name: part.topology for part in lies if part is not owner}
    if others:
        out['on'] = ['' if part is owner else part.held.name for part in lies]
        out['topologies'] = others
    return out


def placed(surface, curve):
    """The points of a curve on the surface, [(triangle, shares)], and whether they were looked for anew: a pair. None for the points of a
    curve that lies off it."""
    out, other = [], False
    for i, (triangle, *shares) in enumerate(curve['points']):
        name = curve['on'][i] if 'on' in curve else ''
        part = next((p for p in surface.parts if p.object().name == name), None) if name else surface.part_of(curve.owner)
        if part is None:
            continue
        triangle = int(triangle)
        if part.topology != (curve['topologies'][name] if name else curve.topology) or triangle >= len(part.triangles):
            other = True
            break
        out.append((part.first_triangle + triangle, shares))
    if other:
        return store.found_again(surface, of_owner(surface, curve.owner, np.array(curve['rest']))), True
    return (out if len(out) > 1 or len(out) == len(curve['points']) else None), False


def _own_space(surface, owner):
    """The space of the object that keeps curves; None where it is the character's."""
    frame = frame_of(owner)
    return None if frame == surface.anchor.get() else Space(frame.matrix_world)


def of_owner(surface, owner, points):
    """Places (n, 3) as they are kept, as the character has them."""
    own = _own_space(surface, owner)
    return np.asarray(points, dtype=float) if own is None else surface.space.from_world(own.to_world(points))


def to_owner(surface, owner, points):
    """The way back."""
    own = _own_space(surface, owner)
    return np.asarray(points, dtype=float) if own is None else own.from_world(surface.space.to_world(points))


def view_between(view, a, b):
    """A view in the space a, as it is in b; None stands for the same."""
    if a is None or b is None:
        return view
    eye, look, above = b.from_world(a.to_world([view.eye, view.look_at, np.array(view.eye) + view.up]))
    return View(tuple(eye), tuple(look), tuple(above - eye), view.vertical_fov_degrees, view.width, view.height)


def view_of_owner(surface, owner, view):
    """A view as it is kept, as the character has it."""
    return view_between(view, _own_space(surface, owner), surface.space)


def view_to_owner(surface, owner, view):
    """The way back."""
    return view_between(view, surface.space if _own_space(surface, owner) is not None else None, _own_space(surface, owner))


# What the viewport shows.

def places(obj, depsgraph):
    """Where the curves of a character are as Blender shows it, in the world: [(curve, (n, 3))]. Changes nothing."""
    out, meshes = [], {}
    for curve in curves(obj):
        names = curve['on'] if 'on' in curve else [''] * len(curve['points'])
        points = np.zeros((len(names), 3))
        good = np.ones(len(names), dtype=bool)
        for name in set(names):
            owner = bpy.data.objects.get((name, None)) if name else curve.owner
            rows = [i for i, n in enumerate(names) if n == name]
            found = _shown_points(owner, [curve['points'][i] for i in rows], depsgraph, meshes) if owner is not None else None
            if found is None:
                good[rows] = False
            else:
                points[rows] = found
        if good.sum() > 1:
            out.append((curve, points[good]))
    return out


def _shown_points(obj, points, depsgraph, meshes):
    if obj.name not in meshes:
        seen = obj.evaluated_get(depsgraph)
        data = seen.data if is_drawn_as_shown(obj, seen) else obj.data
        # Of what subdivides, the vertices of the cage come first.
        meshes[obj.name] = None if len(seen.data.vertices) < len(data.vertices) else (data, seen)
        if meshes[obj.name] is not None:
            data.calc_loop_triangles()
    if meshes[obj.name] is None:
        return None
    data, seen = meshes[obj.name]
    triangles, vertices = data.loop_triangles, seen.data.vertices
    if max(int(p[0]) for p in points) >= len(triangles):
        return None
    flip = -1 if obj.matrix_world.determinant() < 0 else 1
    places = np.array([[tuple(vertices[v].co) for v in list(triangles[int(p[0])].vertices)[::flip]] for p in points])
    matrix = np.array(seen.matrix_world)
    return np.einsum('ij,ijk->ik', np.array(points)[:, 1:], places) @ matrix[:3, :3].T + matrix[:3, 3]


def target_places(obj, curve):
    """Where a target was drawn, in the world, as deep as the middle of its reference at rest (n, 3)."""
    target, space = curve['target'], Space(frame_of(getattr(curve, 'owner', obj)).matrix_world)
    if 'points' in target:
        return space.to_world(target['points'])
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
