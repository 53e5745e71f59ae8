"""Characters: made, given curves, targets and constraints, solved, evaluated."""
import enum
from ctypes import byref, c_double, c_size_t, c_uint32, create_string_buffer
from dataclasses import dataclass, field
from typing import Dict, List, NamedTuple, Optional, Sequence, Tuple, Union

import numpy as np
from numpy.typing import ArrayLike

from . import _c
from ._arrays import numbers, pointer
from ._c import C, LIBRARY, made, text


class Preset(enum.IntEnum):
    """What a solve minimises: what was meant, as the window does; the least sum of distances; the same by the simplex of 2006."""
    DEFAULT = 0
    EXACT = 1
    PAPER = 2


class Role(enum.IntEnum):
    """A reference is brought to its target; a constraint stays where it is when it is made."""
    REFERENCE = 0
    CONSTRAINT = 1


class Parameter(NamedTuple):
    """One control: the pose has one value of it, from minimum to maximum."""
    name: str
    minimum: float
    rest: float
    maximum: float


@dataclass
class View:
    """Where somebody draws from: a pinhole camera, and the size of its picture in px."""
    eye: Sequence[float] = (0, 0, 1)
    look_at: Sequence[float] = (0, 0, 0)
    up: Sequence[float] = (0, 1, 0)
    vertical_fov_degrees: float = 30
    width: int = 1000
    height: int = 1000

    def _c(self) -> _c.CView:
        three = c_double * 3
        return _c.CView(three(*self.eye), three(*self.look_at), three(*self.up), self.vertical_fov_degrees, self.width, self.height)

    def project(self, points: ArrayLike) -> np.ndarray:
        """Where the picture shows points (n, 3): px (n, 2). Raises Error where one lies behind it."""
        xyz = numbers(points, 3)
        px = np.empty((len(xyz), 2))
        _c.check(C.penpose_project, byref(self._c()), pointer(xyz), len(xyz), pointer(px))
        return px


class LineRead(NamedTuple):
    """What a line of a drawing was taken for: a part of a feature curve of the face, by shares of its length; None: nothing known."""
    curve: Optional[str]
    start: float
    end: float
    reversed: bool


class DrawnFace(NamedTuple):
    """What the lines of a drawing, and of the one of the face at rest, were taken for (Character.draw_face)."""
    lines: List[LineRead]
    neutral: List[LineRead]


@dataclass
class Shape:
    """A blend shape of Character.from_arrays: (vertices, 3) deltas, or those of the vertices named (ascending)."""
    name: str
    deltas: np.ndarray
    vertices: Optional[np.ndarray] = None
    minimum: float = 0
    maximum: float = 1


@dataclass
class Joint:
    """A joint of Character.from_arrays (penpose_joint). `rotation` is x y z w, `inverse_bind` a 4 x 4 matrix, rows first."""
    name: str
    parent: int = -1
    translation: Sequence[float] = (0, 0, 0)
    rotation: Sequence[float] = (0, 0, 0, 1)
    scale: Sequence[float] = (1, 1, 1)
    inverse_bind: np.ndarray = field(default_factory=lambda: np.eye(4))
    posable: bool = True
    minimum: Sequence[float] = (-np.pi / 2,) * 3
    maximum: Sequence[float] = (np.pi / 2,) * 3


class Live(_c.Handle):
    """The pose that follows a target while it is drawn (Character.live)."""

    def __init__(self, handle: int, parameters: int) -> None:
        super().__init__(handle)
        self._pose = np.empty(parameters)

    def follow(self, px: ArrayLike) -> np.ndarray:
        """The pose for the line so far, all px (n, 2) since the pen went down. The array is the same one every time."""
        line = numbers(px, 2)
        self._call(C.penpose_live_follow, pointer(line), len(line), pointer(self._pose), len(self._pose), None)
        return self._pose


class Character(_c.Handle):
    """A character that is posed. Made by `read`, `built_in`, `from_arrays`, `copy` or `penpose.play`."""

    @classmethod
    def read(cls, data: bytes, hint: str = '') -> 'Character':
        """A glTF, OBJ, PLY, OFF or STL file in memory, or a project. `hint`: its name, for formats that do not say what they are."""
        return cls(made(C.penpose_character_read, LIBRARY.pointer, data, len(data), text(hint), None))

    @classmethod
    def built_in(cls, name: str = 'builtin:head') -> 'Character':
        """The program's own head, with nothing to pose yet; 'builtin:demo': with sketched deformers."""
        return cls(made(C.penpose_character_built_in, LIBRARY.pointer, text(name), None))

    @classmethod
    def from_arrays(cls, positions: ArrayLike, triangles: ArrayLike, shapes: Sequence[Shape] = (), joints: Sequence[Joint] = (),
                    joint_of: Optional[ArrayLike] = None, weight_of: Optional[ArrayLike] = None) -> 'Character':
        """From positions (vertices, 3), triangles (n, 3), blend shapes, and joints with (vertices, k) numbers and weights."""
        xyz, corners = numbers(positions, 3), numbers(triangles, 3, np.uint32)
        keep: List[object] = [xyz, corners]
        c_shapes = (_c.CShape * max(1, len(shapes)))()
        for c, shape in zip(c_shapes, shapes):
            deltas = numbers(shape.deltas, 3, np.float32)
            vertices = None if shape.vertices is None else numbers(shape.vertices, 1, np.uint32)
            if vertices is not None and len(vertices) != len(deltas):
                raise ValueError('shape %s: %d vertices for %d deltas' % (shape.name, len(vertices), len(deltas)))
            keep += [deltas, vertices]
            c.name, c.minimum, c.maximum, c.count = text(shape.name), shape.minimum, shape.maximum, len(deltas)
            c.vertices, c.deltas = pointer(vertices), pointer(deltas)
        c_joints = (_c.CJoint * max(1, len(joints)))()
        for c, joint in zip(c_joints, joints):
            c.name, c.parent, c.posable = text(joint.name), joint.parent, int(joint.posable)
            c.translation[:], c.rotation[:], c.scale[:] = joint.translation, joint.rotation, joint.scale
            c.inverse_bind[:] = list(np.asarray(joint.inverse_bind, dtype=float).T.ravel())
            c.minimum[:], c.maximum[:] = joint.minimum, joint.maximum
        arrays = _c.CArrays(len(xyz), pointer(xyz), len(corners), pointer(corners), len(shapes), c_shapes if shapes else None,
                            len(joints), c_joints if joints else None)
        if joints:
            numbers_of = np.ascontiguousarray(joint_of, dtype=np.uint32)
            weights = np.ascontiguousarray(weight_of, dtype=np.float64)
            if numbers_of.shape != weights.shape or numbers_of.ndim != 2 or len(weights) != len(xyz):
                raise ValueError('joint_of and weight_of are (vertices, k)')
            keep += [numbers_of, weights]
            arrays.influences, arrays.joint_of, arrays.weight_of = weights.shape[1], pointer(numbers_of), pointer(weights)
        return cls(made(C.penpose_character_from_arrays, LIBRARY.pointer, byref(arrays), None))

    def copy(self) -> 'Character':
        """Another one, as this is now; costs little. It records nothing."""
        return Character(made(C.penpose_character_copy, *self._on, None))

    # What it is.

    def _counts(self) -> _c.CCounts:
        counts = _c.CCounts()
        self._call(C.penpose_count, byref(counts))
        return counts

    @property
    def vertex_count(self) -> int:
        """How many there are."""
        return self._counts().vertices

    @property
    def triangles(self) -> np.ndarray:
        """(n, 3) uint32."""
        out = np.empty((self._counts().triangles, 3), dtype=np.uint32)
        self._call(C.penpose_triangles, pointer(out), len(out))
        return out

    @property
    def parameters(self) -> List[Parameter]:
        """In the order of the pose."""
        out = []
        size, limits = c_size_t(), (c_double * 3)()
        for i in range(self._counts().parameters):
            self._call(C.penpose_parameter, i, None, 0, byref(size), limits)
            name = create_string_buffer(size.value + 1)
            self._call(C.penpose_parameter, i, name, len(name), None, None)
            out.append(Parameter(name.value.decode('utf-8', 'replace'), *limits))
        return out

    @property
    def state(self) -> str:
        """The canonical hash of the document, as `penpose replay` prints it."""
        out = create_string_buffer(33)
        self._call(C.penpose_state, out)
        return out.value.decode()

    def write(self, format: str = '.glb') -> bytes:
        """A project as .glb, or .obj as it is posed."""
        return self._bytes(C.penpose_write, text(format))

    # The pose.

    @property
    def pose(self) -> np.ndarray:
        """One value a parameter: a copy. Setting it takes all of them."""
        out = np.empty(self._counts().parameters)
        self._call(C.penpose_get_pose, pointer(out), len(out))
        return out

    @pose.setter
    def pose(self, values: ArrayLike) -> None:
        array = numbers(values, 1)
        self._call(C.penpose_set_pose, pointer(array), len(array))

    def values(self) -> Dict[str, float]:
        """The pose by the names of the parameters."""
        return {parameter.name: float(value) for parameter, value in zip(self.parameters, self.pose)}

    def set(self, name: str, value: float) -> None:
        """Sets one parameter."""
        self._call(C.penpose_set_parameter, text(name), value)

    def reset(self) -> None:
        """Puts all parameters at rest."""
        self._call(C.penpose_reset)

    def lock(self, name: str, locked: bool = True) -> None:
        """Whether a solve may move a parameter."""
        self._call(C.penpose_lock, text(name), int(locked))

    def evaluate(self, pose: Optional[ArrayLike] = None, out: Optional[np.ndarray] = None) -> np.ndarray:
        """Positions (vertices, 3) at a pose (default: its own). `out`: an array of float64 or float32 to write into, not copied."""
        values = None if pose is None else numbers(pose, 1)
        if values is not None and values.size == 0 and self.parameters:
            raise ValueError('the pose has no values; give one a parameter, or no pose')
        if out is None:
            out = np.empty((self.vertex_count, 3))
        if out.dtype not in (np.float64, np.float32) or not out.flags.c_contiguous or not out.flags.writeable or out.ndim != 2 or \
                out.shape[1] != 3:
            raise ValueError('out is a contiguous (vertices, 3) array of float64 or float32')
        function = C.penpose_evaluate if out.dtype == np.float64 else C.penpose_evaluate_float
        self._call(function, pointer(values), 0 if values is None else len(values), pointer(out), len(out))
        return out

    # Curves.

    def curve(self, name: str, role: Role = Role.REFERENCE) -> int:
        """A curve that has a name in the model."""
        return self._curve(C.penpose_curve_named, text(name), role)

    def curve_at(self, vertices: ArrayLike, role: Role = Role.REFERENCE) -> int:
        """A curve of vertices."""
        array = numbers(vertices, 1, np.uint32)
        return self._curve(C.penpose_curve_from_vertices, pointer(array), len(array), role)

    def curve_of(self, triangles: ArrayLike, shares: ArrayLike, role: Role = Role.REFERENCE) -> int:
        """A curve of points of the surface: (n,) triangles and (n, 3) shares of their corners."""
        where, parts = numbers(triangles, 1, np.uint32), numbers(shares, 3)
        if len(where) != len(parts):
            raise ValueError('one row of shares a triangle')
        points = (_c.CMeshPoint * max(1, len(where)))()
        for point, triangle, row in zip(points, where, parts):
            point.triangle, point.shares[:] = int(triangle), row
        return self._curve(C.penpose_curve_from_points, points, len(where), role)

    def draw(self, view: View, px: ArrayLike, role: Role = Role.REFERENCE) -> int:
        """A curve drawn on the character as it is posed: px (n, 2) of a view."""
        line = numbers(px, 2)
        return self._curve(C.penpose_curve_from_stroke, byref(view._c()), pointer(line), len(line), role)

    def _curve(self, function: _c.Function, *arguments: object) -> int:
        curve = c_uint32()
        self._call(function, *arguments, byref(curve))
        return curve.value

    def positions(self, curve: int) -> np.ndarray:
        """Where the points of a curve are now: (n, 3)."""
        count = c_size_t()
        self._call(C.penpose_curve_positions, curve, None, 0, byref(count))
        out = np.empty((count.value, 3))
        self._call(C.penpose_curve_positions, curve, pointer(out), len(out), byref(count))
        return out

    def points(self, curve: int) -> Tuple[np.ndarray, np.ndarray]:
        """The points of the surface that a curve is glued to: (n,) triangles and (n, 3) shares of their corners."""
        count = c_size_t()
        self._call(C.penpose_curve_points, curve, None, 0, byref(count))
        out = (_c.CMeshPoint * max(1, count.value))()
        self._call(C.penpose_curve_points, curve, out, count.value, byref(count))
        rows = out[:count.value]
        return np.array([p.triangle for p in rows], dtype=np.uint32), np.array([list(p.shares) for p in rows]).reshape(-1, 3)

    def distances(self, curve: int) -> np.ndarray:
        """How far each point of a curve is from where it should be, model units."""
        count = c_size_t()
        self._call(C.penpose_curve_distances, curve, None, 0, byref(count))
        out = np.empty(count.value)
        self._call(C.penpose_curve_distances, curve, pointer(out), len(out), byref(count))
        return out

    def delete(self, curve: int) -> None:
        """Deletes one curve; the pose stays."""
        self._call(C.penpose_curve_delete, curve)

    def clear(self) -> None:
        """Deletes all curves; the pose stays."""
        self._call(C.penpose_curves_clear)

    def target(self, curve: int, points: ArrayLike) -> None:
        """Says where each point of a reference should go: (n, 3). `solve` brings it there."""
        xyz = numbers(points, 3)
        self._call(C.penpose_target_points, curve, pointer(xyz), len(xyz))

    def draw_target(self, curve: int, view: View, px: ArrayLike, pressure: Optional[ArrayLike] = None) -> None:
        """Draws where a reference should go, and solves at once as the window does when the pen lifts."""
        line = numbers(px, 2)
        pressed = None if pressure is None else numbers(pressure, 1)
        if pressed is not None and len(pressed) != len(line):
            raise ValueError('one pressure a px')
        self._call(C.penpose_target_stroke, curve, byref(view._c()), pointer(line), pointer(pressed), len(line))

    def solve(self, preset: int = Preset.DEFAULT) -> None:
        """Brings references to their targets, from the pose as it is, and keeps constraints where they are."""
        self._call(C.penpose_solve, preset)

    def live(self, curve: int, view: View) -> Live:
        """Follows a target while it is drawn; changes nothing here."""
        return Live(made(C.penpose_live_begin, *self._on, curve, byref(view._c()), None), self._counts().parameters)

    def draw_face(self, lines: Sequence[ArrayLike], view: Optional[View] = None, neutral: Sequence[ArrayLike] = ()) -> DrawnFace:
        """Poses the face as a drawing of it shows: lines of px (n, 2) without labels, anywhere on a sheet. `view`: from where it is seen
        (default: the front). `neutral`: the same hand's drawing of the face at rest, which takes its proportions out."""
        px = [numbers(line, 2) for line in (*lines, *neutral)]
        c_lines = [(_c.CLine * max(1, len(part)))(*((pointer(line), len(line)) for line in part))
                   for part in (px[:len(lines)], px[len(lines):])]
        read = (_c.CLineRead * max(1, len(px)))()
        self._call(C.penpose_draw_face, None if view is None else byref(view._c()), c_lines[0], len(lines), c_lines[1], len(neutral), read)
        taken = [LineRead(one.curve.decode('utf-8', 'replace') or None, one.start, one.end, bool(one.reversed)) for one in read[:len(px)]]
        return DrawnFace(taken[:len(lines)], taken[len(lines):])

    def view(self, yaw_degrees: float = 0, pitch_degrees: float = 0, width: int = 1000, height: int = 1000) -> View:
        """A view of the whole character at rest."""
        c = _c.CView()
        self._call(C.penpose_view_of, yaw_degrees, pitch_degrees, width, height, byref(c))
        return View(tuple(c.eye), tuple(c.look_at), tuple(c.up), c.vertical_fov_degrees, c.width, c.height)

    def sketch(self, view: View, general: ArrayLike, specific: ArrayLike, target: ArrayLike, reference: Optional[ArrayLike] = None,
               name: Optional[str] = None, mode: str = 'auto', range: Tuple[float, float] = (0, 1),
               target_view: Optional[View] = None) -> None:
        """Sketches a deformer in strokes of px (n, 2), on the character at rest: a new parameter. `mode`: auto, translate, rotate."""
        lines = [None if line is None else numbers(line, 2) for line in (general, specific, reference, target)]
        places = [item for line in lines for item in (pointer(line), 0 if line is None else len(line))]
        own = None if target_view is None else _c.POINTER(_c.CView)(target_view._c())
        modes = {'auto': 0, 'translate': 1, 'rotate': 2}
        if mode not in modes:
            raise ValueError('mode is auto, translate or rotate')
        c = _c.CSketch(None if name is None else text(name), view._c(), own, *places, modes[mode], *range)
        self._call(C.penpose_sketch_deformer, byref(c))

    def perform(self, command: str) -> None:
        """Any command that a session can hold, as its text: 'set_key time_s=1 name=smile'."""
        self._call(C.penpose_perform, text(command))

    # Recording.

    def record(self, model: str) -> None:
        """From now on every change is recorded; `model`: where the character as it is now can be found, a hint."""
        self._call(C.penpose_record, text(model))

    @property
    def recorded(self) -> bytes:
        """The session so far: what `penpose replay` and `penpose.play` replay."""
        return self._bytes(C.penpose_recorded)
