"""Curves and targets over everything in the viewport, and the line that is being drawn."""
import bpy
import numpy as np
from gpu_extras.batch import batch_for_shader

from . import drawing, versions

COLORS = {'reference': (0.25, 0.75, 1.0, 1.0), 'constraint': (0.75, 0.75, 0.75, 1.0), 'target': (1.0, 0.6, 0.15, 1.0)}
WIDTH = 2.5

_handlers = []
_stroke = [None]


def show_stroke(stroke):
    """The stroke that is being drawn, or None."""
    _stroke[0] = stroke


def _line(shader, points, color, width):
    import gpu
    gpu.state.line_width_set(width * bpy.context.preferences.system.pixel_size)
    batch = batch_for_shader(shader, 'LINE_STRIP', {'pos': np.ascontiguousarray(points, dtype=np.float32)})
    shader.uniform_float('color', color)
    batch.draw(shader)


def _shown(context):
    from .pen import mesh_of
    obj = mesh_of(context)
    return obj if obj is not None and obj.type == 'MESH' and obj.get(drawing.store.PROPERTY) else None


def draw_curves():
    """What the object keeps: in space, over everything."""
    import gpu
    context = bpy.context
    obj = _shown(context)
    if obj is None or not context.space_data.overlay.show_overlays:
        return
    shader = versions.color_shader()
    shader.bind()
    gpu.state.blend_set('ALPHA')
    gpu.state.depth_test_set('NONE')
    for curve, points in drawing.places(obj, context.evaluated_depsgraph_get()):
        _line(shader, points, COLORS[curve['role']], WIDTH)
        if 'target' in curve:
            _line(shader, drawing.target_places(obj, curve), COLORS['target'], WIDTH)
    gpu.state.line_width_set(1)
    gpu.state.depth_test_set('LESS_EQUAL')
    gpu.state.blend_set('NONE')


def draw_stroke():
    """The line that is being drawn, in px."""
    import gpu
    stroke = _stroke[0]
    if stroke is None or len(stroke.px) < 2:
        return
    shader = versions.color_shader()
    shader.bind()
    gpu.state.blend_set('ALPHA')
    places = stroke.places()
    _line(shader, np.column_stack([places, np.zeros(len(places))]), COLORS[stroke.kind], WIDTH)
    gpu.state.line_width_set(1)
    gpu.state.blend_set('NONE')


def register():
    _handlers.append(bpy.types.SpaceView3D.draw_handler_add(draw_curves, (), 'WINDOW', 'POST_VIEW'))
    _handlers.append(bpy.types.SpaceView3D.draw_handler_add(draw_stroke, (), 'WINDOW', 'POST_PIXEL'))


def unregister():
    while _handlers:
        bpy.types.SpaceView3D.draw_handler_remove(_handlers.pop(), 'WINDOW')
    _stroke[0] = None
