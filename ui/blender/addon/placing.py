"""Curves and targets from known places instead of strokes, for scripts: what `penpose pose` does with a case."""
import numpy as np

from . import drawing, keys, store
from .controls import Refused
from .library import Preset, Role


def place_curve(obj, vertices, role='reference'):
    """A curve through vertices of the mesh, a 'reference' or a 'constraint'. Its id. Raises Refused or library.Error."""
    one = drawing.known(obj, wholly=True)
    one.rig.take_pose()
    number = one.rig.character.curve_at(np.asarray(vertices), Role.CONSTRAINT if role == 'constraint' else Role.REFERENCE)
    return drawing.keep_curve(one, obj, number, role)


def place_target(obj, curve, points):
    """Says where each point of a reference should go: (n, 3) in the character's space (space.Space). Nothing moves before solve()."""
    one = drawing.known(obj)
    kept = store.read(obj)
    found = store.find(kept, curve)
    if found is None or curve not in one.numbers:
        raise Refused('%s has no curve %s' % (obj.name, curve))
    one.rig.character.target(one.numbers[curve], points)
    found['target'] = {'points': np.asarray(points, dtype=float).tolist()}
    store.write(obj, kept)
    one.kept = obj.get(store.PROPERTY, '')


def solve(obj, preset=Preset.DEFAULT):
    """Brings all references to their targets from the pose as it is, and keys what moved. The controls that moved."""
    return drawing.solve_again(obj, preset)
