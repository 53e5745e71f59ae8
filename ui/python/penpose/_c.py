"""libpenpose as it is: found, its version checked, its functions and structs as penpose.h declares them."""
import ctypes
import ctypes.util
import enum
import importlib
import importlib.util
import os
from ctypes import POINTER, byref, c_char, c_char_p, c_double, c_int32, c_int64, c_size_t, c_uint16, c_uint32, c_uint64, c_void_p
from types import SimpleNamespace
from typing import Any, Callable, Optional

ABI_VERSION = 0
Function = Callable[..., Any]  # one of the library, as ctypes calls it


class Status(enum.IntEnum):
    """Why a call failed (penpose_status)."""
    OK = 0
    BAD_ARGUMENT = 1
    BAD_HANDLE = 2
    REFUSED = 3
    TOO_SMALL = 4
    NO_MEMORY = 5
    DIVERGED = 6
    INTERNAL = 7


class Error(Exception):
    """A call that changed nothing. `status` says why; the text is one line for a person."""

    def __init__(self, status: int, message: str) -> None:
        super().__init__(message)
        self.status = Status(status)


class _Error(ctypes.Structure):
    _fields_ = [('status', c_int32), ('message', c_char * 508)]


class CView(ctypes.Structure):
    _fields_ = [('eye', c_double * 3), ('look_at', c_double * 3), ('up', c_double * 3), ('vertical_fov_degrees', c_double),
                ('width', c_int32), ('height', c_int32)]


class CMeshPoint(ctypes.Structure):
    _fields_ = [('triangle', c_uint32), ('shares', c_double * 3)]


class CShape(ctypes.Structure):
    _fields_ = [('name', c_char_p), ('minimum', c_double), ('maximum', c_double), ('count', c_size_t), ('vertices', c_void_p),
                ('deltas', c_void_p)]


class CJoint(ctypes.Structure):
    _fields_ = [('name', c_char_p), ('parent', c_int32), ('posable', c_int32), ('translation', c_double * 3),
                ('rotation', c_double * 4), ('scale', c_double * 3), ('inverse_bind', c_double * 16), ('minimum', c_double * 3),
                ('maximum', c_double * 3)]


class CArrays(ctypes.Structure):
    _fields_ = [('vertex_count', c_size_t), ('positions', c_void_p), ('triangle_count', c_size_t), ('triangles', c_void_p),
                ('shape_count', c_size_t), ('shapes', POINTER(CShape)), ('joint_count', c_size_t), ('joints', POINTER(CJoint)),
                ('influences', c_size_t), ('joint_of', c_void_p), ('weight_of', c_void_p)]


class CCounts(ctypes.Structure):
    _fields_ = [('vertices', c_size_t), ('triangles', c_size_t), ('parameters', c_size_t), ('curves', c_size_t)]


class CSketch(ctypes.Structure):
    _fields_ = [('name', c_char_p), ('view', CView), ('target_view', POINTER(CView)), ('general', c_void_p), ('general_count', c_size_t),
                ('specific', c_void_p), ('specific_count', c_size_t), ('reference', c_void_p), ('reference_count', c_size_t),
                ('target', c_void_p), ('target_count', c_size_t), ('mode', c_int32), ('minimum', c_double), ('maximum', c_double)]


class CLine(ctypes.Structure):
    _fields_ = [('px', c_void_p), ('count', c_size_t)]


class CLineRead(ctypes.Structure):
    _fields_ = [('curve', c_char * 64), ('start', c_double), ('end', c_double), ('reversed', c_int32)]


class CPlayback(ctypes.Structure):
    _fields_ = [('reports', c_uint64), ('strokes', c_uint64), ('steps', c_uint64), ('refused', c_uint64), ('checked', c_uint64),
                ('differing', c_uint64), ('line', c_uint64), ('state', c_char * 33)]


class CAnimateOptions(ctypes.Structure):
    _fields_ = [('head', c_int32), ('units', c_int32), ('neutral', c_int64), ('tremor_px', c_double), ('smooth_s', c_double),
                ('least_confidence', c_double), ('fps', c_double), ('stretch', c_double), ('picture', c_double * 2), ('curves', c_char_p)]


class CAnimated(ctypes.Structure):
    _fields_ = [('frames', c_size_t), ('held', c_size_t), ('blinks', c_size_t), ('unmatched', c_size_t), ('rest', c_int64),
                ('fps', c_double)]


class CInterface(ctypes.Structure):
    _fields_ = [('bus', c_uint16), ('vendor', c_uint16), ('product', c_uint16), ('name', c_char_p), ('descriptor', c_char_p),
                ('descriptor_size', c_size_t)]


class CAxis(ctypes.Structure):
    _fields_ = [('present', c_int32), ('minimum', c_int32), ('maximum', c_int32), ('units_per_mm', c_double)]


AXES = ('x', 'y', 'pressure', 'tilt_x', 'tilt_y', 'distance', 'rotation', 'wheel')


class CAxes(ctypes.Structure):
    _fields_ = [(name, CAxis) for name in AXES]


class CSample(ctypes.Structure):
    _fields_ = [(name, c_int32) for name in AXES] + [
        ('serial', c_uint64), ('tool_id', c_uint32), ('buttons', c_uint32), ('tool', c_int32), ('in_range', c_int32), ('tip', c_int32),
        ('reserved', c_int32)]


_LIBRARY, _HANDLE, _ERROR = c_void_p, c_uint64, POINTER(_Error)
_ON = (_LIBRARY, _HANDLE)  # what most begin with: a library and a handle in it
_SIZES, _HANDLES = POINTER(c_size_t), POINTER(c_uint64)
# Arguments of each function without the last, which is where the error goes.
_FUNCTIONS = {
    'penpose_open': (POINTER(_LIBRARY),),
    'penpose_free': _ON,
    'penpose_character_read': (_LIBRARY, c_char_p, c_size_t, c_char_p, _HANDLES),
    'penpose_character_built_in': (_LIBRARY, c_char_p, _HANDLES),
    'penpose_character_from_arrays': (_LIBRARY, POINTER(CArrays), _HANDLES),
    'penpose_character_copy': _ON + (_HANDLES,),
    'penpose_count': _ON + (POINTER(CCounts),),
    'penpose_triangles': _ON + (c_void_p, c_size_t),
    'penpose_state': _ON + (c_char_p,),
    'penpose_write': _ON + (c_char_p, c_void_p, c_size_t, _SIZES),
    'penpose_parameter': _ON + (c_size_t, c_char_p, c_size_t, _SIZES, POINTER(c_double)),
    'penpose_find_parameter': _ON + (c_char_p, _SIZES),
    'penpose_get_pose': _ON + (c_void_p, c_size_t),
    'penpose_set_pose': _ON + (c_void_p, c_size_t),
    'penpose_set_parameter': _ON + (c_char_p, c_double),
    'penpose_reset': _ON,
    'penpose_lock': _ON + (c_char_p, c_int32),
    'penpose_evaluate': _ON + (c_void_p, c_size_t, c_void_p, c_size_t),
    'penpose_evaluate_float': _ON + (c_void_p, c_size_t, c_void_p, c_size_t),
    'penpose_view_of': _ON + (c_double, c_double, c_int32, c_int32, POINTER(CView)),
    'penpose_project': (POINTER(CView), c_void_p, c_size_t, c_void_p),
    'penpose_curve_from_vertices': _ON + (c_void_p, c_size_t, c_int32, POINTER(c_uint32)),
    'penpose_curve_from_points': _ON + (POINTER(CMeshPoint), c_size_t, c_int32, POINTER(c_uint32)),
    'penpose_curve_from_stroke': _ON + (POINTER(CView), c_void_p, c_size_t, c_int32, POINTER(c_uint32)),
    'penpose_curve_named': _ON + (c_char_p, c_int32, POINTER(c_uint32)),
    'penpose_curve_positions': _ON + (c_uint32, c_void_p, c_size_t, _SIZES),
    'penpose_curve_points': _ON + (c_uint32, POINTER(CMeshPoint), c_size_t, _SIZES),
    'penpose_curve_distances': _ON + (c_uint32, c_void_p, c_size_t, _SIZES),
    'penpose_curve_delete': _ON + (c_uint32,),
    'penpose_curves_clear': _ON,
    'penpose_target_points': _ON + (c_uint32, c_void_p, c_size_t),
    'penpose_target_stroke': _ON + (c_uint32, POINTER(CView), c_void_p, c_void_p, c_size_t),
    'penpose_solve': _ON + (c_int32,),
    'penpose_live_begin': _ON + (c_uint32, POINTER(CView), _HANDLES),
    'penpose_live_follow': _ON + (c_void_p, c_size_t, c_void_p, c_size_t, POINTER(c_int32)),
    'penpose_draw_face': _ON + (POINTER(CView), POINTER(CLine), c_size_t, POINTER(CLine), c_size_t, POINTER(CLineRead)),
    'penpose_sketch_deformer': _ON + (POINTER(CSketch),),
    'penpose_perform': _ON + (c_char_p,),
    'penpose_session_play': (_LIBRARY, c_char_p, c_size_t, _HANDLE, _HANDLES, POINTER(CPlayback)),
    'penpose_record': _ON + (c_char_p,),
    'penpose_recorded': _ON + (c_void_p, c_size_t, _SIZES),
    'penpose_animate': _ON + (c_char_p, c_size_t, c_char_p, POINTER(CAnimateOptions), _HANDLES, POINTER(CAnimated)),
    'penpose_animation_frames': _ON + (c_void_p, c_void_p, c_size_t, _SIZES),
    'penpose_animation_notes': _ON + (c_void_p, c_size_t, _SIZES),
    'penpose_animation_character': _ON + (_HANDLES,),
    'penpose_tablet': (_LIBRARY, POINTER(CInterface), _HANDLES, POINTER(CAxes)),
    'penpose_tablet_report': _ON + (c_char_p, c_size_t, POINTER(CSample), c_size_t, _SIZES),
}


def _found() -> ctypes.CDLL:
    """$PENPOSE_LIBRARY, then the one that whoever packed this package brings along (a module _packed with library(), which gives its path),
    then what the system's loader finds, then the prefix that this package is installed below."""
    named = os.environ.get('PENPOSE_LIBRARY')
    if not named and importlib.util.find_spec('._packed', __package__):
        named = importlib.import_module('._packed', __package__).library()
    if named:
        return ctypes.CDLL(named)
    name = 'libpenpose.so.%d' % ABI_VERSION
    tried = []
    lib = os.path.normpath(os.path.join(os.path.dirname(os.path.abspath(__file__)), '..', '..', '..'))
    folders = ['', lib] + sorted(entry.path for entry in os.scandir(lib) if entry.is_dir() and entry.name.endswith('-linux-gnu'))
    for folder in folders:
        try:
            return ctypes.CDLL(os.path.join(folder, name))
        except OSError as problem:
            tried.append(str(problem))
    raise ImportError('%s is not found (%s); install libpenpose0, or name it in PENPOSE_LIBRARY' % (name, tried[0]))


class _Functions(SimpleNamespace):
    """Those of the library by name, while it is loaded."""
    library: Optional[ctypes.CDLL] = None


C: Any = _Functions()


def load() -> None:
    """Loads libpenpose, as importing this package does, after unload()."""
    library = _found()
    library.penpose_abi_version.restype = c_uint32
    found = library.penpose_abi_version()
    if found != ABI_VERSION:
        raise ImportError('libpenpose has interface %d, this package needs %d' % (found, ABI_VERSION))
    library.penpose_version.restype = c_char_p
    library.penpose_close.argtypes = (POINTER(_LIBRARY),)
    library.penpose_close.restype = None
    for name, arguments in _FUNCTIONS.items():
        function = getattr(library, name)
        function.argtypes = arguments + (_ERROR,)
        function.restype = c_int32
        setattr(C, name, function)
    C.library, C.penpose_close, C.penpose_version = library, library.penpose_close, library.penpose_version
    LIBRARY.open()


def unload() -> None:
    """Frees all handles and gives libpenpose back to the system, so that its file may be replaced. What is still held of this package
    raises Error from then on."""
    LIBRARY.close()
    library, C.library = C.library, None
    if library is not None:
        import _ctypes
        getattr(_ctypes, 'FreeLibrary' if os.name == 'nt' else 'dlclose')(library._handle)


def version() -> str:
    """The version of libpenpose."""
    return C.penpose_version().decode()


def check(function: Function, *arguments: Any) -> None:
    """Calls a function of the library; what it says against it is raised."""
    if C.library is None:
        raise Error(Status.BAD_HANDLE, 'libpenpose is unloaded, and what was made with it is gone')
    error = _Error()
    if function(*arguments, byref(error)):
        raise Error(error.status, error.message.decode('utf-8', 'replace'))


class Library:
    """What the handles of this package live in; freed with the last of them."""

    def __init__(self) -> None:
        self.pointer = c_void_p()

    def open(self) -> None:
        """Handles of before name nothing: they keep the pointer of theirs."""
        self.pointer = c_void_p()
        check(C.penpose_open, byref(self.pointer))

    def close(self) -> None:
        """Frees all handles."""
        if self.pointer:
            C.penpose_close(byref(self.pointer))

    __del__ = close


LIBRARY = Library()
load()


class Handle:
    """Something that lives in the library and is freed with this."""

    def __init__(self, handle: int) -> None:
        self._library = LIBRARY
        self._on = (LIBRARY.pointer, c_uint64(handle))

    def _call(self, function: Function, *arguments: Any) -> None:
        check(function, *self._on, *arguments)

    def _bytes(self, function: Function, *arguments: Any) -> bytes:
        size = c_size_t()
        self._call(function, *arguments, None, 0, byref(size))
        buffer = ctypes.create_string_buffer(max(1, size.value))
        self._call(function, *arguments, ctypes.cast(buffer, c_void_p), size.value, byref(size))
        return ctypes.string_at(buffer, size.value)

    def close(self) -> None:
        """Frees it; any use after that raises Error with Status.BAD_HANDLE."""
        self._call(C.penpose_free)

    def __del__(self) -> None:
        if getattr(self, '_on', None) and self._on[0]:
            C.penpose_free(*self._on, None)


def text(value: str) -> bytes:
    """As C has it. A 0 inside would end it there."""
    out = value.encode('utf-8')
    if b'\0' in out:
        raise ValueError('a text with a 0 inside')
    return out


def made(function: Function, *arguments: Any) -> int:
    """The handle that a function gives out, in the place of the last argument, None."""
    handle = c_uint64()
    check(function, *arguments[:-1], byref(handle))
    return handle.value
