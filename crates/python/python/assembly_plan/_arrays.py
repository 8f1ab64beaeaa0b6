"""Arrays, and how they go to and come from the native module."""

import numpy as np
from numpy.typing import ArrayLike, NDArray

from assembly_plan.errors import SceneError

FloatArray = NDArray[np.float64]
"""An array of floats."""


def fixed(values: ArrayLike) -> FloatArray:
    """An array that cannot be changed."""
    array = np.array(values, dtype=np.float64)
    array.flags.writeable = False
    return array


def read(numbers: bytes, *shape: int) -> FloatArray:
    """The read-only array of some bytes."""
    return np.frombuffer(numbers, dtype=np.float64).reshape(shape)


def numbers(values: ArrayLike, name: str) -> FloatArray:
    """Finite real numbers, in C order; `name` is what the caller calls them."""
    array = np.asarray(values)
    if array.dtype.kind not in "biuf":
        raise SceneError(f"{name}: has elements of type {array.dtype}, must be real numbers")
    if not np.isfinite(array).all():
        raise SceneError(f"{name}: has a number that is not finite")
    return np.ascontiguousarray(array, dtype=np.float64)


def table(values: ArrayLike, columns: int, name: str) -> FloatArray:
    """Finite numbers of shape (K, `columns`); one row may stand alone."""
    array = numbers(values, name)
    if array.ndim == 1:
        array = array[None]
    if array.ndim != 2 or array.shape[1] != columns or len(array) == 0:
        raise SceneError(f"{name}: has shape {np.shape(values)}, must have shape (K, {columns}) with K at least 1")
    return array
