"""Sessions, replayed from bytes."""
from ctypes import byref, c_uint64
from dataclasses import dataclass
from typing import Optional, Tuple

from . import _c
from ._c import C, LIBRARY
from .character import Character


@dataclass
class Playback:
    """What replaying a session came to (penpose_playback)."""
    reports: int
    strokes: int
    steps: int
    refused: int
    checked: int
    differing: int
    line: int
    state: str


def play(session: bytes, on: Optional[Character] = None) -> Tuple[Character, Playback]:
    """Replays a session, or a recording of a tablet of any kind that `penpose replay` reads, as fast as it goes, on the character that it was
    recorded on (default: the built-in head that it names). Raises Error with Status.DIVERGED where a state differs from what was recorded."""
    handle, playback = c_uint64(), _c.CPlayback()
    _c.check(C.penpose_session_play, LIBRARY.pointer, session, len(session), on._on[1] if on is not None else 0, byref(handle),
             byref(playback))
    values = [getattr(playback, name) for name, _ in _c.CPlayback._fields_]
    return Character(handle.value), Playback(*values[:-1], values[-1].decode())
