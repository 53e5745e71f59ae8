"""Curves and targets over everything in the viewport, and the line that is being drawn."""
import bpy
import gpu
import numpy as np

from . import curves, drawing, hint, lines, over_time

FAINT = 0.35  # of the opacity: a constraint that is not heeded

_handlers = []
_strokes = []  # each with kind, px and places()
_region = [0]  # the address of the one they are drawn in


def show_stroke(stroke, region=None, earlier=()):
    """The stroke that is being drawn in a region, or None. `earlier`: those of the same drawing before it."""
    _strokes[:] = [s for s in (*earlier, stroke) if s is not None]
    _region[0] = region.as_pointer() if region is not None else 0


def is_drawing():
    """Whether a stroke is being drawn."""
    return bool(_strokes)


def _shown(context):
    from .pen import mesh_of
    obj = mesh_of(context)
    return obj if obj is not None and context.space_data.overlay.show_overlays and curves.curves(obj) else None


def draw_curves():
    """What the object keeps: in space, over everything."""
    context = bpy.context
    obj = _shown(context)
    if obj is None:
        return
    pen = context.window_manager.penpose
    gpu.state.blend_set('ALPHA')
    gpu.state.depth_test_set('NONE')
    if (pen.arcs or pen.ghosts) and not context.screen.is_animation_playing:
        over_time.draw(obj, context.scene, pen, is_drawing())
    shader, pulled = lines.line_shader(), [getattr(stroke, 'pulls', 0) for stroke in _strokes]
    for curve, points in drawing.places(obj, context.evaluated_depsgraph_get()):
        width = lines.CHOSEN_WIDTH if curve['id'] == pen.curve else lines.WIDTH
        lines.line(shader, points, lines.COLORS[curve['role']], width, FAINT if curve.get('off') else 1.0)
        if 'target' in curve and curve['id'] not in pulled:
            lines.line(shader, drawing.target_places(obj, curve), lines.SHOULD_BE, width)
    gpu.state.depth_test_set('LESS_EQUAL')
    gpu.state.blend_set('NONE')


def _flat(places):
    return np.column_stack([places, np.zeros(len(places))])


def draw_stroke():
    """The line that is being drawn, in px, and what of another frame follows it."""
    if bpy.context.region is None:
        return
    hint.draw(bpy.context)
    if not _strokes or bpy.context.region.as_pointer() != _region[0]:
        return
    shader = lines.line_shader()
    gpu.state.blend_set('ALPHA')
    for stroke in _strokes:
        if len(stroke.px) > 1:
            if hasattr(stroke, 'line_of_frame'):
                lines.line(shader, _flat(stroke.line_of_frame()), over_time.color_of(stroke.frame - bpy.context.scene.frame_current))
            lines.line(shader, _flat(stroke.places()), lines.COLORS[stroke.kind])
    gpu.state.blend_set('NONE')


def register():
    _handlers.append(bpy.types.SpaceView3D.draw_handler_add(draw_curves, (), 'WINDOW', 'POST_VIEW'))
    _handlers.append(bpy.types.SpaceView3D.draw_handler_add(draw_stroke, (), 'WINDOW', 'POST_PIXEL'))


def unregister():
    while _handlers:
        bpy.types.SpaceView3D.draw_handler_remove(_handlers.pop(), 'WINDOW')
    show_stroke(None)
    over_time.forget()


def forget():
    """Nothing of an object is remembered."""
    over_time.forget()
