"""Arcs and ghosts in the viewport: before now violet, after it cyan, the farther away the fainter."""
import bpy
import gpu
import numpy as np
from gpu_extras.batch import batch_for_shader

from . import arcs, drawing, lines, versions

BEFORE, AFTER, NOW = 0xc04bff, 0x19c8d8, 0xffffff
FADE = 0.6  # each ghost shows so much of the one before it
OPAQUE = 0.25  # of the nearest ghost's face, where it lies well apart from the face as it is now
HERE, APART = 0.002, 0.03  # of the size: where a ghost lies as the face does now, nothing is drawn
TICK, KEY = 4.0, 7.0  # px of a frame on an arc, and of one with a key
MOST_KEPT = 40
SETTLED_S, NEXT_S = 0.15, 0.02

_batches = {}
_waiting = {}  # what is done as soon as Blender has time, by name


def forget():
    """Nothing is remembered."""
    while _waiting:
        _, waiting = _waiting.popitem()
        if bpy.app.timers.is_registered(waiting):
            bpy.app.timers.unregister(waiting)
    _batches.clear()
    _Picture.obj, _Picture.times, _Picture.arcs, _Picture.ghosts = None, None, (), ()
    arcs.forget()


def color_of(away, opacity=1.0):
    """The colour of a moment that lies so far from now."""
    return lines.srgb(BEFORE if away < 0 else AFTER if away > 0 else NOW, opacity)


class _Picture:
    """What was drawn last: of which object, the arcs, and ghosts with the Times they are of."""
    obj, times, arcs, ghosts = None, None, (), ()


def draw(obj, scene, pen, drawing_now=False):
    """The arcs and ghosts of a character. `drawing_now`: while a stroke is drawn they stay as they are."""
    if not drawing_now or _Picture.obj != obj.name:
        try:
            times = arcs.Times(obj)
            _Picture.arcs = arcs.arcs_of(times, scene, pen) if pen.arcs else ()
            _Picture.ghosts = arcs.ghosts_of(times, scene, pen) if pen.ghosts else ()
        except LookupError:
            _read_soon(obj.name)
            return
        except (drawing.Refused, drawing.Error, ReferenceError):
            return
        if times.missing:
            _look_soon(times, scene.frame_current)
        settled = _Picture.times is not None and np.array_equal(_Picture.times.now, times.now)
        _Picture.obj, _Picture.times = obj.name, times
        if not settled and _Picture.ghosts:
            _soon(lines.redraw, SETTLED_S)
    else:
        settled = False
    for ghost in _Picture.ghosts:
        _draw_ghost(_Picture.times, ghost, settled)
    for arc in _Picture.arcs:
        _draw_arc(arc, scene.frame_current)


def _soon(do, seconds):
    """Does something once outside of drawing, where nothing may be read anew."""
    def now():
        _waiting.pop(do.__name__, None)
        do()
    if do.__name__ not in _waiting:
        _waiting[do.__name__] = now
        bpy.app.timers.register(now, first_interval=seconds)


def _read_soon(name):
    def read():
        obj = bpy.data.objects.get(name)
        try:
            if obj is not None:
                drawing.known(obj)
                lines.redraw()
        except (drawing.Refused, drawing.Error):
            pass
    _soon(read, 0.01)


def _look_soon(times, now):
    """Looks at one frame after the other, the nearest first, so that Blender answers meanwhile."""
    def look():
        from .overlay import is_drawing
        try:
            if not is_drawing():
                times.shapes.looked.look([min(times.missing, key=lambda frame: abs(frame - now))])
                lines.redraw()
        except (drawing.Refused, drawing.Error, ReferenceError):
            pass
    _soon(look, NEXT_S if times.shapes.looked.kept else SETTLED_S)


def _draw_ghost(times, ghost, settled):
    share = FADE ** (abs(ghost.away) - 1)
    batch = _face(times, ghost, OPAQUE * share, settled)
    if batch is not None:
        gpu.state.face_culling_set('BACK')
        batch.draw(versions.smooth_shader())
        gpu.state.face_culling_set('NONE')
    shader = lines.line_shader()
    for _, points in ghost.lines:
        lines.line(shader, points, color_of(ghost.away, share))


def _face(times, ghost, opaque, settled):
    """What of the face lies elsewhere then, as triangles; None where nothing does. Takes ms: it is made where the pose has settled."""
    name = id(ghost.vertices), times.now.tobytes(), ghost.away
    kept, batch = _batches.get(name, (None, None))
    if kept is ghost.vertices:
        return batch
    if settled:
        if len(_batches) >= MOST_KEPT:
            _batches.clear()
        there, here = ghost.vertices, times.here()
        away = np.linalg.norm(there - here, axis=1) / np.linalg.norm(np.ptp(here, axis=0))
        share = np.clip((away - HERE) / (APART - HERE), 0, 1)
        triangles = times.shapes.character.triangles
        triangles = triangles[(share[triangles] > 0).any(axis=1)]
        colors = np.empty((len(there), 4), dtype=np.float32)
        colors[:] = color_of(ghost.away)
        colors[:, 3] = opaque * share
        batch = batch_for_shader(
            versions.smooth_shader(), 'TRIS', {'pos': times.space.to_world(there).astype(np.float32), 'color': colors},
            indices=np.ascontiguousarray(triangles, dtype=np.int32)) if len(triangles) else None
        _batches[name] = ghost.vertices, batch
        return batch
    return None


def _draw_arc(arc, now):
    middle = arc.frames.index(now) if now in arc.frames else len(arc.frames) // 2
    shader = lines.line_shader()
    for part, away in ((slice(0, middle + 1), -1), (slice(middle, None), 1)):
        if len(arc.points[part]) > 1:
            lines.line(shader, arc.points[part], color_of(away), 2.0)
    shader = versions.flat_shader()
    shader.bind()
    for keyed, size in ((False, TICK), (True, KEY)):
        gpu.state.point_size_set(size * bpy.context.preferences.system.pixel_size)
        for away in (-1, 0, 1):
            points = [p for p, f, k in zip(arc.points, arc.frames, arc.keyed) if k == keyed and np.sign(f - now) == away]
            if points:
                shader.uniform_float('color', color_of(away))
                batch_for_shader(shader, 'POINTS', {'pos': np.array(points, dtype=np.float32)}).draw(shader)
