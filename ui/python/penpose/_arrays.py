"""numpy arrays as the library wants them: as they are where the layout allows, copied where not."""
from ctypes import c_void_p
from typing import Optional

import numpy as np
from numpy.typing import ArrayLike, DTypeLike


def numbers(values: ArrayLike, width: int, kind: DTypeLike = np.float64) -> np.ndarray:
    """A list of rows of `width` numbers (1: a flat list), contiguous; the same array where it is so already."""
    given = np.asarray(values)
    array = np.ascontiguousarray(given, dtype=kind)
    if array.dtype.kind == 'u' and not np.array_equal(array, given):
        raise ValueError('whole numbers from 0 to %d are needed' % np.iinfo(array.dtype).max)
    if width == 1:
        fits = array.ndim == 1
    else:
        fits = array.ndim == 2 and array.shape[1] == width
    if not fits and array.size:
        raise ValueError('an array of shape (n%s) is needed, not %s' % ('' if width == 1 else ', %d' % width, array.shape))
    return array


def pointer(array: Optional[np.ndarray]) -> Optional[c_void_p]:
    """None for none and for an empty one."""
    return None if array is None or array.size == 0 else c_void_p(array.ctypes.data)
