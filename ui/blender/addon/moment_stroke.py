"""A stroke that poses another frame: an arc is pulled there, or a ghost is drawn as it should be. The frame that is shown stays."""
import bpy
import numpy as np

from . import arcs, curves, drawing, keys
from .controls import TINY, Refused
from .held import Held
from .library import Error, Role
from .moments import Moments
from .rig import give_back


class MomentStroke:
    """What drawing.Stroke is, on another frame. `way`: 'arc' pulls the curve along, 'ghost' draws its target."""
    kind = 'target'

    def __init__(self, obj, way, curve, frame, seen):
        self.held, self.way, self.curve, self.frame, self.seen = Held(obj), way, curve, frame, seen
        one = drawing.known(obj)
        self.rig, self.moments = one.rig, Moments(one.rig)
        self.before = self.moments.pose(frame)
        self.character = self.rig.character.copy()
        triangles, shares = self.character.points(one.numbers[curve])
        held = [self.character.points(one.numbers[c['id']]) for c in curves.curves(obj)
                if c['role'] == 'constraint' and not c.get('off') and c['id'] in one.numbers]
        # What the other curves are drawn for is the frame that is shown.
        self.character.clear()
        self.character.pose = self.before
        self.number = self.character.curve_of(triangles, shares)
        for where, parts in held:
            self.character.curve_of(where, parts, Role.CONSTRAINT)
        self.start = seen.view.project(self.character.positions(self.number))
        self.live = self.character.live(self.number, seen.view)
        self.shown = self.character.copy()
        self.px, self.pressure, self.grabbed, self.keyed = [], [], None, 0

    def add(self, place, pressure=1.0):
        """A place of the region."""
        px = self.seen.px([place])[0]
        if not np.isfinite(px).all():
            return
        if self.way == 'arc':
            self.grabbed = px if self.grabbed is None else self.grabbed
            self.px = list(self.start + (px - self.grabbed))
        elif not self.px or np.abs(px - self.px[-1]).max() >= 1e-3:
            self.px.append(px)

    def follow(self):
        """Shows the curve where it would be on that frame."""
        if len(self.px) > 1:
            self.shown.pose = self.live.follow(np.array(self.px))

    def places(self):
        """The line that is drawn, px of the region."""
        return self.seen.places(self.px)

    def line_of_frame(self):
        """The curve as it follows, px of the region."""
        return self.seen.places(self.seen.view.project(self.shown.positions(self.number)))

    def cancel(self, obj):
        """Nothing was changed."""

    def end(self, obj):
        """Keys what moves there. The controls that moved."""
        still = self.way == 'arc' and self.px and np.abs(np.array(self.px) - self.start).max() < 1
        if len(self.px) < 2 or still:
            raise Refused('a stroke is a line; pull %s, or draw over the ghost, with the pen down' % obj.name)
        try:
            self.character.draw_target(self.number, self.seen.view, np.array(self.px), None)
        except Error as problem:
            raise Refused('frame %g of %s: %s' % (self.frame, obj.name, problem)) from None
        pose = self.character.pose
        moved = [control for control, numbers, free in self.rig.parts if free and np.abs(pose[numbers] - self.before[numbers]).max() > TINY]
        self._key(moved, pose)
        return moved

    def _key(self, moved, pose):
        scene, kept, said = bpy.context.scene, self.rig.kept(), drawing.known(self.held.get()).said
        rules = keys.Rules(scene).for_all()
        unmoved = [control for control in moved if not self.moments.is_animated(control)]
        # The change stays between the neighbouring keys.
        for frame in self.moments.neighbours(self.frame) if unmoved else ():
            keys.insert(unmoved, rules, frame, said)
        self.rig.apply(pose)
        self.keyed = keys.insert(moved, rules, self.frame, said)
        give_back(kept)
        scene.frame_set(scene.frame_current, subframe=scene.frame_subframe)
        arcs.forget()


class StrokeThere(drawing.Stroke):
    """The same on a rig whose controls are measured near the pose that is shown: its frame is shown while the stroke is drawn."""

    def __init__(self, obj, way, curve, frame, seen):
        self.way, self.frame, self.grabbed = way, frame, None
        scene = bpy.context.scene
        self.back = scene.frame_current
        scene.frame_set(int(frame), subframe=frame % 1)
        try:
            super().__init__(obj, 'target', seen, curve)
        except (Refused, Error):
            scene.frame_set(self.back)
            raise
        self.drawn = drawing.kept_all(obj)
        self.start = seen.view.project(self.rig.character.positions(self.known.numbers[curve]))

    def add(self, place, pressure=1.0):
        """A place of the region."""
        if self.way != 'arc':
            super().add(place, pressure)
            return
        px = self.seen.px([place])[0]
        if np.isfinite(px).all():
            self.grabbed = px if self.grabbed is None else self.grabbed
            self.px = list(self.start + (px - self.grabbed))
            self.pressure = [1.0] * len(self.px)

    def cancel(self, obj):
        """Leaves no trace."""
        super().cancel(obj)
        bpy.context.scene.frame_set(self.back)

    def end(self, obj):
        """Keys what moves there. The controls that moved."""
        moved = super().end(obj)
        drawing.put_back_all(self.drawn)  # the curve's own target is of the frame where one was
        rules, said, scene = keys.Rules(bpy.context.scene).for_all(), self.known.said, bpy.context.scene
        when = Moments(self.known.rig)
        unmoved = [control for control in moved if not when.is_animated(control)]
        now = [(control, control.kept()) for control in unmoved]
        give_back([one for one in self.kept if one[0] in unmoved])
        for frame in when.neighbours(self.frame) if unmoved else ():
            keys.insert(unmoved, rules, frame, said)
        for control, value in now:
            control.give_back(value)
        self.keyed = keys.insert(moved, rules, self.frame, said)
        scene.frame_set(self.back)
        arcs.forget()
        return moved


def stroke_at(obj, way, curve, frame, seen):
    """A stroke on another frame."""
    kind = StrokeThere if drawing.known(obj).rig.measured else MomentStroke
    return kind(obj, way, curve, frame, seen)
