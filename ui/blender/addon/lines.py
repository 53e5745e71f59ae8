"""Lines of the viewport, in the colours that they have everywhere in penpose."""
import bpy
import gpu
import numpy as np
from gpu_extras.batch import batch_for_shader

from . import versions


def srgb(number, opacity=1.0):
    """A colour as it is written in the window's code."""
    return (number >> 16 & 255) / 255, (number >> 8 & 255) / 255, (number & 255) / 255, opacity


# As everywhere in penpose: where it is, where it should be, what stays.
IS, SHOULD_BE, STAYS = srgb(0x2fd24a), srgb(0x2f7bff), srgb(0xf23a3a)
COLORS = {'reference': IS, 'target': SHOULD_BE, 'constraint': STAYS, 'general': STAYS, 'specific': IS}
EDGE = (0.05, 0.05, 0.05, 0.6)  # below each line, so that it is seen on bright skin too
WIDTH, CHOSEN_WIDTH = 2.5, 4.0


def line_shader():
    """The shader of lines, ready for line()."""
    shader = versions.line_shader()
    shader.bind()
    shader.uniform_float('viewportSize', gpu.state.viewport_get()[2:])
    shader.uniform_bool('lineSmooth', [True])
    return shader


def line(shader, points, color, width=WIDTH, opacity=1.0, edge=True):
    """A line with a dark edge."""
    batch = batch_for_shader(shader, 'LINE_STRIP', {'pos': np.ascontiguousarray(points, dtype=np.float32)})
    for wide, shade in (((width + 2, EDGE),) if edge else ()) + ((width, color),):
        shader.uniform_float('lineWidth', wide * bpy.context.preferences.system.pixel_size)
        shader.uniform_float('color', (*shade[:3], shade[3] * opacity))
        batch.draw(shader)


def redraw():
    """All viewports show what is new. Areas are looked up at each use, for they may be closed at any time."""
    for window in bpy.context.window_manager.windows:
        for area in window.screen.areas:
            if area.type == 'VIEW_3D':
                area.tag_redraw()
