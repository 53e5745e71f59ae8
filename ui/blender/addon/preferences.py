"""The add-on's preferences: whether the hint for the first stroke was read."""
import bpy
from bpy.props import BoolProperty


class PENPOSE_AP_preferences(bpy.types.AddonPreferences):
    """What stays from one session to the next."""
    bl_idname = __package__

    show_hint: BoolProperty(name='Show the Hint', default=True,
                            description='How to draw, at the bottom of the viewport, until a face has moved')

    def draw(self, context):
        self.layout.prop(self, 'show_hint')
        self.layout.label(text='Keys: Keymap > 3D View > Object Mode, and Pose > Hold for the Pen; the tool\'s own below Penpose')


def _own(context):
    addon = context.preferences.addons.get(__package__)
    return addon.preferences if addon is not None else None


def hint_is_wanted(context):
    """Whether nobody has moved a face yet."""
    own = _own(context)
    return own is not None and own.show_hint


def hint_was_read(context):
    """It is not shown again."""
    own = _own(context)
    if own is not None and own.show_hint:
        own.show_hint = False
        context.preferences.is_dirty = True


CLASSES = (PENPOSE_AP_preferences,)
