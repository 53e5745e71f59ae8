"""How to draw, at the bottom of the viewport, until a face has moved for the first time."""
import blf
import gpu
from gpu_extras.batch import batch_for_shader

from . import curves, drawing, free_keys, preferences, versions

LINES = ('1  Draw along a feature of the face, such as the mouth', '2  Draw where it should be: the face follows the pen',
         'Shift: what stays    %s: menu    %s held: the pen from any tool' % (free_keys.PIE, free_keys.HOLD))
EDGE, TEXT, BACK = 12, 14, (0.06, 0.06, 0.06, 0.75)


def draw(context):
    """The hint, while the pen is in hand."""
    from .tools import in_hand
    if not preferences.hint_is_wanted(context) or not in_hand(context) or context.space_data.type != 'VIEW_3D' or \
            not context.space_data.overlay.show_overlays:
        return
    from .pen import mesh_of
    obj = mesh_of(context)
    if obj is None:
        return
    scale = context.preferences.system.ui_scale
    versions.set_text_size(TEXT * scale)
    waiting = any(c['role'] == 'reference' and 'target' not in c for c in curves.curves(obj))
    wide, high = max(blf.dimensions(0, text)[0] for text in LINES), 1.7 * TEXT * scale
    left, low = 0.5 * (context.region.width - wide), 3 * EDGE * scale
    _box(left - EDGE * scale, low - EDGE * scale, wide + 2 * EDGE * scale, len(LINES) * high + EDGE * scale)
    for i, text in enumerate(LINES):
        blf.color(0, 1, 1, 1, 1.0 if i == (1 if waiting else 0) else 0.55)
        blf.position(0, left, low + (len(LINES) - 1 - i) * high, 0)
        blf.draw(0, text)


def _box(left, low, wide, high):
    shader = versions.flat_shader_of_px()
    corners = [(left, low), (left + wide, low), (left, low + high), (left + wide, low + high)]
    gpu.state.blend_set('ALPHA')
    shader.bind()
    shader.uniform_float('color', BACK)
    batch_for_shader(shader, 'TRI_STRIP', {'pos': corners}).draw(shader)
    gpu.state.blend_set('NONE')
