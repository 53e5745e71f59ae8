"""Curves and targets from known places instead of strokes, for scripts: what `penpose pose` does with a case."""
import numpy as np

from . import curves, drawing
from .controls import Refused
from .library import Preset, Role
from .rig import check


def place_curve(obj, vertices, role='reference'):
    """A curve through vertices of the mesh, a 'reference' or a 'constraint'. Its id. Raises Refused or library.Error."""
    one = drawing.known(obj, wholly=True, measured=False)
    one.rig.take_pose()
    number = one.rig.character.curve_at(np.asarray(vertices), Role.CONSTRAINT if role == 'constraint' else Role.REFERENCE)
    return drawing.keep_curve(one, obj, number, role)


def place_target(obj, curve, points):
    """Says where each point of a reference should go: (n, 3) in the character's space (space.Space). Nothing moves before solve()."""
    one = drawing.of(obj)
    if one is None or one.kept != curves.texts(obj):
        one = drawing.known(obj)
    check(obj)
    found = next((c for c in curves.curves(obj) if c['id'] == curve), None)
    if found is None or curve not in one.numbers:
        raise Refused('%s has no curve %s' % (obj.name, curve))
    # Whether the rig is what it was is asked by solve().
    one.rig.character.target(one.numbers[curve], points)
    places = curves.to_owner(one.rig.surface, found.owner, points)
    curves.change(obj, curve, lambda kept: kept.update(target={'points': places.tolist()}) or kept)
    one.kept = curves.texts(obj)


def solve(obj, preset=Preset.DEFAULT):
    """Brings all references to their targets from the pose as it is, and keys what moved. The controls that moved."""
    return drawing.solve_again(obj, preset, wholly=False)
