"""Poses and rigs 3D characters by drawing.

    import penpose
    head = penpose.Character.built_in('builtin:demo')
    lip = head.curve("lip_upper")
    head.target(lip, head.positions(lip) + [0, 0.002, 0])
    head.solve()
    xyz = head.evaluate()          # (vertices, 3)

Arrays are numpy's: points are (n, 3) in the model's unit of length, px are (n, 2) with their origin at the top left. What fails raises
`penpose.Error`, whose text is one line for a person. A `Character` may be used by one thread at a time as well as by several: calls
wait for each other, and different characters do not. docs/library.md says more.
"""
from ._c import ABI_VERSION, Error, Status, version
from .animation import Animation, animate
from .character import Character, DrawnFace, Joint, LineRead, Live, Parameter, Preset, Role, Shape, View
from .session import Playback, play
from .tablet import Axis, Sample, Tablet

__all__ = ['ABI_VERSION', 'Animation', 'Axis', 'Character', 'DrawnFace', 'Error', 'Joint', 'LineRead', 'Live', 'Parameter', 'Playback', 'Preset',
           'Role', 'Sample', 'Shape', 'Status', 'Tablet', 'View', 'animate', 'play', 'version']
__version__ = version()
