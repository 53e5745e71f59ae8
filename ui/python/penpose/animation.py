"""Animations from what a face tracker saw."""
from ctypes import byref, c_size_t, c_uint64
from typing import List, Optional, Tuple, Union

import numpy as np

from . import _c
from ._arrays import pointer
from ._c import C, text
from .character import Character

_HEADS = {None: 0, 'drop': 1, 'apply': 2}


class Animation(_c.Handle):
    """Keyframes from a track (penpose.animate). `held`, `blinks`, `unmatched` are how many, `rest` the frame that was taken for rest."""

    def __init__(self, handle: int, told: _c.CAnimated, parameters: int) -> None:
        super().__init__(handle)
        self.held, self.blinks, self.unmatched = told.held, told.blinks, told.unmatched
        self.rest, self.fps = None if told.rest < 0 else told.rest, told.fps
        self.times, self.poses = np.empty(told.frames), np.empty((told.frames, parameters))
        self._call(C.penpose_animation_frames, pointer(self.times), pointer(self.poses), told.frames, byref(c_size_t()))

    @property
    def notes(self) -> List[str]:
        """What was left out or held, a line each."""
        return self._bytes(C.penpose_animation_notes).decode('utf-8', 'replace').splitlines()

    @property
    def character(self) -> Character:
        """The character with the animation, named "tracked", before those that it had: write() keeps it."""
        return Character(_c.made(C.penpose_animation_character, *self._on, None))


def animate(character: Character, track: bytes, map: Union[str, None] = None, *, head: Optional[str] = None, units: bool = False,
            neutral: Optional[int] = None, tremor_px: Optional[float] = None, smooth_s: float = 0, least_confidence: float = 0.2,
            fps: float = 0, stretch: float = 0, picture: Optional[Tuple[float, float]] = None, curves: Optional[str] = None) -> Animation:
    """Keyframes from what a face tracker saw; the character stays as it is. `map`: the text of a map file, or openface, mediapipe, ibug68,
    curves or arkit (default: by the track). `head`: 'drop' or 'apply' its turn (default: as the map says). `neutral`: the frame at rest.
    `fps`: keys at that rate; the take keeps its length. `stretch`: frames follow each other at that rate. `picture`: width and height in px, for normalised coordinates. `curves`: JSON of more curves
    that the map may name. penpose_animate_options has the ranges."""
    if head not in _HEADS:
        raise ValueError("head is None, 'drop' or 'apply'")
    if neutral is not None and neutral < 0:
        raise ValueError('frames count from 0')
    options = _c.CAnimateOptions(_HEADS[head], int(units), -1 if neutral is None else neutral, -1 if tremor_px is None else tremor_px,
                                 smooth_s, least_confidence, fps, stretch, (0, 0) if picture is None else tuple(picture),
                                 None if curves is None else text(curves))
    handle, told = c_uint64(), _c.CAnimated()
    character._call(C.penpose_animate, track, len(track), None if map is None else text(map), byref(options), byref(handle), byref(told))
    return Animation(handle.value, told, len(character.pose))
