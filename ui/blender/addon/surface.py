"""The meshes of a character as one surface, in the space of its first: as they are at rest, and as Blender shows them.

Where modifiers make other vertices (Mirror, Subdivision), the surface is what Blender shows, up to a size; of larger ones it is what goes
into those modifiers.
"""
import hashlib

import bpy
import numpy as np
from mathutils import Vector
from mathutils.bvhtree import BVHTree

from . import versions
from .character import bone_above, frame_of
from .controls import Refused
from .held import Held
from .space import Space

MOST_SHOWN = 60000  # vertices of a mesh: where modifiers make more, they are put aside
# Modifiers that leave the vertices what they are.
DEFORMING = ('ARMATURE', 'CAST', 'CORRECTIVE_SMOOTH', 'CURVE', 'DISPLACE', 'HOOK', 'LAPLACIANDEFORM', 'LATTICE', 'MESH_DEFORM',
             'SHRINKWRAP', 'SIMPLE_DEFORM', 'SMOOTH', 'LAPLACIANSMOOTH', 'SURFACE_DEFORM', 'WARP', 'WAVE')
# Those that change no place at all.
IDLE = ('DATA_TRANSFER', 'MESH_CACHE', 'NORMAL_EDIT', 'WEIGHTED_NORMAL', 'UV_PROJECT', 'UV_WARP', 'VERTEX_WEIGHT_EDIT', 'VERTEX_WEIGHT_MIX',
        'VERTEX_WEIGHT_PROXIMITY')


def making(obj):
    """The modifiers in force that make other vertices."""
    return [m for m in obj.modifiers if m.show_viewport and m.type not in DEFORMING and m.type not in IDLE]


def coordinates(points, count):
    """Of vertices or points of a key (n, 3), float32."""
    out = np.empty(3 * count, dtype=np.float32)
    points.foreach_get('co', out)
    return out.reshape(-1, 3)


def finite(array, what):
    """The array. Raises Refused where it is not finite."""
    if not np.isfinite(array).all():
        raise Refused('%s has a vertex that is not finite (NaN); mend or delete it' % what)
    return array


def corners_of(data):
    """The corners of a mesh's triangles (n, 3)."""
    data.calc_loop_triangles()
    out = np.empty(3 * len(data.loop_triangles), dtype=np.int32)
    data.loop_triangles.foreach_get('vertices', out)
    return out.reshape(-1, 3)


def _shown_mesh(obj):
    return obj.evaluated_get(bpy.context.evaluated_depsgraph_get()).data


def is_drawn_as_shown(obj, seen):
    """Whether a mesh is drawn on with the vertices that its modifiers make. `seen`: as it is evaluated."""
    return bool(making(obj)) and 0 < len(seen.data.vertices) <= MOST_SHOWN


class Part:
    """A mesh of the character. `shown`: whether its vertices are those that modifiers make; `first`, `count` of its vertices,
    `first_triangle`, `triangles` (n, 3) with the part's own numbers."""

    def __init__(self, obj, shown):
        self.held, self.shown, self.first, self.first_triangle = Held(obj), shown, 0, 0
        data = _shown_mesh(obj) if shown else obj.data
        self.count = len(data.vertices)
        self.triangles = corners_of(data)
        if obj.matrix_world.determinant() < 0:
            self.triangles = self.triangles[:, ::-1]
        self.topology = hashlib.sha256(np.ascontiguousarray(self.triangles).tobytes() + b'%d' % self.count).hexdigest()[:16]

    def object(self):
        """The object. Raises Refused."""
        obj = self.held.get()
        if obj is None:
            raise Refused('%s is gone; draw again' % self.held.name)
        return obj


class Surface:
    """Parts as one: `triangles` (n, 3), `count` of vertices, `space`, `rest` (n, 3), which is not finite where a part has none."""

    def __init__(self, objects):
        self._tree = None
        self.anchor = Held(frame_of(objects[0]))
        self.parts = [Part(o, is_drawn_as_shown(o, o.evaluated_get(bpy.context.evaluated_depsgraph_get()))) for o in objects]
        self.aside = [p.held for p in self.parts if not p.shown and making(p.object())]
        vertices = triangles = 0
        for part in self.parts:
            part.first, part.first_triangle = vertices, triangles
            vertices, triangles = vertices + part.count, triangles + len(part.triangles)
        self.count = vertices
        self.triangles = np.concatenate([p.triangles + p.first for p in self.parts])
        self.topology = hashlib.sha256(''.join(p.topology for p in self.parts).encode()).hexdigest()[:16]
        self.rest = np.concatenate([self._rest_of(p) for p in self.parts])

    @property
    def space(self):
        """Where the character lies now."""
        return Space(self.anchor.get().matrix_world)

    def of_part(self, obj, points, matrix=None):
        """Points (n, 3) of an object's own space, as the character has them. `matrix`: the object's, where it is another."""
        space = self.space
        if matrix is None and obj == self.anchor.get():
            return space.of_object(points)
        world = np.array(matrix or obj.matrix_world, dtype=np.float64)
        turn, place = np.array(space.turn, dtype=np.float64), np.array(space.place, dtype=np.float64)
        return np.asarray(points, dtype=np.float64) @ (turn.T @ world[:3, :3]).T + (world[:3, 3] - place) @ turn

    def _rest_of(self, part):
        obj = part.object()
        if part.shown:
            return self.look_at(part)
        keys = obj.data.shape_keys
        points = keys.reference_key.data if keys else obj.data.vertices
        out = finite(coordinates(points, part.count), obj.name)
        above = bone_above(obj)
        if above is None:
            return self.of_part(obj, out)
        armature, bone = above
        return self.of_part(obj, out, armature.matrix_world @ bone.bone.matrix_local @ bone.matrix.inverted() @
                            armature.matrix_world.inverted() @ obj.matrix_world)

    def look_at(self, part):
        """Where Blender shows the vertices of a part (n, 3); None where there are others now."""
        obj = part.object()
        seen = obj.evaluated_get(bpy.context.evaluated_depsgraph_get())
        if len(seen.data.vertices) != part.count:
            return None
        points = coordinates(seen.data.vertices, part.count)
        return self.of_part(obj, points, seen.matrix_world if obj != self.anchor.get() else None)

    def look(self):
        """Where Blender shows all vertices (n, 3), brought up to date; None where there are others now."""
        bpy.context.view_layer.update()
        out = [self.look_at(p) for p in self.parts]
        return None if any(one is None for one in out) else np.concatenate(out)

    def tree(self):
        """The surface at rest, to find what is near."""
        if self._tree is None:
            self._tree = BVHTree.FromPolygons([Vector(p) for p in self.rest], [tuple(t) for t in self.triangles.tolist()])
        return self._tree

    def part_of_triangle(self, triangle):
        """The part that a triangle lies on."""
        return next(p for p in reversed(self.parts) if p.first_triangle <= triangle)

    def part_of(self, obj):
        """The part that an object is, or None."""
        return next((p for p in self.parts if p.held.get() == obj), None)


def plain_normals(objects):
    """Leaves custom normals out while a pose changes much: before 4.1 they are most of an evaluation. What normals_back() wants."""
    corners = sum(len(o.data.loops) for o in objects if getattr(o.data, 'use_auto_smooth', False) and o.data.has_custom_normals)
    return [Held(o.data) for o in objects if versions.plain_normals(o.data, corners)]


def normals_back(kept):
    """Undoes plain_normals()."""
    for held in kept:
        mesh = held.get()
        versions.normals_back(mesh.name if mesh is not None else '')
