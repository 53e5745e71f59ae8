"""What lines on a measured rig are read by: a character of its own, with only the controls that they may mean.

A control that is there but locked is still one that a line might mean: beside a jaw, which goes far, a corner of the mouth is faint, and a
small smile is then no more than the hand's doubt. What carries much more than what is drawn on is no such control."""
import numpy as np

from .library import Character


class Reader:
    """Reads lines for a rig. `character`: it may be the rig's own; `at`: its parameters among the rig's; `numbers`: of its curves, by
    their ids."""

    def __init__(self, character, at, numbers):
        self.character, self.at, self.numbers = character, at, numbers

    def whole(self, pose, own=None):
        """A pose of the rig's character with what the reader has. `own`: a pose of the reader's character; None: the one it has."""
        out = np.array(pose)
        out[self.at] = self.character.pose if own is None else own
        return out


def part_of(rig, at):
    """A character with some of the parameters of a rig's, in the same pose; the others stay as they are there."""
    pose = rig.character.pose
    others = pose.copy()
    others[at] = 0.0
    made = Character.from_arrays(rig.character.evaluate(others), rig.surface.triangles, [rig.shapes[i] for i in at])
    for i in at:
        if rig.locked[i]:
            made.lock(rig.names[i], True)
    made.pose = pose[at]
    return made
