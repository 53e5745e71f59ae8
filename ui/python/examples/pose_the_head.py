"""Poses the built-in head and plots how far it is from where it should be. Cells as a notebook has them; run it as it is, or cell by cell.

    PYTHONPATH=ui/python python3 ui/python/examples/pose_the_head.py residual.png
"""
# %% The head with sixteen sketched deformers, and the curves that have names in it.
import sys

import numpy as np

import penpose

head = penpose.Character.built_in('builtin:demo')
print(head.vertex_count, 'vertices;', ', '.join(parameter.name for parameter in head.parameters))

# %% What should happen: the jaw drops, the brows go up, the corners of the eyes stay.
moves = {'lip_lower': [0, -0.008, 0], 'brow_L': [0, 0.004, 0], 'brow_R': [0, 0.004, 0]}
curves = {}
for name, move in moves.items():
    curves[name] = head.curve(name)
    head.target(curves[name], head.positions(curves[name]) + move)
kept = head.curve('nose_bridge', penpose.Role.CONSTRAINT)
before = {name: head.distances(curve) for name, curve in curves.items()}

# %% Each way of solving, from rest.
residuals = {}
for preset in penpose.Preset:
    head.reset()
    head.solve(preset)
    residuals[preset.name.lower()] = {name: head.distances(curve) for name, curve in curves.items()}
    moved = {name: round(value, 3) for name, value in head.values().items() if value}
    print(preset.name.lower(), 'moved', moved, '; the nose by', '%.2g mm' % (1000 * head.distances(kept).max()))

# %% The residual along each curve, in millimetres.
try:
    import matplotlib
    matplotlib.use('Agg')
    import matplotlib.pyplot as plt
except ImportError:
    for name in curves:
        print(name, 'was', '%.2f mm' % (1000 * before[name].mean()),
              {preset: '%.2f mm' % (1000 * left[name].mean()) for preset, left in residuals.items()})
    sys.exit('matplotlib is not here: no plot')

figure, axes = plt.subplots(1, len(curves), figsize=(4 * len(curves), 3.2), sharey=True, constrained_layout=True)
for axis, name in zip(axes, curves):
    along = np.linspace(0, 1, len(before[name]))
    axis.plot(along, 1000 * before[name], color='0.6', linestyle='--', label='before')
    for preset, left in residuals.items():
        axis.plot(along, 1000 * left[name], label=preset)
    axis.set_title(name)
    axis.set_xlabel('along the curve')
axes[0].set_ylabel('distance to the target, mm')
axes[0].set_ylim(bottom=0)
axes[0].legend(frameon=False)
figure.savefig(sys.argv[1] if len(sys.argv) > 1 else 'residual.png', dpi=120)
