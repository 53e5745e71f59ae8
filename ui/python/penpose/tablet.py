"""Tablets: descriptor and reports in, samples out."""
from ctypes import byref, c_size_t, c_uint64
from typing import Dict, List, NamedTuple

from . import _c
from ._c import C, LIBRARY, text

_TOOLS = ('none', 'pen', 'eraser', 'mouse')
_ROOM = 16


class Axis(NamedTuple):
    """The range of an axis, in the device's own units. `units_per_mm` (of tilt: a degree) is 0 where it is unknown."""
    minimum: int
    maximum: int
    units_per_mm: float


class Sample(NamedTuple):
    """What a pen says in one report, in the device's own units. What the device does not have is 0."""
    x: int
    y: int
    pressure: int
    tilt_x: int
    tilt_y: int
    distance: int
    rotation: int
    wheel: int
    serial: int
    tool_id: int
    buttons: int
    tool: str
    in_range: bool
    tip: bool


class Tablet(_c.Handle):
    """One interface of a tablet, known by its ids and its HID report descriptor. Raises Error where nothing known reads it."""

    def __init__(self, vendor: int, product: int, descriptor: bytes = b'', name: str = '', bus: int = 3) -> None:
        handle, axes = c_uint64(), _c.CAxes()
        interface = _c.CInterface(bus, vendor, product, text(name), descriptor or None, len(descriptor))
        _c.check(C.penpose_tablet, LIBRARY.pointer, byref(interface), byref(handle), byref(axes))
        super().__init__(handle.value)
        self.axes: Dict[str, Axis] = {}
        for axis in _c.AXES:
            found = getattr(axes, axis)
            if found.present:
                self.axes[axis] = Axis(found.minimum, found.maximum, found.units_per_mm)
        self._samples = (_c.CSample * _ROOM)()

    def report(self, report: bytes) -> List[Sample]:
        """One raw report, the report id first; the states that it went through, oldest first. Feed all of them, in order."""
        count = c_size_t()
        self._call(C.penpose_tablet_report, report, len(report), self._samples, _ROOM, byref(count))
        out = []
        for c in self._samples[:count.value]:
            values = [getattr(c, name) for name in Sample._fields[:-3]]
            out.append(Sample(*values, _TOOLS[c.tool], bool(c.in_range), bool(c.tip)))
        return out
