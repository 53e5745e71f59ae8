"""Curves and targets over everything in the viewport, and the line that is being drawn."""
import bpy
import gpu
import numpy as np
from gpu_extras.batch import batch_for_shader

from . import drawing, versions

COLORS = {'reference': (0.25, 0.75, 1.0, 1.0), 'constraint': (0.9, 0.9, 0.9, 1.0), 'target': (1.0, 0.6, 0.15, 1.0),
          'general': (0.6, 0.85, 0.35, 1.0), 'specific': (0.95, 0.85, 0.3, 1.0)}
EDGE = (0.05, 0.05, 0.05, 0.6)  # below each line, so that it is seen on bright skin too
WIDTH, CHOSEN_WIDTH = 2.5, 4.0
FAINT = 0.35  # of the opacity: a constraint that is not heeded

_handlers = []
_strokes = []  # each with kind, px and places()
_region = [0]  # the address of the one they are drawn in


def show_stroke(stroke, region=None, earlier=()):
    """The stroke that is being drawn in a region, or None. `earlier`: those of the same drawing before it."""
    _strokes[:] = [s for s in (*earlier, stroke) if s is not None]
    _region[0] = region.as_pointer() if region is not None else 0


def _shader():
    shader = versions.line_shader()
    shader.bind()
    shader.uniform_float('viewportSize', gpu.state.viewport_get()[2:])
    shader.uniform_bool('lineSmooth', [True])
    return shader


def _line(shader, points, color, width=WIDTH, opacity=1.0):
    batch = batch_for_shader(shader, 'LINE_STRIP', {'pos': np.ascontiguousarray(points, dtype=np.float32)})
    for wide, shade in ((width + 2, EDGE), (width, color)):
        shader.uniform_float('lineWidth', wide * bpy.context.preferences.system.pixel_size)
        shader.uniform_float('color', (*shade[:3], shade[3] * opacity))
        batch.draw(shader)


def _shown(context):
    from .pen import mesh_of
    obj = mesh_of(context)
    return obj if obj is not None and obj.type == 'MESH' and obj.get(drawing.store.PROPERTY) else None


def draw_curves():
    """What the object keeps: in space, over everything."""
    context = bpy.context
    obj = _shown(context)
    if obj is None or not context.space_data.overlay.show_overlays:
        return
    chosen = context.window_manager.penpose.curve
    shader = _shader()
    gpu.state.blend_set('ALPHA')
    gpu.state.depth_test_set('NONE')
    for curve, points in drawing.places(obj, context.evaluated_depsgraph_get()):
        width = CHOSEN_WIDTH if curve['id'] == chosen else WIDTH
        _line(shader, points, COLORS[curve['role']], width, FAINT if curve.get('off') else 1.0)
        if 'target' in curve:
            _line(shader, drawing.target_places(obj, curve), COLORS['target'], width)
    gpu.state.depth_test_set('LESS_EQUAL')
    gpu.state.blend_set('NONE')


def draw_stroke():
    """The line that is being drawn, in px."""
    if not _strokes or bpy.context.region.as_pointer() != _region[0]:
        return
    shader = _shader()
    gpu.state.blend_set('ALPHA')
    for stroke in _strokes:
        if len(stroke.px) > 1:
            places = stroke.places()
            _line(shader, np.column_stack([places, np.zeros(len(places))]), COLORS[stroke.kind])
    gpu.state.blend_set('NONE')


def register():
    _handlers.append(bpy.types.SpaceView3D.draw_handler_add(draw_curves, (), 'WINDOW', 'POST_VIEW'))
    _handlers.append(bpy.types.SpaceView3D.draw_handler_add(draw_stroke, (), 'WINDOW', 'POST_PIXEL'))


def unregister():
    while _handlers:
        bpy.types.SpaceView3D.draw_handler_remove(_handlers.pop(), 'WINDOW')
    show_stroke(None)
